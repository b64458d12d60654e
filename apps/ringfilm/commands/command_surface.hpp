#pragma once
#include <optional>
#include <string>
#include <vector>

#include "measurement_outputs.hpp"
#include "ringfilm/instrument/documents/surface_measurement.hpp"

namespace ringfilm::app {

/// The contact law of the maps themselves, which `pair` writes next to their numbers.
struct LawRequest {
  std::string path;        ///< --law
  double E_prime = 0;      ///< --composite-modulus [Pa]
  std::size_t shifts = 8;  ///< --shifts
};

/// What `surface` and `pair` have in common.
struct MeasuringCommand {
  instrument::SurfaceOptions reading;
  instrument::SurfaceAnalysis analysis;
  std::optional<std::string> noise;  ///< file of a flat
  MeasurementOutputs outputs;
};

struct SurfaceCommand : MeasuringCommand {
  std::vector<std::string> files;
};
/// Reads a map, measures it, writes what was asked for; of several files the mean and its scatter.
void surface(const SurfaceCommand& command);

struct PairCommand : MeasuringCommand {
  std::vector<std::string> ring, liner;  ///< files
  std::optional<LawRequest> law;
};
/// Two surfaces in contact; several files a side.
void pair(const PairCommand& command);

}  // namespace ringfilm::app
