#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// A measured bore.
struct BoreMapFile {
  cycle::BoreMap map;
  std::string sha256;
  std::vector<std::string> notes;
};

/// What the cycle adds to the bore.
struct DynamicBoreFile {
  cycle::DynamicBore dynamic;
  std::string sha256;
  std::vector<std::string> notes;
};

/// Reads a CSV file with the columns `height [mm],angle [degree],deviation [um]`, all angles of one height and then of
/// the next; angles are evenly spaced over one turn and the same at all heights, which rise. Throws InputError with
/// its faults: holes, angles that are not a whole turn, a last angle that repeats the first with another deviation.
BoreMapFile read_bore_map(const NamedFile& file, const Units& units);

/// Reads a CSV file as read_bore_map does, with `crank_angle [degree]` in place of the height: crank angles over a
/// whole cycle of 720 degree, at most models::kMaxSampleDistanceDeg apart. The last may repeat the first one cycle
/// later. Throws InputError with its faults, also where the repetition differs.
DynamicBoreFile read_dynamic_bore(const NamedFile& file, const Units& units);

/// Pressure around a ring.
struct PressurePointsFile {
  cycle::PressurePoints points;
  std::string sha256;
  std::vector<std::string> notes;
};

/// Reads a CSV file with the columns `angle [degree],pressure [bar]`, angles evenly spaced over one turn. Throws
/// InputError with its faults.
PressurePointsFile read_pressure_points(const NamedFile& file, const Units& units);

}  // namespace ringfilm::io
