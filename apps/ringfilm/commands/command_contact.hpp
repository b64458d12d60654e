#pragma once
#include <string>
#include <vector>

#include "measurement_outputs.hpp"
#include "ringfilm/instrument/documents/contact_measurement.hpp"

namespace ringfilm::app {

/// What `contact` was asked for.
struct ContactCommand {
  std::vector<std::string> surfaces;  ///< one file, or two: ring and liner
  instrument::SurfaceOptions reading;
  instrument::ContactAnalysis analysis;
  MeasurementOutputs outputs;
};

/// Computes the contact law of a measured pair and writes what was asked for.
void contact(const ContactCommand& command);

}  // namespace ringfilm::app
