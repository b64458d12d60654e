#pragma once
#include <vector>

#include "ringfilm/instrument/documents/surface_measurement.hpp"

/// The pictures and tables that a metrologist expects of a surface.
namespace ringfilm::instrument {

io::MeasuredMap height_map(const PreparedSurface& surface, const std::string& name);
io::MeasuredCurve profile_curve(const PreparedSurface& surface);
io::MeasuredCurve material_ratio_curve(const std::vector<double>& falling_heights_m);
io::MeasuredCurve spectrum_curve(const PreparedSurface& surface);

/// Parameters of a surface alone against the short cut-off: m4, N and beta have no value without it.
io::MeasuredTable scale_table(const PreparedSurface& surface, const SurfaceAnalysis& analysis);
/// Parameters against the short cut-off, relative to their values without cut-off, with a mark at the cut-off in use.
io::MeasuredCurve scale_curve(const io::MeasuredTable& table, const SurfaceAnalysis& analysis);

}  // namespace ringfilm::instrument
