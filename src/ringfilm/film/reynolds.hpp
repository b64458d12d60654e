#pragma once
#include <span>
#include <vector>

#include "ringfilm/film/film_state.hpp"

/// Parts of the discrete balance of mass on cells (eq-reynolds, eq-discrete-balance) of a film at hand; the balance as
/// Newton's method needs it is defined in newton_sweep.hpp.
namespace ringfilm::film {

/// Oil at the nodes for the pressures of a state. (Arrays of n+1.)
struct NodalOil {
  std::vector<double> rho, drho_dp, eta, deta_dp;
  std::vector<double> K, dK_dp;  ///< rho/eta and its slope [s/m2], [s/(m2 Pa)]
  void update(const models::OilAtTemperature& oil, std::span<const double> p);
};

/// Does an iteration go to pressures at which viscosity grows until neither is a number? Such a film is too thin for
/// its load. @param p_low,p_high the lowest and the highest pressure in the film [Pa]
bool runs_away(const models::OilAtTemperature& oil, double p_low, double p_high);

/// Has viscosity run away in a film that was found? Where oil is a glass, neither the laws nor Reynolds' equation hold.
bool is_glass(const models::OilAtTemperature& oil, double p_low, double p_high);

/// Is a film that was found one of a liquid? If not, the failure in its report is kRunsAway.
bool accept(const models::OilAtTemperature& oil, double p_cavitation, const FilmState& solved, FilmReport& report);

/// A search for the separation has failed: kOverloaded below the size of an atom, kRunsAway if viscosity has begun to
/// run away in the last film that was found, else kNotConverged; overloads and lift-offs remain. With little patience a
/// film that was not found may exist next to one in which viscosity rises but is not yet that of a solid.
/// @param p_cavitation [Pa]
void explain_failure(const models::OilAtTemperature& oil, double p_cavitation, const FilmState& found,
                     Patience patience, FilmReport& report);

/// Viscosity of the oil at a pressure, by the laws that a solved film holds, without shear [Pa s].
double viscosity_at(const models::OilAtTemperature& oil, LaneLaws laws, double p);
/// Density of the oil at a pressure, by the laws that a solved film holds [kg/m3].
double density_at(const models::OilAtTemperature& oil, LaneLaws laws, double p);

/// Mass flux of a solved film through the face between nodes i and i+1, positive in +x [kg/(m s)].
double mass_flux(const FilmView& view, const FilmInputs& inputs, const FilmState& state, int i);

/// The weights of z in the cavity of Reynolds exit (multiplier_weight()) of the inner nodes.
void cavity_multiplier(const FilmProblem& problem, const FilmState& state, const NodalOil& oil,
                       std::vector<double>& multiplier);

/// rho theta h at every node of a state whose pressure, film content and h_m are solved with `inputs`.
/// @param laws kFitted: by the fits that the oil must have
void complete_state(const FilmProblem& problem, const FilmInputs& inputs, LaneLaws laws, FilmState& state);

/// The state as the kernels see it.
FilmView film_view(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state);
/// View of an oil that has fits, as the kernels see it.
FittedOilView fitted_oil_view(const models::OilAtTemperature& oil);

}  // namespace ringfilm::film
