#pragma once
#include "ringfilm/pad/pad_result.hpp"
#include "ringfilm/pad/pad_setup.hpp"

namespace ringfilm::pad {

/// What the user must know about this result: how separation and gap add up, a cavitation pressure that was lowered,
/// mass that is not kept, remedies that were used.
void append_notes(const PadSetup& setup, PadResult& result);

}  // namespace ringfilm::pad
