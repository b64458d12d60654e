#pragma once
#include "arguments.hpp"
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

}  // namespace ringfilm::python
