#pragma once
#include <string>

#include "arguments.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/surface_file.hpp"

namespace ringfilm::python {

/// What a user states of a file, and the name of the argument for errors.
/// @param step_name name of the argument that has the step along x
inline instrument::SurfaceOptions file_options(const GivenMaybeText& height_unit, const GivenMaybeText& lateral_unit,
                                               const char* step_name, const GivenMaybeText& step) {
  instrument::SurfaceOptions options;
  options.height_unit = maybe_text_of("height_unit", height_unit.value, "um");
  options.lateral_unit = maybe_text_of("lateral_unit", lateral_unit.value, "um");
  options.step_x = maybe_text_of(step_name, step.value, "0.5 um");
  options.names = {"channel=1", "height_unit=\"um\"", "lateral_unit=\"um\"", std::string(step_name) + "=\"0.5 um\""};
  return options;
}

/// What a user states of a text: its columns, lines in front of its table, what marks a missing height.
inline io::TableReading table_reading(const GivenMaybeText& columns, const Given<kinds::Integer>& skip_lines,
                                      const Given<kinds::Words>& missing) {
  io::TableReading table;
  table.columns = maybe_text_of("columns", columns.value, "x [um], -, z [um]");
  const int lines = integer_of("skip_lines", skip_lines.value);
  if (lines < 0) {
    throw InputError("skip_lines = " + std::to_string(lines) + " is not a number of lines",
                     "for example skip_lines=12");
  }
  if (lines > 0) table.skip_lines = static_cast<std::size_t>(lines);
  table.missing = words_of("missing", missing.value);
  return table;
}

}  // namespace ringfilm::python
