#include "ringfilm/models/oil/oil_of_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

constexpr double kDifference = 1e5;  // [Pa]

/// To second order, without asking below the zero of pressures; exactly 0 for a law that does not change.
double slope(const PropertyOfPressure& law, double p, double value) {
  if (p >= kDifference) return (law(p + kDifference) - law(p - kDifference)) / (2 * kDifference);
  return (4 * (law(p + kDifference) - value) - (law(p + 2 * kDifference) - value)) / (2 * kDifference);
}

class OilOfFunctions final : public OilAtTemperature {
 public:
  OilOfFunctions(PropertyOfPressure viscosity, PropertyOfPressure density)
      : viscosity_(std::move(viscosity)), density_(std::move(density)) {}

  void properties(std::span<const double> p, OilProperties out) const override {
    for (std::size_t i = 0; i < p.size(); ++i) {
      out.rho[i] = density_(p[i]);
      out.drho_dp[i] = slope(density_, p[i], out.rho[i]);
      out.eta[i] = viscosity_(p[i]);
      out.deta_dp[i] = slope(viscosity_, p[i], out.eta[i]);
    }
  }

 private:
  PropertyOfPressure viscosity_, density_;
};

constexpr int kPlaces = 33;  // at which an oil is checked
using AtPlaces = std::array<double, kPlaces>;

void check_values(const AtPlaces& value, const AtPlaces& p, const char* property, const char* unit) {
  for (int i = 0; i < kPlaces; ++i) {
    if (std::isfinite(value[i]) && value[i] > 0) continue;
    throw InputError("the oil's own law gives a " + std::string(property) + " of " + number_text(value[i]) + " " +
                         unit + " at " + text_in(p[i], kMegapascal),
                     "let it give a positive number from 0 to four times the largest mean pressure on the face");
  }
}

/// @param after the same property a little further on, at p + step
void check_slopes(const AtPlaces& value, const AtPlaces& after, const AtPlaces& slope, const AtPlaces& p, double step,
                  const char* property) {
  // Tolerance over the largest slope: a table's corners pass, a wrong sign or unit does not.
  constexpr double kSteepness = 0.01;
  // What rounding leaves in a difference of the values.
  constexpr double kRounding = 1e-12;
  double largest = 0;
  for (int i = 0; i < kPlaces; ++i) largest = std::max(largest, std::abs(after[i] - value[i]) / step);
  for (int i = 0; i < kPlaces; ++i) {
    const double by_values = (after[i] - value[i]) / step;
    const double let_through = kSteepness * largest + kRounding * value[i] / step;
    if (std::isfinite(slope[i]) && std::abs(slope[i] - by_values) <= let_through) continue;
    throw InputError("the oil's own law gives a slope of " + std::string(property) + " of " + number_text(slope[i]) +
                         " per Pa at " + text_in(p[i], kMegapascal) + ", but its values there rise by " +
                         number_text(by_values) + " per Pa",
                     "let OilProperties hold the derivatives of the values with respect to pressure, in SI");
  }
}

}  // namespace

std::shared_ptr<const OilAtTemperature> oil_of_functions(PropertyOfPressure viscosity, PropertyOfPressure density) {
  if (!viscosity || !density) {
    throw InputError("an oil of functions lacks its viscosity or its density", "give both functions");
  }
  return std::make_shared<OilOfFunctions>(std::move(viscosity), std::move(density));
}

void check_oil(const OilAtTemperature& oil, double low, double high) {
  const double step = 1e-5 * (high - low);
  AtPlaces p, p_after, rho, drho_dp, eta, deta_dp, rho_after, eta_after, unused_rho, unused_eta;
  for (int i = 0; i < kPlaces; ++i) {
    p[i] = low + (high - low) * i / (kPlaces - 1);
    p_after[i] = p[i] + step;
  }
  oil.properties(p, {rho, drho_dp, eta, deta_dp});
  oil.properties(p_after, {rho_after, unused_rho, eta_after, unused_eta});
  check_values(rho, p, "density", "kg/m3");
  check_values(rho_after, p_after, "density", "kg/m3");
  check_values(eta, p, "viscosity", "Pa.s");
  check_values(eta_after, p_after, "viscosity", "Pa.s");
  check_slopes(rho, rho_after, drho_dp, p, step, "density");
  check_slopes(eta, eta_after, deta_dp, p, step, "viscosity");
}

}  // namespace ringfilm::models
