#include "ringfilm/case/accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "ringfilm/base/number_text.hpp"

namespace ringfilm::cycle {
namespace {

struct Measured {
  double accuracy;  ///< [%]
  Resolution resolution;
};
/// docs/theory/film.md, "accuracy in place of a grid".
constexpr std::array kMeasured = {Measured{0.1, {400, 320, 12, 1.5e-4, 1e-7}}, Measured{0.5, {72, 96, 12, 3e-3, 1e-6}},
                                  Measured{1, {48, 64, 12, 1e-2, 1e-6}}, Measured{5, {24, 40, 15, 6e-2, 1e-5}}};
/// From here on cells by gap cost less than uniform ones for the same accuracy [%].
constexpr double kFinestByGap = 0.5;

/// Next to gas the film ends at a meniscus: values came as near with cells and steps for a fifth of the accuracy.
constexpr double kOfFilmNextToGas = 0.2;

/// With oil on the liner, of which a nearly dry ring lives for many cycles: fixed steps and cells by gap cost less than
/// adaptive ones for the same values (docs/theory/oil-supply.md, "Accuracy").
struct OnLiner {
  double accuracy;  ///< [%]
  int cells_by_gap;
  double crank_step_deg;
};
constexpr std::array kMeasuredOnLiner = {OnLiner{0.1, 800, 0.25}, OnLiner{0.5, 400, 0.5}, OnLiner{1, 200, 0.5},
                                         OnLiner{5, 100, 1}};
/// Uniform cells for as many by gap [-].
constexpr double kUniformPerByGap = 4.0 / 3;
/// Change of a cycle that counts as none, over the accuracy [1/%].
constexpr double kStepErrorPerPercent = 1e-3;
constexpr double kToleranceOnLiner = 1e-6;

/// The coarsest that was measured to be as accurate.
const OnLiner& on_liner_for(double accuracy) {
  const auto coarser = std::upper_bound(kMeasuredOnLiner.begin() + 1, kMeasuredOnLiner.end(), accuracy,
                                        [](double value, const OnLiner& m) { return value < m.accuracy; });
  return *(coarser - 1);
}

/// The longest step up to `longest` of which the angles that are asked for are multiples; of others that are listed
/// 1 degree, which most lists are multiples of.
double step_for(const Output& output, double longest) {
  const std::vector<double>& angles = output.crank_angles_deg;
  const bool is_passed = angles.size() == 1 && std::remainder(angles.front(), longest) == 0;
  const bool has_list = !angles.empty() || !output.field_angles_deg.empty();
  if (is_passed && output.field_angles_deg.empty()) return longest;
  if (has_list) return std::min(longest, 1.0);
  return output.crank_angle_step_deg / std::ceil(output.crank_angle_step_deg / longest);
}

}  // namespace

Resolution resolution_for(double accuracy) {
  const auto above = std::lower_bound(kMeasured.begin() + 1, kMeasured.end() - 1, accuracy,
                                      [](const Measured& m, double value) { return m.accuracy < value; });
  const Measured &finer = *(above - 1), &coarser = *above;
  const double share = std::log(accuracy / finer.accuracy) / std::log(coarser.accuracy / finer.accuracy);
  const auto between = [share](double a, double b) { return a * std::pow(b / a, share); };
  const auto cells = [&](int Resolution::*of) {
    return static_cast<int>(std::lround(between(finer.resolution.*of, coarser.resolution.*of)));
  };
  const double step_error = between(finer.resolution.step_error, coarser.resolution.step_error);
  const double tolerance = between(finer.resolution.tolerance, coarser.resolution.tolerance);
  const Resolution& at_least = accuracy < coarser.accuracy ? finer.resolution : coarser.resolution;
  return {cells(&Resolution::cells_by_gap), cells(&Resolution::uniform_cells), at_least.crank_step_deg, step_error,
          tolerance};
}

Case with_accuracy(Case c, CellLengths coarse) {
  Solver& solver = c.solver;
  if (!solver.accuracy) return c;
  solver.time_scheme = TimeScheme::kBdf2;
  if (c.film.supply_at_inlet() == OilSupply::kFilmOnLiner && !c.is_unrolled()) {
    const OnLiner& resolution = on_liner_for(*solver.accuracy);
    solver.cell_lengths = coarse;
    const double cells = resolution.cells_by_gap * (coarse == CellLengths::kByGap ? 1 : kUniformPerByGap);
    solver.cells = static_cast<int>(std::lround(cells));
    solver.crank_step_deg = step_for(c.output, resolution.crank_step_deg);
    solver.crank_step_control = StepControl::kFixed;
    solver.step_error = kStepErrorPerPercent * *solver.accuracy;
    solver.tolerance = kToleranceOnLiner;
    return c;
  }
  const double accuracy = *solver.accuracy * (c.film.has_gas_edge() ? kOfFilmNextToGas : 1);
  const Resolution resolution = resolution_for(accuracy);
  solver.cell_lengths = accuracy < kFinestByGap ? CellLengths::kUniform : coarse;
  solver.cells = solver.cell_lengths == CellLengths::kByGap ? resolution.cells_by_gap : resolution.uniform_cells;
  solver.crank_step_deg = step_for(c.output, resolution.crank_step_deg);
  solver.crank_step_control = StepControl::kAdaptive;
  solver.step_error = resolution.step_error;
  solver.tolerance = resolution.tolerance;
  return c;
}

bool is_chosen_by_accuracy(const std::string& key) {
  constexpr std::array<std::string_view, 7> kKeys = {
      "solver.cells",       "solver.cell_lengths", "solver.crank_step", "solver.crank_step_control",
      "solver.time_scheme", "solver.step_error",   "solver.tolerance"};
  return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

std::string accuracy_text(const Case& c) {
  return formatted(
      "solver.accuracy = %.3g %%: computed on %d %s cells with crank steps of %.3g degree%s, "
      "time_scheme = \"bdf2\", step_error = %.2g and tolerance = %.1g, whatever [solver] states of these",
      *c.solver.accuracy, c.solver.cells, c.solver.cell_lengths == CellLengths::kUniform ? "uniform" : "by-gap",
      c.solver.crank_step_deg, c.solver.crank_step_control == StepControl::kFixed ? "" : " at the most",
      c.solver.step_error, c.solver.tolerance);
}

}  // namespace ringfilm::cycle
