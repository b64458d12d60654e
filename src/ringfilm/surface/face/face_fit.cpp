#include "ringfilm/surface/face/face_fit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/face/face_alignment.hpp"
#include "ringfilm/surface/face/face_invention.hpp"

namespace ringfilm::surface {
namespace {

/// A spline of so many points is a matter of milliseconds, and its equations are still far from singular.
constexpr std::size_t kMaxTracePoints = 8192;
constexpr int kMaxPassesOfFit = 80;
constexpr int kFreePasses = 8;  ///< steps of the slope itself between a tilt too small and one too large
constexpr double kTiltSettled = 1e-10;

/// Seeks the tilt with which the running surface is level. Its slope jumps where a part joins the running surface or
/// leaves it, and steps of the slope alone may go round there for ever: between tilts too small and too large the
/// middle is tried.
class TiltSearch {
 public:
  /// The tilt to try next, after the slope that one left; nothing where it is found.
  std::optional<double> next(double tilt, double slope) {
    if (std::abs(slope) < kTiltSettled) return std::nullopt;
    (slope > 0 ? too_small_ : too_large_) = tilt;
    const double stepped = tilt + slope;
    if (!too_small_ || !too_large_) return stepped;
    if (*too_small_ >= *too_large_) {
      (slope > 0 ? too_large_ : too_small_).reset();
      return stepped;
    }
    if (*too_large_ - *too_small_ < kTiltSettled) return std::nullopt;
    const bool inside = stepped > *too_small_ && stepped < *too_large_;
    return inside && ++free_passes_ <= kFreePasses ? stepped : (*too_small_ + *too_large_) / 2;
  }

 private:
  std::optional<double> too_small_, too_large_;
  int free_passes_ = 0;
};

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
  if (!std::isfinite(rule.running_surface_height_m) || rule.running_surface_height_m <= 0) {
    throw InputError("the height of the running surface is not a length above zero", "for example 1 um");
  }
  if (!std::isfinite(rule.tilt)) {
    throw InputError("the tilt of the face is not a finite number", "a slope is required, for example 0.002");
  }
  // Heights are lowered by tilt * x, which is a rotation as long as its cosine is 1: at 0.1 lengths are 0.5 % off.
  constexpr double kMaxTilt = 0.1;
  if (std::abs(rule.tilt) > kMaxTilt) {
    throw InputError("the tilt of the face is " + number_text(rule.tilt) + " rad, more than any holder has",
                     "a slope of -0.1 to 0.1 is expected, for example 2 mrad");
  }
  if (rule.pore_depth_m && (!std::isfinite(*rule.pore_depth_m) || *rule.pore_depth_m <= 0)) {
    throw InputError("the depth from which on pores are omitted is not a length above zero",
                     "some three times the roughness, for example 1 um");
  }
  const double length = trace.x_m.back() - trace.x_m.front();
  if (length < rule.width_m * (1 - 1e-6)) {
    throw InputError(
        "the trace is " + text_in(length, kMicrometre) + " long and does not cover the face of " +
            text_in(rule.width_m, kMicrometre),
        "no shape is invented beyond a trace; measure a longer one, or state the width that it covers (--width)");
  }
  if (!rule.start_m) return;
  if (std::isfinite(*rule.start_m) && *rule.start_m >= trace.x_m.front() - 1e-6 * rule.width_m &&
      *rule.start_m + rule.width_m <= trace.x_m.back() + 1e-6 * rule.width_m) {
    return;
  }
  throw InputError(
      "the face of " + text_in(rule.width_m, kMicrometre) + " does not lie in the trace from the stated start on",
      "the trace runs from " + text_in(trace.x_m.front(), kMicrometre) + " to " +
          text_in(trace.x_m.back(), kMicrometre) + ": state another --start, or none");
}

}  // namespace

std::string FitArtifact::words() const {
  const std::string size = text_in(size_m, kMicrometre, 3) + " ";
  return "x = " + range_in(from_m, to_m, kMillimetre, 4) + ": " +
         (reason == InventionReason::kDeparts ? "the polynomial lies " + size + "off the trace"
          : reason == InventionReason::kTurnNotInTrace
              ? "the polynomial's gap falls by " + size + "where that of the trace does not"
              : "the gap falls by " + size + "towards the edge, in polynomial and trace");
}

FaceFit fit_face(const Trace& trace, const FaceRule& rule) {
  const Trace untilted = gap_trace(trace, rule.sense);
  check_rule(untilted, rule);
  FaceFit fit;
  fit.spline_cutoff_m = rule.spline_cutoff_m.value_or(rule.width_m / 10);
  if (rule.levelling == FaceLevelling::kStated) fit.tilt = rule.tilt;
  TiltSearch search;
  Trace gap;
  RunningSurface running_surface{};
  std::vector<double> smooth;
  for (int pass = 1;; ++pass) {
    Trace whole = untilted;
    remove_tilt(whole, fit.tilt);
    fit.start_m = std::clamp(rule.start_m.value_or(found_start(whole, rule.width_m)), whole.x_m.front(),
                             std::max(whole.x_m.front(), whole.x_m.back() - rule.width_m));
    gap = window(whole, fit.start_m, rule.width_m);
    fit.averaged = static_cast<int>((gap.x_m.size() - 1) / kMaxTracePoints + 1);
    if (fit.averaged > 1) gap = averaged(gap, static_cast<std::size_t>(fit.averaged));
    if (rule.pore_depth_m) {
      const std::size_t before = gap.x_m.size();
      gap = without_pores(std::move(gap), *rule.pore_depth_m, fit.spline_cutoff_m);
      fit.pore_share = static_cast<double>(before - gap.x_m.size()) / static_cast<double>(before);
    }
    smooth = SmoothingSpline(gap.x_m, gap.height_m, fit.spline_cutoff_m).height_m();
    running_surface = running_surface_of(smooth, rule.running_surface_height_m);
    if (rule.levelling != FaceLevelling::kRunningSurface) break;
    const std::optional<double> tilt = search.next(fit.tilt, slope_over(gap, running_surface));
    if (!tilt) break;
    if (pass == kMaxPassesOfFit) {
      throw InputError(
          "the running surface of the face cannot be made level: with each tilt another part of the trace is the "
          "running surface",
          "state the tilt of the holder (--tilt \"2 mrad\"), take the trace as it is (--levelling none), or state a "
          "larger height of the running surface (--running-surface-height \"5 um\")");
    }
    fit.tilt = *tilt;
  }
  if (rule.direction == FaceDirection::kTurned) {
    for (double& x : gap.x_m) x = rule.width_m - x;
    std::reverse(gap.x_m.begin(), gap.x_m.end());
    std::reverse(gap.height_m.begin(), gap.height_m.end());
    std::reverse(smooth.begin(), smooth.end());
    running_surface = {gap.x_m.size() - 1 - running_surface.last, gap.x_m.size() - 1 - running_surface.first};
  }
  fit.running_surface_from_m = gap.x_m[running_surface.first];
  fit.running_surface_to_m = gap.x_m[running_surface.last];
  if (rule.zero == FaceZero::kMinPoint) {
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
