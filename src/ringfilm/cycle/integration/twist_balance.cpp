#include "ringfilm/cycle/integration/twist_balance.hpp"

#include <cmath>
#include <numbers>

#include "ringfilm/cycle/integration/sampling.hpp"
#include "ringfilm/film/integrals/film_integrals.hpp"

namespace ringfilm::cycle {
namespace {

/// Moment of film and asperities about the centroid, per length of the bore, eq-section-film-moment [N].
double moment_of_film(const film::FilmProblem& problem, const film::FilmState& state, double centroid_below_edge) {
  const film::FilmGrid& grid = problem.grid;
  double sum = 0;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    double pressure = state.p[i];
    if (problem.contact != nullptr) {
      const bool is_local = problem.contact_spread == film::ContactSpread::kLocal;
      pressure += problem.contact->contact(is_local ? state.h_m + grid.node_height[i] : state.h_m).pressure;
    }
    sum += pressure * (centroid_below_edge - grid.x[i]) * grid.share[i];
  }
  return sum;
}

}  // namespace

double balanced_twist(const Setup& setup, const RingConditions& at, const film::FilmProblem& problem,
                      const film::FilmState& previous, const film::FilmState& state) {
  const models::TwistingRing& ring = *setup.ring.twisting;
  const double length = std::numbers::pi * setup.input.engine.bore;
  const film::FilmIntegrals film = film::film_integrals(problem, at.inputs, previous, state);
  const double boundary = boundary_friction(setup.input.contact, film.asperity_load, film.asperity_area);
  // Boundary friction changes its sign over a small speed, so that the twist is continuous at dead centres.
  const double sliding = std::tanh(at.piston_velocity / setup.input.gas_path.sliding_smoothing_speed);
  const double friction = -length * (sliding * boundary + film.shear_couette - film.shear_poiseuille);
  models::ForceOnRing force = at.on_section;
  force +=
      {friction, friction * ring.friction_arm() + length * moment_of_film(problem, state, ring.centroid_below_edge())};
  return ring.held(force).angle;
}

}  // namespace ringfilm::cycle
