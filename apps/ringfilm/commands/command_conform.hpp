#pragma once
#include <string>
#include <vector>

#include "measurement_outputs.hpp"

namespace ringfilm::app {

/// What `conform` was asked for.
struct ConformCommand {
  std::string case_path;
  std::vector<io::Override> settings;  ///< of its keys
  MeasurementOutputs outputs;
};

/// Computes the static closure of the ring of a case in its bore, and writes what was asked for.
void conform(const ConformCommand& command);

}  // namespace ringfilm::app
