#include "ringfilm/surface/face/face_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/surface/face/face_spline.hpp"

namespace ringfilm::surface {
namespace {

constexpr int kMaxPassesOfAlignment = 30;

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

}  // namespace

Trace gap_trace(const Trace& trace, HeightSense sense) {
  if (trace.x_m.size() != trace.height_m.size()) {
    throw InputError("the trace has " + std::to_string(trace.x_m.size()) + " places and " +
                         std::to_string(trace.height_m.size()) + " heights",
                     "equally many of both are required");
  }
  if (trace.x_m.size() < 2) {
    throw InputError("the trace has too few points, " + std::to_string(trace.x_m.size()), "give the whole trace");
  }
  for (std::size_t i = 0; i < trace.x_m.size(); ++i) {
    const bool is_place = !std::isfinite(trace.x_m[i]);
    if (!is_place && std::isfinite(trace.height_m[i])) continue;
    throw InputError("the trace holds a value that is not a number: point " + std::to_string(i + 1) + " has the " +
                         (is_place ? "place " + number_text(trace.x_m[i]) : "height " + number_text(trace.height_m[i])),
                     "leave points that were not measured out");
  }
  if (!std::is_sorted(trace.x_m.begin(), trace.x_m.end(), std::less_equal<>())) {
    throw InputError("the places of the trace do not rise", "x must increase from point to point");
  }
  Trace gap = trace;
  if (sense == HeightSense::kMaterial) {
    for (double& h : gap.height_m) h = -h;
  }
  return gap;
}

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

Trace without_pores(Trace trace, double depth, double cutoff) {
  for (int pass = 0; pass < kMaxPassesOfAlignment; ++pass) {
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

RunningSurface running_surface_of(const std::vector<double>& smooth, double running_surface_height) {
  const std::size_t lowest = static_cast<std::size_t>(std::min_element(smooth.begin(), smooth.end()) - smooth.begin());
  const double limit = smooth[lowest] + running_surface_height;
  RunningSurface running_surface{lowest, lowest};
  while (running_surface.first > 0 && smooth[running_surface.first - 1] <= limit) --running_surface.first;
  while (running_surface.last + 1 < smooth.size() && smooth[running_surface.last + 1] <= limit) ++running_surface.last;
  return running_surface;
}

double slope_over(const Trace& trace, const RunningSurface& running_surface) {
  double x_mean = 0, h_mean = 0, xh = 0, xx = 0;
  const double n = static_cast<double>(running_surface.last - running_surface.first + 1);
  for (std::size_t i = running_surface.first; i <= running_surface.last; ++i) {
    x_mean += trace.x_m[i] / n;
    h_mean += trace.height_m[i] / n;
  }
  for (std::size_t i = running_surface.first; i <= running_surface.last; ++i) {
    xh += (trace.x_m[i] - x_mean) * (trace.height_m[i] - h_mean);
    xx += (trace.x_m[i] - x_mean) * (trace.x_m[i] - x_mean);
  }
  return xx > 0 ? xh / xx : 0.0;
}

void remove_tilt(Trace& trace, double tilt) {
  for (std::size_t i = 0; i < trace.x_m.size(); ++i) trace.height_m[i] -= tilt * (trace.x_m[i] - trace.x_m.front());
}

}  // namespace ringfilm::surface
