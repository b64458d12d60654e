#include "ringfilm/io/data/trace_cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/models/gas/trace_span.hpp"

namespace ringfilm::io {
namespace {

using base::kCycleDeg;

/// A fall of the angle by this much begins another cycle; a smaller one is a fault [degree].
constexpr double kRestartDeg = kCycleDeg / 2;
constexpr double kSameAngleDeg = 1e-6;

/// Angles that rise over all cycles: at each restart 720 degrees are added. Samples that repeat the angle of the one
/// before, as the end of a cycle and the start of the next do, are omitted.
struct Unrolled {
  std::vector<double> angle_deg;
  std::vector<std::size_t> sample;  ///< index of each among the rows
  std::size_t n_restarts = 0;
};

Unrolled unrolled(const std::vector<double>& angles) {
  Unrolled all;
  double turns = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (i > 0 && angles[i - 1] - angles[i] >= kRestartDeg) {
      turns += kCycleDeg;
      ++all.n_restarts;
    }
    const double angle = angles[i] + turns;
    const bool repeats = turns > 0 && !all.angle_deg.empty() && std::abs(angle - all.angle_deg.back()) <= kSameAngleDeg;
    if (repeats) continue;
    all.angle_deg.push_back(angle);
    all.sample.push_back(i);
  }
  return all;
}

/// Do the angles rise, with no more than a usual distance between them?
bool rises_without_hole(const std::vector<double>& angles) {
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double step = angles[i] - angles[i - 1];
    if (!(step > 0) || step > models::kMaxSampleDistanceDeg * (1 + 1e-9)) return false;
  }
  return true;
}

/// Linear between samples; places are within the angles, or less than a step beyond them.
double value_at(const std::vector<double>& angle, const std::vector<double>& value, double place) {
  const auto next = std::lower_bound(angle.begin(), angle.end(), place - kSameAngleDeg);
  if (next == angle.end()) return value.back();
  const auto k = static_cast<std::size_t>(next - angle.begin());
  if (k == 0 || std::abs(angle[k] - place) <= kSameAngleDeg) return value[k];
  return value[k - 1] + (value[k] - value[k - 1]) * (place - angle[k - 1]) / (angle[k] - angle[k - 1]);
}

/// Each cycle on the angles of the first one.
struct Cycles {
  std::vector<double> angle_deg;
  std::vector<std::size_t> sample;
  std::vector<std::vector<double>> value;
  double left_over_deg = 0;  ///< part of a cycle at the end
};

Cycles cycles_in(const TraceRows& rows, const Unrolled& all) {
  Cycles cycles;
  const double first = all.angle_deg.front(), last = all.angle_deg.back();
  for (std::size_t i = 0; i < all.angle_deg.size() && all.angle_deg[i] < first + kCycleDeg - kSameAngleDeg; ++i) {
    cycles.angle_deg.push_back(all.angle_deg[i]);
    cycles.sample.push_back(all.sample[i]);
  }
  const double reach = last - cycles.angle_deg.back();
  const auto n_cycles = static_cast<std::size_t>(std::floor(reach / kCycleDeg + kSameAngleDeg)) + 1;
  cycles.left_over_deg = reach - kCycleDeg * static_cast<double>(n_cycles - 1);
  for (const std::vector<double>& column : rows.pressure) {
    std::vector<double> value;
    for (const std::size_t i : all.sample) value.push_back(column[i]);
    for (std::size_t k = 0; k < n_cycles; ++k) {
      std::vector<double> of_cycle;
      for (const double angle : cycles.angle_deg) {
        of_cycle.push_back(value_at(all.angle_deg, value, angle + kCycleDeg * static_cast<double>(k)));
      }
      cycles.value.push_back(std::move(of_cycle));
    }
  }
  return cycles;
}

std::string scatter_of(const std::vector<std::vector<double>>& cycles, double peak_of_result,
                       std::optional<double> pressure_scale) {
  std::vector<double> peaks;
  for (const std::vector<double>& cycle : cycles) peaks.push_back(*std::max_element(cycle.begin(), cycle.end()));
  const auto n = static_cast<double>(peaks.size());
  const double mean = std::accumulate(peaks.begin(), peaks.end(), 0.0) / n;
  double squares = 0;
  for (const double peak : peaks) squares += (peak - mean) * (peak - mean);
  const double deviation = std::sqrt(squares / (n - 1));
  const auto shown = [&](double pressure) {
    return pressure_scale ? text_in(pressure * *pressure_scale, kBar, 4) : fmt::format("{:.4g}", pressure);
  };
  return fmt::format("their peaks are {} on the mean with a standard deviation of {:.2g} %, that of the result is {}",
                     shown(mean), mean > 0 ? 100 * deviation / mean : 0, shown(peak_of_result));
}

}  // namespace

void turn_falling(TraceRows& rows) {
  const std::vector<double>& angles = rows.crank_angle_deg;
  if (angles.size() < 3) return;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (angles[i] >= angles[i - 1] && angles[i] - angles[i - 1] < kRestartDeg) return;
  }
  std::reverse(rows.crank_angle_deg.begin(), rows.crank_angle_deg.end());
  for (std::vector<double>& column : rows.pressure) std::reverse(column.begin(), column.end());
  std::reverse(rows.row.begin(), rows.row.end());
  rows.notes.push_back("the crank angle falls from row to row: the rows were turned about");
}

CycleChoice::CycleChoice(const std::optional<std::string>& text) {
  if (!text || *text == "mean") return;
  if (*text == "median") {
    kind_ = Kind::kMedian;
    return;
  }
  std::size_t number = 0;
  const auto [rest, error] = std::from_chars(text->data(), text->data() + text->size(), number);
  const bool is_number = error == std::errc{} && rest == text->data() + text->size() && number > 0;
  kind_ = is_number ? Kind::kNumber : Kind::kUnknown;
  if (is_number) number_ = number;
}

double CycleChoice::value_of(std::vector<double> of_cycles) const {
  if (number_) return of_cycles[*number_ - 1];
  const std::size_t n = of_cycles.size();
  if (kind_ != Kind::kMedian) return std::accumulate(of_cycles.begin(), of_cycles.end(), 0.0) / static_cast<double>(n);
  std::sort(of_cycles.begin(), of_cycles.end());
  return n % 2 == 1 ? of_cycles[n / 2] : (of_cycles[n / 2 - 1] + of_cycles[n / 2]) / 2;
}

std::string CycleChoice::words() const {
  if (number_) return fmt::format("cycle {}", *number_);
  return kind_ == Kind::kMedian ? "their median" : "their mean";
}

std::size_t join_cycles(TraceRows& rows, const CycleChoice& choice, const std::string& shown,
                        std::optional<double> pressure_scale) {
  if (rows.crank_angle_deg.size() < 2) return 1;
  const Unrolled all = unrolled(rows.crank_angle_deg);
  const double span = all.angle_deg.back() - all.angle_deg.front();
  const bool follow = rises_without_hole(all.angle_deg) && (all.n_restarts > 0 || span > kCycleDeg * (1 + 1e-9));
  if (!follow && rows.pressure.size() < 2) return 1;
  Cycles cycles;
  if (follow) {
    cycles = cycles_in(rows, all);
  } else {  // columns alone
    cycles.angle_deg = rows.crank_angle_deg;
    cycles.sample.resize(cycles.angle_deg.size());
    std::iota(cycles.sample.begin(), cycles.sample.end(), std::size_t{0});
    cycles.value = rows.pressure;
  }
  const std::size_t n_cycles = cycles.value.size();
  if (choice.number() && *choice.number() > n_cycles) return n_cycles;  // is reported by the caller
  std::vector<double> result(cycles.angle_deg.size()), of_cycles(n_cycles);
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t k = 0; k < n_cycles; ++k) of_cycles[k] = cycles.value[k][i];
    result[i] = choice.value_of(of_cycles);
  }
  if (n_cycles > 1) {
    const double peak = result.empty() ? 0 : *std::max_element(result.begin(), result.end());
    rows.notes.push_back(fmt::format("{} has {} cycles, and {} was taken (gas.cycle); {}", shown, n_cycles,
                                     choice.words(), scatter_of(cycles.value, peak, pressure_scale)));
  } else {
    rows.notes.push_back(
        fmt::format("{} begins in the middle of a cycle, and was joined where its angle starts again", shown));
  }
  if (cycles.left_over_deg > models::kMaxSampleDistanceDeg) {
    rows.notes.push_back(
        fmt::format("{}: the last {:.4g} degree, a part of a cycle, were omitted", shown, cycles.left_over_deg));
  }
  TraceRows one{std::move(cycles.angle_deg), {std::move(result)}, {}, std::move(rows.notes)};
  for (const std::size_t i : cycles.sample) one.row.push_back(rows.row[i]);
  rows = std::move(one);
  return n_cycles;
}

}  // namespace ringfilm::io
