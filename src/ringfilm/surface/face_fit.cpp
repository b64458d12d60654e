#include "ringfilm/surface/face_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/face_invention.hpp"

namespace ringfilm::surface {
namespace {

/// A spline of so many points is a matter of milliseconds, and its equations are still far from singular.
constexpr std::size_t kMostPoints = 8192;
constexpr int kMostPasses = 30;
constexpr double kTiltSettled = 1e-10;

std::string micrometres(double length_m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g um", length_m * 1e6);
  return text;
}

Trace gap_trace(const Trace& trace, const FaceRule& rule) {
  if (trace.x_m.size() != trace.height_m.size() || trace.x_m.size() < 2) {
    throw InputError("the trace has " + std::to_string(trace.x_m.size()) + " places and " +
                         std::to_string(trace.height_m.size()) + " heights",
                     "as many of both are wanted");
  }
  const auto finite = [](double v) { return std::isfinite(v); };
  if (!std::all_of(trace.x_m.begin(), trace.x_m.end(), finite) ||
      !std::all_of(trace.height_m.begin(), trace.height_m.end(), finite)) {
    throw InputError("the trace holds a value that is no number", "leave points that were not measured out");
  }
  if (!std::is_sorted(trace.x_m.begin(), trace.x_m.end(), std::less_equal<>())) {
    throw InputError("the places of the trace do not rise", "x must increase from point to point");
  }
  Trace gap = trace;
  if (rule.sense == HeightSense::kMaterial) {
    for (double& h : gap.height_m) h = -h;
  }
  return gap;
}

double interpolated(const Trace& trace, double x) {
  const auto above = std::upper_bound(trace.x_m.begin(), trace.x_m.end(), x);
  const std::size_t i =
      std::clamp<std::size_t>(static_cast<std::size_t>(above - trace.x_m.begin()), 1, trace.x_m.size() - 1);
  const double t = (x - trace.x_m[i - 1]) / (trace.x_m[i] - trace.x_m[i - 1]);
  return (1 - t) * trace.height_m[i - 1] + t * trace.height_m[i];
}

/// Integral of the trace from its first point to each point.
std::vector<double> area_up_to(const Trace& trace) {
  std::vector<double> area(trace.x_m.size(), 0.0);
  for (std::size_t i = 1; i < area.size(); ++i) {
    area[i] = area[i - 1] + (trace.x_m[i] - trace.x_m[i - 1]) * (trace.height_m[i] + trace.height_m[i - 1]) / 2;
  }
  return area;
}

/// Start of the window of the face's width under which the gap is least.
double found_start(const Trace& trace, double width) {
  const std::vector<double> area = area_up_to(trace);
  const auto area_at = [&](double x) {
    const std::size_t i =
        static_cast<std::size_t>(std::upper_bound(trace.x_m.begin(), trace.x_m.end(), x) - trace.x_m.begin()) - 1;
    return area[i] + (x - trace.x_m[i]) * (trace.height_m[i] + interpolated(trace, x)) / 2;
  };
  const double last = std::max(trace.x_m.front(), trace.x_m.back() - width);
  double best = trace.x_m.front(), least = area_at(std::min(best + width, trace.x_m.back()));
  const auto look_at = [&](double start) {
    const double inside = area_at(std::min(start + width, trace.x_m.back())) - area_at(start);
    if (inside < least) {
      least = inside;
      best = start;
    }
  };
  for (const double x : trace.x_m) {
    if (x <= last) look_at(x);
  }
  look_at(last);
  return best;
}

/// The part of the trace from `start` over `width`, from 0 on, with a point on both edges.
Trace window(const Trace& trace, double start, double width) {
  const double slack = 1e-9 * width;
  Trace cut{{0.0}, {interpolated(trace, start)}};
  for (std::size_t i = 0; i < trace.x_m.size(); ++i) {
    const double x = trace.x_m[i] - start;
    if (x <= slack || x >= width - slack) continue;
    cut.x_m.push_back(x);
    cut.height_m.push_back(trace.height_m[i]);
  }
  cut.x_m.push_back(width);
  cut.height_m.push_back(interpolated(trace, std::min(start + width, trace.x_m.back())));
  return cut;
}

/// Means of `group` neighbours; the edges stay points of their own.
Trace averaged(const Trace& trace, std::size_t group) {
  Trace mean{{trace.x_m.front()}, {trace.height_m.front()}};
  for (std::size_t first = 1; first + 1 < trace.x_m.size(); first += group) {
    const std::size_t last = std::min(first + group, trace.x_m.size() - 1);
    double x = 0, height = 0;
    for (std::size_t i = first; i < last; ++i) {
      x += trace.x_m[i] / static_cast<double>(last - first);
      height += trace.height_m[i] / static_cast<double>(last - first);
    }
    mean.x_m.push_back(x);
    mean.height_m.push_back(height);
  }
  mean.x_m.push_back(trace.x_m.back());
  mean.height_m.push_back(trace.height_m.back());
  return mean;
}

/// The trace without points that lie deeper than its spline by more than `depth`, again and again, since a pore pulls
/// the spline down with it. The edges stay.
Trace without_pores(Trace trace, double depth, double cutoff) {
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const SmoothingSpline spline(trace.x_m, trace.height_m, cutoff);
    Trace kept{{trace.x_m.front()}, {trace.height_m.front()}};
    for (std::size_t i = 1; i < trace.x_m.size(); ++i) {
      const bool edge = i + 1 == trace.x_m.size();
      if (!edge && trace.height_m[i] - spline.height_m()[i] > depth) continue;
      kept.x_m.push_back(trace.x_m[i]);
      kept.height_m.push_back(trace.height_m[i]);
    }
    if (kept.x_m.size() == trace.x_m.size()) break;
    trace = std::move(kept);
  }
  return trace;
}

struct Land {
  std::size_t first, last;  ///< points
};

Land land_of(const std::vector<double>& smooth, double land_height) {
  const std::size_t lowest = static_cast<std::size_t>(std::min_element(smooth.begin(), smooth.end()) - smooth.begin());
  const double limit = smooth[lowest] + land_height;
  Land land{lowest, lowest};
  while (land.first > 0 && smooth[land.first - 1] <= limit) --land.first;
  while (land.last + 1 < smooth.size() && smooth[land.last + 1] <= limit) ++land.last;
  return land;
}

double slope_over(const Trace& trace, const Land& land) {
  double x_mean = 0, h_mean = 0, xh = 0, xx = 0;
  const double n = static_cast<double>(land.last - land.first + 1);
  for (std::size_t i = land.first; i <= land.last; ++i) {
    x_mean += trace.x_m[i] / n;
    h_mean += trace.height_m[i] / n;
  }
  for (std::size_t i = land.first; i <= land.last; ++i) {
    xh += (trace.x_m[i] - x_mean) * (trace.height_m[i] - h_mean);
    xx += (trace.x_m[i] - x_mean) * (trace.x_m[i] - x_mean);
  }
  return xx > 0 ? xh / xx : 0.0;
}

void take_off(Trace& trace, double tilt) {
  for (std::size_t i = 0; i < trace.x_m.size(); ++i) trace.height_m[i] -= tilt * (trace.x_m[i] - trace.x_m.front());
}

FaceResidual residual_of(const Trace& gap, const std::function<double(std::size_t)>& fit) {
  FaceResidual residual;
  double squares = 0;
  for (std::size_t i = 0; i < gap.x_m.size(); ++i) {
    const double distance = gap.height_m[i] - fit(i);
    squares += distance * distance;
    if (std::abs(distance) <= std::abs(residual.largest_m)) continue;
    residual.largest_m = distance;
    residual.largest_at_m = gap.x_m[i];
  }
  residual.rms_m = std::sqrt(squares / static_cast<double>(gap.x_m.size()));
  return residual;
}

/// Lowest place of the polynomial between its edges.
std::pair<double, double> lowest_of(const FacePolynomial& polynomial) {
  std::vector<double> places = polynomial.turning_points_m();
  places.insert(places.end(), {0.0, polynomial.width_m()});
  const double x = *std::min_element(places.begin(), places.end(), [&](double a, double b) {
    return polynomial.height_m(a) < polynomial.height_m(b);
  });
  return {x, polynomial.height_m(x)};
}

void check_rule(const Trace& trace, const FaceRule& rule) {
  if (!std::isfinite(rule.width_m) || rule.width_m <= 0) {
    throw InputError("the width of the face is not a length above zero", "for example 1.2 mm");
  }
  if (!std::isfinite(rule.land_height_m) || rule.land_height_m <= 0) {
    throw InputError("the height of the land is not a length above zero", "for example 1 um");
  }
  if (rule.pore_depth_m && (!std::isfinite(*rule.pore_depth_m) || *rule.pore_depth_m <= 0)) {
    throw InputError("the depth from which on pores are left out is not a length above zero",
                     "some three times the roughness, for example 1 um");
  }
  const double length = trace.x_m.back() - trace.x_m.front();
  if (length < rule.width_m * (1 - 1e-6)) {
    throw InputError(
        "the trace is " + micrometres(length) + " long and does not cover the face of " + micrometres(rule.width_m),
        "no shape is invented beyond a trace; measure a longer one, or state the width that it covers");
  }
  if (!rule.start_m) return;
  if (std::isfinite(*rule.start_m) && *rule.start_m >= trace.x_m.front() - 1e-6 * rule.width_m &&
      *rule.start_m + rule.width_m <= trace.x_m.back() + 1e-6 * rule.width_m) {
    return;
  }
  throw InputError("the face of " + micrometres(rule.width_m) + " does not lie in the trace from the stated start on",
                   "the trace runs from " + micrometres(trace.x_m.front()) + " to " + micrometres(trace.x_m.back()));
}

}  // namespace

std::string InventedShape::words() const {
  char text[200];
  const char* what = reason == InventionReason::kDeparts ? "the polynomial lies %.3g um off the trace"
                     : reason == InventionReason::kTurnNotInTrace
                         ? "the polynomial's gap falls by %.3g um where that of the trace does not"
                         : "the gap falls by %.3g um towards the edge, in polynomial and trace";
  char figure[160];
  std::snprintf(figure, sizeof figure, what, size_m * 1e6);
  std::snprintf(text, sizeof text, "x = %.4g to %.4g mm: %s", from_m * 1e3, to_m * 1e3, figure);
  return text;
}

FaceFit fit_face(const Trace& trace, const FaceRule& rule) {
  Trace whole = gap_trace(trace, rule);
  check_rule(whole, rule);
  FaceFit fit;
  fit.spline_cutoff_m = rule.spline_cutoff_m.value_or(rule.width_m / 10);
  if (rule.levelling == FaceLevelling::kStated) {
    take_off(whole, rule.tilt);
    fit.tilt = rule.tilt;
  }
  Trace gap;
  Land land{};
  std::vector<double> smooth;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    fit.start_m = std::clamp(rule.start_m.value_or(found_start(whole, rule.width_m)), whole.x_m.front(),
                             std::max(whole.x_m.front(), whole.x_m.back() - rule.width_m));
    gap = window(whole, fit.start_m, rule.width_m);
    fit.averaged = static_cast<int>((gap.x_m.size() - 1) / kMostPoints + 1);
    if (fit.averaged > 1) gap = averaged(gap, static_cast<std::size_t>(fit.averaged));
    if (rule.pore_depth_m) {
      const std::size_t before = gap.x_m.size();
      gap = without_pores(std::move(gap), *rule.pore_depth_m, fit.spline_cutoff_m);
      fit.pore_share = static_cast<double>(before - gap.x_m.size()) / static_cast<double>(before);
    }
    smooth = SmoothingSpline(gap.x_m, gap.height_m, fit.spline_cutoff_m).height_m();
    land = land_of(smooth, rule.land_height_m);
    if (rule.levelling != FaceLevelling::kLand) break;
    const double tilt = slope_over(gap, land);
    if (std::abs(tilt) < kTiltSettled) break;
    take_off(whole, tilt);
    fit.tilt += tilt;
  }
  if (rule.direction == FaceDirection::kTurned) {
    for (double& x : gap.x_m) x = rule.width_m - x;
    std::reverse(gap.x_m.begin(), gap.x_m.end());
    std::reverse(gap.height_m.begin(), gap.height_m.end());
    std::reverse(smooth.begin(), smooth.end());
    land = {gap.x_m.size() - 1 - land.last, gap.x_m.size() - 1 - land.first};
  }
  fit.land_from_m = gap.x_m[land.first];
  fit.land_to_m = gap.x_m[land.last];
  if (rule.zero == FaceZero::kLowestPoint) {
    const double lowest = *std::min_element(smooth.begin(), smooth.end());
    for (double& h : gap.height_m) h -= lowest;
    for (double& h : smooth) h -= lowest;
  }
  fit.polynomial = FacePolynomial::fit(gap.x_m, gap.height_m, rule.width_m, rule.degree);
  fit.polynomial_residual = residual_of(gap, [&](std::size_t i) { return fit.polynomial.height_m(gap.x_m[i]); });
  fit.spline_residual = residual_of(gap, [&](std::size_t i) { return smooth[i]; });
  const Departure departure(gap, fit.polynomial, fit.spline_cutoff_m);
  fit.noise_m = departure.noise_m();
  fit.invented = departure.invented();
  std::tie(fit.polynomial_minimum_at_m, fit.polynomial_minimum_m) = lowest_of(fit.polynomial);
  const auto lowest = std::min_element(smooth.begin(), smooth.end());
  fit.spline_minimum_m = *lowest;
  fit.spline_minimum_at_m = gap.x_m[static_cast<std::size_t>(lowest - smooth.begin())];
  fit.polynomial_end_m[0] = fit.polynomial.height_m(0) - fit.polynomial_minimum_m;
  fit.polynomial_end_m[1] = fit.polynomial.height_m(rule.width_m) - fit.polynomial_minimum_m;
  fit.spline_end_m[0] = smooth.front() - *lowest;
  fit.spline_end_m[1] = smooth.back() - *lowest;
  fit.x_m = std::move(gap.x_m);
  fit.gap_m = std::move(gap.height_m);
  fit.spline_m = std::move(smooth);
  return fit;
}

}  // namespace ringfilm::surface
