#include "ringfilm/cycle/accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace ringfilm::cycle {
namespace {

struct Measured {
  double accuracy;  ///< [%]
  Resolution resolution;
};
/// docs/manual/performance.md, "accuracy and cost".
constexpr std::array kMeasured = {Measured{0.1, {320, CellLengths::kUniform, 12, 1.5e-4, 1e-7}},
                                  Measured{0.5, {72, CellLengths::kByGap, 12, 3e-3, 1e-6}},
                                  Measured{1, {48, CellLengths::kByGap, 12, 1e-2, 1e-6}},
                                  Measured{5, {24, CellLengths::kByGap, 15, 6e-2, 1e-5}}};

/// Next to gas the film ends at a meniscus: values came as near with cells and steps for a fifth of the accuracy.
constexpr double kOfFilmNextToGas = 0.2;

/// The longest step up to `longest` of which the angles that are asked for are multiples; of a list 1 degree, which
/// most lists are multiples of.
double step_for(const Output& output, double longest) {
  const bool is_one_angle = output.crank_angles_deg.size() == 1;
  const bool has_list = output.crank_angles_deg.size() > 1 || !output.field_angles_deg.empty();
  if (has_list) return std::min(longest, 1.0);
  if (is_one_angle) return longest;
  return output.crank_angle_step_deg / std::ceil(output.crank_angle_step_deg / longest);
}

}  // namespace

Resolution resolution_for(double accuracy) {
  const auto above = std::lower_bound(kMeasured.begin() + 1, kMeasured.end() - 1, accuracy,
                                      [](const Measured& m, double value) { return m.accuracy < value; });
  const Measured &finer = *(above - 1), &coarser = *above;
  const double share = std::log(accuracy / finer.accuracy) / std::log(coarser.accuracy / finer.accuracy);
  const auto between = [share](double a, double b) { return a * std::pow(b / a, share); };
  const double cells = between(finer.resolution.cells, coarser.resolution.cells);
  const double step_error = between(finer.resolution.step_error, coarser.resolution.step_error);
  const Resolution& at_least = accuracy < coarser.accuracy ? finer.resolution : coarser.resolution;
  const double tolerance = between(finer.resolution.tolerance, coarser.resolution.tolerance);
  return {static_cast<int>(std::lround(cells)), at_least.cell_lengths, at_least.crank_step_deg, step_error, tolerance};
}

Case with_accuracy(Case c) {
  Solver& solver = c.solver;
  if (!solver.accuracy) return c;
  const Resolution resolution = resolution_for(*solver.accuracy * (c.film.has_gas_edge() ? kOfFilmNextToGas : 1));
  solver.cells = resolution.cells;
  solver.cell_lengths = resolution.cell_lengths;
  solver.crank_step_deg = step_for(c.output, resolution.crank_step_deg);
  solver.crank_step_control = StepControl::kAdaptive;
  solver.time_scheme = TimeScheme::kBdf2;
  solver.step_error = resolution.step_error;
  solver.tolerance = resolution.tolerance;
  return c;
}

std::string accuracy_text(const Case& c) {
  char text[320];
  std::snprintf(text, sizeof text,
                "solver.accuracy = %.3g %%: computed on %d %s cells with crank steps of %.3g degree at the most, "
                "time_scheme = \"bdf2\", step_error = %.2g and tolerance = %.1g, whatever [solver] states of these",
                *c.solver.accuracy, c.solver.cells,
                c.solver.cell_lengths == CellLengths::kUniform ? "uniform" : "by-gap", c.solver.crank_step_deg,
                c.solver.step_error, c.solver.tolerance);
  return text;
}

}  // namespace ringfilm::cycle
