#include "ringfilm/surface/topography/roughness.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/regions.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kMinPointsOfRoughness = 4;
constexpr std::size_t kMinPointsOfARow = 8;
constexpr std::size_t kUsualSamplingLengths = 5;  // sampling lengths per evaluation length, ISO 21920-2 and ISO 4287

/// Calls visit(heights of the measured points) row by row.
template <class Visit>
void visit_rows(const HeightMap& map, const Visit& visit) {
  Eigen::ArrayXd kept(static_cast<Eigen::Index>(map.points_x));
  for (std::size_t j = 0; j < map.points_y; ++j) {
    Eigen::Index count = 0;
    for (std::size_t i = map.index(0, j); i < map.index(0, j + 1); ++i) {
      kept[count] = map.height_m[i];
      count += map.measured(i);
    }
    if (count > 0) visit(kept.head(count));
  }
}

[[noreturn]] void refuse_huge(const char* what) {
  throw InputError("the heights of the map are so large that " + std::string(what) + " cannot be expressed as numbers",
                   "heights are in metres");
}

struct Extent {
  double mean_m, lowest_m, highest_m;
};

/// Mean, lowest and highest of the measured points; the mean is summed row by row about the first of them.
Extent extent(const HeightMap& map, std::size_t measured) {
  double reference = 0, sum = 0;
  bool first = true;
  Extent of{};
  visit_rows(map, [&](const auto& heights) {
    if (first) of = {0, heights[0], heights[0]};
    if (first) reference = heights[0];
    first = false;
    of.lowest_m = std::min(of.lowest_m, heights.minCoeff());
    of.highest_m = std::max(of.highest_m, heights.maxCoeff());
    sum += (heights - reference).sum();
  });
  of.mean_m = reference + sum / static_cast<double>(measured);
  return of;
}

}  // namespace

HeightStatistics height_statistics(const HeightMap& map) {
  check_map(map, kMinPointsOfRoughness);
  HeightStatistics of;
  of.points = measured_points(map);
  of.missing = map.points() - of.points;
  const Extent range = extent(map, of.points);
  of.mean_m = range.mean_m;
  of.Sp_m = range.highest_m - of.mean_m;
  of.Sv_m = of.mean_m - range.lowest_m;
  of.Sz_m = range.highest_m - range.lowest_m;
  if (!(of.Sz_m > 0)) {
    throw InputError("all heights of the map are the same: it has no roughness", "choose another channel or region");
  }
  if (!std::isfinite(of.Sz_m)) refuse_huge("their range");
  // In units of Sz, so that no power of a height in metres runs out of range.
  double absolute = 0, squares = 0, cubes = 0, fourths = 0;
  Eigen::ArrayXd z, square;
  visit_rows(map, [&](const auto& heights) {
    z = (heights - of.mean_m) / of.Sz_m;
    square = z.square();
    absolute += z.abs().sum();
    squares += square.sum();
    cubes += (square * z).sum();
    fourths += square.square().sum();
  });
  const double count = static_cast<double>(of.points), variance = squares / count;
  of.Sa_m = absolute / count * of.Sz_m;
  of.Sq_m = std::sqrt(variance) * of.Sz_m;
  of.Ssk = cubes / count / (variance * std::sqrt(variance));
  of.Sku = fourths / count / (variance * variance);
  return of;
}

SampledHeights sampled_heights(const HeightMap& profile, std::optional<double> sampling_length_m) {
  check_map(profile, kMinPointsOfRoughness);
  if (!profile.is_profile()) {
    throw InputError("a map of several rows has no sampling lengths", "choose a profile, or use Sz of the map");
  }
  const double all = static_cast<double>(profile.points_x);
  const double each = sampling_length_m ? *sampling_length_m / profile.step_x_m : all / kUsualSamplingLengths;
  constexpr double kRounding = 1e-9;
  SampledHeights of;
  of.sampling_length_m = each * profile.step_x_m;
  of.count = each > 0 && each <= all * (1 + kRounding) ? static_cast<std::size_t>(all / each * (1 + kRounding)) : 0;
  const std::string name = "a sampling length of " + length_text(of.sampling_length_m);
  if (of.count == 0) {
    throw InputError(name + " does not fit into a profile of " + length_text(all * profile.step_x_m),
                     "take a shorter long cut-off, or measure a longer profile");
  }
  const double start = (all - static_cast<double>(of.count) * each) / 2;
  const auto edge = [&](std::size_t k) {
    return static_cast<std::size_t>(std::clamp(std::round(start + static_cast<double>(k) * each), 0.0, all));
  };
  const double mean = extent(profile, measured_points(profile)).mean_m;
  for (std::size_t k = 0; k < of.count; ++k) {
    const std::size_t points = edge(k + 1) - edge(k);
    const HeightMap part = points < 2 ? HeightMap() : part_of_map(profile, {edge(k), 0, points, 1, 0});
    if (measured_points(part) < 2) {
      throw InputError(name + " has fewer than 2 measured points: it has no peak and pit",
                       "take a longer long cut-off, or measure a longer profile");
    }
    const Extent range = extent(part, measured_points(part));
    of.Rp_m += (range.highest_m - mean) / static_cast<double>(of.count);
    of.Rv_m += (mean - range.lowest_m) / static_cast<double>(of.count);
  }
  of.Rz_m = of.Rp_m + of.Rv_m;
  if (!std::isfinite(of.Rz_m)) refuse_huge("their range");
  return of;
}

RowRoughness row_roughness(const HeightMap& map) {
  check_map(map);
  RowRoughness of;
  double absolute = 0, squares = 0;
  for (std::size_t j = 0; j < map.points_y; ++j) {
    const std::size_t begin = map.index(0, j), end = map.index(0, j + 1);
    double sum = 0, row_absolute = 0, row_squares = 0;
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (!map.measured(i)) continue;
      sum += map.height_m[i];
      ++count;
    }
    if (count < kMinPointsOfARow) continue;
    const double mean = sum / static_cast<double>(count);
    for (std::size_t i = begin; i < end; ++i) {
      if (!map.measured(i)) continue;
      const double z = map.height_m[i] - mean;
      row_absolute += std::abs(z);
      row_squares += z * z;
    }
    absolute += row_absolute / static_cast<double>(count);
    squares += row_squares / static_cast<double>(count);
    ++of.rows;
  }
  if (of.rows == 0) {
    throw InputError("no row of the map has " + std::to_string(kMinPointsOfARow) + " measured points",
                     "take a larger region");
  }
  of.Ra_m = absolute / static_cast<double>(of.rows);
  of.Rq_m = std::sqrt(squares / static_cast<double>(of.rows));
  if (!std::isfinite(of.Ra_m) || !std::isfinite(of.Rq_m)) refuse_huge("their squares");
  return of;
}

std::vector<double> material_ratio_curve(const HeightMap& map) {
  check_map(map);
  std::vector<double> heights;
  heights.reserve(map.points());
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (map.measured(i)) heights.push_back(map.height_m[i]);
  }
  std::sort(heights.begin(), heights.end(), std::greater<>());
  return heights;
}

}  // namespace ringfilm::surface
