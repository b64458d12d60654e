#include "ringfilm/cycle/integration/time_integration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/reynolds.hpp"
#include "ringfilm/film/solver/first_guess.hpp"
#include "ringfilm/models/oil/viscosity_laws.hpp"

namespace ringfilm::cycle {
namespace {

constexpr int kTicks = TimeIntegration::kTicksPerBaseStep;
/// Steps of no more ticks than that are searched for where Newton's method finds no film.
constexpr int kSearchedTicks = kTicks / 8;
/// Steps are laid out for this share of the error that they may make, eq-step-length.
constexpr double kAimedError = 0.65;
/// The first step after a start of a new past, of which no error is known.
constexpr int kTicksWithoutPast = kTicks / 16;
constexpr double kMinGrowth = 0.25, kMaxGrowth = 2;  ///< bounds of the ratio of a step to the one before
/// BDF2 is stable while a step is no longer than 1 + sqrt(2) times the one before.
constexpr double kMaxToLast = 2.1;

/// What has no answer at a crank angle, with the figures that show it.
std::string reason(const Setup& setup, const film::FilmProblem& problem, const film::FilmInputs& inputs,
                   const film::FilmReport& report) {
  const film::FilmGrid& grid = problem.grid;
  const double pressing = inputs.mean_pressure(grid);
  const double between_edges = 0.5 * (inputs.left.pressure + inputs.right.pressure);  // load of a wide gap over width
  const double at_edges = inputs.has_gas()
                              ? std::max(film::least_hydrodynamic_load(problem, inputs) / grid.width, between_edges)
                              : between_edges;
  const double load = number_in(inputs.load, kNewtonPerMillimetre);
  const double smallest_cell = *std::min_element(grid.spacing.begin(), grid.spacing.end());
  switch (report.failure) {
    case film::Failure::kOverloaded:
      return formatted(
          "neither the film nor the asperities carry the load of %.4g N per mm of circumference, at any "
          "separation: asperities carry at most %.4g, the pressures at the edges %.4g (computed on %d "
          "cells, the shortest %.3g um long; solver.cells = %d)",
          load, number_in(film::asperity_load(problem, film::kThinnest), kNewtonPerMillimetre),
          number_in(at_edges * grid.width, kNewtonPerMillimetre), grid.n_cells(), number_in(smallest_cell, kMicrometre),
          setup.input.solver.cells);
    case film::Failure::kLiftedOff:
      if (at_edges > pressing) {
        return formatted(
            "the gas lifts the ring off: %.4g and %.4g bar at the edges of its face press it away with %.3g bar "
            "more than the %.4g bar that press it on",
            number_in(inputs.left.pressure, kBar), number_in(inputs.right.pressure, kBar),
            number_in(at_edges - pressing, kBar), number_in(pressing, kBar));
      }
      return formatted(
          "the film carries more than the load of %.4g N per mm of circumference up to a thickness of "
          "%.3g mm: face, speed, oil and load are not those of a ring",
          load, number_in(film::thickest(problem), kMillimetre));
    case film::Failure::kRunsAway:
      return formatted(
          "no film carries the load of %.4g N per mm of circumference: at about %.3g um viscosity rises with "
          "pressure until the oil is solid, and Reynolds' equation has no solution "
          "(lubricant.viscosity_pressure = \"%s\")",
          load, number_in(report.thinnest_film, kMicrometre),
          models::viscosity_law(setup.input.lubricant.viscosity_pressure).name.c_str());
    default:
      break;
  }
  const std::string text =
      formatted("film, contact and load do not balance, with 1/%d of the crank step either", kTicks);
  constexpr double kMaxAtTips = 100;  // multiple of the mean load, about what rings of the paper press in a point
  if (!setup.input.bends() || problem.contact == nullptr) return text;
  if (film::asperity_load(problem, 0) > kMaxAtTips * inputs.load) return text;
  return text +
         formatted(
             "; a ring that bends presses in a point where its tips meet a crest of the bore, and asperities carry at "
             "most %.3g N per mm of circumference there (the mean load is %.3g N): turn ring.gap_position off the "
             "crest, or state rougher surfaces",
             number_in(film::asperity_load(problem, 0), kNewtonPerMillimetre), load);
}

NoBalance no_balance(const Setup& setup, const film::FilmProblem& problem, const film::FilmInputs& inputs,
                     const film::FilmReport& report, double crank_angle_deg) {
  return {formatted("at %.6g degree ", wrapped(crank_angle_deg)) + reason(setup, problem, inputs, report),
          wrapped(crank_angle_deg), report.failure};
}

const film::EdgeState& chamber_edge(const RingConditions& at) {
  return at.axis == Axis::kFromChamber ? at.inputs.left : at.inputs.right;
}
const film::EdgeState& crankcase_edge(const RingConditions& at) {
  return at.axis == Axis::kFromChamber ? at.inputs.right : at.inputs.left;
}

}  // namespace

TimeIntegration::TimeIntegration(const Setup& setup, const PlaceOnLiner& place) : setup_(setup), film_(setup) {
  if (setup.input.film.supply_at_inlet() == OilSupply::kFilmOnLiner) {
    liner_oil_.emplace(setup, film_.across().grid, place);
  }
}

RingConditions TimeIntegration::conditions(double from_deg, double to_deg, double time_step) const {
  RingConditions at = ring_conditions(setup_, to_deg, time_step, heat_);
  if (liner_oil_) liner_oil_->limit(at, from_deg, to_deg);
  at.off_liner = off_liner(at);
  return at;
}

/// Adds the oil of the candidate, which becomes the next state.
void TimeIntegration::account_of_oil() {
  if (!liner_oil_) return;
  const film::FilmView view = film::film_view(problem(), step_.at.inputs, candidate_);
  const auto flow = [&](int face) { return film::mass_flux(view, step_.at.inputs, candidate_, face); };
  film::PassedOil passed =
      liner_oil_->passed(step_.at, step_.of_flow_before, flow(0), flow(problem().grid.n_cells() - 1));
  const bool can_move = film2d() == nullptr && problem().cavitation == film::Cavitation::kMassConserving;
  oil_moves_ = can_move && step_.at.inputs.has_gas();
  if (oil_moves_) {
    moved_ = candidate_;
    film::move_with_wall(problem(), step_.at.inputs, state_, liner_oil_->way(angle_deg_, step_.to_deg), passed, moved_);
  }
  liner_oil_->pass(step_.at, angle_deg_, step_.to_deg, passed);
}

void TimeIntegration::count(const film::FilmReport& report) {
  totals_.newton_iterations += report.iterations;
  totals_.exact_law_solves += report.converged && report.exact_laws && setup_.ring.oil.range->has_fit();
  effort_.newton_iterations += report.iterations;
  totals_.relaxation_sweeps += report.sweeps;
  if (report.converged && report.route == film::Route::kSecant) {
    ++totals_.fallback_secant;
    ++effort_.fallbacks;
  }
}

/// By how much the separation of another film differs from what the films before lead to expect, relative; the mean
/// around a ring that bends.
double TimeIntegration::change_of_trend(const film::FilmState& to, const film::Prediction& prediction,
                                        const film::FilmState& older) const {
  const auto change = [&prediction](double h, double state, double before, double oldest) {
    return std::abs(prediction.expected(std::log(state / h), std::log(before / h), std::log(oldest / h)));
  };
  if (to.ring.empty()) return change(to.h_m, state_.h_m, before_.h_m, older.h_m);
  const film::CircumferentialGrid& around = film2d()->around;
  double sum = 0;
  for (int j = 0; j < around.n_strips(); ++j) {
    const auto at = [&](const film::FilmState& state) { return state.h_m + film_.rise(state, j); };
    sum += around.share[j] / around.length * change(at(to), at(state_), at(before_), at(older));
  }
  return sum;
}

film::MassSums TimeIntegration::mass_off(const film::FilmState& to, const film::Prediction& prediction,
                                         const film::FilmState& older) const {
  const bool with_gas = step_.at.inputs.has_gas();
  if (!with_gas && film2d() == nullptr) {
    return problem().kernels->mass_off(
        to.mass_per_area.data(),
        {prediction.of_state, prediction.of_before, prediction.of_older, state_.mass_per_area.data(),
         before_.mass_per_area.data(), older.mass_per_area.data()},
        static_cast<int>(to.mass_per_area.size()));
  }
  // Oil next to gas lies on the liner and moves with it: it bears nothing, and its steps in x are steps in time. So
  // are those of a meniscus that crosses nodes.
  const film::GasReach reach(problem().grid, step_.at.inputs);
  const auto is_next_to_gas = [&](std::size_t i) {
    return (film::is_cavity(to.deficit[i]) || film::is_cavity(state_.deficit[i])) &&
           reach.is_filled(static_cast<int>(i));
  };
  film::MassSums sums{0, 0};
  for (std::size_t i = 0; i < to.mass_per_area.size(); ++i) {
    if (with_gas && is_next_to_gas(i)) continue;
    const double expected =
        prediction.expected(state_.mass_per_area[i], before_.mass_per_area[i], older.mass_per_area[i]);
    sums.off += film_.weight(i) * std::abs(to.mass_per_area[i] - expected);
    sums.all += film_.weight(i) * to.mass_per_area[i];
  }
  return sums;
}

double TimeIntegration::time_error(const film::FilmState& to, double time_step) const {
  if (time_step_before_ == 0) return 0;
  const bool by_three = has_parabola();
  const film::Prediction prediction = by_three
                                          ? film::Prediction::parabola(time_step, time_step_before_, time_step_older_)
                                          : film::Prediction::line(time_step, time_step_before_);
  const film::FilmState& older = by_three ? older_ : before_;
  const double film = change_of_trend(to, prediction, older);
  const film::MassSums content = mass_off(to, prediction, older);
  const double share = step_.is_second_order ? kContentShareOfBdf2 : kContentShare;
  const double of_content = content.all > 0 ? content.off / content.all / share : 0;  // 0: all lies next to gas
  const double error =
      prediction.error_share * std::max(weight_of_film(to) * film, of_content) / setup_.input.solver.step_error;
  return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

/// Lays out the proposed step as one of second order. False where it is not one: there is no history, it is much longer
/// than the step before it, the face turns over, the ring turns to oil on the liner, or a cavity would have less than
/// no oil.
bool TimeIntegration::remember_two_films() {
  const bool can = is_second_order() && time_step_before_ > 0 && step_.time_step <= kMaxToLast * time_step_before_;
  if (!can || step_.state_was_turned) return false;
  if (liner_oil_ && liner_oil_->turns(angle_deg_, step_.to_deg)) return false;
  const film::Bdf2 scheme(step_.time_step, time_step_before_);
  const std::vector<double>& mass = state_.mass_per_area;
  history_.mass_per_area.resize(mass.size());
  const double least = problem().kernels->remembered_mass(
      {scheme.of_state, -scheme.of_before, 0, mass.data(), before_.mass_per_area.data(), nullptr},
      static_cast<int>(mass.size()), history_.mass_per_area.data());
  if (least < 0 && (!step_.at.inputs.has_gas() || film2d() != nullptr ||
                    film::spread_debt_in_gas(problem(), step_.at.inputs, history_.mass_per_area) < 0)) {
    return false;
  }
  step_.at.inputs.time_step = scheme.time_step;
  step_.of_flow_before = scheme.of_before;
  if (liner_oil_) liner_oil_->limit(step_.at, angle_deg_, step_.to_deg, scheme.of_before);
  return true;
}

/// By how much a change of the film counts more than by itself, eq-error-weight: friction of asperities follows it with
/// a high power. Of steps of second order alone, which are long enough.
double TimeIntegration::weight_of_film(const film::FilmState& to) const {
  const models::AsperityContact* contact = problem().contact;
  if (!step_.is_second_order || contact == nullptr || to.h_m <= 0) return 1;
  double pressure, slope, highest, unused;
  contact->pressure(to.h_m, pressure, slope);
  contact->pressure(std::min(to.h_m, thinnest_), highest, unused);
  const double felt = std::max(highest, kFeltPressure * step_.at.inputs.mean_pressure(problem().grid));
  return 1 + kWeightOfContact * std::abs(slope) * to.h_m / felt;
}

HeatBefore TimeIntegration::heat_of_state(const RingConditions& at) const {
  if (!setup_.input.thermal.is_heated()) return {};
  return {viscous_heating_rise(at.inputs, state_), setup_.ring.oil.range->viscosity(at.film_temperature)};
}

double TimeIntegration::viscous_heating_rise(const film::FilmInputs& inputs, const film::FilmState& state) const {
  const Lubricant& oil = setup_.input.lubricant;
  return film_.heating(inputs, state).rise(oil.thermal_conductivity, oil.specific_heat);
}

/// The face turns over at a reversal. The share of the gap that is full of oil stays where it is, and so does the
/// pressure. Where the face is not symmetric, the gap changes and its oil with it: as much oil in a smaller gap would
/// have to leave at once, at a pressure that rises without limit as the step is cut.
void TimeIntegration::turn(film::FilmState& state) const {
  const std::vector<double>& rise = film_.film2d() ? film_.film2d()->gap.node : problem().grid.node_height;
  const std::size_t n_across = problem().grid.x.size();
  const auto gap = [&](std::size_t i) {
    return state.h_m + film_.rise(state, static_cast<int>(i / n_across)) + rise[i];
  };
  for (std::size_t i = 0; i < state.mass_per_area.size(); ++i) state.mass_per_area[i] /= gap(i);
  for (std::vector<double>* nodal : {&state.p, &state.deficit, &state.mass_per_area}) {
    for (auto strip = nodal->begin(); strip < nodal->end(); strip += static_cast<std::ptrdiff_t>(n_across)) {
      std::reverse(strip, strip + static_cast<std::ptrdiff_t>(n_across));
    }
  }
  for (std::size_t i = 0; i < state.mass_per_area.size(); ++i) state.mass_per_area[i] *= gap(i);
  state.factors = nullptr;  // those of the face as it was
}

TimeIntegration::Fluids TimeIntegration::fluids(const RingConditions& at) {
  return {chamber_edge(at).fluid, crankcase_edge(at).fluid};
}

void TimeIntegration::start_steady(RingConditions& at) {
  // A steady film with a full inlet exists at any speed.
  for (film::EdgeState* edge : {&at.inputs.left, &at.inputs.right}) {
    if (std::isfinite(edge->supply)) *edge = {edge->pressure};
  }
  const film::FilmReport report = film_.solve_steady(at, before_, state_);
  count(report);
  if (report.converged) return;
  if (at.inputs.has_gas()) {
    // At a dead centre gas presses the oil out of a flat gap, and no steady film is left: it begins full.
    RingConditions full = at;
    for (film::EdgeState* edge : {&full.inputs.left, &full.inputs.right}) *edge = {edge->pressure};
    const film::FilmReport of_full = film_.solve_steady(full, before_, state_);
    count(of_full);
    if (of_full.converged) return;
  }
  throw no_balance(setup_, problem(), at.inputs, report, angle_deg_);
}

void TimeIntegration::start(int k) {
  k_ = k;
  angle_deg_ = k * setup_.input.solver.crank_step_deg;
  time_step_before_ = time_step_older_ = 0;
  thinnest_ = std::numeric_limits<double>::infinity();
  longest_ticks_ = kTicks;
  step_.state_was_turned = step_.is_repeated = is_lifted_ = false;
  tick_ = kTicks;
  heat_ = {};
  RingConditions at = ring_conditions(setup_, angle_deg_, film::kSteady);
  std::optional<film::FilmState> dry;
  if (liner_oil_) at.off_liner = off_liner(at);
  if (at.off_liner) {
    on_liner_ = 0;
    on_liner_ = separation_off_liner(0);
    dry = film::film_on_wall(problem(), at.inputs, on_liner_ + *at.off_liner, liner_oil_->mean_on_liner());
  } else if (liner_oil_) {
    dry = film::dry_film(problem(), at.inputs, liner_oil_->mean_on_liner());
  }
  if (dry) {
    before_ = state_ = std::move(*dry);
  } else {
    start_steady(at);
  }
  axis_ = at.axis;
  fluids_ = fluids(at);
  heat_ = heat_of_state(at);
  instant_ = {wrapped(angle_deg_), at, &before_, &state_, effort_, 0};
}

/// Steps of equal length to the next base angle, none longer than `longest_ticks_`.
int TimeIntegration::ticks_of_step() const {
  const int left = kTicks - tick_;
  const int longest = std::max(1, static_cast<int>(longest_ticks_ + 0.5));
  const int steps = (left + longest - 1) / longest;
  return (left + steps - 1) / steps;
}

/// By how much a step may be longer than one that made this share of the error allowed, eq-step-length.
double TimeIntegration::growth_after(double error) const {
  const double order = has_parabola() ? 3 : 2;
  const double growth = std::pow(kAimedError / std::max(error, 1e-9), 1 / order);
  return std::clamp(growth, kMinGrowth, kMaxGrowth);
}

void TimeIntegration::lay_out_step() {
  const double base_deg = setup_.input.solver.crank_step_deg;
  step_.ticks = ticks_of_step();
  step_.to_deg = k_ * base_deg + base_deg * (tick_ + step_.ticks) / kTicks;
  step_.time_step = radians(base_deg * step_.ticks / kTicks) / setup_.engine.speed;
  step_.at = conditions(angle_deg_, step_.to_deg, step_.time_step);
}

void TimeIntegration::forget_past() {
  time_step_before_ = time_step_older_ = 0;
  // Without a past its error is not known.
  longest_ticks_ = adaptive() ? std::min(longest_ticks_, double{kTicksWithoutPast}) : longest_ticks_;
  lay_out_step();
}

std::optional<double> TimeIntegration::off_liner(const RingConditions& at) const {
  const film::FilmInputs& inputs = at.inputs;
  if (!inputs.has_gas() || !film_.has_simple_gap()) return std::nullopt;
  if (is_lifted_) return 0;
  const double width = problem().grid.width, pressing = inputs.mean_pressure(problem().grid);
  if (std::max(inputs.left.pressure, inputs.right.pressure) < pressing) return std::nullopt;
  film::FilmInputs now = inputs;
  now.h_m_before = state_.h_m;
  const double excess = film::least_hydrodynamic_load(problem(), now) / width - pressing;
  if (excess < 0) return std::nullopt;
  return setup_.ring.collapse.distance(excess);
}

/// As far beyond the reach of asperities.
double TimeIntegration::separation_off_liner(double distance) const {
  constexpr double kNothingTouches = 10;  // distance of Gaussian surfaces, over their roughness [-]
  constexpr double kSmoothRing = 1e-6;    // [m]
  const models::AsperityContact* contact = problem().contact;
  const double reach =
      contact == nullptr ? kSmoothRing : std::min(contact->reach(), kNothingTouches * contact->length_scale());
  return std::max(on_liner_, reach) + distance;
}

void TimeIntegration::propose() {
  if (tick_ == kTicks) {
    tick_ = 0;
    effort_ = {};
    if (!adaptive()) longest_ticks_ = kTicks;
  }
  lay_out_step();
  // The film does not follow its past across a step where oil takes the place of gas at an edge.
  if (fluids(step_.at) != fluids_) {
    fluids_ = fluids(step_.at);
    forget_past();
  }
  // Nor where the ring comes down on the liner, or is off it.
  if (is_off_liner() || instant_.at.off_liner) forget_past();
  // A step that can be shortened is not searched for: most films that Newton's method misses change fast.
  if (adaptive() && step_.ticks > kSearchedTicks) step_.at.inputs.fallback = film::Fallback::kNone;
  if (step_.at.axis != axis_) {
    step_.state_was_turned = true;  // until a step is accepted
    turn(state_);
    turn(before_);
    time_step_older_ = 0;
    axis_ = step_.at.axis;
  }
  step_.of_flow_before = 0;
  step_.is_second_order = remember_two_films();
  step_.h_m = state_.h_m;
  if (time_step_before_ > 0) {
    const double growth = std::log(state_.h_m / before_.h_m) * step_.time_step / time_step_before_;
    step_.h_m *= std::exp(std::clamp(growth, -0.5, 0.5));
  }
  if (!instant_.at.off_liner) on_liner_ = state_.h_m;
  if (instant_.at.off_liner) step_.h_m = on_liner_;
  if (is_off_liner()) step_.h_m = separation_off_liner(*step_.at.off_liner);
  step_.at.inputs.h_m_before = step_.h_m;
}

/// A ring that bends continues its motion, as far as no film becomes much thinner.
void TimeIntegration::continue_ring(film::FilmState& to) const {
  to.h_m = state_.h_m;
  if (time_step_before_ == 0) return;
  constexpr double kMax = 0.5;
  const double closed = film::closed_film(*film2d());
  double ratio = step_.time_step / time_step_before_;
  const int n_strips = film2d()->around.n_strips();
  const auto at = [&](const film::FilmState& state, int j) { return state.h_m + film_.rise(state, j); };
  for (int j = 0; j < n_strips; ++j) {
    const double room = at(state_, j) - closed, fall = at(before_, j) - at(state_, j);
    if (ratio * fall > kMax * room) ratio = kMax * room / fall;
  }
  to.h_m += ratio * (state_.h_m - before_.h_m);
  for (std::size_t i = 0; i < to.ring.size(); ++i) to.ring[i] += ratio * (state_.ring[i] - before_.ring[i]);
}

/// Continues film and cavity of the state in time, eq-continued-film. @param to holds that state
void TimeIntegration::continue_film(film::FilmState& to) const {
  if (time_step_before_ == 0) return;
  problem().kernels->continued({state_.p.data(), before_.p.data(), state_.deficit.data(), before_.deficit.data(),
                                step_.time_step / time_step_before_, step_.at.inputs.p_cavitation},
                               static_cast<int>(to.p.size()), {to.p.data(), to.deficit.data()});
}

const film::FilmState& TimeIntegration::guess() {
  candidate_ = state_;
  candidate_.h_m = step_.h_m;
  if (!state_.ring.empty()) continue_ring(candidate_);
  if (!step_.at.inputs.has_gas()) continue_film(candidate_);
  return candidate_;
}

film::FilmReport TimeIntegration::solve_film(const RingConditions& at, const film::FilmState& previous,
                                             film::FilmState& state) {
  return at.off_liner ? film_.solve_off_liner(at, previous, state) : film_.solve(at, previous, state);
}

film::FilmReport TimeIntegration::solve() {
  guess();
  return solve_film(step_.at, remembered(), candidate_);
}

void TimeIntegration::conclude(const film::FilmReport& report, StepObserver& waypoints) {
  count(report);
  const double error = report.converged && adaptive() ? time_error(candidate_, step_.time_step) : 0;
  const bool is_error_known = time_step_before_ > 0;
  const bool too_coarse = adaptive() && !(error <= 1) && step_.ticks > 1;
  if (report.failure == film::Failure::kLiftedOff && !is_lifted_ && step_.at.inputs.has_gas() &&
      film_.has_simple_gap()) {
    is_lifted_ = true;  // what oil is left and the gas carry more than the load
    return;
  }
  if (!report.converged || too_coarse) {
    if (step_.ticks == 1) throw no_balance(setup_, problem(), step_.at.inputs, report, step_.to_deg);
    if (!report.converged) {
      ++totals_.fallback_sub_step;
      ++effort_.fallbacks;
    }
    longest_ticks_ = std::min(step_.ticks * (report.converged ? growth_after(error) : 0.5), step_.ticks - 1.0);
    step_.is_repeated = true;
    return;
  }
  if (adaptive() && is_error_known) {
    const double growth = growth_after(error);
    // What made the step before too long is still near.
    longest_ticks_ = std::min(step_.ticks * (step_.is_repeated ? std::min(growth, 1.0) : growth), double{kTicks});
  }
  waypoints.before_step(*this, angle_deg_, step_.to_deg);
  film_.lay_gap_of(candidate_);  // films of side steps may have been solved since
  account_of_oil();
  std::swap(older_, before_);
  std::swap(before_, state_);
  std::swap(state_, candidate_);
  time_step_older_ = time_step_before_;
  time_step_before_ = step_.time_step;
  thinnest_ = std::min(thinnest_, state_.h_m);
  heat_ = heat_of_state(step_.at);
  angle_deg_ = step_.to_deg;
  tick_ += step_.ticks;
  ++effort_.steps;
  ++totals_.crank_steps;
  totals_.sub_steps += step_.ticks < kTicks;
  const double relative_error = error * setup_.input.solver.step_error;
  uncontrolled_error_ = error > 1 && relative_error > kUncontrolledError ? relative_error : 0;
  totals_.max_newton_step = std::max(totals_.max_newton_step, report.last_step);
  const film::FilmState* previous = step_.is_second_order ? &history_ : &before_;
  instant_ = {wrapped(angle_deg_), step_.at, previous, &state_, effort_, liner_oil_ ? liner_oil_->bead() : 0};
  step_.state_was_turned = step_.is_repeated = is_lifted_ = false;
  waypoints.after_step(*this);
  if (oil_moves_) std::swap(state_, moved_);
  if (tick_ == kTicks) {
    k_ = (k_ + 1) % steps_per_cycle(setup_.input.solver);
    angle_deg_ = k_ * setup_.input.solver.crank_step_deg;
  }
}

void TimeIntegration::advance(StepObserver& waypoints) {
  do {
    propose();
    conclude(solve(), waypoints);
  } while (!at_base_angle());
}

Instant TimeIntegration::side_step(double crank_angle_deg, film::FilmState& to) {
  film::FilmReport report;
  RingConditions at;
  for (int parts = 1; parts <= kTicks && !report.converged; parts *= 4) {
    const double part_deg = (crank_angle_deg - angle_deg_) / parts;
    to = state_;
    Axis axis = axis_;
    for (int part = 1; part <= parts; ++part) {
      const double to_deg = angle_deg_ + part * part_deg;
      at = conditions(to_deg - part_deg, to_deg, radians(part_deg) / setup_.engine.speed);
      at.inputs.h_m_before = to.h_m;
      if (at.axis != axis) turn(to);
      axis = at.axis;
      side_before_ = to;
      if (at.off_liner) to.h_m = separation_off_liner(*at.off_liner);
      report = solve_film(at, side_before_, to);
      if (!report.converged) break;
    }
  }
  if (!report.converged) throw no_balance(setup_, problem(), at.inputs, report, crank_angle_deg);
  return {wrapped(crank_angle_deg), at, &side_before_, &to, {1, report.iterations, 0}, instant_.bead};
}

TimeIntegration::Snapshot TimeIntegration::snapshot() const {
  return {state_, liner_oil_ ? liner_oil_->film().mass_per_area() : std::vector<double>()};
}

TimeIntegration::Distance TimeIntegration::distance(const Snapshot& snapshot) const {
  const film::FilmState& other = snapshot.film;
  const double scale = instant_.at.inputs.mean_pressure(problem().grid);
  Distance distance{std::abs(std::log(state_.h_m / other.h_m)), 0};
  for (int j = 0; !state_.ring.empty() && j < film2d()->around.n_strips(); ++j) {
    const double now = state_.h_m + film_.rise(state_, j), then = other.h_m + film_.rise(other, j);
    distance.film = std::max(distance.film, std::abs(std::log(now / then)));
  }
  if (liner_oil_) {
    // A meniscus that lies a little elsewhere changes single nodes. What lies next to gas bears nothing: it is as the
    // oil on the liner is.
    const std::vector<double>& share = problem().grid.share;
    double sum = 0;
    for (std::size_t i = 0; i < state_.p.size(); ++i) {
      sum += share[i % share.size()] / problem().grid.width * std::abs(state_.p[i] - other.p[i]) / scale;
    }
    distance.film = std::max(distance.film, sum);
    distance.on_liner = share_elsewhere(liner_oil_->film().mass_per_area(), snapshot.on_liner);
    return distance;
  }
  for (std::size_t i = 0; i < state_.p.size(); ++i) {
    distance.film = std::max(distance.film, std::abs(state_.p[i] - other.p[i]) / scale);
    if (problem().cavitation == film::Cavitation::kMassConserving) {
      distance.film = std::max(distance.film, std::abs(state_.deficit[i] - other.deficit[i]));
    }
  }
  return distance;
}

}  // namespace ringfilm::cycle
