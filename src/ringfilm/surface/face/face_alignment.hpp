#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/surface/face/face_fit.hpp"

/// The steps from a trace as measured to a gap over the face: docs/theory/face.md.
namespace ringfilm::surface {

/// The trace with heights as a gap. Throws InputError for lists of different lengths, NaN, places that do not rise.
Trace gap_trace(const Trace& trace, HeightSense sense);

/// Start of the window of the face's width under which the gap is least [m].
double found_start(const Trace& gap, double width);

/// The part of the trace from `start` over `width`, from 0 on, with a point on both edges.
Trace window(const Trace& gap, double start, double width);

/// Means of `group` neighbours; the edges stay points of their own.
Trace averaged(const Trace& gap, std::size_t group);

/// The trace without points that lie deeper than its spline by more than `depth`, again and again, since a pore pulls
/// the spline down with it. The edges stay.
Trace without_pores(Trace gap, double depth, double cutoff);

/// First and last point of the running surface.
struct RunningSurface {
  std::size_t first, last;
};

/// The connected part around the lowest point that is at most `running_surface_height` above it.
RunningSurface running_surface_of(const std::vector<double>& smooth, double running_surface_height);

/// Slope of the line through the running surface [-].
double slope_over(const Trace& gap, const RunningSurface& running_surface);

/// Takes a tilt off, about the first point.
void remove_tilt(Trace& gap, double tilt);

}  // namespace ringfilm::surface
