#include "ringfilm/study/verification/dry_wear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/life/dry_contact.hpp"

namespace ringfilm::study {
namespace {

constexpr int kWaves = 4;

double height_of(const DryWear& input, double x) {
  const double s = x - 0.5 * input.width;
  if (input.profile == "parabola") return s * s / (2 * input.shape);
  if (input.profile == "roof") return input.shape * std::abs(s);
  if (input.profile == "wave") return input.shape * std::cos(2 * std::numbers::pi * kWaves * x / input.width);
  return 0;
}

struct Worn {
  std::vector<double> height, depth;  ///< at the places [m]
  double area;                        ///< [m2]
};

Worn worn_after(const DryWear& input, double sliding) {
  constexpr double kSpeed = 10;  // any: the sliding length counts
  const std::vector<double> x = life::places(input.width, input.cells);
  Worn worn;
  for (const double place : x) worn.height.push_back(height_of(input, place));
  const life::DryContact dry(input.roughness, input.load, kSpeed, x, worn.height);
  life::Wear wear;
  wear.coefficient = input.coefficient;
  wear.largest_depth = input.largest_depth;
  wear.jump_error = input.largest_depth;
  const auto load = [&dry](const life::WornDepths& now) { return dry(now.face); };
  worn.depth = life::integrate_wear(wear, {sliding / kSpeed}, x.size(), 0, load).states.front().face;
  worn.area = dry.area(worn.depth);
  return worn;
}

}  // namespace

const std::vector<std::string>& dry_wear_profiles() {
  static const std::vector<std::string> names = {"flat", "parabola", "roof", "wave"};
  return names;
}

const std::vector<cycle::Quantity>& dry_wear_quantities() {
  static const std::vector<cycle::Quantity> all = {
      {"largest_worn_depth", "m", "um", "largest worn depth", "w_max", ""},
      {"depth_difference", "m", "um", "largest less least worn depth", "", ""},
      {"worn_area", "m2", "um mm", "worn area", "A", ""},
      {"amplitude_left", "1", "1", "amplitude left", "", ""},
      {"sliding_exponent", "1", "1", "exponent of the sliding length", "", ""}};
  return all;
}

double dry_wear_value(const DryWear& input, const std::string& quantity) {
  const Worn worn = worn_after(input, input.sliding);
  const auto [least, largest] = std::minmax_element(worn.depth.begin(), worn.depth.end());
  if (quantity == "depth_difference") return *largest - *least;
  if (quantity == "worn_area") return worn.area;
  if (quantity == "amplitude_left") {
    const std::size_t half = static_cast<std::size_t>(input.cells) / (2 * kWaves), k = 2 * half;
    const double before = worn.height[k] - worn.height[half];
    return (before + worn.depth[k] - worn.depth[half]) / before;
  }
  if (quantity == "sliding_exponent") {
    const Worn half = worn_after(input, 0.5 * input.sliding);
    return std::log2(*largest / *std::max_element(half.depth.begin(), half.depth.end()));
  }
  return *largest;
}

}  // namespace ringfilm::study
