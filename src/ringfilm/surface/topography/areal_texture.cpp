#include "ringfilm/surface/topography/areal_texture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/gaussian_kernel.hpp"
#include "ringfilm/surface/topography/grid_transform.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kMinPointsOfTexture = 16;
constexpr double kDecay = 0.2;            // decay of the autocorrelation, the usual value of the standard
constexpr int kRays = 360;                // directions in which it is followed, over half a turn
constexpr int kAngles = 180;              // angles of the spectrum, one a degree
constexpr int kMinWaves = 4;              // over a side: coarser waves have no direction
constexpr int kSmoothing = 2;             // angles to both sides
constexpr int kApart = 10;                // least angle between two lays [degree]
constexpr int kLobe = 8;                  // angles to both sides that belong to a lay
constexpr double kStandsOut = 3;          // times the median of all directions
constexpr double kSecondOverFirst = 0.1;  // least height of the second lay above the median, over that of the first

void check_texture(const HeightMap& map) {
  check_map(map);
  if (map.is_profile()) throw InputError("a profile has no direction", "take a map of several rows");
  if (map.points_x < kMinPointsOfTexture || map.points_y < kMinPointsOfTexture ||
      2 * measured_points(map) < map.points()) {
    throw InputError("too few points for a direction: " + std::to_string(kMinPointsOfTexture) +
                         " or more are needed along x and y, half of them measured",
                     "take a larger region");
  }
}

/// Autocorrelation for shifts up to half of the map, each over the pairs of points that it has.
class Autocorrelation {
 public:
  explicit Autocorrelation(const HeightMap& map)
      : map_(map), length_x_(transform_length(2 * map.points_x)), length_y_(transform_length(2 * map.points_y)) {
    const double mean = mean_height(map);
    std::vector<double> heights(length_x_ * length_y_, 0.0), ones(heights);
    for (std::size_t j = 0; j < map.points_y; ++j) {
      for (std::size_t i = 0; i < map.points_x; ++i) {
        const std::size_t point = map.index(i, j);
        if (!map.measured(point)) continue;
        heights[j * length_x_ + i] = map.height_m[point] - mean;
        ones[j * length_x_ + i] = 1;
      }
    }
    products_ = with_itself(heights);
    pairs_ = with_itself(ones);
    if (!(products_[0] > 0)) {
      throw InputError("all heights of the map are the same: it has no texture", "choose another channel or region");
    }
  }

  /// Shifts of up to half of the map alone. @returns 1 at 0, 0
  double at(std::ptrdiff_t shift_x, std::ptrdiff_t shift_y) const {
    const auto wrapped = [](std::ptrdiff_t shift, std::size_t length) {
      return static_cast<std::size_t>(shift < 0 ? shift + static_cast<std::ptrdiff_t>(length) : shift);
    };
    const std::size_t i = wrapped(shift_y, length_y_) * length_x_ + wrapped(shift_x, length_x_);
    return pairs_[i] < 0.5 ? 0 : products_[i] / pairs_[i] * pairs_[0] / products_[0];
  }

  /// Distance in a direction at which it first falls to the decay, in metres; 0: not within half of the map.
  double reach(double angle) const {
    const double step = std::min(map_.step_x_m, map_.step_y_m) / 2;
    const double along_x = std::cos(angle) * step / map_.step_x_m, along_y = std::sin(angle) * step / map_.step_y_m;
    const double most_x = static_cast<double>(map_.points_x / 2 - 1),
                 most_y = static_cast<double>(map_.points_y / 2 - 1);
    double before = 1;
    for (double k = 1;; ++k) {
      const double x = k * along_x, y = k * along_y;
      if (std::abs(x) >= most_x || std::abs(y) >= most_y) return 0;
      const double here = between(x, y);
      if (here <= kDecay) return step * (k - (kDecay - here) / (before - here));
      before = here;
    }
  }

 private:
  std::vector<double> with_itself(const std::vector<double>& values) const {
    std::vector<std::complex<double>> waves = waves_of(values, length_x_, length_y_);
    for (std::complex<double>& wave : waves) wave = std::norm(wave);
    return values_of(std::move(waves), length_x_, length_y_);
  }

  double between(double x, double y) const {
    const auto i = static_cast<std::ptrdiff_t>(std::floor(x)), j = static_cast<std::ptrdiff_t>(std::floor(y));
    const double s = x - static_cast<double>(i), t = y - static_cast<double>(j);
    return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) + t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
  }

  const HeightMap& map_;
  std::size_t length_x_, length_y_;
  std::vector<double> products_, pairs_;
};

using Angular = std::array<double, kAngles>;

/// Power of the slopes against the lay of the grooves, under a Hann window: mean over the waves of each direction.
Angular angular_spectrum(const HeightMap& map) {
  const double mean = mean_height(map);
  const std::size_t length_x = transform_length(map.points_x), length_y = transform_length(map.points_y);
  const auto window = [](std::size_t i, std::size_t points) {
    const double s = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(points));
    return s * s;
  };
  std::vector<double> values(length_x * length_y, 0.0);
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const std::size_t point = map.index(i, j);
      if (!map.measured(point)) continue;
      values[j * length_x + i] = window(i, map.points_x) * window(j, map.points_y) * (map.height_m[point] - mean);
    }
  }
  const std::vector<std::complex<double>> waves = waves_of(values, length_x, length_y);
  const double per_x = 1 / (static_cast<double>(length_x) * map.step_x_m);
  const double per_y = 1 / (static_cast<double>(length_y) * map.step_y_m);
  const double least = kMinWaves * std::max(per_x, per_y), most = 0.5 / std::max(map.step_x_m, map.step_y_m);
  Angular power{}, weight{};
  const std::size_t columns = length_x / 2 + 1;
  for (std::size_t k = 0; k < length_y; ++k) {
    for (std::size_t m = 0; m < columns; ++m) {
      const double fx = static_cast<double>(m) * per_x, fy = wave_number(k, length_y) * per_y, f = std::hypot(fx, fy);
      if (f < least || f > most) continue;
      double lay = std::atan2(fy, fx) + std::numbers::pi / 2;  // grooves run across their wave
      lay -= std::numbers::pi * std::floor(lay / std::numbers::pi);
      // Shared between the two nearest angles, so that coarse waves leave no gap.
      const double place = lay / std::numbers::pi * kAngles;
      const auto low = static_cast<int>(place) % kAngles;
      const double share = place - std::floor(place);
      const double slopes = f * f * std::norm(waves[k * columns + m]);
      power[static_cast<std::size_t>(low)] += (1 - share) * slopes;
      weight[static_cast<std::size_t>(low)] += 1 - share;
      power[static_cast<std::size_t>((low + 1) % kAngles)] += share * slopes;
      weight[static_cast<std::size_t>((low + 1) % kAngles)] += share;
    }
  }
  Angular smooth{};
  for (int a = 0; a < kAngles; ++a) {
    double sum = 0, sum_of_weights = 0;
    for (int d = -kSmoothing; d <= kSmoothing; ++d) {
      const auto at = static_cast<std::size_t>((a + d + kAngles) % kAngles);
      sum += power[at];
      sum_of_weights += weight[at];
    }
    smooth[static_cast<std::size_t>(a)] = sum_of_weights > 0 ? sum / sum_of_weights : 0;
  }
  return smooth;
}

/// Smallest difference of two directions, in angles of the spectrum.
int apart(int a, int b) {
  const int d = std::abs(a - b) % kAngles;
  return std::min(d, kAngles - d);
}

struct Lobe {
  double place, variance;  // [angles], [angles^2]
};

/// Mean direction of a lay and its variance, less that of the smoothing.
Lobe lobe_at(const Angular& power, int peak, double floor) {
  double sum = 0, first = 0, second = 0;
  for (int d = -kLobe; d <= kLobe; ++d) {
    const double p = std::max(0.0, power[static_cast<std::size_t>((peak + d + kAngles) % kAngles)] - floor);
    sum += p;
    first += p * d;
    second += p * d * d;
  }
  const double mean = first / sum, smoothing = kSmoothing * (kSmoothing + 1) / 3.0;
  return {peak + mean, std::max(0.0, second / sum - mean * mean - smoothing)};
}

}  // namespace

double developed_area_ratio(const HeightMap& map) {
  check_map(map);
  if (map.is_profile()) throw InputError("a profile has no developed area", "take a map of several rows");
  // (sqrt(1 + s^2) - 1) of a triangle, without the loss of digits of small slopes.
  const auto excess = [](double slope_x, double slope_y) {
    const double squares = slope_x * slope_x + slope_y * slope_y;
    return squares / (1 + std::sqrt(1 + squares));
  };
  double sum = 0, cells = 0;
  for (std::size_t j = 0; j + 1 < map.points_y; ++j) {
    for (std::size_t i = 0; i + 1 < map.points_x; ++i) {
      const std::size_t at[4] = {map.index(i, j), map.index(i + 1, j), map.index(i, j + 1), map.index(i + 1, j + 1)};
      if (!std::all_of(at, at + 4, [&map](std::size_t point) { return map.measured(point); })) continue;
      const double upper = (map.height_m[at[1]] - map.height_m[at[0]]) / map.step_x_m;
      const double lower = (map.height_m[at[3]] - map.height_m[at[2]]) / map.step_x_m;
      const double left = (map.height_m[at[2]] - map.height_m[at[0]]) / map.step_y_m;
      const double right = (map.height_m[at[3]] - map.height_m[at[1]]) / map.step_y_m;
      // Mean of both ways to cut the cell into two triangles.
      sum += (excess(upper, left) + excess(lower, right) + excess(upper, right) + excess(lower, left)) / 4;
      cells += 1;
    }
  }
  if (cells == 0) throw InputError("no four neighbours of the map are measured", "take another region");
  return sum / cells;
}

AutocorrelationLengths autocorrelation_lengths(const HeightMap& map) {
  check_texture(map);
  const Autocorrelation correlation(map);
  double shortest = 0, longest = 0;
  bool is_open = false;
  for (int ray = 0; ray < kRays; ++ray) {
    const double reach = correlation.reach(std::numbers::pi * ray / kRays);
    if (reach == 0) {
      is_open = true;
      continue;
    }
    shortest = shortest == 0 ? reach : std::min(shortest, reach);
    longest = std::max(longest, reach);
  }
  if (shortest == 0) {
    throw InputError("the autocorrelation does not fall to 0.2 within half of the map",
                     "take the form off, or a long cut-off");
  }
  AutocorrelationLengths of;
  of.Sal_m = shortest;
  if (!is_open) of.Str = shortest / longest;
  return of;
}

std::optional<HoningAngle> honing_angle(const HeightMap& map) {
  check_texture(map);
  const Angular power = angular_spectrum(map);
  Angular sorted = power;
  std::nth_element(sorted.begin(), sorted.begin() + kAngles / 2, sorted.end());
  const double median = sorted[kAngles / 2];
  const auto at = [&power](int a) { return power[static_cast<std::size_t>((a + kAngles) % kAngles)]; };
  const auto highest = [&](const auto& allowed) {
    int best = -1;
    for (int a = 0; a < kAngles; ++a) {
      if (!allowed(a) || at(a) < at(a - 1) || at(a) < at(a + 1)) continue;
      if (best < 0 || at(a) > at(best)) best = a;
    }
    return best;
  };
  const int first = highest([](int) { return true; });
  if (first < 0 || !(at(first) > kStandsOut * median)) return std::nullopt;
  const int second = highest([first](int a) { return apart(a, first) >= kApart; });
  if (second < 0 || !(at(second) > kStandsOut * median) ||
      at(second) - median < kSecondOverFirst * (at(first) - median)) {
    return std::nullopt;
  }
  const Lobe one = lobe_at(power, first, median), other = lobe_at(power, second, median);
  constexpr double kStep = std::numbers::pi / kAngles;
  const auto in_half_turn = [](double rad) { return rad - std::numbers::pi * std::floor(rad / std::numbers::pi); };
  HoningAngle of;
  of.first_rad = in_half_turn(one.place * kStep);
  of.second_rad = in_half_turn(other.place * kStep);
  const double between = std::abs(of.first_rad - of.second_rad);
  of.angle_rad = std::min(between, std::numbers::pi - between);
  if (of.angle_rad < kApart * kStep) return std::nullopt;  // two peaks of one broad lobe
  of.scatter_rad = std::sqrt(0.5 * (one.variance + other.variance)) * kStep;
  return of;
}

}  // namespace ringfilm::surface
