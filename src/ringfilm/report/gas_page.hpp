#pragma once
#include <string>

#include "ringfilm/io/gas_path/gas_path_file.hpp"

namespace ringfilm::report {

/// The gas of a ring pack alone as one self-contained web page: blow-by, the pack at a crank angle, pressures, flows
/// through the end gaps, positions of the rings, inputs and notes. Throws InputError where the file has no gas.
std::string gas_page(const io::GasPathFile& file);

}  // namespace ringfilm::report
