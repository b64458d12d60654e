#pragma once
#include <limits>

/// What lies at the edges of a film.
namespace ringfilm::film {

/// What the film meets at an edge.
enum class EdgeFluid {
  kOil,  ///< as much oil as the film takes; cavities on this side of the lowest place of the gap are at p_c
  kGas,  ///< gas: cavities on this side are filled with it, at the pressure of the edge
};

/// What passes the narrowest place of the gap while gas of a higher pressure blows through there (eq-broken-film).
enum class BrokenFilm {
  kFreeSurface,    ///< what a film with a free surface on the wall carries against the gas
  kHalfPasses,     ///< half of the gap, as without gas
  kNothingPasses,  ///< a thousandth of the first
};

/// An edge during one step.
struct EdgeState {
  double pressure = 0;  ///< absolute [Pa]
  EdgeFluid fluid = EdgeFluid::kOil;
  /// Oil on the moving wall ahead of an edge of gas at which the film enters: of it no more can enter [kg/m2].
  double supply = std::numeric_limits<double>::infinity();
};

}  // namespace ringfilm::film
