#pragma once
#include <optional>
#include <string>
#include <vector>

#include "measurement_outputs.hpp"
#include "ringfilm/instrument/documents/surface_measurement.hpp"

namespace ringfilm::app {

/// What `surface` and `pair` were asked for.
struct SurfaceCommand {
  instrument::SurfaceOptions reading;
  instrument::SurfaceAnalysis analysis;
  std::optional<std::string> noise;  ///< file of a flat
  MeasurementOutputs outputs;
};

/// Reads a map, measures it, writes what was asked for; of several files the mean and its scatter.
/// @param heights CSV of the heights as read, of one file
void surface(const std::vector<std::string>& paths, const std::optional<std::string>& heights,
             const SurfaceCommand& command);

/// Two surfaces in contact; several files a side.
void pair(const std::vector<std::string>& ring, const std::vector<std::string>& liner, const SurfaceCommand& command);

}  // namespace ringfilm::app
