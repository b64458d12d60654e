#pragma once
#include <memory>

#include "ringfilm/sheet/sheet.hpp"

namespace ringfilm::sheet {

/// Memory of a solver, for one problem at a time. The caller owns it.
class SheetWorkspace {
 public:
  explicit SheetWorkspace(const SheetProblem& problem);
  SheetWorkspace(SheetWorkspace&&) noexcept;
  SheetWorkspace& operator=(SheetWorkspace&&) noexcept;
  ~SheetWorkspace();

 private:
  friend class SheetSolve;
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// Finds pressure, fill and the one separation of the whole sheet such that mass, cavitation and load balance
/// (eq-sheet-balance).
///
/// By Newton's method on all nodes and ln h_m; its linear systems by GMRES, preconditioned by strips: each solved as in
/// film/, the slow changes in y on coarser sheets (docs/theory/sheet.md, "the solver"). A film whose pressure leaves
/// the range of the fitted laws is solved again with the laws themselves. If Newton's method fails: a bracketed search
/// on ln h_m, as in film/.
///
/// @param previous the state one time step ago; only its `content` enters
/// @param state in: first guess; out: the solution if `converged`, else unusable
film::FilmReport solve_sheet(const SheetProblem& problem, const SheetInputs& inputs, const film::FilmState& previous,
                             film::FilmState& state, SheetWorkspace& workspace);

/// The same at the h_m of `state`, which stays. `inputs.strip.load` is only the scale of pressures.
film::FilmReport solve_sheet_at_separation(const SheetProblem& problem, const SheetInputs& inputs,
                                           const film::FilmState& previous, film::FilmState& state,
                                           SheetWorkspace& workspace);

/// Every strip like the one of a film across.
film::FilmState of_strips(const SheetProblem& problem, const film::FilmState& strip);

/// rho theta h of every node, from pressure, deficit and h_m, by the laws that `state.laws` names.
void complete_state(const SheetProblem& problem, const SheetInputs& inputs, film::FilmState& state);

/// W_h + W_a per length in y [N/m].
double mean_load(const SheetProblem& problem, const SheetInputs& inputs, const film::FilmState& state);

}  // namespace ringfilm::sheet
