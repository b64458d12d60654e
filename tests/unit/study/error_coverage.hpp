#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "../../scenarios/usual_engine.hpp"
#include "ringfilm/study/ensemble/error_estimate.hpp"

/// Do the error bands hold what they promise? Seeded cases, each against an integration on a much finer grid.
namespace ringfilm::study::testing {

/// Usual engines at 800-6000 rpm, on grids that are rather too coarse: 40-120 cells, crank steps of 1-2 degree,
/// adaptive and fixed.
inline cycle::Case coverage_case(std::uint64_t seed) {
  ringfilm::scenarios::RepeatableNumbers draw(seed);
  cycle::Case c = ringfilm::scenarios::usual_engine(draw, 800, 6000);
  c.solver.cells = static_cast<int>(draw.log_between(40, 120));
  c.solver.crank_step_deg = draw.one_of(2) == 0 ? 1 : 2;
  c.solver.crank_step_control = draw.one_of(2) == 0 ? cycle::StepControl::kFixed : cycle::StepControl::kAdaptive;
  c.output.crank_angle_step_deg = 2;
  return c;
}

/// How many errors were within their band, and how much wider the band was.
struct Coverage {
  long values = 0, within = 0;
  std::vector<double> width;  ///< band over true error, where there is one

  /// @param band NaN, where there is no estimate, holds nothing
  /// @param value what has the error; what the iteration leaves of it, 1e-7, is not a measure of the width of a band
  void add(double error, double band, double value) {
    ++values;
    within += error <= band;
    if (error > 1e-7 * std::abs(value) && !std::isnan(band)) width.push_back(band / error);
  }
  void add(const Coverage& other) {
    values += other.values;
    within += other.within;
    width.insert(width.end(), other.width.begin(), other.width.end());
  }
  /// NaN of nothing.
  double share() const { return static_cast<double>(within) / static_cast<double>(values); }
  double median_width() {
    if (width.empty()) return 0;
    const auto middle = width.begin() + static_cast<std::ptrdiff_t>(width.size() / 2);
    std::nth_element(width.begin(), middle, width.end());
    return *middle;
  }
};

/// By quantity.
struct CoverageTable {
  std::map<std::string, Coverage> values, curves;
  long cases = 0, stopped = 0, not_estimated = 0;
};

inline Coverage together(const std::map<std::string, Coverage>& parts) {
  Coverage all;
  for (const auto& [name, part] : parts) all.add(part);
  return all;
}

/// Compares the estimate of `c` with an integration on `finer` times the cells and steps. Exact inputs do not count.
inline void add_case(const cycle::Case& c, int finer, CoverageTable& table) {
  cycle::Case fine = c;
  fine.solver.cells *= finer;
  fine.solver.crank_step_deg /= finer;
  fine.solver.step_error /= finer * finer;
  cycle::CycleResult result, truth;
  try {
    result = cycle::simulate(cycle::prepare(c));
    truth = cycle::simulate(cycle::prepare(fine));
  } catch (const cycle::StoppedCycle&) {
    ++table.stopped;
    return;
  }
  const ErrorEstimate errors = error_estimate(c, result);
  ++table.cases;
  const auto add = [&](double error, double band, double value, Coverage& coverage) {
    if (std::isnan(error)) return;
    table.not_estimated += std::isnan(band);
    if (std::isnan(band) || band > 0 || error > 0) coverage.add(error, band, value);
  };
  for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
    double error = result.values.*quantity.value - truth.values.*quantity.value;
    if (quantity.unit == "degree") error = std::remainder(error, 720);
    add(std::abs(error), errors.values.*quantity.value, result.values.*quantity.value, table.values[quantity.name]);
  }
  for (const cycle::CurveQuantity& quantity : cycle::curve_quantities()) {
    if (!has_error(quantity)) continue;
    for (std::size_t k = 0; k < result.samples.size(); ++k) {
      const double error = result.samples[k].*quantity.value - truth.samples[k].*quantity.value;
      add(std::abs(error), errors.samples[k].*quantity.value, result.samples[k].*quantity.value,
          table.curves[quantity.name]);
    }
  }
}

}  // namespace ringfilm::study::testing
