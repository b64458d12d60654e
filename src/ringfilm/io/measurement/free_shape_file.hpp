#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// A measured free ring.
struct FreeShapeFile {
  cycle::FreeRing ring;
  std::string sha256;
  std::vector<std::string> notes;
};

/// Reads a CSV file with the columns `angle [degree],radius [mm]` of the running surface of a free ring, from one end
/// to the other, about any centre inside of it. Throws InputError with its faults: angles that do not rise or are more
/// than one turn, radii that are not positive.
FreeShapeFile read_free_shape(const NamedFile& file, const Units& units);

}  // namespace ringfilm::io
