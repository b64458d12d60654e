#pragma once

/// What lies at the edges of a film.
namespace ringfilm::film {

enum class EdgeFluid {
  kOil,  ///< as much oil as the film takes; cavities on this side of the lowest place of the gap are at p_c
  kGas,  ///< gas: cavities on this side are filled with it, at the pressure of the edge
};

struct EdgeState {
  double pressure = 0;  ///< absolute [Pa]
  EdgeFluid fluid = EdgeFluid::kOil;
  double film_content = 1;  ///< theta at the edge, of gas: 2 f/h at the first face where a film f enters [-]
};

}  // namespace ringfilm::film
