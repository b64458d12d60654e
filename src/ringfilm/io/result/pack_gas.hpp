#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/gas_path/result.hpp"

namespace ringfilm::io {

/// The gas of a ring pack over a cycle, as results and their files have it.
struct PackGas {
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

  gas_path::GasSums sums;
  std::optional<double> cylinders;              ///< number of cylinders of the engine, where it is stated
  std::vector<gas_path::RegionValues> regions;  ///< the chamber first, the crankcase last
  std::vector<gas_path::PathValues> paths;
  std::vector<Event> events;
  std::vector<Ring> rings;  ///< in the order of `position`
  /// Motion of each of `rings`; empty for a file of an earlier version.
  std::vector<gas_path::RingMotionValues> motion;
  std::vector<gas_path::ScalarValues> scalars;  ///< empty where the gas has no composition
  std::vector<double> crank_angle_deg;          ///< 0 to 719 [degree]
  // row by row of the crank angles
  std::vector<double> pressure;  ///< pressure of each region [Pa]
  std::vector<double> flow;      ///< flow along each path [kg/s]
  std::vector<double> share;     ///< mass share of each scalar in each region [-]
  std::vector<double> position;  ///< position of each compression ring above its lower flank [m]
};

/// The gas of a computed result. @param gas_constant [J/(kg K)] @param cylinders of the engine, where it is stated
PackGas pack_gas(const gas_path::GasPathResult& result, double gas_constant,
                 std::optional<double> cylinders = std::nullopt);

}  // namespace ringfilm::io
