#include "ringfilm/study/ensemble/error_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "ringfilm/case/accuracy.hpp"
#include "ringfilm/cycle/cycle_values.hpp"
#include "ringfilm/cycle/menisci_cycle.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/simulate.hpp"

namespace ringfilm::study {
namespace {

using cycle::Case;
using cycle::CycleResult;
using cycle::CycleValues;
using cycle::Sample;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// Safety factors of the grid convergence index: orders observed, and not.
constexpr double kObserved = 1.25;
constexpr double kNotObserved = 3;
constexpr double kMinOrder = 0.5;
constexpr double kFormalOrderInStep = 1;  // with BDF2, too, which has steps of first order
/// Neighbours whose differences a curve shares: where a difference changes sign the error does not vanish.
constexpr double kNeighboursDeg = 3;

/// No angle is farther from another.
constexpr double kFarthestAngle = cycle::kCycleDeg / 2;

/// Cells or steps of the grid that is half as fine; of an odd number the ratio is 2 to within a part of the number.
int half(int n) { return (n + 1) / 2; }

double formal_order_in_cells(const Case& c) {
  // Fluxes are second order; the fill in a cavity is upwinded.
  return c.film.cavitation == cycle::Cavitation::kMassConserving ? 1 : 2;
}

/// A value on three grids, each half as fine as the one before; NaN where there is none.
struct ResultLevels {
  double fine, result, coarse;
};

struct Estimate {
  double error = kNone;
  double order = kNone;
};

/// Where no order can be seen; a change that is missing (NaN) leaves the other to go by.
Estimate without_order(double finer_change, double coarser_change) {
  return {kNotObserved * std::fmax(finer_change, coarser_change), kNone};
}

/// Error of the result from the sizes of the changes that refinement and coarsening make in one sense; eq-grid-error.
Estimate estimate(double finer_change, double coarser_change, double formal_order) {
  if (!(coarser_change > finer_change) || finer_change == 0) return without_order(finer_change, coarser_change);
  const double observed = std::log2(coarser_change / finer_change);
  const double order = std::clamp(observed, kMinOrder, formal_order);
  // A change that is smaller than the formal order allows is taken for a chance.
  const double change = std::max(finer_change, coarser_change / std::exp2(formal_order));
  const double growth = std::exp2(order);
  return {kObserved * change * growth / (growth - 1), observed};
}

Estimate estimate(const ResultLevels& levels, double formal_order) {
  const double finer = levels.fine - levels.result;
  const double coarser = levels.result - levels.coarse;
  if (!(finer * coarser > 0)) return without_order(std::abs(finer), std::abs(coarser));
  return estimate(std::abs(finer), std::abs(coarser), formal_order);
}

bool is_angle(const cycle::CycleQuantity& quantity) { return quantity.unit == "degree"; }

/// An angle moves in whole crank steps, so that the largest change is taken as it is.
Estimate angle_estimate(const ResultLevels& levels) {
  const auto turn = [](double a, double b) { return std::abs(std::remainder(a - b, cycle::kCycleDeg)); };
  const double finer = turn(levels.fine, levels.result), coarser = turn(levels.result, levels.coarse);
  return {std::fmax(finer, coarser), kNone};
}

/// What a value cannot be resolved below, whatever the grids give.
double resolution(const Case& c, const cycle::CycleQuantity& quantity, const CycleResult& result) {
  if (is_angle(quantity)) return 0.5 * c.solver.crank_step_deg;
  const double share = result.values.*quantity.value;
  const bool is_begun = cycle::is_regime_share(quantity) && share > 0 && share < 1;
  return is_begun ? c.solver.crank_step_deg / cycle::kCycleDeg : 0;
}

Case on_grid(Case c, int cells, double crank_step_deg) {
  const double ratio = crank_step_deg / c.solver.crank_step_deg;
  if (c.is_unrolled() && cells != c.solver.cells) {
    const double end_cell = c.end_cell() * c.solver.cells / cells;
    c.solver.cells_y = cells > c.solver.cells ? 2 * c.solver.cells_y : half(c.solver.cells_y);
    // Half of an odd number is rounded up: no longer than cells that are all alike.
    if (c.ring.end_gap) c.solver.end_cell = std::min(end_cell, c.ring_length() / c.solver.cells_y);
  }
  c.solver.cells = cells;
  c.solver.crank_step_deg = crank_step_deg;
  // The error of a step goes with its square, of second order with its cube.
  c.solver.step_error *= c.solver.time_scheme == cycle::TimeScheme::kBdf2 ? ratio * ratio * ratio : ratio * ratio;
  c.solver.accuracy.reset();
  c.output.fields = cycle::FieldOutput::kNone;
  return c;
}

/// Two grids to either side of the result's own.
struct Sides {
  const CycleResult* fine;  ///< null: there is none
  const CycleResult* coarse;
};

ResultLevels levels(const CycleResult& result, const Sides& sides, double CycleValues::*value) {
  return {sides.fine ? sides.fine->values.*value : kNone, result.values.*value,
          sides.coarse ? sides.coarse->values.*value : kNone};
}

double iteration_error(const Case& c, double scale) { return cycle::kPeriodicityFactor * c.solver.tolerance * scale; }

void add_value_errors(const Case& c, const CycleResult& result, const Sides& cells, const Sides& step,
                      ErrorEstimate& errors) {
  for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
    const auto value = quantity.value;
    const ResultLevels in_cells = levels(result, cells, value), in_step = levels(result, step, value);
    const bool angle = is_angle(quantity);
    const Estimate by_cells = angle ? angle_estimate(in_cells) : estimate(in_cells, formal_order_in_cells(c));
    const Estimate by_step = angle ? angle_estimate(in_step) : estimate(in_step, kFormalOrderInStep);
    const double by_grid = by_cells.error + by_step.error;
    // What no grid moves is an input, and no iteration moves it.
    const double by_iteration = angle || by_grid == 0 ? 0 : iteration_error(c, std::abs(result.values.*value));
    const double error = by_grid + resolution(c, quantity, result) + by_iteration;
    errors.values.*value = angle ? std::min(error, kFarthestAngle) : error;  // a NaN stays
    errors.order_in_cells.*value = by_cells.order;
    errors.order_in_step.*value = by_step.order;
  }
}

/// For each angle with a change the largest at the angles close to it, of which those without one (NaN) do not count;
/// an angle without one keeps none.
std::vector<double> largest_nearby(const std::vector<double>& changes, const std::vector<Sample>& samples,
                                   double reach_deg) {
  const auto n = static_cast<std::ptrdiff_t>(changes.size());
  std::vector<double> largest = changes;
  const auto at = [n](std::ptrdiff_t k) { return static_cast<std::size_t>((k % n + n) % n); };
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const double angle = samples[at(k)].crank_angle_deg;
    if (std::isnan(changes[at(k)])) continue;
    for (const std::ptrdiff_t way : {-1, 1}) {
      for (std::ptrdiff_t i = 1; i < n; ++i) {
        const std::size_t other = at(k + way * i);
        if (std::abs(std::remainder(samples[other].crank_angle_deg - angle, cycle::kCycleDeg)) > reach_deg) break;
        largest[at(k)] = std::fmax(largest[at(k)], changes[other]);
      }
    }
  }
  return largest;
}

std::vector<double> changes(const CycleResult& result, const CycleResult* other, double Sample::*value) {
  std::vector<double> changes;
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    changes.push_back(other ? std::abs(other->samples[k].*value - result.samples[k].*value) : kNone);
  }
  return changes;
}

/// Parts of the error of one curve that come from the grids to both sides. An order of the angle alone would be noise:
/// it is that of the changes nearby.
std::vector<double> curve_errors(const Case& c, const CycleResult& result, const Sides& sides, double Sample::*value,
                                 double formal_order) {
  const double reach = std::max(kNeighboursDeg, 2 * c.solver.crank_step_deg);
  const auto finer = largest_nearby(changes(result, sides.fine, value), result.samples, reach);
  const auto coarser = largest_nearby(changes(result, sides.coarse, value), result.samples, reach);
  std::vector<double> errors;
  for (std::size_t k = 0; k < finer.size(); ++k) {
    errors.push_back(estimate(finer[k], coarser[k], formal_order).error);
  }
  return errors;
}

/// What follows the fronts of the cavity is known to half a cell at best.
double front_resolution(const Case& c, const cycle::CurveQuantity& quantity) {
  const double half_a_cell = 0.5 / c.solver.cells;
  if (quantity.value == &Sample::cavitated_fraction) return half_a_cell;
  const bool is_position =
      quantity.value == &Sample::rupture_position || quantity.value == &Sample::reformation_position;
  return is_position ? half_a_cell * c.ring.face_width : 0;
}

void add_curve_errors(const Case& c, const CycleResult& result, const Sides& cells, const Sides& step,
                      ErrorEstimate& errors) {
  for (const cycle::CurveQuantity& quantity : cycle::curve_quantities()) {
    if (!has_error(quantity)) continue;
    const auto value = quantity.value;
    const auto by_cells = curve_errors(c, result, cells, value, formal_order_in_cells(c));
    const auto by_step = curve_errors(c, result, step, value, kFormalOrderInStep);
    double scale = 0;
    for (std::size_t k = 0; k < by_cells.size(); ++k) {
      if (by_cells[k] + by_step[k] > 0) scale = std::fmax(scale, std::abs(result.samples[k].*value));
    }
    const double floor = front_resolution(c, quantity) + iteration_error(c, scale);
    for (std::size_t k = 0; k < by_cells.size(); ++k) errors.samples[k].*value = by_cells[k] + by_step[k] + floor;
  }
}

}  // namespace

bool has_error(const cycle::CurveQuantity& quantity) {
  const std::array without = {&Sample::crank_angle_deg, &Sample::newton_iterations, &Sample::crank_sub_steps,
                              &Sample::fallbacks, &Sample::load_residual};
  return std::find(without.begin(), without.end(), quantity.value) == without.end();
}

ErrorEstimate no_estimate(std::size_t n_samples) {
  Sample none;
  for (const cycle::CurveQuantity& quantity : cycle::curve_quantities()) none.*quantity.value = kNone;
  ErrorEstimate errors;
  errors.samples.assign(n_samples, none);
  errors.values = errors.order_in_cells = errors.order_in_step = cycle::no_cycle_values();
  return errors;
}

namespace {

bool has_note(const CycleResult& result, const char* topic) {
  return std::any_of(result.notes.begin(), result.notes.end(),
                     [&](const cycle::Note& note) { return note.topic == topic; });
}

/// Why the difference of a result to that of another grid does not measure its error; empty where it does.
std::string not_comparable(const Case& c, const CycleResult& result, const Ending& other) {
  if (has_note(result, cycle::kCellsGraded) || has_note(other.result, cycle::kCellsGraded)) {
    return "cells were graded, so that their number does not measure the error";
  }
  if (!other.is_solved()) return other.reason();
  if (c.solver.method == cycle::Method::kMenisci && !has_note(result, cycle::kMenisciNotUsed)) {
    return "the film between two menisci has no cells whose number measures the error";
  }
  if (has_note(result, cycle::kSurfacesFlattened) != has_note(other.result, cycle::kSurfacesFlattened)) {
    return "one of the two was computed with surfaces that flatten, the other with rigid ones";
  }
  return "";
}

}  // namespace

std::vector<Case> other_grids(const Case& stated) {
  const Case c = cycle::with_accuracy(stated);
  const int cells = c.solver.cells;
  const double step_deg = c.solver.crank_step_deg;
  const double double_step_deg = cycle::kCycleDeg / half(cycle::steps_per_cycle(c.solver));
  return {on_grid(c, 2 * cells, step_deg), on_grid(c, half(cells), step_deg), on_grid(c, cells, step_deg / 2),
          on_grid(c, cells, double_step_deg)};
}

Case finer_grid(const Case& stated) {
  const Case c = cycle::with_accuracy(stated);
  return on_grid(c, 2 * c.solver.cells, c.solver.crank_step_deg / 2);
}

ErrorEstimate error_estimate(const Case& stated, const CycleResult& result, std::span<const Ending> others) {
  const Case c = cycle::with_accuracy(stated);
  const std::vector<Case> grids = other_grids(c);
  if (others.size() != grids.size()) throw std::logic_error("an error estimate needs an ending on each other grid");
  ErrorEstimate errors = no_estimate(result.samples.size());
  const auto cells_y = [&](const cycle::Solver& solver) { return c.is_unrolled() ? solver.cells_y : 0; };
  errors.runs.push_back({c.solver.cells, c.solver.crank_step_deg, c.solver.step_error, true, "", cells_y(c.solver)});
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const cycle::Solver& solver = grids[i].solver;
    const std::string reason = not_comparable(c, result, others[i]);
    const bool is_usable = reason.empty();
    errors.runs.push_back({solver.cells, solver.crank_step_deg, solver.step_error, is_usable, reason, cells_y(solver)});
  }
  const auto solved = [&](std::size_t i) { return errors.runs[i + 1].solved ? &others[i].result : nullptr; };
  const Sides in_cells{solved(0), solved(1)}, in_step{solved(2), solved(3)};
  add_value_errors(c, result, in_cells, in_step, errors);
  add_curve_errors(c, result, in_cells, in_step, errors);
  return errors;
}

ErrorEstimate error_estimate(const Case& c, const CycleResult& result, const Progress& progress,
                             const BatchOptions& options) {
  return error_estimate(c, result, endings(other_grids(c), progress, options));
}

namespace {

/// The other integration of the pair, of cells or of steps, that run `i` belongs to.
std::size_t partner(std::size_t i) { return i % 2 == 1 ? i + 1 : i - 1; }

bool is_missing(const ErrorEstimate& estimate, std::size_t i) {
  return i < estimate.runs.size() && !estimate.runs[i].solved;
}

std::string grid_words(const GridRun& run) {
  const std::string around = run.cells_y > 0 ? fmt::format(" x {}", run.cells_y) : "";
  return fmt::format("{}{} cells and a crank step of {:.4g} degree", run.cells, around, run.crank_step_deg);
}

}  // namespace

bool has_values(const ErrorEstimate& estimate) {
  for (std::size_t i = 1; i < estimate.runs.size(); i += 2) {
    if (is_missing(estimate, i) && is_missing(estimate, partner(i))) return false;
  }
  return true;
}

std::vector<cycle::Note> notes_on(const ErrorEstimate& estimate) {
  const bool is_there = has_values(estimate);
  std::vector<std::pair<std::string, std::string>> grids;  // by reason
  for (std::size_t i = 1; i < estimate.runs.size(); ++i) {
    if (!is_missing(estimate, i)) continue;
    const GridRun& run = estimate.runs[i];
    const auto known =
        std::find_if(grids.begin(), grids.end(), [&](const auto& one) { return one.first == run.reason; });
    if (known == grids.end()) {
      grids.emplace_back(run.reason, grid_words(run));
    } else {
      known->second += ", " + grid_words(run);
    }
  }
  std::vector<cycle::Note> notes;
  for (const auto& [reason, words] : grids) {
    notes.push_back({is_there ? "error-estimate-one-sided" : "error-estimate-missing",
                     std::string(is_there ? "the error estimate has one side only" : "there is no error estimate") +
                         ": the result with " + words + " cannot be used: " + reason});
  }
  return notes;
}

std::optional<cycle::Note> note_on_accuracy(const Case& c, const CycleResult& result, const ErrorEstimate& estimate) {
  if (!c.solver.accuracy || !has_values(estimate)) return std::nullopt;
  constexpr double kPercent = 100;
  constexpr std::size_t kNamed = 6;
  std::vector<std::pair<double, std::string>> missed;  // error [%], name
  std::size_t n = 0;
  for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
    const double scale = quantity.value == &CycleValues::net_oil_flow ? result.values.mean_absolute_oil_flow
                         : cycle::is_regime_share(quantity)           ? 1
                                                                      : result.values.*quantity.value;
    const double error = kPercent * estimate.values.*quantity.value / std::abs(scale);
    if (is_angle(quantity) || !std::isfinite(error) || error == 0) continue;  // 0: an input
    ++n;
    if (error > *c.solver.accuracy) missed.emplace_back(error, quantity.name);
  }
  std::sort(missed.rbegin(), missed.rend());
  std::string text = fmt::format("by the error estimate {} of {} values of the cycle are within {:.3g} %",
                                 n - missed.size(), n, *c.solver.accuracy);
  for (std::size_t i = 0; i < std::min(kNamed, missed.size()); ++i) {
    text += fmt::format("{}{} ({:.2g} %)", i == 0 ? "; not: " : ", ", missed[i].second, missed[i].first);
  }
  if (missed.size() > kNamed) text += " and " + std::to_string(missed.size() - kNamed) + " others";
  return cycle::Note{"accuracy-reached", text};
}

}  // namespace ringfilm::study
