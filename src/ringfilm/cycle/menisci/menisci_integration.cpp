#include "ringfilm/cycle/menisci/menisci_integration.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/film/menisci/menisci_places.hpp"

namespace ringfilm::cycle {
namespace {

using film::MeniscusPlace;

/// BDC before compression, at which a cycle of the oil begins.
constexpr double kBeginDeg = 540;
constexpr double kStrokeDeg = 180;
/// Bead that takes the errors of steps, over the oil of the film [-].
constexpr double kLargeBead = 0.3;
/// Length of the first step [degree].
constexpr double kFirstLength = 0.1;
constexpr int kMaxChanges = 8;
/// Oil that hangs behind a film on a shorter stretch is not followed [m], and what hangs is drained after so many times
/// its stretch.
constexpr double kMinHanging = 50e-6, kDrainedAfter = 1.5;
constexpr long kMaxStepsPerStroke = 100000;

/// Smallest film of a dry ring, whose asperities carry what the gas does not [m].
double dry_film(const film::MenisciFilm& film, const film::MenisciInputs& inputs) {
  const double x = film.throat().x;
  const double gas = inputs.left.pressure * x + inputs.right.pressure * (film.width() - x);
  const double carried = inputs.film.load - gas, h_m = film.asperities().film_under(carried);
  if (h_m > 0) return h_m;
  throw ConvergenceError(formatted("asperities do not carry the %.4g N per mm of circumference of a dry ring",
                                   number_in(carried, kNewtonPerMillimetre)));
}

}  // namespace

MenisciIntegration::MenisciIntegration(const Setup& setup, double tolerance)
    : setup_(setup),
      tolerance_(tolerance),
      grid_(menisci_grid(setup)),
      contact_(menisci_contact(setup)),
      film_(grid_, contact_),
      degrees_per_second_(setup.engine.speed / radians(1)),
      state_{std::log(dry_film(film_, conditions(kBeginDeg).inputs)),
             {film_.throat().x, MeniscusPlace::kAtThroat},
             {film_.throat().x, MeniscusPlace::kAtThroat},
             0},
      liner_(setup, setup.engine.crank.stroke() + film_.throat().x),
      now_{kBeginDeg, conditions(kBeginDeg), state_, {}, {}},
      next_length_deg_(kFirstLength),
      passes_(kStrokes, {liner_, liner_}) {}

MenisciConditions MenisciIntegration::conditions(double crank_angle_deg, double highest_pressure) const {
  return menisci_conditions(setup_, grid_.width, crank_angle_deg, direction_, highest_pressure, heat_);
}

void MenisciIntegration::accept(const Instant& end) {
  const auto left_behind = [](const Instant& at) {
    const film::MenisciInputs& in = at.conditions.inputs;
    const auto film_of = [&](const film::Meniscus& meniscus, const film::MeniscusMotion& motion, double flow,
                             const film::MenisciInputs::Edge& edge, bool leads) {
      constexpr double kSlow = 1e-3;  // [m/s]
      if (meniscus.place != MeniscusPlace::kAtEdge) return motion.leaves ? edge.density * motion.film : 0;
      return leads ? 0 : std::max(in.direction * flow, 0.0) / std::max(std::abs(in.film.U), kSlow);
    };
    return film::OnLiner{film_of(at.state.left, at.balance.left, at.balance.flow_left, in.left, in.left_leads()),
                         film_of(at.state.right, at.balance.right, at.balance.flow_right, in.right, !in.left_leads())};
  };
  const double place = end.conditions.at.below_tdc;
  const film::MenisciInputs& inputs = end.conditions.inputs;
  const film::Meniscus& leading = inputs.left_leads() ? end.state.left : end.state.right;
  const double film_mass = end.state.is_dry() ? 0 : end.balance.film_mass;
  const bool has_bead = leading.place == MeniscusPlace::kAtEdge && end.state.bead > kLargeBead * film_mass &&
                        inputs.surplus == film::Surplus::kStays;
  liner_.pass({place + end.state.left.x, place + end.state.right.x, film_mass, end.state.bead, has_bead,
               left_behind(now_), left_behind(end)});
  MenisciStep step;
  step.from_deg = now_.angle_deg;
  step.to_deg = end.angle_deg;
  step.direction = direction_;
  step.from = state_;
  step.to = end.state;
  step.rate_from = begin_.rate;
  step.rate_to = rate(end.state, end.balance);
  step.lift_rate = now_.balance.lift_rate;
  step.highest_pressure = highest_pressure_;
  step.heat = heat_;
  step.beyond_from = beyond_;
  now_ = end;
  if (now_.conditions.inputs.surplus == film::Surplus::kIsLost) {
    liner_.scrape(direction_ > 0);
    now_.state.bead = 0;
  }
  now_.state.bead = liner_.bead();
  state_ = now_.state;
  highest_pressure_ = kServedOverPeak * now_.balance.peak_pressure;
  step.beyond_to = beyond_ = oil_beyond();
  steps_.push_back(std::move(step));
  ++effort_.steps;
  if (setup_.input.thermal.is_heated()) warm_up();
  now_.on_liner = read(now_.conditions.at, state_);
  film_.set_motion(now_.conditions.inputs, state_, now_.on_liner, now_.balance);
}

/// The film at hand with the heat that it makes, from which the next step begins.
void MenisciIntegration::warm_up() {
  const Lubricant& oil = setup_.input.lubricant;
  const film::MenisciBalance balance = solve(now_.conditions.inputs, state_, now_.on_liner, now_.balance.lift_rate);
  const film::FilmHeating heating = film_.integrals(now_.conditions.inputs, state_, balance).heating;
  heat_ = {heating.rise(oil.thermal_conductivity, oil.specific_heat),
           setup_.ring.oil.range->viscosity(now_.conditions.at.film_temperature)};
  now_.conditions = conditions(now_.angle_deg);
  now_.balance = solve(now_.conditions.inputs, state_, now_.on_liner, now_.balance.lift_rate);
}

void MenisciIntegration::settle_places() {
  for (int k = 0; k < kMaxChanges; ++k) {
    if (!film::change_places(film_, now_.conditions.inputs, now_.balance, state_)) return;
    ++effort_.changes_of_places;
    now_.state = state_;
    now_.on_liner = read(now_.conditions.at, state_);
    now_.balance.lift_rate = 0;
    now_.balance = solve(now_.conditions.inputs, state_, now_.on_liner, now_.balance.lift_rate);
  }
}

OilBeyond MenisciIntegration::oil_beyond() const {
  const double width = grid_.width, place = now_.conditions.at.below_tdc;
  const film::OnLiner edges = liner_.next_to(place, place + width);
  const film::OnLiner middle = liner_.next_to(place + 0.5 * width, place + 0.5 * width);
  return {read(now_.conditions.at, state_), edges.left, 0.5 * width < state_.left.x ? middle.left : middle.right,
          edges.right};
}

/// The film that the liner drains out of the full gap behind a film that begins to retreat: the gap at each place falls
/// to its half, which leaves with the liner, after h/h' of travel (eq-hung-oil).
std::vector<LinerSide::Point> MenisciIntegration::hung_oil() const {
  const bool leaves_right = now_.conditions.inputs.left_leads();
  const double begin = leaves_right ? state_.right.x : state_.left.x, throat = film_.throat().x;
  const double h_m = std::exp(state_.ln_h_m), density = now_.conditions.inputs.trailing().density;
  const double extent = std::abs(begin - throat);
  std::vector<LinerSide::Point> drained;
  constexpr int kPoints = 24;
  for (int k = 0; k < kPoints && extent > kMinHanging; ++k) {
    const double at = extent * (1 - static_cast<double>(k) / kPoints), step = extent / kPoints;
    const auto gap = [&](double distance) {
      return h_m + film::gap_height(grid_, throat + (begin > throat ? distance : -distance));
    };
    const double rise = (gap(at) - gap(at - 0.5 * step)) / (0.5 * step);
    const double oil = 0.5 * density * gap(at), travel = gap(at) / std::max(rise, 1e-6) + (extent - at);
    if (drained.empty()) drained.push_back({0, oil});
    if (travel > kDrainedAfter * extent) break;
    if (travel > drained.back().place) drained.push_back({travel, oil});
  }
  return drained;
}

void MenisciIntegration::integrate_stroke(double to_deg) {
  const auto stroke = static_cast<std::size_t>(stroke_at(wrapped(to_deg - 0.5 * kStrokeDeg)));
  const bool up = stroke % 2 == 1;
  direction_ = up ? 1 : -1;
  if (!up) liner_.replenish();
  passes_[stroke].before = liner_;
  now_.conditions = conditions(now_.angle_deg);
  now_.state = state_;
  now_.on_liner = read(now_.conditions.at, state_);
  now_.balance = solve(now_.conditions.inputs, state_, now_.on_liner, now_.balance.lift_rate);
  settle_places();
  beyond_ = oil_beyond();
  const std::vector<LinerSide::Point> drained = hung_oil();
  const double begins = now_.conditions.at.below_tdc + (up ? state_.right.x : state_.left.x);
  const long before = effort_.steps;
  while (now_.angle_deg < to_deg) {
    if (effort_.steps - before > kMaxStepsPerStroke) {
      throw ConvergenceError(formatted("the film between its menisci needs more than %ld steps", kMaxStepsPerStroke),
                             wrapped(now_.angle_deg));
    }
    step(to_deg);
  }
  if (drained.size() > 1) liner_.drain(!up, begins, drained);
  passes_[stroke].after = liner_;
  liner_.scrape(up);
  state_.bead = now_.state.bead = 0;
}

void MenisciIntegration::integrate_cycle() {
  steps_.clear();
  now_.angle_deg = kBeginDeg;
  for (std::size_t stroke = 1; stroke <= kStrokes; ++stroke) {
    integrate_stroke(kBeginDeg + static_cast<double>(stroke) * kStrokeDeg);
  }
  limit_rates(steps_);
}

MenisciSample MenisciIntegration::sample(const MenisciStep& step, double crank_angle_deg) {
  MenisciConditions acting =
      menisci_conditions(setup_, grid_.width, crank_angle_deg, step.direction, step.highest_pressure, step.heat);
  film::MenisciInputs& inputs = acting.inputs;
  film::MenisciState state = step.state_at(crank_angle_deg);
  // The asperities of a dry ring balance its load at once.
  if (state.is_dry()) state.ln_h_m = std::log(dry_film(film_, inputs));
  const OilBeyond oil = step.beyond_at(crank_angle_deg);
  const film::MenisciBalance balance = solve(inputs, state, oil.next, step.lift_rate);
  MenisciSample sample;
  sample.crank_angle_deg = wrapped(crank_angle_deg);
  sample.h_m = std::exp(state.ln_h_m);
  sample.bead = state.bead;
  sample.is_dry = state.is_dry();
  sample.integrals = film_.integrals(inputs, state, balance);
  // Where gas is, the oil lies on the liner and moves with it.
  const double U = inputs.film.U, middle = 0.5 * grid_.width;
  if (state.left.x > 0) sample.integrals.flow_left = U * oil.left_edge;
  if (state.right.x < grid_.width) sample.integrals.flow_right = U * oil.right_edge;
  if (middle <= state.left.x || middle >= state.right.x) sample.integrals.flow_middle = U * oil.middle;
  acting.at.oil_ahead = inputs.left_leads() ? oil.left_edge : oil.right_edge;
  sample.at = std::move(acting.at);
  return sample;
}

}  // namespace ringfilm::cycle
