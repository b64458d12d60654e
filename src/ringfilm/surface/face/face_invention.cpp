#include "ringfilm/surface/face/face_invention.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/surface/friction_loop/lateral_force_loop.hpp"

namespace ringfilm::surface {
namespace {

/// Beyond so many standard errors a departure is not noise: some 20 independent places are looked at.
constexpr double kSure = 4;
/// Rounding of heights is not a departure, however quiet the trace [m].
constexpr double kMin = 1e-10;

std::vector<double> difference(const Trace& gap, const FacePolynomial& polynomial) {
  std::vector<double> left(gap.x_m.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = gap.height_m[i] - polynomial.height_m(gap.x_m[i]);
  return left;
}

}  // namespace

Departure::Departure(const Trace& gap, const FacePolynomial& polynomial, double cutoff_m)
    : polynomial_(polynomial), spline_(gap.x_m, difference(gap, polynomial), cutoff_m) {
  std::vector<double> noise = difference(gap, polynomial);
  double squares = 0;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    noise[i] -= spline_.height_m()[i];
    squares += noise[i] * noise[i];
  }
  const double n = static_cast<double>(noise.size());
  // The spline leaves n - (2 tr S - tr S^2) squares of white noise; with its transmission 2 tr S - tr S^2 is 2.8 per
  // cut-off.
  const double width = gap.x_m.back() - gap.x_m.front();
  noise_m_ = std::sqrt(squares / std::max(1.0, n - 2.8 * width / cutoff_m));
  memory_ = n / independent_points(noise);
  const double coefficients = static_cast<double>(polynomial.coefficients_mm_um().size());
  polynomial_m_ = noise_m_ * std::sqrt(coefficients * memory_ / n);
}

double Departure::error_m(double x) const { return noise_m_ * std::sqrt(memory_) * spline_.error_share(x); }

void Departure::append_departures(std::vector<FitArtifact>& all) const {
  const auto& x = spline_.x_m();
  const auto& apart = spline_.height_m();
  FitArtifact* open = nullptr;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double size = std::abs(apart[i]);
    if (size <= std::max(kMin, kSure * std::hypot(error_m(x[i]), polynomial_m_))) {
      open = nullptr;
      continue;
    }
    if (open == nullptr) {
      all.push_back({x[i], x[i], InventionReason::kDeparts, 0});
      open = &all.back();
    }
    open->to_m = x[i];
    open->size_m = std::max(open->size_m, size);
  }
}

void Departure::append_turns(std::vector<FitArtifact>& all) const {
  const double width = polynomial_.width_m();
  std::vector<double> turns = polynomial_.turning_points_m();
  turns.insert(turns.begin(), 0.0);
  turns.push_back(width);
  const std::size_t lowest = static_cast<std::size_t>(
      std::min_element(turns.begin(), turns.end(),
                       [&](double a, double b) { return polynomial_.height_m(a) < polynomial_.height_m(b); }) -
      turns.begin());
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    // From the lowest point outwards the gap of a face rises; a piece that falls outwards is looked at.
    const bool right_of_it = k >= lowest;
    const double inner = right_of_it ? turns[k] : turns[k + 1], outer = right_of_it ? turns[k + 1] : turns[k];
    const double fall = polynomial_.height_m(inner) - polynomial_.height_m(outer);
    if (fall <= std::max(kMin, kSure * polynomial_m_)) continue;
    const double traced_fall = traced_m(inner) - traced_m(outer);
    const bool in_trace = traced_fall > 2 * std::hypot(error_m(inner), error_m(outer));
    const bool reaches_edge = outer == 0 || outer == width;
    if (in_trace && !reaches_edge) continue;  // a groove that is there
    all.push_back({turns[k], turns[k + 1],
                   in_trace ? InventionReason::kFallsTowardsTheEdge : InventionReason::kTurnNotInTrace, fall});
  }
}

std::vector<FitArtifact> Departure::invented() const {
  std::vector<FitArtifact> all;
  append_departures(all);
  append_turns(all);
  std::stable_sort(all.begin(), all.end(),
                   [](const FitArtifact& a, const FitArtifact& b) { return a.from_m < b.from_m; });
  return all;
}

}  // namespace ringfilm::surface
