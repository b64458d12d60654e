#pragma once
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/cycle/setup/ring_section.hpp"
#include "ringfilm/io/measurement/measurement.hpp"

namespace ringfilm::io {

/// A value of the section of a ring: one number, or those of its axes in their order.
struct SectionNumbers {
  std::string name;           ///< name of the key in JSON
  std::string unit;           ///< SI
  std::vector<double> value;  ///< a single number, (axial, radial) or (axial, radial, product)
};

/// The values of a section under the names that `section` has in JSON and Python.
std::vector<SectionNumbers> section_numbers(const cycle::SectionValues& section);

/// The same values one by one, for tables.
MeasuredGroup section_group(const cycle::SectionValues& section);

}  // namespace ringfilm::io
