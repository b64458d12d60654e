#pragma once
#include <optional>
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"

namespace ringfilm::instrument {

/// Heights as text with the header of an instrument's program: Keyence and Olympus CSV, lists of points of Alicona
/// (GPoint3DVector), phase maps with `h= w=` and a height conversion factor. Nothing for any other text. Throws
/// InputError.
/// @param file name for messages
/// @param text UTF-8
std::optional<InstrumentFile> read_trade_table(const std::string& file, const std::string& text);

}  // namespace ringfilm::instrument
