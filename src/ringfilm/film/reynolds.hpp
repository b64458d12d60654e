#pragma once
#include <vector>

#include "ringfilm/base/tridiagonal.hpp"
#include "ringfilm/film/film_state.hpp"

/// The discrete balance of mass on cells (eq-reynolds, eq-discrete-balance): finite volumes around nodes, the gap exact
/// at cell faces, Couette flux with the fill taken upstream, backward Euler. Knows no load.
namespace ringfilm::film {

/// Oil at the nodes for the pressures of a state. (Arrays of n+1.)
struct NodalOil {
  std::vector<double> rho, drho_dp, eta, deta_dp;
  std::vector<double> K, dK_dp;  ///< rho/eta and its slope [s/m2], [s/(m2 Pa)]
  void update(const models::OilAtTemperature& oil, const std::vector<double>& p);
};

/// Mass flux of a solved film through the face between nodes i and i+1, positive in +x [kg/(m s)].
double mass_flux(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state, int i);

/// Fills rows 1..n-1 of the linear system for (z, ln h_m): minus the residual on the right-hand side, its derivatives
/// on the left. `multiplier[i]` weighs z in the cavity of Reynolds exit.
void assemble_balance(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                      const FilmState& state, const NodalOil& oil, double scale, const std::vector<double>& multiplier,
                      base::BorderedTridiagonal& system);

/// The weight of z in the cavity of Reynolds exit: the Poiseuille conductance of the node, so that z is a pressure.
void cavity_multiplier(const FilmProblem& problem, const FilmState& state, const NodalOil& oil,
                       std::vector<double>& multiplier);

/// Oil and rho theta h at every node of a state whose pressure, fill and h_m are solved.
void complete_state(const FilmProblem& problem, const NodalOil& oil, FilmState& state);

}  // namespace ringfilm::film
