#pragma once
#include <vector>

#include "ringfilm/models/gas/gas.hpp"

namespace ringfilm::models {

/// The part of the cycle with open valves; angles in degrees, 0 = firing TDC, increasing in the order of the members.
struct GasExchange {
  double exhaust_from;                       ///< end of the blow-down: from here the exhaust pressure holds
  double overlap_begin, overlap_end;         ///< in between the exhaust pressure goes over into the intake pressure
  double intake_until;                       ///< up to here the intake pressure holds
  double exhaust_pressure, intake_pressure;  ///< [Pa] absolute
};

/// Closes the cycle: the samples of the closed part, then monotone cubics to the exhaust pressure, to the intake
/// pressure and back to the first sample, each with the slope that the closed part has there as far as that is
/// monotone.
/// @param crank_angle_deg two or more, increasing, from above overlap_end - 720 to below exhaust_from
CyclePressure closed_cycle(std::vector<double> crank_angle_deg, std::vector<double> pressure,
                           const GasExchange& exchange);

}  // namespace ringfilm::models
