#pragma once

/// Real area of contact of a random surface after Persson @cite persson2001, eq-persson-area: all waves act together,
/// and neither summits nor their shape enter.
namespace ringfilm::models {

/// Shares of the nominal area [-].
struct PerssonArea {
  double elastic;  ///< in elastic contact
  double plastic;  ///< at the hardness
  double total() const { return elastic + plastic; }
};

/// Elastic contact: erf(sqrt 2 p/(E* h')). @param p on the nominal area, not below 0 [Pa] @param E_star_slope E* h'
/// with the rms slope h', above 0 [Pa]
double persson_area(double p, double E_star_slope);

/// With a hardness at which material flows, the same on all scales. @param p below the hardness
PerssonArea persson_area(double p, double E_star_slope, double hardness);

}  // namespace ringfilm::models
