#include "ringfilm/cycle/menisci_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "ringfilm/cycle/advice/advice.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/advice/validity.hpp"
#include "ringfilm/cycle/approach.hpp"
#include "ringfilm/cycle/integration/sampling.hpp"
#include "ringfilm/cycle/oil_settling.hpp"
#include "ringfilm/cycle/recorder.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

/// Cells of the liner in which cycles are compared and mixed.
constexpr std::size_t kLinerCells = 1000;
/// Angles at which the film of a cycle is compared with that of the one before.
constexpr std::size_t kFilmAngles = 720;
/// Samples lie no farther apart where gas blows through [degree].
constexpr double kSpacingWithGas = 2.5;
/// Angle within which gas begins or ceases to blow through [degree].
constexpr double kChangeOfGas = 0.2;
/// Angle within which a jump of a curve lies [degree].
constexpr double kJump = 1e-6;
/// Cycles before oil is mixed: as a rule a front of oil that moves on by as much in each cycle has come to its end by
/// then, and the cycle repeats itself.
constexpr int kPlainCycles = 6;
/// Oil that a cycle may move, over `solver.step_error` [-]: less than that is the scatter of steps of this error.
constexpr double kOilScatter = 3;
/// Error that a step may make, over `solver.step_error` [-]: a step of third order goes ten times as far as one of the
/// fixed grid, and the errors of fewer steps add up.
constexpr double kStepError = 10;

/// The step of a cycle that holds an angle within [0, 720).
const MenisciStep& step_at(const std::vector<MenisciStep>& steps, double& angle_deg) {
  if (angle_deg < steps.front().from_deg) angle_deg += kCycleDeg;
  const auto next = std::upper_bound(steps.begin(), steps.end(), angle_deg,
                                     [](double angle, const MenisciStep& step) { return angle < step.to_deg; });
  return next == steps.end() ? steps.back() : *next;
}

/// By how much the film at the begin of a cycle differs from that of one cycle before [-].
double difference(const film::MenisciState& a, const film::MenisciState& b, double width) {
  const double places = std::max(std::abs(a.left.x - b.left.x), std::abs(a.right.x - b.right.x));
  return std::max(std::abs(a.ln_h_m - b.ln_h_m), places / width);
}

Sample sample_of(const Setup& setup, const film::FilmProblem& contact, const MenisciSample& at) {
  film::FilmState state;
  state.h_m = at.h_m;
  Instant instant;
  instant.crank_angle_deg = at.crank_angle_deg;
  instant.at = at.at;
  instant.at.inputs.h_m_before = at.h_m;
  instant.state = &state;
  instant.bead = std::max(at.bead, 0.0);
  return sample(setup, contact, instant, at.integrals);
}

}  // namespace

MenisciCycles::MenisciCycles(const Setup& setup, double tolerance) : integration_(setup, tolerance) {
  const double allowed = allowed_distance(setup.input), allowed_of_oil = kOilScatter * setup.input.solver.step_error;
  const double allowed_ahead = kFilmAhead * setup.input.solver.step_error;
  Approach approach(setup.input);
  FilmOfCycle film(kFilmAngles);
  OilSettling settling(least_oil(setup) / integration_.liner().length() * kLinerCells);
  settling.begin(integration_.liner().in_cells(kLinerCells));
  while (!repeats_ && !approach.moves_on()) {
    const film::MenisciState begin = integration_.state();
    const LinerOil::Account before = integration_.liner().account();
    integration_.integrate_cycle();
    const LinerOil::Account& now = integration_.liner().account();
    account_ = {now.replenished - before.replenished, now.scraped_up - before.scraped_up,
                now.scraped_down - before.scraped_down};
    ++cycles_;
    settling.end_cycle(integration_.liner().in_cells(kLinerCells));
    for (std::size_t k = 0; k < kFilmAngles; ++k) {
      double angle_deg = kCycleDeg / kFilmAngles * static_cast<double>(k);
      film.add(k, std::exp(step_at(integration_.steps(), angle_deg).state_at(angle_deg).ln_h_m));
    }
    film.end_cycle();
    const double film_ahead = std::max(settling.cycles_ahead(), 1.0) * film.moved();
    film_moved_ = difference(integration_.state(), begin, setup.input.ring.face_width);
    oil_moved_ = std::max(settling.moved(), settling.ahead());
    repeats_ = film_moved_ <= allowed &&
               (approach.takes_unsettled() ? settling.moved() <= allowed_of_oil
                                           : oil_moved_ <= allowed_of_oil && film_ahead <= allowed_ahead);
    if (repeats_) break;
    approach.add(distance(), film_moved_, allowed, 0);
    if (cycles_ >= kPlainCycles) {
      if (const std::optional<std::vector<double>> mixed = settling.mixture()) integration_.replace_oil(*mixed);
    }
    settling.begin(integration_.liner().in_cells(kLinerCells));
  }
}

MenisciSample MenisciCycles::sample(double crank_angle_deg) {
  double at = crank_angle_deg;
  const MenisciStep& step = step_at(integration_.steps(), at);
  return integration_.sample(step, at);
}

/// Samples about the angle between two others at which gas begins or ceases to blow through, by halving.
void MenisciCycles::add_change_of_gas(const MenisciStep& step, double from_deg, double to_deg,
                                      std::vector<MenisciSample>& samples) {
  const bool was_broken = samples.back().integrals.is_broken_through;
  std::vector<MenisciSample> after;  // the last first
  while (to_deg - from_deg > kChangeOfGas) {
    const double middle = 0.5 * (from_deg + to_deg);
    MenisciSample between = integration_.sample(step, middle);
    const bool is_before = between.integrals.is_broken_through == was_broken;
    (is_before ? from_deg : to_deg) = middle;
    (is_before ? samples : after).push_back(std::move(between));
  }
  samples.insert(samples.end(), std::make_move_iterator(after.rbegin()), std::make_move_iterator(after.rend()));
}

std::vector<MenisciSample> MenisciCycles::samples_at_steps() {
  std::vector<MenisciSample> samples;
  const MenisciStep* before = nullptr;
  for (const MenisciStep& step : integration_.steps()) {
    // Where gas begins or ceases to blow through, curves jump.
    const bool jumps = before != nullptr && !before->has_places_of(step);
    const double jump = std::min(kJump, 0.5 * step.length_deg());
    if (jumps) samples.push_back(integration_.sample(step, step.from_deg + jump));
    const double from_deg = jumps ? step.from_deg + jump : step.from_deg;
    MenisciSample end = integration_.sample(step, step.to_deg);
    const bool was_broken = !samples.empty() && samples.back().integrals.is_broken_through;
    const bool is_broken = end.integrals.is_broken_through;
    // Masses of gas are sums of straight lines between samples.
    if (was_broken && is_broken) {
      const int parts = static_cast<int>(std::ceil(step.length_deg() / kSpacingWithGas));
      for (int k = 1; k < parts; ++k) {
        samples.push_back(integration_.sample(step, step.from_deg + step.length_deg() * k / parts));
      }
    } else if (was_broken != is_broken && !samples.empty()) {
      add_change_of_gas(step, from_deg, step.to_deg, samples);
    }
    samples.push_back(std::move(end));
    before = &step;
  }
  const auto less = [](const MenisciSample& a, const MenisciSample& b) {
    return a.crank_angle_deg < b.crank_angle_deg;
  };
  std::stable_sort(samples.begin(), samples.end(), less);
  return samples;
}

OilOfCycle MenisciCycles::oil() const {
  const auto mean = [this](MenisciLiner MenisciIntegration::Pass::*liner, std::size_t stroke, bool below, double begin,
                           double end) {
    const double shift = below ? integration_.contact().grid.width : 0;
    return (integration_.passes()[stroke].*liner).mean(begin + shift, end + shift);
  };
  const auto goes_down = [](std::size_t stroke) { return stroke % 2 == 0; };
  return {account_,
          [=](std::size_t stroke, double begin, double end) {
            return mean(&MenisciIntegration::Pass::before, stroke, goes_down(stroke), begin, end);
          },
          [=](std::size_t stroke, double begin, double end) {
            return mean(&MenisciIntegration::Pass::after, stroke, !goes_down(stroke), begin, end);
          }};
}

namespace {

CycleResult result_of(const Setup& setup) {
  MenisciCycles cycles(setup, kStepError * setup.input.solver.step_error);
  const MenisciIntegration& integration = cycles.integration();
  const film::FilmProblem& contact = integration.contact();
  std::vector<Sample> at_steps;
  UntrustedContact untrusted;
  double load = 0, untrusted_load = 0, residual = 0;
  for (const MenisciSample& one : cycles.samples_at_steps()) {
    at_steps.push_back(sample_of(setup, contact, one));
    residual = std::max(residual, at_steps.back().load_residual);
    load += one.integrals.asperity_load;
    untrusted_load += one.integrals.asperity_load_beyond_polynomial;
  }
  untrusted.share_of_cycle = untrusted_load > 0 ? untrusted_load / load : 0;
  CycleResult result;
  for (const double angle : requested_angles(setup.input.output)) {
    result.samples.push_back(sample_of(setup, contact, cycles.sample(angle)));
  }
  result.fields = empty_fields(setup, contact.grid);
  result.values = cycle_values(setup, at_steps);
  result.stroke = stroke_profile(setup, at_steps, result.values.archard_wear_load);
  add_liner_oil(setup, cycles.oil(), result.values, result.stroke);
  result.derived = derived_values(setup, contact.grid);
  const MenisciEffort& effort = integration.effort();
  result.effort.cycles_integrated = cycles.cycles();
  result.effort.periodicity_error = cycles.distance();
  result.effort.crank_steps = effort.steps;
  result.effort.newton_iterations = effort.balances;
  result.effort.max_load_residual = residual;
  result.notes = advice(setup);
  append_validity_notes(setup, contact.grid, at_steps, result.values, untrusted, result.notes);
  if (cycles.distance() > setup.input.solver.step_error && !cycles.repeats()) {
    result.notes.push_back(settling_note(cycles.cycles(), cycles.distance()));
  }
  sort_notes(result.notes);
  return result;
}

}  // namespace

std::optional<CycleResult> simulate_menisci(const Setup& setup, std::optional<Setup>& on_cells) {
  std::optional<std::string> reason = no_menisci_since(setup);
  if (!reason) {
    try {
      return result_of(setup);
    } catch (const ConvergenceError& error) {
      reason = error.what();
    }
  }
  on_cells = without_menisci(setup, *reason);
  return std::nullopt;
}

Setup without_menisci(const Setup& setup, const std::string& reason) {
  Setup on_cells = setup;
  on_cells.input.solver.method = Method::kCoupledNewton;
  on_cells.notes.push_back({kMenisciNotUsed, "computed on cells, not between two menisci, since " + reason, 1});
  return on_cells;
}

}  // namespace ringfilm::cycle
