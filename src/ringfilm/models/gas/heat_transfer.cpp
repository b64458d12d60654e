#include "ringfilm/models/gas/heat_transfer.hpp"

#include <cmath>

namespace ringfilm::models {

double woschni_coefficient(double bore, double pressure, double temperature, double velocity) {
  constexpr double kKilopascal = 1e3;
  return 3.26 * std::pow(bore, -0.2) * std::pow(pressure / kKilopascal, 0.8) * std::pow(temperature, -0.55) *
         std::pow(velocity, 0.8);
}

double mass_transfer_coefficient(double alpha, double density, double heat_capacity, double lewis_number) {
  return alpha / (density * heat_capacity * std::cbrt(lewis_number * lewis_number));
}

}  // namespace ringfilm::models
