#include "ringfilm/cycle/march/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ringfilm/cycle/cycle_values.hpp"
#include "ringfilm/cycle/march/sampling.hpp"
#include "ringfilm/cycle/note_topics.hpp"
#include "ringfilm/cycle/validity.hpp"

namespace ringfilm::cycle {
namespace {

/// Angles closer than this are the same [degree].
constexpr double kSameAngle = 1e-9;

std::vector<double> wanted_angles(const Output& output) {
  if (!output.crank_angles_deg.empty()) return output.crank_angles_deg;
  std::vector<double> angles;
  const int n = static_cast<int>(std::lround(kCycleDeg / output.crank_angle_step_deg));
  for (int i = 0; i < n; ++i) angles.push_back(kCycleDeg * i / n);
  return angles;
}

bool is_multiple(double angle, double step) { return std::abs(std::remainder(angle, step)) < kSameAngle; }

}  // namespace

Recorder::Recorder(const Setup& setup)
    : setup_(setup),
      step_deg_(setup.input.solver.crank_step_deg),
      base_(steps_per_cycle(setup.input.solver)),
      is_passed_(base_.size(), false),
      wanted_deg_(wanted_angles(setup.input.output)) {
  if (setup.input.is_unrolled()) unrolled_.emplace(setup);
  if (setup.input.output.fields == FieldsWanted::kAll) field_deg_ = wanted_deg_;
  if (setup.input.output.fields == FieldsWanted::kListed) field_deg_ = setup.input.output.field_angles_deg;
  for (const auto& angles : {wanted_deg_, field_deg_}) {
    for (const double angle : angles) {
      if (!is_multiple(angle, step_deg_)) between_[angle] = std::nullopt;
    }
  }
}

bool Recorder::wants_fields(double crank_angle_deg) const {
  const auto next = std::lower_bound(field_deg_.begin(), field_deg_.end(), crank_angle_deg - kSameAngle);
  return next != field_deg_.end() && *next < crank_angle_deg + kSameAngle;
}

void Recorder::keep(const March& march, const Instant& instant, Sample& slot) {
  sheet::SheetIntegrals of_sheet;
  film::FilmIntegrals& integrals = of_sheet.mean;
  if (unrolled_) {
    of_sheet = sheet::sheet_integrals(*march.sheet(), sheet_inputs(instant.inputs), *instant.previous, *instant.state);
  } else {
    integrals = film::film_integrals(march.problem(), instant.inputs, *instant.previous, *instant.state);
  }
  slot = sample(setup_, march, instant, integrals);
  if (unrolled_) unrolled_->keep(march, instant, of_sheet, slot);
  max_load_residual_ = std::max(max_load_residual_, slot.load_residual);
  largest_flow_ = std::max(largest_flow_, std::abs(integrals.flow_middle));
  if (march.problem().cavitation == film::Cavitation::kMassConserving) {
    largest_mass_defect_ = std::max(largest_mass_defect_, std::abs(integrals.mass_defect));
  }
  const double beyond = integrals.asperity_load_beyond_polynomial;
  if (setup_.input.contact.integrals == ContactIntegrals::kPolynomialAsPrinted && beyond > 0) {
    ++polynomial_steps_;
    polynomial_share_ = std::max(polynomial_share_, beyond / integrals.asperity_load);
  }
  if (wants_fields(instant.crank_angle_deg)) {
    FaceFields fields;
    append_fields(setup_, march, instant, fields);
    if (unrolled_) unrolled_->keep_fields(march, instant, of_sheet);
    fields_[instant.crank_angle_deg] = std::move(fields);
  }
}

void Recorder::before_step(March& march, double from_deg, double to_deg) {
  const double turn = kCycleDeg * std::floor(from_deg / kCycleDeg);
  const double end = to_deg - turn - kSameAngle;
  for (auto it = between_.upper_bound(from_deg - turn + kSameAngle); it != between_.end() && it->first < end; ++it) {
    film::FilmState state;
    Instant instant = march.side_step(turn + it->first, state);
    instant.crank_angle_deg = it->first;
    keep(march, instant, it->second.emplace());
  }
}

void Recorder::after_step(const March& march) {
  Instant instant = march.instant();
  if (march.at_base_angle()) {
    const auto k = static_cast<std::size_t>(std::lround(instant.crank_angle_deg / step_deg_)) % base_.size();
    instant.crank_angle_deg = static_cast<double>(k) * step_deg_;
    keep(march, instant, base_[k]);
    is_passed_[k] = true;
    return;
  }
  const auto asked = between_.lower_bound(instant.crank_angle_deg - kSameAngle);
  if (asked == between_.end() || asked->first > instant.crank_angle_deg + kSameAngle) return;
  instant.crank_angle_deg = asked->first;
  keep(march, instant, asked->second.emplace());
}

CycleResult Recorder::result(const March& march, double periodicity_error, int steps_marched,
                             Completeness completeness) const {
  CycleResult result;
  result.complete = completeness == Completeness::kComplete;
  result.samples.reserve(wanted_deg_.size());
  for (const double angle : wanted_deg_) {
    const auto between = between_.find(angle);
    const auto k = static_cast<std::size_t>(std::lround(angle / step_deg_)) % base_.size();
    const bool is_between = between != between_.end();
    if (is_between ? between->second.has_value() : is_passed_[k]) {
      result.samples.push_back(is_between ? *between->second : base_[k]);
    } else if (result.complete) {
      throw std::logic_error("an angle asked for was never passed");
    }
  }
  result.fields = empty_fields(setup_, march);
  for (const auto& [angle, f] : fields_) {
    const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    result.fields.crank_angle_deg.push_back(angle);
    append(result.fields.film_thickness, f.film_thickness);
    append(result.fields.film_pressure, f.film_pressure);
    append(result.fields.fill, f.fill);
    append(result.fields.film_parameter, f.film_parameter);
    append(result.fields.asperity_pressure, f.asperity_pressure);
  }
  std::vector<Sample> passed;  // only of a march that stopped: else all of them
  if (!result.complete) {
    for (std::size_t k = 0; k < base_.size(); ++k) {
      if (is_passed_[k]) passed.push_back(base_[k]);
    }
  }
  const std::vector<Sample>& base = result.complete ? base_ : passed;
  result.values = result.complete ? cycle_values(setup_, base) : no_cycle_values();
  if (result.complete) result.stroke = stroke_profile(setup_, base);
  if (unrolled_) unrolled_->add_to(result, march, base);
  result.derived = derived_values(setup_, march.problem().grid);

  const March::Totals& totals = march.totals();
  result.effort = {static_cast<double>(steps_marched) / static_cast<double>(base_.size()),
                   periodicity_error,
                   totals.crank_steps,
                   totals.newton_iterations,
                   totals.sub_steps,
                   totals.fallback_secant,
                   totals.fallback_sub_step,
                   max_load_residual_,
                   totals.max_newton_step,
                   largest_flow_ > 0 ? largest_mass_defect_ / largest_flow_ : 0.0,
                   totals.relaxation_sweeps};
  result.notes = setup_.notes;
  append_validity_notes(setup_, march.problem().grid, base, result.complete ? result.values.fmep : 0.0,
                        {polynomial_steps_, polynomial_share_}, result.notes);
  append_effort_notes(result.effort, totals, result.notes);
  sort_notes(result.notes);
  return result;
}

}  // namespace ringfilm::cycle
