#pragma once
#include <optional>
#include <vector>

#include "ringfilm/film/lane_newton.hpp"
#include "ringfilm/film/reynolds.hpp"
#include "ringfilm/sheet/gmres.hpp"
#include "ringfilm/sheet/sheet.hpp"
#include "ringfilm/sheet/strip_multigrid.hpp"

namespace ringfilm::sheet {

/// Newton's method on pressure and fill of all nodes of a sheet, and on ln h_m (docs/theory/sheet.md, "the solver").
/// Nodes stop at the kink, fronts that only advance are helped along each strip, h_m moves by at most -60 % or +150 %
/// an iteration, as in film::LaneNewton.
class SheetNewton {
 public:
  explicit SheetNewton(const SheetProblem& problem);
  SheetNewton(const SheetNewton&) = delete;  // the block points into the memory
  SheetNewton& operator=(const SheetNewton&) = delete;

  struct Outcome {
    bool solved = false;
    int iterations = 0;
    double last_step = 0;      ///< largest relative change of film or pressure in the last iteration [-]
    double peak_pressure = 0;  ///< of the film, given strips and edges included [Pa]
  };
  /// From `state`, at its h_m or from it. `state` receives h_m, pressure and deficit, solved or not.
  Outcome solve(const SheetProblem& problem, const SheetInputs& inputs, const film::FilmState& previous,
                film::Unknowns unknowns, film::LaneLaws laws, film::FilmState& state);

 private:
  void set_gap(const SheetProblem& problem);
  void set_step(const SheetProblem& problem, const SheetInputs& inputs, const film::FilmState& previous,
                film::LaneLaws laws, const film::FilmState& guess);
  void set_separation(const SheetInputs& inputs, double h_m);
  void set_given(const SheetInputs& inputs);
  void give_oil(const SheetProblem& problem);
  /// Excess of the load carried, and its slope in ln h_m at fixed pressures.
  struct LoadRow {
    double excess, slope;
  };
  LoadRow load_row(const SheetProblem& problem, const SheetInputs& inputs, double h_m) const;
  /// Fills step_; returns the change of ln h_m, or nothing if the system was not solved.
  std::optional<double> solve_linear(const LoadRow& load, film::Unknowns unknowns, double reduction, int iteration);
  bool solve_at(double d_ln_h, double reduction);
  void help_along(bool only_advanced);
  void read(const SheetProblem& problem, const SheetInputs& inputs, film::FilmState& state) const;

  /// Index of strip j in the zebra: strips that are given stand at -1 and n_strips.
  int strip_of(int j) const { return j - first_; }

  const SheetKernels* kernels_;
  ZebraShape shape_;
  Ends ends_;
  int first_;  ///< the first strip that is solved
  std::vector<double> memory_;
  SheetBlock block_{};
  std::optional<StripMultigrid> multigrid_;
  Gmres gmres_;
  std::vector<double> step_, rhs_, product_, column_solution_;  ///< zebras, the first two with d ln h_m behind them
  std::vector<double> p_;                                       ///< for laws that are given
  film::NodalOil oil_;
  double left_ = 1;          ///< of the last linear system [-]
  double border_scale_ = 1;  ///< by which d ln h_m counts among pressures [Pa]
  // Help for advancing fronts
  int reach_ = 0, largest_reach_ = 0, retreats_left_ = 0, advances_ = 0;
};

}  // namespace ringfilm::sheet
