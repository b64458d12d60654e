#pragma once
#include <span>
#include <vector>

namespace ringfilm::surface {

/// How the laws of single samples lie about their mean, as two numbers: ln p = ln p_mean(h - dh) + ds,
/// eq-law-scatter.
struct LawScatter {
  double shift_variance = 0;  ///< variance of dh [m2]
  double log_variance = 0;    ///< variance of ds [-]
  double covariance = 0;      ///< covariance of dh and ds [m]
  std::size_t samples = 0;    ///< 0 or 1: no scatter

  double shift_deviation() const;  ///< [m]
  double log_deviation() const;    ///< [-]
  double correlation() const;      ///< correlation of dh and ds; 0 where one of them does not scatter [-]
};

/// dh is the shift that fits best alone, by least squares over the separations at which all samples carry; ds is the
/// mean of the remaining residuals. Fitted together both would be almost one number, since ln p is nearly straight.
/// Nothing scatters where the separations are fewer than 3.
/// @param separations_m in any order @param weight of each separation: the number of spots, whose inverse is the
/// variance of ln p @param pressure of each sample at each separation [Pa]
LawScatter law_scatter(std::span<const double> separations_m, std::span<const double> weight,
                       const std::vector<std::vector<double>>& pressure);

/// Total scatter of independent origins: relative positions and regions.
LawScatter operator+(const LawScatter& one, const LawScatter& other);

}  // namespace ringfilm::surface
