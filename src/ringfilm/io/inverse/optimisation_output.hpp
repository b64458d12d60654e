#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/inverse/optimisation_file.hpp"

namespace ringfilm::io {

/// A design with all that its cases give.
struct DesignQuantities {
  study::Design design;
  std::map<std::string, double> quantities;           ///< over the operating points, by weighted means [SI]
  std::vector<std::map<std::string, double>> points;  ///< at each operating point [SI]
};

/// What came of an optimisation, with what it was of.
struct OptimisationDocument {
  OptimisationFile file;
  study::OptimisationResult result;
  std::optional<DesignQuantities> best;     ///< nothing: no design meets all constraints
  std::optional<DesignQuantities> nearest;  ///< the design that breaks them the least, where none meets them
  std::vector<DesignQuantities> front;
  std::size_t n_computed = 0;  ///< cases that were computed
  std::size_t n_stored = 0;    ///< cases that were there before
};

/// A constraint that cannot be met, in words: "min_film_thickness is 0.31 um at best, 0.09 um below at_least = 0.4 um".
std::vector<std::string> broken_constraints(const OptimisationDocument& document, const Units& units);

/// The optimisation as JSON, SI: `best` and each of `front` with `variables` (key to value) and `quantities`,
/// `binding` (quantities of constraints at their limit), `at_bounds`, `feasible`, `violated`, ...
std::string optimisation_json(const OptimisationDocument& document);

/// All designs that were computed: variables, objectives and constraints.
std::string designs_csv(const OptimisationDocument& document);

}  // namespace ringfilm::io
