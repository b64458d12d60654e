#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"

/// The two tables of a pad: its gap, and how its separation changes.
namespace ringfilm::io {

struct GapFile {
  std::vector<double> x;       ///< places along x [m], increasing; twice where the gap has a step
  std::vector<double> y;       ///< places along y of a map [m], increasing; twice where the gap has a step; else empty
  std::vector<double> height;  ///< gap at each x [m]; in a map at each x of the first y, then of the next
  std::string sha256;
  std::vector<std::string> notes;
};

/// Reads a CSV file with the columns `x [mm],h [um]` (or `height`) in any units of length; with a column y, or from
/// NetCDF, a map (gap_map_file.hpp). Throws InputError with its faults: an x that falls, one that comes three times, a
/// step at an end.
GapFile read_gap(const NamedFile& file, const Units& units);

struct SeparationHistory {
  std::vector<double> time;        ///< [s], increasing
  std::vector<double> separation;  ///< as many [m]
  std::string sha256;
  std::vector<std::string> notes;
};

/// Reads a CSV file with the columns `time [s],h [um]` (or `separation`). Throws InputError with its faults.
SeparationHistory read_separation_history(const NamedFile& file, const Units& units);

}  // namespace ringfilm::io
