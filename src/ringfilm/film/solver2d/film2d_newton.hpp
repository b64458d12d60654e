#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "ringfilm/film/film2d.hpp"
#include "ringfilm/film/reynolds.hpp"
#include "ringfilm/film/solver/front_advance.hpp"
#include "ringfilm/film/solver/lane_newton.hpp"
#include "ringfilm/film/solver2d/border.hpp"
#include "ringfilm/film/solver2d/gmres.hpp"
#include "ringfilm/film/solver2d/strip_multigrid.hpp"

namespace ringfilm::film {

/// Newton's method on pressure and film content of all nodes of a two-dimensional film and on ln h_m, or on separation
/// and slope of a ring that bends (docs/theory/two-dimensional-film.md, "the solver"). Nodes stop at the kink, fronts
/// that only advance are helped along each strip, h_m moves by at most -60 % or +150 % an iteration, as in LaneNewton.
/// With a ring that bends, this limit applies to the film of each strip.
class Film2dNewton {
 public:
  explicit Film2dNewton(const Film2dProblem& problem);
  Film2dNewton(const Film2dNewton&) = delete;  // the block points into the memory
  Film2dNewton& operator=(const Film2dNewton&) = delete;

  struct Outcome {
    bool solved = false;
    int iterations = 0;
    double last_step = 0;      ///< largest relative change of film or pressure in the last iteration [-]
    double peak_pressure = 0;  ///< largest pressure of the film, given strips and edges included [Pa]
  };
  /// From `state`, at its separation or from it. `state` receives separation, pressure and deficit, solved or not.
  Outcome solve(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous, Unknowns unknowns,
                LaneLaws laws, FilmState& state);

 private:
  void set_gap(const Film2dProblem& problem);
  void set_step(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous, LaneLaws laws,
                const FilmState& guess);
  void set_separation(const Film2dProblem& problem, const Film2dInputs& inputs);
  void set_lowest();
  void set_given(const Film2dInputs& inputs);
  void set_factors(const FlowFactors* factors);
  void give_oil(const models::OilAtTemperature& oil);
  /// Excess of what is carried over the load, and its slopes in the border's unknowns at fixed pressures.
  void set_loads(const Film2dProblem& problem, const Film2dInputs& inputs);
  void set_load_of_rigid_ring(const Film2dProblem& problem, const Film2dInputs& inputs);
  void set_loads_of_beam(const Film2dProblem& problem, const Film2dInputs& inputs);
  /// Fills step_ and border_step_; false if the system was not solved.
  bool solve_linear(Unknowns unknowns, double reduction, int iteration);
  void prepare_multigrid(int iteration);
  /// At the border's step.
  bool solve_at_border_step(double reduction);
  bool limit_border_step();
  bool limit_step_of_beam();
  double change_of_strip(int j) const;  ///< change of the strip's separation in the border's step [m]
  double largest_move() const;          ///< largest relative move in the border's step [-]
  bool has_film_everywhere() const;
  void move_border(const Film2dProblem& problem, const Film2dInputs& inputs);
  void advance_fronts(bool only_advanced);
  void read(const Film2dProblem& problem, const Film2dInputs& inputs, FilmState& state) const;

  /// Index of strip j in the zebra: strips that are given have the indices -1 and n_strips.
  int strip_of(int j) const { return j - first_; }

  const Film2dKernels* kernels_;
  ZebraShape shape_;
  Ends ends_;
  int first_;  ///< the first strip that is solved
  std::vector<double> memory_;
  Film2dBlock block_{};
  std::optional<StripMultigrid> multigrid_;
  Gmres gmres_;
  ElasticRing elastic_;
  double closed_;  ///< closed_film() [m]
  RigidBorder rigid_border_;
  std::optional<BeamBorder> beam_border_;
  Border* border_;
  std::vector<double> step_, rhs_, product_;  ///< zebras, the first two with the border's step behind them
  std::vector<double> excess_, border_step_;  ///< residuals of the border's equations [N/m]; step of its unknowns
  double h_m_ = 0;
  std::vector<double> ring_;         ///< unknowns of a ring that bends, over h_m [m]
  std::vector<double> rise_;         ///< rise of each strip over h_m; empty: none [m]
  std::vector<double> lowest_;       ///< height of the gap at each strip [m]
  std::vector<double> strip_loads_;  ///< loads of the strips' films, in the order of the block [N/m]
  std::vector<double> p_;            ///< for laws that are given
  NodalOil oil_;
  double left_ = 1;          ///< reduction of the residual of the last linear system [-]
  int krylov_ = 0;           ///< iterations of GMRES that it took
  int krylov_prepared_ = 0;  ///< iterations of GMRES for the system for which the multigrid was prepared
  double border_scale_ = 1;  ///< by which the border's step counts among pressures [Pa]
  FrontAdvance fronts_;
};

}  // namespace ringfilm::film
