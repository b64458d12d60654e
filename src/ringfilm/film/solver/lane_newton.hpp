#pragma once
#include <memory>
#include <vector>

#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/film/reynolds.hpp"
#include "ringfilm/film/solver/front_advance.hpp"

namespace ringfilm::film {

/// The fits if the oil of the step has them.
LaneLaws best_laws(const FilmInputs& inputs);

enum class Unknowns {
  kFilmAndSeparation,  ///< film and separation, with a separation for each strip where a ring bends
  kFilmAlone,          ///< film at the given separation
};

/// The coupled Newton method for as many films as there are lanes, each at its own iteration of its own step. What
/// happens in one lane depends on no other.
///
/// Method, eqs eq-discrete-balance, eq-load-balance: Newton on (z, ln h_m) with one bordered tridiagonal solve an
/// iteration; a node that would cross the cavitation kink stops at it; a front that only advances is helped along; h_m
/// moves by at most -60 % or +150 % an iteration. A lane has solved its film when an iteration moves nothing across the
/// kink and changes film and pressure by less than sqrt(tolerance): what is left is then of the order of the tolerance,
/// by quadratic convergence.
class LaneNewton {
 public:
  /// @param width 1, or `kernels.width`; @param most_cells of any film in a lane
  LaneNewton(const FilmKernels& kernels, int width, int most_cells);
  LaneNewton(LaneNewton&&) = default;
  LaneNewton& operator=(LaneNewton&&) = default;

  int width() const { return width_; }

  /// The film of `problem` takes the lane; the problem must outlive it there.
  void bind(int lane, const FilmProblem& problem);

  /// Leaves the lane empty.
  void clear(int lane);

  /// A new solve in a bound lane, from `guess`; of `previous` only the `mass_per_area` enters; `inputs` must outlive
  /// the solve. All running lanes must have the same laws and the same way of closing a cavity. A solve with fits fails
  /// at once if the oil of the step has none.
  /// @param h_m where to start from, instead of the guess's [m]; @param laws kGiven: oil and contact as they are, not
  /// their fits
  void start(int lane, const FilmInputs& inputs, const FilmState& previous, const FilmState& guess, double h_m,
             Unknowns unknowns, LaneLaws laws);

  /// The solve just started is one of many in a search for the separation: it ends after fewer iterations, since the
  /// search then tries a film nearer to one that was found, and where it carries far more than the load.
  void limit_search_effort(int lane);

  /// One iteration of all running lanes.
  void iterate();

  /// Nodes that an iteration visits in each lane: those of the longest film.
  int nodes_swept() const { return block_.n_cells + 1; }

  enum class Phase { kIdle, kRunning, kSolved, kFailed };
  Phase phase(int lane) const { return lanes_[lane].phase; }
  int iterations(int lane) const { return lanes_[lane].iterations; }
  double last_step(int lane) const { return lanes_[lane].last_step; }
  /// Largest pressure of the film, edges included [Pa].
  double peak_pressure(int lane) const;

  /// Writes h_m, pressure and deficit of a lane, solved or not.
  void read(int lane, FilmState& state) const;

 private:
  struct Lane {
    const FilmProblem* problem = nullptr;
    const FilmInputs* inputs = nullptr;
    std::shared_ptr<const models::OilAtTemperature> oil;  ///< oil of the last step, whose fit the lane holds
    Phase phase = Phase::kIdle;
    int n_cells = 0;
    int iterations = 0, most_iterations = 0;
    double last_step = 0;
    double enough = 0;        ///< step that ends the iteration [-]
    double thickest = 0;      ///< film that is sought [m]
    double far_too_much = 0;  ///< excess of the load at which a search has seen enough; 0: none [N/m]
    FrontAdvance fronts;
    MeetingPlace meeting_place;
    std::vector<double> z_before;  ///< the iteration, where its step is damped
  };
  double& nodal(double* array, int i, int lane) const { return array[i * width_ + lane]; }
  void clear_from(int lane, int node);
  void set_step(int lane, const FilmInputs& inputs, const FilmState& previous, double h_m, Unknowns unknowns,
                LaneLaws laws);
  void set_edges(int lane);
  void set_oil(int lane, const FilmInputs& inputs);
  void set_contact(int lane);
  void set_polynomials(int lane, const models::FittedContact& law);
  void set_table(int lane, const models::ContactPieces& pieces);
  void clear_contact(int lane);
  void note_laws();
  void set_terms(int lane, const FilmInputs& inputs);
  void set_load_shares(int lane);
  void set_throat(int lane, const Throat& throat);
  void fit_block();
  void evaluate_properties(int lane);
  bool is_damped(int lane) const;
  void keep_contents(int lane);
  void damp_contents(int lane);
  bool has_outlet(int lane) const;
  bool alternates(int lane) const;
  void stop_where_oil_hangs(int lane);
  void conclude(int lane);
  void advance_fronts(int lane, bool only_advanced);

  const FilmKernels* kernels_;
  int width_, most_cells_;
  std::vector<double> memory_;
  std::vector<Lane> lanes_;
  std::vector<double> p_;  ///< pressures of one lane, for laws that are given
  NodalOil oil_;           ///< at these pressures
  LaneBlock block_;
};

}  // namespace ringfilm::film
