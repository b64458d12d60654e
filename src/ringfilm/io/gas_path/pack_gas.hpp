#pragma once
#include <string>
#include <vector>

#include "ringfilm/gas_path/result.hpp"

namespace ringfilm::io {

/// The gas of a ring pack over a cycle, as a result of its film has it.
struct PackGas {
  /// The net mass along a path in a cycle.
  struct Path {
    std::string name;           ///< "end gap 1", "above ring 1", ...
    double mass_per_cycle = 0;  ///< [kg]
  };
  /// A change of flank contact.
  struct Event {
    long ring = 0;               ///< from 1
    double crank_angle_deg = 0;  ///< 0 to 720 [degree]
    std::string event;           ///< "leaves-lower", ...
  };

  /// A compression ring, which moves in its groove.
  struct Ring {
    long number = 0;  ///< from 1
  };

  std::vector<gas_path::RegionValues> regions;  ///< the chamber first, the crankcase last
  std::vector<Path> paths;
  std::vector<Event> events;
  std::vector<Ring> rings;              ///< in the order of `position`
  std::vector<double> crank_angle_deg;  ///< 0 to 719 [degree]
  // row by row of the crank angles
  std::vector<double> pressure;  ///< of each region [Pa]
  std::vector<double> flow;      ///< along each path [kg/s]
  std::vector<double> position;  ///< of each compression ring above its lower flank [m]
  double blow_by_per_cycle = 0;  ///< [kg]
  double blow_by_flow = 0;       ///< at 25 degC and standard atmosphere [m3/s]
  double mass_defect = 0;        ///< of the cycle [-]
  double periodicity_error = 0;  ///< largest relative change of a pressure from one cycle to the next [-]
};

/// The same of what was computed. @param gas_constant [J/(kg K)]
PackGas pack_gas(const gas_path::GasPathResult& result, double gas_constant);

}  // namespace ringfilm::io
