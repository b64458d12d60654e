#pragma once

/// What lies at the edges of a film.
namespace ringfilm::film {

/// What the film meets at an edge.
enum class EdgeFluid {
  kOil,  ///< as much oil as the film takes; cavities on this side of the lowest place of the gap are at p_c
  kGas,  ///< gas: cavities on this side are filled with it, at the pressure of the edge
};

/// An edge during one step.
struct EdgeState {
  double pressure = 0;  ///< absolute [Pa]
  EdgeFluid fluid = EdgeFluid::kOil;
  double film_content = 1;  ///< theta at an edge of gas; where a film f enters, 2 f/h with h of the first face [-]
};

}  // namespace ringfilm::film
