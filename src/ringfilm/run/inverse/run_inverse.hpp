#pragma once
#include <functional>
#include <string>

#include "ringfilm/io/inverse/fit_output.hpp"
#include "ringfilm/io/inverse/optimisation_output.hpp"
#include "ringfilm/io/inverse/point_store.hpp"

/// Fits of a case to measurements, and optimisations of a case, from their files.
namespace ringfilm::run {

/// How fits and optimisations are computed; none of it changes a number.
struct InverseOptions {
  int threads = 0;  ///< 0: as many as the machine runs at once
  /// Called by every thread now and then; what it throws ends the work. Cases that were computed are in the store.
  std::function<void()> pulse = {};
};

/// Reads a fit. Throws InputError.
io::FitFile read_fit(const std::string& path);

/// Fits the case. Throws ConvergenceError where it has no solution at any start, OutputError of the store.
io::FitDocument run_fit(io::FitFile file, io::PointStore& store, const InverseOptions& options = {});

/// Reads an optimisation. Throws InputError.
io::OptimisationFile read_optimisation(const std::string& path);

/// Optimises the case. Throws ConvergenceError where no design has a solution, OutputError of the store.
io::OptimisationDocument run_optimisation(io::OptimisationFile file, io::PointStore& store,
                                          const InverseOptions& options = {});

/// The case of a design at an operating point.
cycle::Case case_of_design(const io::OptimisationFile& file, const study::Design& design, std::size_t point);

}  // namespace ringfilm::run
