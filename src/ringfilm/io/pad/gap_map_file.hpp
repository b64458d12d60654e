#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/table/csv_file.hpp"
#include "ringfilm/io/text/units.hpp"

/// The gap of a pad over x and y, from a table of points or from NetCDF.
namespace ringfilm::io {

/// A full rectangle of points.
struct GapMap {
  std::vector<double> x, y;    ///< [m], increasing; twice where the gap has a step
  std::vector<double> height;  ///< for each x of the first y, then of the next [m]
};

inline constexpr std::size_t kMaxGapPlaces = 4096;  ///< in each direction

inline constexpr double kMaxGap = 1;  ///< [m]; what is thicker is a mistake of units or of a file

/// What can be wrong with places along one axis of a gap.
enum class PlaceFault {
  kFalls,       ///< below the one before
  kThreeTimes,  ///< twice is a step
  kStepAtEnd,   ///< where no film lies beyond
};

/// The first place that is wrong, and what it is.
struct WrongPlace {
  std::size_t index;
  PlaceFault fault;
};
std::optional<WrongPlace> wrong_place(const std::vector<double>& places);

/// Reports what is wrong with places that are in a column.
/// @param mark_of where that number is in the file
void check_gap_column(const std::string& name, const std::vector<double>& places,
                      const std::function<SourceMark(std::size_t)>& mark_of, std::vector<Fault>& faults);

/// The first height that is beyond `kMaxGap`, whichever its sign.
std::optional<std::size_t> implausible_height(const std::vector<double>& heights);

/// What is reported of one, and what to do.
std::string implausible_height_text(double height);
inline constexpr const char* kImplausibleHeightRemedy =
    "a gap beyond 1 m is refused: look at the unit, and for a number that marks a hole";

/// Reports a height that is beyond `kMaxGap` at its place in the column.
void check_height_column(const CsvFile& csv, const std::string& name, const std::vector<double>& heights,
                         std::vector<Fault>& faults);

/// The points of a table with the columns `x [mm],y [mm],h [um]` (or `height`): all x of one y, then of the next, or
/// all y of one x, then of the next. Throws InputError with its faults: columns, places, points that make no full
/// rectangle, more than `kMaxGapPlaces` of x or y, a height beyond `kMaxGap`.
GapMap gap_map_of(const CsvFile& csv, const Units& units);

/// Is the file NetCDF of any format, by its first bytes?
bool is_netcdf(const std::string& path);

struct GapMapFile {
  GapMap map;
  std::string sha256;
};

/// Reads the variable `h(y, x)` (or `height`) and the coordinates `x` and `y`, each with the attribute `units`. Throws
/// InputError with its faults: the above, a classic format instead of NetCDF-4, values that are missing or not finite;
/// one that was never written, which holds its type's default fill, is missing.
GapMapFile read_gap_netcdf(const NamedFile& file, const Units& units);

}  // namespace ringfilm::io
