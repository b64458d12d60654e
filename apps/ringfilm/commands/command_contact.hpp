#pragma once
#include <optional>
#include <string>
#include <vector>

#include "measurement_outputs.hpp"
#include "ringfilm/instrument/documents/contact_measurement.hpp"

namespace ringfilm::app {

/// What `contact` was asked for.
struct ContactCommand {
  std::optional<std::string> case_path;  ///< the law of a case instead of that of maps
  std::vector<io::Override> settings;    ///< of its keys
  std::vector<double> lambda;            ///< at which it is tabulated
  std::vector<std::string> surfaces;     ///< one file, or two: ring and liner
  instrument::SurfaceOptions reading;
  instrument::ContactAnalysis analysis;
  MeasurementOutputs outputs;
};

/// Computes the contact law of a measured pair, or that of a case, and writes what was asked for.
void contact(const ContactCommand& command);

}  // namespace ringfilm::app
