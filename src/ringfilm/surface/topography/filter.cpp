#include "ringfilm/surface/topography/filter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/gaussian_kernel.hpp"

namespace ringfilm::surface {
namespace {

constexpr double kMinSteps = 2;
constexpr double kMinSupport = 1e-9;  // least sum of weights over that of a complete neighbourhood
// Tukey's biweight with 3 standard deviations, taken from the median of the deviations of a Gaussian: 3/0.6745.
constexpr double kOutlier = 4.4478;
constexpr double kSettled = 1e-3;
constexpr int kMaxIterations = 30;

void check_cutoff(const HeightMap& map, double cutoff_m) {
  if (!(std::isfinite(cutoff_m) && cutoff_m > 0)) {
    throw InputError("a filter cut-off of " + length_text(cutoff_m) + " is not a positive length");
  }
  const auto check_axis = [&](double step_m, std::size_t points, const char* axis) {
    if (cutoff_m < kMinSteps * step_m * (1 - 1e-12)) {
      throw InputError("a filter cut-off of " + length_text(cutoff_m) + " is below two steps of " +
                           length_text(step_m) + " along " + axis,
                       "such waves are not in the map; take " + length_text(5 * step_m) + " or more");
    }
    const double length_m = step_m * static_cast<double>(points);
    if (cutoff_m > length_m) {
      throw InputError("a filter cut-off of " + length_text(cutoff_m) + " is longer than the map, " +
                           length_text(length_m) + " along " + axis,
                       "take the form off instead, or a longer trace");
    }
  };
  check_axis(map.step_x_m, map.points_x, "x");
  if (!map.is_profile()) check_axis(map.step_y_m, map.points_y, "y");
}

/// The two kernels of a map and what their renormalisation needs.
struct Smoother {
  const HeightMap& map;
  std::vector<double> kernel_x, kernel_y;

  Smoother(const HeightMap& of, double cutoff_m) : map(of), kernel_x(gaussian_kernel(cutoff_m / of.step_x_m)) {
    if (!of.is_profile()) kernel_y = gaussian_kernel(cutoff_m / of.step_y_m);
  }

  void convolve(std::vector<double>& values) const {
    convolve_grid(values, map.points_x, map.points_y, kernel_x, kernel_y);
  }

  /// Sum of the weights that lie on the line, for each of its points.
  static std::vector<double> on_the_line(std::vector<double> kernel, std::size_t points) {
    std::vector<double> ones(points, 1.0);
    if (!kernel.empty()) LineConvolution(kernel, points).apply(ones, {});
    return ones;
  }

  /// Smooth surface of the measured heights.
  std::vector<double> linear() const {
    std::vector<double> smooth = map.height_m;
    if (!map.missing.empty()) {
      std::vector<double> weight(map.points());
      for (std::size_t i = 0; i < map.points(); ++i) {
        weight[i] = map.measured(i) ? 1.0 : 0.0;
        if (!map.measured(i)) smooth[i] = 0;
      }
      convolve(smooth);
      convolve(weight);
      for (std::size_t i = 0; i < map.points(); ++i) smooth[i] = map.measured(i) ? smooth[i] / weight[i] : 0.0;
      return smooth;
    }
    const std::vector<double> weight_x = on_the_line(kernel_x, map.points_x),
                              weight_y = on_the_line(kernel_y, map.points_y);
    convolve(smooth);
    for (std::size_t j = 0; j < map.points_y; ++j) {
      for (std::size_t i = 0; i < map.points_x; ++i) smooth[map.index(i, j)] /= weight_x[i] * weight_y[j];
    }
    return smooth;
  }
};

/// Height of an outlier after the median of the deviations from the smooth surface.
double outlier_height(const HeightMap& map, const std::vector<double>& smooth) {
  std::vector<double> deviations;
  deviations.reserve(map.points());
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (map.measured(i)) deviations.push_back(std::abs(map.height_m[i] - smooth[i]));
  }
  const auto middle = deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 2);
  std::nth_element(deviations.begin(), middle, deviations.end());
  return kOutlier * *middle;
}

/// Repeats the smoothing with weights that fall with the deviation until the height of an outlier settles.
std::vector<double> robust(const Smoother& smoother, FilterApplied& applied) {
  const HeightMap& map = smoother.map;
  std::vector<double> smooth = smoother.linear();
  double limit = outlier_height(map, smooth);
  std::vector<double> sum, weight(map.points());
  while (limit > 0 && applied.iterations < kMaxIterations) {
    ++applied.iterations;
    sum.assign(map.points(), 0.0);
    for (std::size_t i = 0; i < map.points(); ++i) {
      weight[i] = 0;
      if (!map.measured(i)) continue;
      const double away = (map.height_m[i] - smooth[i]) / limit;
      if (std::abs(away) >= 1) continue;
      weight[i] = (1 - away * away) * (1 - away * away);
      sum[i] = weight[i] * map.height_m[i];
    }
    smoother.convolve(sum);
    smoother.convolve(weight);
    applied.points_without_support = 0;
    for (std::size_t i = 0; i < map.points(); ++i) {
      if (!map.measured(i)) continue;
      if (weight[i] > kMinSupport) {
        smooth[i] = sum[i] / weight[i];
      } else {
        ++applied.points_without_support;  // the surface of the step before stays
      }
    }
    const double next = outlier_height(map, smooth);
    const bool settled = std::abs(next - limit) <= kSettled * limit;
    limit = next;
    if (settled) break;
  }
  return smooth;
}

/// Mean line of a profile whose valleys were cut off at the mean line of the whole, eq-surface-valley-suppression.
std::vector<double> valley_suppressed(HeightMap& profile, const Smoother& smoother) {
  const std::vector<double> heights = profile.height_m, first = smoother.linear();
  for (std::size_t i = 0; i < profile.points(); ++i) profile.height_m[i] = std::max(heights[i], first[i]);
  std::vector<double> second = smoother.linear();
  profile.height_m = heights;
  return second;
}

}  // namespace

double gaussian_transmission(double wavelength_m, double cutoff_m) {
  if (!(wavelength_m > 0) || !(std::isfinite(cutoff_m) && cutoff_m > 0)) {
    throw InputError("a wave of " + length_text(wavelength_m) + " and a filter cut-off of " + length_text(cutoff_m) +
                         " are not both positive lengths",
                     "state both in metres, for example 80e-6");
  }
  const double ratio = cutoff_m / wavelength_m;
  return std::exp(-std::log(2.0) * ratio * ratio);
}

FilterApplied apply_filter(HeightMap& map, const FilterChoice& choice) {
  check_map(map);
  check_cutoff(map, choice.cutoff_m);
  FilterApplied applied;
  applied.choice = choice;
  applied.cutoff_steps = choice.cutoff_m / (map.is_profile() ? map.step_x_m : std::max(map.step_x_m, map.step_y_m));
  const bool keeps_long = choice.side == FilterSide::short_cutoff;
  const char* kind = map.is_profile() ? "Gaussian (ISO 16610-21)" : "Gaussian (ISO 16610-61)";
  if (choice.kind == FilterKind::robust_gaussian) {
    kind = map.is_profile() ? "robust Gaussian regression of order 0 (after ISO 16610-31)"
                            : "robust Gaussian regression of order 0 (after ISO 16610-71)";
  }
  const bool is_two_step = choice.kind == FilterKind::valley_suppression && !keeps_long;
  if (is_two_step) {
    kind = "valley suppression in two steps (ISO 13565-1)";
    if (!map.is_profile()) {
      throw InputError("the two-step filter of ISO 13565-1 is one of profiles, and the map has several rows",
                       "take the robust filter of maps");
    }
  }
  applied.text = std::string(keeps_long ? "S-filter" : "L-filter") + ", " + kind + ", cut-off (nesting index) " +
                 length_text(choice.cutoff_m);
  const Smoother smoother(map, choice.cutoff_m);
  std::vector<double> smooth = is_two_step                                  ? valley_suppressed(map, smoother)
                               : choice.kind == FilterKind::robust_gaussian ? robust(smoother, applied)
                                                                            : smoother.linear();
  if (keeps_long) {
    map.height_m = std::move(smooth);
  } else {
    for (std::size_t i = 0; i < map.points(); ++i) map.height_m[i] -= smooth[i];
  }
  if (!map.missing.empty()) {
    for (std::size_t i = 0; i < map.points(); ++i) {
      if (!map.measured(i)) map.height_m[i] = 0;
    }
  }
  return applied;
}

}  // namespace ringfilm::surface
