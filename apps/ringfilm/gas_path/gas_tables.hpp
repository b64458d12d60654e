#pragma once
#include <string>

#include "ringfilm/io/result/pack_gas.hpp"

namespace ringfilm::app {

/// "2.1 mg per cycle, 1.6 l/min at 1.01325 bar and 25 degC", of one cylinder.
std::string blow_by_text(const gas_path::GasSums& sums);

/// "; back past the first ring 1.7 mg per cycle (0.36 % of the charge)"; empty for a file of an earlier version.
std::string reverse_blow_by_text(const gas_path::GasSums& sums);

// Tables in engineers' units, a line each for a region, a path, a ring in its groove and a change of flank contact.
std::string regions_table(const io::PackGas& gas);
std::string paths_table(const io::PackGas& gas);
std::string composition_table(const io::PackGas& gas);  ///< empty where the gas has no composition
std::string ring_motion_table(const io::PackGas& gas);
std::string ring_events_table(const io::PackGas& gas);

}  // namespace ringfilm::app
