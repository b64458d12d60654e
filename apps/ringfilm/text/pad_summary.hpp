#pragma once
#include <string>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/pad/pad_output.hpp"

namespace ringfilm::app {

/// The numbers of a pad for people, in engineer's units.
std::string pad_summary(const cycle::Case& input, const io::PadDocument& document);

}  // namespace ringfilm::app
