#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// Measured viscosity and density of an oil.
struct OilFile {
  cycle::OilTable table;
  std::string sha256;
  std::vector<std::string> notes;
};

/// Reads a CSV file with the columns `temperature [degC],pressure [Pa],viscosity [Pa s],density [kg/m3]`: every
/// pressure at every temperature, rows in any order, two pressures or more, pressures absolute. Throws InputError with
/// its faults.
OilFile read_oil_table(const NamedFile& file, const Units& units);

}  // namespace ringfilm::io
