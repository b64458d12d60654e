#pragma once
#include <string>

#include "measurement_outputs.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/surface/face/face_fit.hpp"

namespace ringfilm::app {

enum class FaceAs { kPolynomial, kPoints };

/// What `face` was asked for.
struct FaceCommand {
  std::string trace;
  instrument::SurfaceOptions reading;
  surface::FaceRule rule;
  FaceAs as = FaceAs::kPolynomial;  ///< what the fragment gives to a case; points are in a CSV file beside it
  MeasurementOutputs outputs;
};

/// Fits a measured trace, prints, writes what was asked for.
void face(const FaceCommand& command);

}  // namespace ringfilm::app
