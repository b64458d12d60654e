#include "ringfilm/surface/friction_loop/lateral_force_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr int kMinLoopPoints = 8;
/// Lags beyond this share of the line are not summed: so far apart the correlation is noise.
constexpr double kMaxLag = 0.25;
constexpr std::size_t kMaxLags = 2000;

struct LoopMean {
  double value;
  double deviation;
};

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double sum_of_squares(const std::vector<double>& values, double mean) {
  double sum = 0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return sum;
}

/// LoopMean and standard error of values along a line.
LoopMean mean_along(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  const double mean = mean_of(values);
  return {mean, std::sqrt(sum_of_squares(values, mean) / (n - 1) / independent_points(values))};
}

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

void check_loop(const FrictionLoop& loop) {
  if (loop.position_m.size() != loop.trace_V.size() || loop.trace_V.size() != loop.retrace_V.size()) {
    throw InputError("a friction loop has " + std::to_string(loop.position_m.size()) + " positions, " +
                         std::to_string(loop.trace_V.size()) + " values of the trace and " +
                         std::to_string(loop.retrace_V.size()) + " of the retrace",
                     "both ways are required at the same positions");
  }
  if (!std::isfinite(loop.load) || !finite(loop.position_m) || !finite(loop.trace_V) || !finite(loop.retrace_V)) {
    throw InputError("a friction loop holds a value that is not a number", "leave the line out");
  }
  if (!std::is_sorted(loop.position_m.begin(), loop.position_m.end(), std::less_equal<>())) {
    throw InputError("the positions of a friction loop do not rise", "turn the retrace round, so that both rise");
  }
}

/// Standard error of the mean of a load: between loops where that is known, along the line elsewhere.
double standard_error(double pooled_variance, int loops, double along_line) {
  return pooled_variance > 0 ? std::sqrt(pooled_variance / loops) : along_line / std::sqrt(static_cast<double>(loops));
}

/// Scatter of one signal between the loops of equal load.
struct Between {
  double squares = 0;
  int freedom = 0;

  double variance() const { return freedom > 0 ? squares / freedom : 0; }
  void add(const std::vector<double>& values) {
    squares += sum_of_squares(values, mean_of(values));
    freedom += static_cast<int>(values.size()) - 1;
  }
};

}  // namespace

double independent_points(const std::vector<double>& values) {
  const std::size_t n = values.size();
  if (n < 2) return static_cast<double>(n);
  const double mean = mean_of(values);
  const double squares = sum_of_squares(values, mean);
  if (!(squares > 0)) return static_cast<double>(n);
  const std::size_t last = std::min(kMaxLags, static_cast<std::size_t>(kMaxLag * static_cast<double>(n)));
  double integral = 1;
  for (std::size_t lag = 1; lag <= last; ++lag) {
    double product = 0;
    for (std::size_t i = lag; i < n; ++i) product += (values[i] - mean) * (values[i - lag] - mean);
    if (product <= 0) break;
    integral += 2 * product / squares;
  }
  return std::max(1.0, static_cast<double>(n) / integral);
}

std::vector<FrictionLoop> loops_of_scan(double load, std::size_t points_x, double step_m,
                                        const std::vector<double>& trace_V, const std::vector<double>& retrace_V) {
  if (points_x == 0 || trace_V.size() != retrace_V.size() || trace_V.size() % points_x != 0 || trace_V.empty()) {
    throw InputError("trace and retrace of a scan are not of one size",
                     "choose the two lateral channels of one scan, of as many lines and points");
  }
  if (!std::isfinite(step_m) || step_m <= 0) throw InputError("the step of a scan is not a length above zero");
  std::vector<FrictionLoop> loops;
  for (std::size_t first = 0; first < trace_V.size(); first += points_x) {
    FrictionLoop loop{load, {}, {}, {}};
    for (std::size_t i = first; i < first + points_x; ++i) {
      loop.position_m.push_back(step_m * static_cast<double>(i - first));
      loop.trace_V.push_back(trace_V[i]);
      loop.retrace_V.push_back(retrace_V[i]);
    }
    if (finite(loop.trace_V) && finite(loop.retrace_V)) loops.push_back(std::move(loop));
  }
  if (loops.empty()) throw InputError("no line of the scan was measured throughout", "choose another scan");
  return loops;
}

LoopFriction loop_friction(const FrictionLoop& loop, double end_share) {
  if (!std::isfinite(end_share) || end_share < 0 || end_share >= 0.5) {
    throw InputError("a share of " + std::to_string(end_share) + " cannot be cut off at each end of a friction loop",
                     "from 0 to below 0.5 is allowed, for example 0.1");
  }
  check_loop(loop);
  std::vector<double> half_difference, half_sum;
  if (!loop.position_m.empty()) {
    const double cut = end_share * (loop.position_m.back() - loop.position_m.front());
    for (std::size_t i = 0; i < loop.position_m.size(); ++i) {
      const double x = loop.position_m[i];
      if (x < loop.position_m.front() + cut || x > loop.position_m.back() - cut) continue;
      half_difference.push_back((loop.trace_V[i] - loop.retrace_V[i]) / 2);
      half_sum.push_back((loop.trace_V[i] + loop.retrace_V[i]) / 2);
    }
  }
  if (half_difference.size() < kMinLoopPoints) {
    throw InputError("a friction loop has " + std::to_string(half_difference.size()) +
                         " points between its ends; the scatter requires at least " + std::to_string(kMinLoopPoints),
                     "give longer lines or cut a smaller share");
  }
  const LoopMean tmr = mean_along(half_difference), offset = mean_along(half_sum);
  for (const double value : {tmr.value, tmr.deviation, offset.value, offset.deviation}) {
    if (std::isfinite(value)) continue;
    throw InputError("the signals of a friction loop are so large that their scatter cannot be expressed as numbers",
                     "trace and retrace are in volts");
  }
  return {tmr.value, tmr.deviation, offset.value, offset.deviation, static_cast<int>(half_difference.size())};
}

std::vector<LoadFriction> friction_of_loads(const std::vector<FrictionLoop>& loops, double end_share,
                                            double load_deviation) {
  if (!std::isfinite(load_deviation) || load_deviation < 0) {
    throw InputError("the standard deviation of the load is not a number from zero on", "0 takes the loads as exact");
  }
  std::vector<std::pair<double, LoopFriction>> measured;
  for (const FrictionLoop& loop : loops) measured.emplace_back(loop.load, loop_friction(loop, end_share));
  std::stable_sort(measured.begin(), measured.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<LoadFriction> loads;
  Between tmr_between, offset_between;
  std::vector<std::pair<double, double>> along;  // standard error along the line, rms over the loops of a load
  for (std::size_t first = 0; first < measured.size();) {
    std::vector<double> tmr, offset;
    double tmr_along = 0, offset_along = 0;
    std::size_t i = first;
    for (; i < measured.size() && measured[i].first == measured[first].first; ++i) {
      const LoopFriction& loop = measured[i].second;
      tmr.push_back(loop.tmr_V);
      offset.push_back(loop.offset_V);
      tmr_along += loop.tmr_deviation_V * loop.tmr_deviation_V;
      offset_along += loop.offset_deviation_V * loop.offset_deviation_V;
    }
    const int count = static_cast<int>(tmr.size());
    Between own;
    own.add(tmr);
    tmr_between.add(tmr);
    offset_between.add(offset);
    along.emplace_back(std::sqrt(tmr_along / count), std::sqrt(offset_along / count));
    loads.push_back(
        {measured[first].first, load_deviation, mean_of(tmr), std::sqrt(own.variance()), 0, mean_of(offset), 0, count});
    first = i;
  }
  for (std::size_t i = 0; i < loads.size(); ++i) {
    loads[i].tmr_deviation_V = standard_error(tmr_between.variance(), loads[i].loops, along[i].first);
    loads[i].offset_deviation_V = standard_error(offset_between.variance(), loads[i].loops, along[i].second);
  }
  return loads;
}

}  // namespace ringfilm::surface
