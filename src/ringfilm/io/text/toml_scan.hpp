#pragma once
#include "ringfilm/io/text/source_text.hpp"

namespace ringfilm::io {

/// Refuses what the TOML parser cannot be trusted with: keys that are not ASCII, and keys or lists nested deeper than
/// any case file needs (the parser and its trees recurse). Throws InputError with the place.
void check_before_parsing(const SourceText& source);

}  // namespace ringfilm::io
