#include "ringfilm/cycle/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ringfilm/cycle/advice/advice.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/advice/validity.hpp"
#include "ringfilm/cycle/cycle_values.hpp"
#include "ringfilm/cycle/integration/sampling.hpp"

namespace ringfilm::cycle {
namespace {

/// Angles closer than this are the same [degree].
constexpr double kSameSample = 1e-9;

bool is_multiple(double angle, double step) { return std::abs(std::remainder(angle, step)) < kSameSample; }

}  // namespace

std::vector<double> requested_angles(const Output& output) {
  if (!output.crank_angles_deg.empty()) return output.crank_angles_deg;
  std::vector<double> angles;
  const int n = static_cast<int>(std::lround(kCycleDeg / output.crank_angle_step_deg));
  for (int i = 0; i < n; ++i) angles.push_back(kCycleDeg * i / n);
  return angles;
}

Recorder::Recorder(const Setup& setup)
    : setup_(setup),
      step_deg_(setup.input.solver.crank_step_deg),
      base_(steps_per_cycle(setup.input.solver)),
      steps_(base_.size()),
      uncontrolled_(base_.size()),
      is_passed_(base_.size(), false),
      untrusted_share_(base_.size(), 0.0),
      requested_deg_(requested_angles(setup.input.output)) {
  if (setup.input.is_unrolled()) unrolled_.emplace(setup);
  if (setup.input.output.fields == FieldOutput::kAll) field_deg_ = requested_deg_;
  if (setup.input.output.fields == FieldOutput::kListed) field_deg_ = setup.input.output.field_angles_deg;
  for (const auto& angles : {requested_deg_, field_deg_}) {
    for (const double angle : angles) {
      if (!is_multiple(angle, step_deg_)) between_[angle] = std::nullopt;
    }
  }
}

bool Recorder::is_field_angle(double crank_angle_deg) const {
  const auto next = std::lower_bound(field_deg_.begin(), field_deg_.end(), crank_angle_deg - kSameSample);
  return next != field_deg_.end() && *next < crank_angle_deg + kSameSample;
}

double Recorder::keep(const TimeIntegration& integration, const Instant& instant, Sample& slot) {
  film::Film2dIntegrals of_film2d;
  film::Film2dInputs acting;
  film::FilmIntegrals& integrals = of_film2d.mean;
  if (unrolled_) {
    acting = integration.film2d_inputs(instant.at);
    of_film2d = film::film2d_integrals(*integration.film2d(), acting, *instant.previous, *instant.state);
  } else {
    integrals = film::film_integrals(integration.problem(), instant.at.inputs, *instant.previous, *instant.state);
  }
  slot = sample(setup_, integration.problem(), instant, integrals);
  if (setup_.input.bends()) {
    slot.load_residual = ring_imbalance(*integration.film2d(), acting, *instant.state, of_film2d.strips);
  }
  if (unrolled_) unrolled_->keep(integration, instant, of_film2d, slot);
  max_load_residual_ = std::max(max_load_residual_, slot.load_residual);
  largest_flow_ = std::max(largest_flow_, std::abs(integrals.flow_middle));
  if (integration.problem().cavitation == film::Cavitation::kMassConserving) {
    largest_mass_defect_ = std::max(largest_mass_defect_, std::abs(integrals.mass_defect));
  }
  const double beyond = integrals.asperity_load_beyond_polynomial;
  if (setup_.input.contact.integrals == ContactIntegrals::kPolynomialAsPrinted && beyond > 0) {
    ++polynomial_steps_;
    polynomial_share_ = std::max(polynomial_share_, beyond / integrals.asperity_load);
  }
  if (is_field_angle(instant.crank_angle_deg)) {
    FaceFields fields;
    append_fields(setup_, integration, instant, fields);
    if (unrolled_) unrolled_->keep_fields(integration, instant, of_film2d);
    fields_[instant.crank_angle_deg] = std::move(fields);
  }
  return beyond > 0 ? beyond / integrals.asperity_load : 0;
}

void Recorder::before_step(TimeIntegration& integration, double from_deg, double to_deg) {
  const double turn = kCycleDeg * std::floor(from_deg / kCycleDeg);
  const double end = to_deg - turn - kSameSample;
  for (auto it = between_.upper_bound(from_deg - turn + kSameSample); it != between_.end() && it->first < end; ++it) {
    film::FilmState state;
    Instant instant = integration.side_step(turn + it->first, state);
    instant.crank_angle_deg = it->first;
    keep(integration, instant, it->second.emplace());
  }
}

void Recorder::after_step(const TimeIntegration& integration) {
  Instant instant = integration.instant();
  if (const double error = integration.uncontrolled_error(); error > 0)
    uncontrolled_on_the_way_.push_back({instant.crank_angle_deg, error});
  if (integration.at_base_angle()) {
    const auto k = static_cast<std::size_t>(std::lround(instant.crank_angle_deg / step_deg_)) % base_.size();
    instant.crank_angle_deg = static_cast<double>(k) * step_deg_;
    untrusted_share_[k] = keep(integration, instant, base_[k]);
    on_the_way_.push_back(base_[k]);
    steps_[k] = std::exchange(on_the_way_, {});
    uncontrolled_[k] = std::exchange(uncontrolled_on_the_way_, {});
    is_passed_[k] = true;
    return;
  }
  const auto asked = between_.lower_bound(instant.crank_angle_deg - kSameSample);
  const bool is_asked_for = asked != between_.end() && asked->first <= instant.crank_angle_deg + kSameSample;
  if (is_asked_for) instant.crank_angle_deg = asked->first;
  Sample& passed = on_the_way_.emplace_back();
  keep(integration, instant, passed);
  if (is_asked_for) asked->second = passed;
}

CycleResult Recorder::result(const TimeIntegration& integration, double periodicity_error, int steps_integrated,
                             Completeness completeness) const {
  CycleResult result;
  result.complete = completeness == Completeness::kComplete;
  result.samples.reserve(requested_deg_.size());
  for (const double angle : requested_deg_) {
    const auto between = between_.find(angle);
    const auto k = static_cast<std::size_t>(std::lround(angle / step_deg_)) % base_.size();
    const bool is_between = between != between_.end();
    if (is_between ? between->second.has_value() : is_passed_[k]) {
      result.samples.push_back(is_between ? *between->second : base_[k]);
    } else if (result.complete) {
      throw std::logic_error("an angle asked for was never passed");
    }
  }
  result.fields = empty_fields(setup_, integration.unloaded_grid());
  for (const auto& [angle, f] : fields_) {
    const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    result.fields.crank_angle_deg.push_back(angle);
    append(result.fields.film_thickness, f.film_thickness);
    append(result.fields.film_pressure, f.film_pressure);
    append(result.fields.film_content, f.film_content);
    append(result.fields.lambda_ratio, f.lambda_ratio);
    append(result.fields.asperity_pressure, f.asperity_pressure);
    append(result.fields.local_deformation, f.local_deformation);
  }
  std::vector<Sample> passed;  // only of an integration that stopped: else all of them
  if (!result.complete) {
    for (std::size_t k = 0; k < base_.size(); ++k) {
      if (is_passed_[k]) passed.push_back(base_[k]);
    }
  }
  const std::vector<Sample>& base = result.complete ? base_ : passed;
  result.values = no_cycle_values();
  if (result.complete) {
    std::vector<Sample> all{base_[0]};  // 0 degree, which ends the last step
    for (std::size_t k = 1; k <= steps_.size(); ++k) {
      const std::vector<Sample>& steps = steps_[k % steps_.size()];
      all.insert(all.end(), steps.begin(), steps.end());
    }
    all.pop_back();
    result.values = cycle_values(setup_, all);
    result.stroke = stroke_profile(setup_, all, result.values.archard_wear_load);
  }
  if (result.complete && integration.liner_oil() != nullptr) {
    add_liner_oil(setup_, oil_of_cycle(*integration.liner_oil()), result.values, result.stroke);
  }
  if (unrolled_) unrolled_->add_to(result, integration, base);
  result.derived = derived_values(setup_, integration.unloaded_grid());

  const TimeIntegration::Totals& totals = integration.totals();
  result.effort = {static_cast<double>(steps_integrated) / static_cast<double>(base_.size()),
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
  double load = 0, untrusted_load = 0;
  for (std::size_t k = 0; k < base_.size(); ++k) {
    load += base_[k].asperity_load;
    untrusted_load += untrusted_share_[k] * base_[k].asperity_load;
  }
  const double untrusted = untrusted_load > 0 ? untrusted_load / load : 0;
  result.notes = advice(setup_);
  append_validity_notes(setup_, integration.unloaded_grid(), base, result.complete ? result.values : CycleValues{},
                        {polynomial_steps_, polynomial_share_, untrusted}, result.notes);
  std::vector<UncontrolledStep> uncontrolled;
  for (const auto& steps : uncontrolled_) uncontrolled.insert(uncontrolled.end(), steps.begin(), steps.end());
  append_step_note(setup_, base, uncontrolled, result.notes);
  append_effort_notes(result.effort, totals, result.notes);
  sort_notes(result.notes);
  return result;
}

}  // namespace ringfilm::cycle
