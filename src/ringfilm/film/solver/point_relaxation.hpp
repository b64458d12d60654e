#pragma once
#include <optional>
#include <vector>

#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/reynolds.hpp"

/// The paper's own method of solution (styles2014, section 3.2), kept as a reference and as a yardstick: point
/// relaxation of the pressures (eqs eq-point-relaxation, eq-relaxation-factor) inside a relaxed correction of h_m
/// (eq-load-relaxation). Solves the equations of the coupled Newton (eq-discrete-balance, eq-load-balance) and shares
/// none of its steps.
namespace ringfilm::film {

/// Over-relaxation of the pressures.
struct RelaxationFactor {
  std::optional<double> fixed;  ///< in (0, 2); absent: the best for the pressures as they are
};

/// Scratch memory; one per thread, for any number of problems.
class RelaxationWorkspace {
 public:
  explicit RelaxationWorkspace(RelaxationFactor factor = {}) : factor_(factor) {}

 private:
  friend class PointRelaxation;
  RelaxationFactor factor_;
  NodalOil oil_;
  std::vector<double> theta_, multiplier_;
  std::vector<double> conductance_, couette_;  ///< coefficients of the flow through the faces [kg/(m s Pa)], [kg/(m s)]
  std::vector<double> gain_;                   ///< storage less source of full nodes [kg/(m s)]
  std::vector<double> compliance_;             ///< d(p)/d(imbalance) of a node [m s Pa/kg]
  std::vector<double> kept_;  ///< balancing pressure = kept + from_left p_left + from_right p_right [Pa]
  std::vector<double> from_left_, from_right_;  ///< [-]
};

/// Finds pressure, film content and h_m together such that mass, cavitation and load balance.
///
/// Stops when a sweep changes no pressure by more than `tolerance` times the mean pressure that is to be carried, no
/// film content by more than `tolerance`, and the load is met to `tolerance`. A change per sweep is not an error: what
/// is left is larger by 1/(1 - rate of convergence), about the number of cells over 2 pi at the best factor. The sweeps
/// are counted and bounded; a report that is not `converged` comes within that bound.
///
/// @param previous the state one time step ago; only its `mass_per_area` enters
/// @param state in: first guess; out: the solution if `converged`, else unusable
FilmReport solve_by_point_relaxation(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                                     FilmState& state, RelaxationWorkspace& workspace);

}  // namespace ringfilm::film
