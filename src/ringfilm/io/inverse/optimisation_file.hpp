#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/inverse/varied_document.hpp"
#include "ringfilm/study/inverse/optimisation.hpp"

namespace ringfilm::io {

/// An optimisation with all that its file names.
struct OptimisationFile {
  study::Optimisation problem;
  study::Compute compute = study::Compute::kFilms;
  std::vector<cycle::Case> bases;  ///< for each combination of choices the case at each operating point
  std::vector<cycle::InputFile> files;

  std::size_t base(std::size_t combination, std::size_t point) const {
    return combination * problem.points.size() + point;
  }
};

/// Reads an optimisation. Throws InputError with every fault of the file and of the cases that it names.
OptimisationFile read_optimisation(const std::string& path, const CaseQuantities& quantities);

}  // namespace ringfilm::io
