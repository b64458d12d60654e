#pragma once
#include <optional>
#include <string>

#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/surface/face/face_fit.hpp"

namespace ringfilm::instrument {

/// What is reported of a measured ring face: trace, polynomial and spline, where the polynomial invents shape.
/// @param points_file file of the points that the fragment names, relative to it; absent: the fragment has the
/// polynomial
io::Measurement face_measurement(const TraceFile& file, const surface::FaceRule& rule, const surface::FaceFit& fit,
                                 const std::optional<std::string>& points_file);

}  // namespace ringfilm::instrument
