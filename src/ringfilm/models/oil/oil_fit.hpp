#pragma once
#include <array>
#include <memory>
#include <optional>

#include "ringfilm/models/oil/lubricant.hpp"
#include "ringfilm/models/oil/polynomial.hpp"

namespace ringfilm::models {

/// Polynomials that replace an oil's laws in the inner loop, eq-oil-fit: rho/eta, rho and their slopes in pressure
/// over a range of it, in t = (p - centre)/half_width, lowest power first.
/// The slopes have polynomials of their own, shorter than the derivatives would be: they steer the iteration, the
/// values alone decide where it ends.
struct OilFit {
  // What the oils of data/lubricants need between -30 and 180 degC: 7 and 5 powers up to 20 MPa, 10 and 6 up to 80 MPa.
  static constexpr int kFluidityDegree = 10, kFluiditySlopeDegree = 5, kDensityDegree = 6, kDensitySlopeDegree = 3;

  double low, high;                                     ///< range of absolute pressure served [Pa]
  double centre, half_width;                            ///< centre and half width of that range [Pa]
  std::array<double, kFluidityDegree + 1> K;            ///< rho/eta [s/m2]
  std::array<double, kFluiditySlopeDegree + 1> dK_dp;   ///< [s/(m2 Pa)]
  std::array<double, kDensityDegree + 1> rho;           ///< [kg/m3]
  std::array<double, kDensitySlopeDegree + 1> drho_dp;  ///< [kg/(m3 Pa)]
  double error;        ///< largest relative difference of rho/eta and rho from the laws at the check points [-]
  double slope_error;  ///< largest difference of the slopes at the check points, each relative to its largest value [-]

  template <class Value>
  struct Values {
    Value K, dK_dp, rho, drho_dp;
  };

  /// What the polynomials give at an absolute pressure p [Pa] between `low` and `high`.
  template <class Value>
  Values<Value> at(const Value& p) const {
    const Value t = (p - centre) * (1 / half_width);
    return {polynomial(K, t), polynomial(dK_dp, t), polynomial(rho, t), polynomial(drho_dp, t)};
  }
};

inline constexpr double kFitError = 1e-10;      ///< largest `error` of a certified fit [-]
inline constexpr double kFitSlopeError = 1e-4;  ///< largest `slope_error` [-]

/// Fits the laws between two absolute pressures, low < high [Pa], and compares at other points, both ends among them.
/// @returns nothing where the fit is not certified: a difference above kFitError or kFitSlopeError, as a table's
/// monotone cubics leave, or a law without a finite positive value within the range.
std::optional<OilFit> fit_oil(const OilAtTemperature& exact, double low, double high);

/// Oil `exact` with `fit()` from low to high [Pa]; its `properties` remain those of the laws themselves.
/// @returns `exact` where the fit is not certified
std::shared_ptr<const OilAtTemperature> fitted_oil(std::shared_ptr<const OilAtTemperature> exact, double low,
                                                   double high);

/// Oil `exact` with the given fit.
std::shared_ptr<const OilAtTemperature> with_fit(std::shared_ptr<const OilAtTemperature> exact, const OilFit& fit);

/// Largest differences of a fit from the laws at the check points, as in OilFit.
struct FitErrors {
  double value, slope;  ///< [-]
};
/// NaN where the laws have no finite positive value.
FitErrors fit_errors(const OilFit& fit, const OilAtTemperature& exact);

}  // namespace ringfilm::models
