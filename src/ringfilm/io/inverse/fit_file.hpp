#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/inverse/varied_document.hpp"
#include "ringfilm/study/inverse/fit.hpp"

namespace ringfilm::io {

/// A fit with all that its file names.
struct FitFile {
  study::Fit problem;
  study::Compute compute = study::Compute::kFilms;
  std::vector<cycle::Case> bases;  ///< the case, then as it is at each measured operating point
  std::vector<cycle::InputFile> files;
};

/// Reads a fit with its measured files. Throws InputError with every fault of all of them.
FitFile read_fit(const std::string& path, const CaseQuantities& quantities);

}  // namespace ringfilm::io
