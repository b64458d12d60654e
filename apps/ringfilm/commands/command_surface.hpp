#pragma once
#include <optional>
#include <string>
#include <vector>

#include "measurement_outputs.hpp"
#include "ringfilm/instrument/documents/surface_measurement.hpp"

namespace ringfilm::app {

/// The contact law of the maps themselves, which `pair` writes next to their numbers.
struct LawRequest {
  std::string path;    ///< --law
  double E_prime;      ///< --composite-modulus [Pa]
  std::size_t shifts;  ///< --shifts
};

/// What `surface` and `pair` were asked for.
struct SurfaceCommand {
  instrument::SurfaceOptions reading;
  instrument::SurfaceAnalysis analysis;
  std::optional<std::string> noise;  ///< file of a flat
  std::optional<LawRequest> law;     ///< of a pair
  MeasurementOutputs outputs;
};

/// Reads a map, measures it, writes what was asked for; of several files the mean and its scatter.
/// @param heights CSV of the heights as read, of one file
void surface(const std::vector<std::string>& paths, const std::optional<std::string>& heights,
             const SurfaceCommand& command);

/// Two surfaces in contact; several files a side.
void pair(const std::vector<std::string>& ring, const std::vector<std::string>& liner, const SurfaceCommand& command);

}  // namespace ringfilm::app
