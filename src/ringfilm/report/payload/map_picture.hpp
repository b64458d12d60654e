#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ringfilm/io/measurement/measurement.hpp"

namespace ringfilm::report {

/// One point of a map [m] and its value.
struct MapPoint {
  double x = 0, y = 0;
  double value = 0;
};

/// A map as a page carries it: means over blocks of points, in steps of 1/65534 of their range. SI.
struct MapPicture {
  static constexpr std::uint16_t kMissing = 65535;

  std::size_t columns = 0, rows = 0;
  std::size_t block_x = 1, block_y = 1;        ///< points of the map in one of the picture; fewer at the far edges
  double low = 0, high = 0;                    ///< values that 0 and 65534 stand for
  double colour_low = 0, colour_high = 0;      ///< 0.1 % of the picture lie below, 0.1 % above
  std::vector<std::uint16_t> values;           ///< row after row; kMissing where most points of a block are
  std::size_t points = 0, missing_points = 0;  ///< points of the map, and those without a value
  MapPoint highest, lowest;                    ///< single points of the map, before any mean

  bool empty() const { return missing_points == points; }
};

/// @param most_points on a side of the picture
MapPicture map_picture(const io::MeasuredMap& map, std::size_t most_points);

/// The values as base64 of 16-bit words, low byte first.
std::string packed(const std::vector<std::uint16_t>& values);

}  // namespace ringfilm::report
