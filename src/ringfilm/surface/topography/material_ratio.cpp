#include "ringfilm/surface/topography/material_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kMinPointsOfMaterialRatio = 20;
constexpr std::size_t kMinPointsOfTwoLines = 100;
constexpr double kCoreShare = 0.4;
constexpr double kProbabilityRange = 3;  // standard deviations to both sides
constexpr int kProbabilityPoints = 601;
constexpr int kMinPointsOfALine = 30;  // 0.3 standard deviations
// Largest ratio of the squares that two lines leave to those that one line leaves.
constexpr double kWorthASecondLine = 0.5;

void check_curve(std::span<const double> z, std::size_t least) {
  if (z.size() < least) {
    throw InputError("a material ratio curve of " + std::to_string(z.size()) + " points is too short",
                     std::to_string(least) + " points or more are needed");
  }
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (!std::isfinite(z[i]) || (i > 0 && z[i] > z[i - 1])) {
      throw InputError("the heights of a material ratio curve do not fall at point " + std::to_string(i + 1));
    }
  }
  if (!(z.front() > z.back())) {
    throw InputError("all heights of the material ratio curve are the same", "choose another channel or region");
  }
}

double ratio_of(double point, std::size_t points) { return (point + 0.5) / static_cast<double>(points); }

/// Height of the curve at a material ratio, straight between its points.
double height_at(std::span<const double> z, double ratio) {
  const double place = std::clamp(ratio * static_cast<double>(z.size()) - 0.5, 0.0, static_cast<double>(z.size() - 1));
  const auto before = std::min(static_cast<std::size_t>(place), z.size() - 2);
  const double share = place - static_cast<double>(before);
  return z[before] + share * (z[before + 1] - z[before]);
}

/// Material ratio at which the falling curve passes a height.
double ratio_at(std::span<const double> z, double height) {
  if (height >= z.front()) return 0;
  if (height <= z.back()) return 1;
  const auto below = std::partition_point(z.begin(), z.end(), [&](double value) { return value > height; });
  const auto i = static_cast<std::size_t>(below - z.begin());
  return ratio_of(static_cast<double>(i) - (height - z[i]) / (z[i - 1] - z[i]), z.size());
}

}  // namespace

CoreRoughness core_roughness(std::span<const double> z) {
  check_curve(z, kMinPointsOfMaterialRatio);
  const std::size_t n = z.size(), width = std::max<std::size_t>(
                                      2, static_cast<std::size_t>(std::lround(kCoreShare * static_cast<double>(n))));
  std::size_t start = 0;
  for (std::size_t i = 1; i + width < n; ++i) {
    if (z[i] - z[i + width] < z[start] - z[start + width]) start = i;
  }
  // Least squares about the middle of the 40 %.
  const double middle = 0.5 * static_cast<double>(width);
  double sum = 0, moment = 0, spread = 0;
  for (std::size_t k = 0; k <= width; ++k) {
    const double t = static_cast<double>(k) - middle;
    sum += z[start + k] - z[start];
    moment += t * (z[start + k] - z[start]);
    spread += t * t;
  }
  const double count = static_cast<double>(n);
  const double fall = -moment / spread * count;  // over the whole curve
  const double at_middle = z[start] + sum / static_cast<double>(width + 1);
  const double ratio_middle = ratio_of(static_cast<double>(start) + middle, n);
  CoreRoughness of;
  of.Rk_m = fall;
  of.upper_m = at_middle + fall * ratio_middle;
  of.lower_m = of.upper_m - fall;
  of.Mr1 = ratio_at(z, of.upper_m);
  of.Mr2 = ratio_at(z, of.lower_m);
  double above = 0, below = 0;
  for (const double height : z) {
    above += std::max(0.0, height - of.upper_m);
    below += std::max(0.0, of.lower_m - height);
  }
  if (of.Mr1 > 0) of.Rpk_m = 2 * above / count / of.Mr1;
  if (of.Mr2 < 1) of.Rvk_m = 2 * below / count / (1 - of.Mr2);
  return of;
}

std::optional<ProbabilityRoughness> probability_roughness(std::span<const double> z) {
  check_curve(z, kMinPointsOfTwoLines);
  // The curve at even steps of normal probability, as far as it has points.
  const double root_of_two = std::sqrt(2.0);
  std::vector<double> s, height;
  for (int k = 0; k < kProbabilityPoints; ++k) {
    const double at = kProbabilityRange * (2.0 * k / (kProbabilityPoints - 1) - 1);
    const double ratio = 0.5 * std::erfc(-at / root_of_two);
    const double place = ratio * static_cast<double>(z.size());
    if (place < 0.5 || place > static_cast<double>(z.size()) - 0.5) continue;
    s.push_back(at);
    height.push_back(height_at(z, ratio) - z.back());
  }
  // Running sums of 1, s, z, s s, s z, z z.
  struct Sums {
    double n = 0, s = 0, z = 0, ss = 0, sz = 0, zz = 0;
  };
  struct Line {
    double slope, at_zero, squares;
  };
  std::vector<Sums> to(s.size() + 1);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Sums& a = to[i];
    to[i + 1] = {a.n + 1,
                 a.s + s[i],
                 a.z + height[i],
                 a.ss + s[i] * s[i],
                 a.sz + s[i] * height[i],
                 a.zz + height[i] * height[i]};
  }
  const auto line = [&](std::size_t begin, std::size_t end) {
    const Sums &a = to[begin], &b = to[end];
    const double n = b.n - a.n, ms = (b.s - a.s) / n, mz = (b.z - a.z) / n;
    const double ss = b.ss - a.ss - n * ms * ms, sz = b.sz - a.sz - n * ms * mz, zz = b.zz - a.zz - n * mz * mz;
    return Line{sz / ss, mz - sz / ss * ms, std::max(0.0, zz - sz * sz / ss)};
  };
  if (s.size() < 2 * kMinPointsOfALine) return std::nullopt;
  const double alone = line(0, s.size()).squares;
  double least = alone;
  std::size_t parting = 0;
  for (std::size_t i = kMinPointsOfALine; i + kMinPointsOfALine <= s.size(); ++i) {
    const double together = line(0, i).squares + line(i, s.size()).squares;
    if (together < least) {
      least = together;
      parting = i;
    }
  }
  if (parting == 0 || least > kWorthASecondLine * alone) return std::nullopt;
  const Line plateau = line(0, parting), valley = line(parting, s.size());
  if (!(valley.slope < plateau.slope && plateau.slope < 0)) return std::nullopt;  // no plateau over deeper valleys
  const double meet = (valley.at_zero - plateau.at_zero) / (plateau.slope - valley.slope);
  if (!(std::abs(meet) < kProbabilityRange)) return std::nullopt;  // they do not meet on the curve
  return ProbabilityRoughness{-plateau.slope, -valley.slope, 0.5 * std::erfc(-meet / root_of_two),
                              z.back() + plateau.at_zero, z.back() + plateau.at_zero + plateau.slope * meet};
}

VolumeParameters volume_parameters(std::span<const double> z, double first, double second) {
  check_curve(z, kMinPointsOfMaterialRatio);
  if (!(first >= 0 && first < second && second <= 1)) {
    throw InputError(
        "material ratios of " + std::to_string(first) + " and " + std::to_string(second) + " are not two planes",
        "both lie from 0 to 1, the second above the first");
  }
  const double top = height_at(z, first), bottom = height_at(z, second), count = static_cast<double>(z.size());
  double above_top = 0, above_bottom = 0, below_top = 0, below_bottom = 0;
  for (const double height : z) {
    above_top += std::max(0.0, height - top);
    above_bottom += std::max(0.0, height - bottom);
    below_top += std::max(0.0, top - height);
    below_bottom += std::max(0.0, bottom - height);
  }
  return {above_top / count, (above_bottom - above_top) / count, (below_top - below_bottom) / count,
          below_bottom / count};
}

double material_ratio_at_depth(std::span<const double> z, double reference_ratio, double depth_m) {
  check_curve(z, kMinPointsOfMaterialRatio);
  return ratio_at(z, height_at(z, reference_ratio) - depth_m);
}

double oil_retention_volume(const CoreRoughness& core) { return core.Rvk_m * (1 - core.Mr2) / 2; }

Cavities cavities(std::span<const double> z, CavityRule rule, double depth_m) {
  check_curve(z, kMinPointsOfMaterialRatio);
  const double median = height_at(z, 0.5);
  Cavities of;
  if (rule == CavityRule::below_core) {
    of.threshold_m = core_roughness(z).lower_m;
  } else if (rule == CavityRule::below_plateau) {
    // Half of the points above the median lie closer to it than the quarter point of the curve.
    of.threshold_m = median - 3 * 1.4826 * (height_at(z, 0.25) - median);
  } else {
    if (!(std::isfinite(depth_m) && depth_m > 0)) {
      throw InputError("a depth of " + length_text(depth_m) + " below which points count as cavities is not positive");
    }
    of.threshold_m = median - depth_m;
  }
  const auto first = std::partition_point(z.begin(), z.end(), [&](double height) { return height >= of.threshold_m; });
  const double count = static_cast<double>(z.size()), below = static_cast<double>(z.end() - first);
  double depth = 0;
  for (auto at = first; at != z.end(); ++at) depth += of.threshold_m - *at;
  of.area_share = below / count;
  of.volume_m = depth / count;
  if (below > 0) of.mean_depth_m = depth / below + (median - of.threshold_m);
  return of;
}

}  // namespace ringfilm::surface
