#pragma once
#include <string>
#include <vector>

/// What the gas models share in refusing their input: an engineer's units and the checks of samples.
namespace ringfilm::models {

std::string in_degrees(double angle);  ///< "12.5 degree"

/// Throws InputError unless the pressures [Pa] are positive and their angles [degree] increase over one cycle at most.
void check_trace(const std::vector<double>& crank_angle_deg, const std::vector<double>& pressure);

/// Throws InputError unless the pressure [Pa] of that key is positive.
void check_gas_pressure(const std::string& key, double pressure);

}  // namespace ringfilm::models
