#pragma once
#include "ringfilm/instrument/grid/channel.hpp"

namespace ringfilm::instrument {

/// Increment and offset that an X3P states for heights in floating-point numbers, which are in metres as a rule.
struct X3pFloatScale {
  char type = 'D';  ///< F or D
  double increment = 1;
  double offset = 0;  ///< [m]
};

/// Applies increment and offset, with a doubt, unless the rms height would then lie below the size of an atom: such
/// heights are in metres already, and another doubt reports that they were read as they are.
void apply_float_scale(const X3pFloatScale& scale, ChannelValues& values);

}  // namespace ringfilm::instrument
