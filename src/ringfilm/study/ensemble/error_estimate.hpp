#pragma once
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

/// How far a result may be from the one of ever finer cells and crank steps (docs/theory/error-estimate.md).
namespace ringfilm::study {

/// One integration of the same case, on its own grid or on another.
struct GridRun {
  long cells = 0;             ///< across the face
  double crank_step_deg = 0;  ///< crank step of the integration [degree]
  double step_error = 0;      ///< error that one step may make under adaptive control [-]
  bool solved = true;         ///< did its integration reach its end?
  std::string reason;         ///< why not, if not solved
  long cells_y = 0;           ///< around the ring; 0: a film across the face
};

/// The members of an integration, as all outputs have them.
constexpr auto members(const GridRun*) {
  using G = GridRun;
  return std::tuple{Member{"cells", "1", "cells across the face of an integration for the error estimate", &G::cells},
                    Member{"cells_y", "1", "cells around the ring of an unrolled film, else 0", &G::cells_y},
                    Member{"crank_step", "degree", "its crank step", &G::crank_step_deg},
                    Member{"step_error", "1", "error that one of its steps may make", &G::step_error},
                    Member{"solved", "1", "1 where it was solved", &G::solved},
                    Member{"reason", "", "why it was not solved", &G::reason}};
}

/// Errors in the units of what they belong to; NaN where there is no estimate. Effort has none.
struct ErrorEstimate {
  std::vector<GridRun> runs;           ///< the case itself, then cells doubled and halved, steps halved and doubled
  cycle::CycleValues values;           ///< error of each value of the cycle
  std::vector<cycle::Sample> samples;  ///< error of each curve at each crank angle of the result
  /// Observed orders in the cells (eq-observed-order) [-]; NaN where the three grids do not converge monotonically.
  cycle::CycleValues order_in_cells;
  cycle::CycleValues order_in_step;  ///< observed orders in the crank step, eq-observed-order [-]
};

/// Is there an error of any value? Not where both integrations of one pair of grids, in cells or in steps, cannot be
/// used.
bool has_values(const ErrorEstimate& estimate);

/// Can a curve have a discretisation error? Not the crank angle itself and not the effort that was spent.
bool has_error(const cycle::CurveQuantity& quantity);

/// The case on the four other grids from which its errors follow: cells doubled and halved, steps halved and doubled.
/// In an unrolled film the number of cells around the ring and the length of those at its ends change with the
/// number of cells across the face.
std::vector<cycle::Case> other_grids(const cycle::Case& c);

/// The case on twice the cells with half the steps, both at once; four times the work, of an unrolled film eight times.
cycle::Case finer_grid(const cycle::Case& c);

/// The errors of `result`, a complete result of `c`, from how its `other_grids` ended. One that was not solved, be it
/// that its integration stopped or that it breaks a rule of cases (too many nodes), leaves the one on its other side to
/// go by, and both no estimate. Throws std::logic_error if there are not as many endings as grids.
ErrorEstimate error_estimate(const cycle::Case& c, const cycle::CycleResult& result, std::span<const Ending> others);

/// Integrates the `other_grids` of `c` and estimates the errors of `result`; for the cost see
/// docs/theory/error-estimate.md.
ErrorEstimate error_estimate(const cycle::Case& c, const cycle::CycleResult& result, const Progress& progress = {},
                             const BatchOptions& options = {});

/// What the user must learn about the integrations that stopped; empty if none did.
std::vector<cycle::Note> notes_on(const ErrorEstimate& estimate);

/// How many values of the cycle the estimate finds within solver.accuracy, and the largest errors of the others;
/// nothing where none is asked for or there is no estimate.
std::optional<cycle::Note> note_on_accuracy(const cycle::Case& c, const cycle::CycleResult& result,
                                            const ErrorEstimate& estimate);

/// No error at all: what `values` and `samples` of a result start from.
ErrorEstimate no_estimate(std::size_t n_samples);

}  // namespace ringfilm::study
