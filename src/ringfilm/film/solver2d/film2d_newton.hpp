#pragma once
#include <optional>
#include <vector>

#include "ringfilm/film/film2d.hpp"
#include "ringfilm/film/solver/front_advance.hpp"
#include "ringfilm/film/solver/lane_newton.hpp"
#include "ringfilm/film/solver/reynolds.hpp"
#include "ringfilm/film/solver2d/gmres.hpp"
#include "ringfilm/film/solver2d/strip_multigrid.hpp"

namespace ringfilm::film {

/// Newton's method on pressure and film content of all nodes of a two-dimensional film, and on ln h_m
/// (docs/theory/two-dimensional-film.md, "the solver"). Nodes stop at the kink, fronts that only advance are helped
/// along each strip, h_m moves by at most -60 % or +150 % an iteration, as in LaneNewton.
class Film2dNewton {
 public:
  explicit Film2dNewton(const Film2dProblem& problem);
  Film2dNewton(const Film2dNewton&) = delete;  // the block points into the memory
  Film2dNewton& operator=(const Film2dNewton&) = delete;

  struct Outcome {
    bool solved = false;
    int iterations = 0;
    double last_step = 0;      ///< largest relative change of film or pressure in the last iteration [-]
    double peak_pressure = 0;  ///< of the film, given strips and edges included [Pa]
  };
  /// From `state`, at its h_m or from it. `state` receives h_m, pressure and deficit, solved or not.
  Outcome solve(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous, Unknowns unknowns,
                LaneLaws laws, FilmState& state);

 private:
  void set_gap(const Film2dProblem& problem);
  void set_step(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous, LaneLaws laws,
                const FilmState& guess);
  void set_separation(const Film2dInputs& inputs, double h_m);
  void set_given(const Film2dInputs& inputs);
  void give_oil(const models::OilAtTemperature& oil);
  /// Excess of the load carried, and its slope in ln h_m at fixed pressures.
  struct LoadRow {
    double excess, slope;
  };
  LoadRow load_row(const Film2dProblem& problem, const Film2dInputs& inputs, double h_m) const;
  /// Fills step_; returns the change of ln h_m, or nothing if the system was not solved.
  std::optional<double> solve_linear(const LoadRow& load, Unknowns unknowns, double reduction, int iteration);
  bool solve_at(double d_ln_h, double reduction);
  void advance_fronts(bool only_advanced);
  void read(const Film2dProblem& problem, const Film2dInputs& inputs, FilmState& state) const;

  /// Index of strip j in the zebra: strips that are given stand at -1 and n_strips.
  int strip_of(int j) const { return j - first_; }

  const Film2dKernels* kernels_;
  ZebraShape shape_;
  Ends ends_;
  int first_;  ///< the first strip that is solved
  std::vector<double> memory_;
  Film2dBlock block_{};
  std::optional<StripMultigrid> multigrid_;
  Gmres gmres_;
  std::vector<double> step_, rhs_, product_, column_solution_;  ///< zebras, the first two with d ln h_m behind them
  std::vector<double> p_;                                       ///< for laws that are given
  NodalOil oil_;
  double left_ = 1;          ///< of the last linear system [-]
  double border_scale_ = 1;  ///< by which d ln h_m counts among pressures [Pa]
  FrontAdvance fronts_;
};

}  // namespace ringfilm::film
