#pragma once
#include <string>

#include "ringfilm/pad/pad_film.hpp"

namespace ringfilm::pad {

/// What the user must know about this result: how separation and gap add up, a cavitation pressure that was lowered,
/// mass that is not kept, remedies that were used.
void append_notes(const PadFilm& film, PadResult& result);

/// The keys of which more make the grid finer.
const char* cell_keys(const PadSetup& setup);

}  // namespace ringfilm::pad
