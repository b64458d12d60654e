#pragma once
#include <cstdio>
#include <string>

#include "ringfilm/pad/pad_film.hpp"

namespace ringfilm::pad {

/// A sentence with figures, for notes and stops; up to 511 characters.
template <typename... Values>
std::string text(const char* format, Values... values) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

/// What the user must know about this result: how separation and gap add up, a cavitation pressure that was lowered,
/// mass that is not kept, remedies that were used.
void append_notes(const PadFilm& film, PadResult& result);

/// The keys of which more make the grid finer.
const char* cell_keys(const PadSetup& setup);

}  // namespace ringfilm::pad
