#pragma once
#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// Which edge of a film is meant.
enum class FilmEdge {
  kLeft,  ///< x = 0
  kRight  ///< x = b
};

/// The integral J of eq-gas-holding-limit [1/m]: in steady flow a film that is flooded at its inlet holds
/// int dp/eta = 6 |U| J at most against gas at its exit. The largest over all places of the exit; by Simpson's rule on
/// the cells of the grid. @param h_m smallest film thickness [m]
double gas_holding_integral(const FilmGrid& grid, double h_m, FilmEdge exit);

/// Mean viscosity 1/mean(1/eta) of an oil between two pressures: int dp/eta is their difference over it [Pa s].
double mean_viscosity(const models::OilAtTemperature& oil, double p_low, double p_high);

}  // namespace ringfilm::film
