#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// A measured ring face.
struct FaceFile {
  std::vector<double> x;       ///< [m], increasing
  std::vector<double> height;  ///< [m]
  std::string sha256;
  std::vector<std::string> notes;
};

/// Reads a CSV file with the columns `x [mm],height [um]` in any units of length. Throws InputError with its faults.
FaceFile read_face(const NamedFile& file, const Units& units);

}  // namespace ringfilm::io
