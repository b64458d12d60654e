#pragma once
#include "ringfilm/instrument/grid/channel.hpp"

namespace ringfilm::instrument {

/// Interpolates a profile of uneven places linearly to as many even ones. Places in holes of more than three steps, and
/// next to a missing point, are missing. A note states by how much the result, interpolated back, differs from the
/// heights as they were measured.
/// @param values heights in metres, x rising
void resample_evenly(ChannelValues& values);

}  // namespace ringfilm::instrument
