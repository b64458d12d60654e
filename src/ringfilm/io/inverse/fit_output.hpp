#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/inverse/fit_file.hpp"

namespace ringfilm::io {

/// What came of a fit, with what it was of.
struct FitDocument {
  FitFile file;
  study::FitResult result;
  std::vector<cycle::Quantity> predicted;  ///< quantities of FitResult::predicted, those of the case itself
  cycle::Case fitted;                      ///< the case with the fitted values
  std::size_t n_computed = 0;              ///< cases that were computed
  std::size_t n_stored = 0;                ///< cases that were there before
};

/// The fit as JSON, SI with angles in degrees: `parameters` (list of `key`, `value`, `low`, `high`, `unit`,
/// `deviation`, `identified`), `residual_rms`, `not_identified`, `correlation`, `nuisances`, `measured`, `predictions`,
/// `notes`, ...
std::string fit_json(const FitDocument& document);

/// Measured and computed values with their bands, one row for each measured value.
std::string fit_csv(const FitDocument& document);

/// A study around the fitted case: the parameters with their scatter and correlations.
/// @param case_name file of the fitted case, relative to the study
std::string fit_study(const FitDocument& document, const std::string& case_name);

}  // namespace ringfilm::io
