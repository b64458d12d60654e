#include "ringfilm/report/payload/map_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/io/text/base64.hpp"

namespace ringfilm::report {
namespace {

std::size_t block_for(std::size_t points, std::size_t most_points) { return (points + most_points - 1) / most_points; }

void note_points(const io::MeasuredMap& map, MapPicture& picture) {
  picture.points = map.values.size();
  picture.highest.value = -std::numeric_limits<double>::infinity();
  picture.lowest.value = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const double value = map.values[j * map.points_x + i];
      if (!std::isfinite(value)) {
        ++picture.missing_points;
        continue;
      }
      const MapPoint point{static_cast<double>(i) * map.step_x, static_cast<double>(j) * map.step_y, value};
      if (value > picture.highest.value) picture.highest = point;
      if (value < picture.lowest.value) picture.lowest = point;
    }
  }
}

/// Mean of the points of one block, NaN where most of them are missing.
double block_mean(const io::MeasuredMap& map, const MapPicture& picture, std::size_t column, std::size_t row) {
  const std::size_t end_x = std::min(map.points_x, (column + 1) * picture.block_x);
  const std::size_t end_y = std::min(map.points_y, (row + 1) * picture.block_y);
  double sum = 0;
  std::size_t n_all = 0, n_measured = 0;
  for (std::size_t j = row * picture.block_y; j < end_y; ++j) {
    for (std::size_t i = column * picture.block_x; i < end_x; ++i) {
      const double value = map.values[j * map.points_x + i];
      ++n_all;
      if (!std::isfinite(value)) continue;
      sum += value;
      ++n_measured;
    }
  }
  return 2 * n_measured < n_all || n_measured == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                   : sum / static_cast<double>(n_measured);
}

/// The value below which this share of them lies. Reorders them.
double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + std::lround(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

MapPicture map_picture(const io::MeasuredMap& map, std::size_t most_points) {
  MapPicture picture;
  picture.block_x = block_for(map.points_x, most_points);
  picture.block_y = block_for(map.points_y, most_points);
  picture.columns = (map.points_x + picture.block_x - 1) / picture.block_x;
  picture.rows = (map.points_y + picture.block_y - 1) / picture.block_y;
  note_points(map, picture);
  std::vector<double> means, measured;
  for (std::size_t row = 0; row < picture.rows; ++row) {
    for (std::size_t column = 0; column < picture.columns; ++column) {
      means.push_back(block_mean(map, picture, column, row));
      if (!std::isnan(means.back())) measured.push_back(means.back());
    }
  }
  if (measured.empty()) {
    picture.values.assign(means.size(), MapPicture::kMissing);
    return picture;
  }
  constexpr double kBeyondColours = 0.001;
  const auto [low, high] = std::minmax_element(measured.begin(), measured.end());
  picture.low = *low;
  picture.high = *high;
  picture.colour_low = quantile(measured, kBeyondColours);
  picture.colour_high = quantile(measured, 1 - kBeyondColours);
  constexpr double kSteps = MapPicture::kMissing - 1;
  const double range = picture.high - picture.low;
  for (const double mean : means) {
    const double share = range > 0 ? (mean - picture.low) / range : 0;
    picture.values.push_back(std::isnan(mean) ? MapPicture::kMissing
                                              : static_cast<std::uint16_t>(std::lround(kSteps * share)));
  }
  return picture;
}

std::string packed(const std::vector<std::uint16_t>& values) {
  std::string bytes;
  bytes.reserve(2 * values.size());
  for (const std::uint16_t value : values) {
    bytes.push_back(static_cast<char>(value & 0xFF));
    bytes.push_back(static_cast<char>(value >> 8));
  }
  return io::base64(bytes);
}

}  // namespace ringfilm::report
