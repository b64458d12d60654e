#include "ringfilm/sheet/sheet_integrals.hpp"
#include "ringfilm/sheet/sheet_solver.hpp"

// Until the solver stands no film is found.
namespace ringfilm::sheet {

struct SheetWorkspace::Memory {};
SheetWorkspace::SheetWorkspace(const SheetProblem&) {}
SheetWorkspace::SheetWorkspace(SheetWorkspace&&) noexcept = default;
SheetWorkspace& SheetWorkspace::operator=(SheetWorkspace&&) noexcept = default;
SheetWorkspace::~SheetWorkspace() = default;

film::FilmReport solve_sheet(const SheetProblem&, const SheetInputs&, const film::FilmState&, film::FilmState&,
                             SheetWorkspace&) {
  return {};
}

film::FilmReport solve_sheet_at_separation(const SheetProblem&, const SheetInputs&, const film::FilmState&,
                                           film::FilmState&, SheetWorkspace&) {
  return {};
}

SheetIntegrals sheet_integrals(const SheetProblem&, const SheetInputs&, const film::FilmState&,
                               const film::FilmState&) {
  return {};
}

}  // namespace ringfilm::sheet
