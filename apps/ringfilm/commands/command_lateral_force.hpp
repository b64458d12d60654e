#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "measurement_outputs.hpp"
#include "ringfilm/instrument/documents/force_sample.hpp"

namespace ringfilm::app {

/// Friction loops as text files, or as scans of an instrument with the load of each.
struct ForceFiles {
  std::vector<std::string> paths;
  std::vector<std::string> loads;  ///< empty: text files
};

/// What `lateral-force` was asked for; exactly one of the three ways to calibrate.
struct LateralForceCommand {
  ForceFiles files;
  std::optional<std::string> name;  ///< name of the sample that scans make
  instrument::ForceRule rule;
  instrument::ScanChannels channels;  ///< empty names: none were stated
  std::optional<ForceFiles> silicon;
  surface::Uncertain reference;  ///< coefficient of friction of silicon
  std::optional<std::string> lever;
  std::vector<std::string> wedge;  ///< two facets
  std::array<surface::Uncertain, 2> wedge_angles_rad{};
  std::optional<std::string> calibration_name;
  std::optional<std::string> sample;  ///< whose fragment is written
  MeasurementOutputs outputs;
};

/// Takes loops to coefficients, prints, writes what was asked for.
void lateral_force(const LateralForceCommand& command);

}  // namespace ringfilm::app
