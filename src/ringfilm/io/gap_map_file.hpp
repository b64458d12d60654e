#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/io/csv_file.hpp"
#include "ringfilm/io/units.hpp"

/// The gap of a pad over x and y, from a table of points or from NetCDF.
namespace ringfilm::io {

/// A full rectangle of points.
struct GapMap {
  std::vector<double> x, y;    ///< [m], increasing; twice where the gap has a step
  std::vector<double> height;  ///< for each x of the first y, then of the next [m]
};

inline constexpr std::size_t kMostGapPlaces = 4096;  ///< in each direction

/// Tells what is wrong with places along one axis of a gap: one that falls, one that comes three times, a step at an
/// end, where no film lies beyond.
/// @param mark_of where the place of that number stands in the file
void check_gap_places(const std::string& name, const std::vector<double>& places,
                      const std::function<SourceMark(std::size_t)>& mark_of, std::vector<Fault>& faults);

/// The points of a table with the columns `x [mm],y [mm],h [um]` (or `height`): all x of one y, then of the next, or
/// all y of one x, then of the next. Throws InputError with its faults: columns, places, points that make no full
/// rectangle, more than `kMostGapPlaces` of x or y.
GapMap gap_map_of(const CsvFile& csv, const Units& units);

/// Is the file one of NetCDF, by its first bytes?
bool is_netcdf(const std::string& path);

struct GapMapFile {
  GapMap map;
  std::string sha256;
};

/// Reads the variable `h(y, x)` (or `height`) and the coordinates `x` and `y`, each with the attribute `units`. Throws
/// InputError with its faults: the above, values that are missing or not finite.
GapMapFile read_gap_netcdf(const NamedFile& file, const Units& units);

}  // namespace ringfilm::io
