#pragma once

namespace ringfilm::models {

/// Between these temperatures an oil may flow in an engine [K], as the case key operating.oil_temperature has it.
/// Below, where no base oil flows any more, values are degrees Celsius that were not converted; above it burns.
inline constexpr double kColdestOil = 200;
inline constexpr double kHottestOil = 600;

/// Throws InputError unless T [K] lies between both.
void check_oil_temperature(double T);

}  // namespace ringfilm::models
