#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/cycle/menisci/menisci_integration.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/film/menisci/menisci_places.hpp"

/// The steps of an integration: rates and their slopes, a step of any length, the part of it up to a change of a place.
namespace ringfilm::cycle {
namespace {

using film::MeniscusPlace;

/// Longest and shortest step [degree].
constexpr double kMaxLength = 12, kMinLength = 1e-9;
constexpr double kAimedError = 0.7, kMinGrowth = 0.2, kMaxGrowth = 4, kAfterFailure = 0.25;
/// Order of the error that is estimated.
constexpr double kOrder = 3;
constexpr int kMaxTries = 100, kMaxSearch = 12;
/// Pressure of a stage at most, over the highest that the oil serves [-].
constexpr double kMaxRise = 4;
/// Within a step a film changes by less [-], and no film is shorter [m].
constexpr double kMaxChangeOfFilm = 3, kMinLengthOfStage = 1e-6;
/// Shifts by which slopes are taken: of ln h_m, of a meniscus [m], of the film on the liner and the bead as a share of
/// the smallest film, of the angle [degree].
constexpr double kShiftOfFilm = 1e-4, kShiftOfPlace = 3e-8, kShiftOfSupply = 1e-3, kShiftOfAngle = 1e-2;
/// Bead that counts as much as an error of 1 in ln h_m, over the oil of a film of the smallest thickness [-].
constexpr double kBeadScale = 5;

}  // namespace

film::MenisciState MenisciIntegration::with(const Vector& y) const {
  film::MenisciState state = state_;
  if (!(std::abs(y[0] - state_.ln_h_m) < kMaxChangeOfFilm)) throw ConvergenceError("the film changes within a step");
  state.ln_h_m = y[0];
  state.left.x = y[1];
  state.right.x = y[2];
  state.bead = y[3];
  return state;
}

MenisciIntegration::Vector MenisciIntegration::unknowns() const {
  return Vector(state_.ln_h_m, state_.left.x, state_.right.x, state_.bead);
}

film::OnLiner MenisciIntegration::read(const RingConditions& at, const film::MenisciState& state) const {
  return liner_.next_to(at.below_tdc + state.left.x, at.below_tdc + state.right.x);
}

/// The balance of a film, whose menisci a stage may have put beyond the face or past each other.
film::MenisciBalance MenisciIntegration::solve(film::MenisciInputs& inputs, const film::MenisciState& state,
                                               const film::OnLiner& on_liner, double lift_rate,
                                               film::Iteration iteration) {
  film::MenisciState within = state;
  if (!state.is_dry()) {
    const double width = grid_.width;
    within.left.x = std::clamp(state.left.x, 0.0, width - kMinLengthOfStage);
    within.right.x = std::clamp(state.right.x, within.left.x + kMinLengthOfStage, width);
  }
  ++effort_.balances;
  constexpr int kMaxRanges = 8;
  for (int k = 0; k < kMaxRanges; ++k) {
    const film::MenisciBalance balance = film_.balance(inputs, within, on_liner, lift_rate, iteration);
    if (balance.peak_pressure <= inputs.oil.high()) return balance;
    inputs = inputs.served_up_to(kServedOverPeak * std::min(balance.peak_pressure, kMaxRise * inputs.oil.high()));
  }
  throw ConvergenceError("the pressure of the film grows without bound");
}

/// Rates of the unknowns per degree.
MenisciIntegration::Vector MenisciIntegration::rate(const film::MenisciState& state,
                                                    const film::MenisciBalance& balance) const {
  const auto speed = [](const film::Meniscus& meniscus, const film::MeniscusMotion& motion) {
    return meniscus.place == MeniscusPlace::kFree ? motion.velocity : 0;
  };
  const Vector per_second(balance.lift_rate / std::exp(state.ln_h_m), speed(state.left, balance.left),
                          speed(state.right, balance.right), balance.bead_rate);
  return per_second / degrees_per_second_;
}

/// Rates and their slopes at the present angle, by differences.
void MenisciIntegration::begin_step(double to_deg) {
  begin_.t = now_.angle_deg;
  begin_.y = unknowns();
  begin_.rate = rate(state_, now_.balance);
  begin_.by_unknowns.setZero();
  film::MenisciInputs& inputs = now_.conditions.inputs;
  const auto slope = [&](const film::MenisciState& shifted, const film::OnLiner& on_liner, double shift) -> Vector {
    return (rate(shifted, solve(inputs, shifted, on_liner, now_.balance.lift_rate, film::Iteration::kOnce)) -
            begin_.rate) /
           shift;
  };
  // What lies on the liner and the bead change the flow at a throat alone; else the balance at hand serves.
  const bool leads_left = inputs.left_leads();
  const bool feeds_throat =
      (leads_left ? state_.left : state_.right).place == MeniscusPlace::kAtThroat && !state_.is_dry();
  const auto slope_of_supply = [&](const film::MenisciState& shifted, const film::OnLiner& on_liner,
                                   double shift) -> Vector {
    if (feeds_throat) return slope(shifted, on_liner, shift);
    film::MenisciBalance balance = now_.balance;
    film_.set_motion(inputs, shifted, on_liner, balance);
    return (rate(shifted, balance) - begin_.rate) / shift;
  };
  film::MenisciState shifted = state_;
  shifted.ln_h_m += kShiftOfFilm;
  begin_.by_unknowns.col(0) = slope(shifted, now_.on_liner, kShiftOfFilm);
  // Away from the nearer one of the places at which a meniscus is no longer free.
  const double throat = film_.throat().x;
  const auto place_shift = [](double x, double low, double high) {
    return 2 * x < low + high ? kShiftOfPlace : -kShiftOfPlace;
  };
  if (state_.left.place == MeniscusPlace::kFree) {
    const double moved = place_shift(state_.left.x, 0, throat);
    shifted = state_;
    shifted.left.x += moved;
    begin_.by_unknowns.col(1) = slope(shifted, now_.on_liner, moved);
  }
  if (state_.right.place == MeniscusPlace::kFree) {
    const double moved = place_shift(state_.right.x, throat, grid_.width);
    shifted = state_;
    shifted.right.x += moved;
    begin_.by_unknowns.col(2) = slope(shifted, now_.on_liner, moved);
  }
  const double shift = kShiftOfSupply * inputs.leading().density * std::exp(state_.ln_h_m);
  shifted = state_;
  shifted.bead += shift * film::kBeadLength;
  begin_.by_unknowns.col(3) = slope_of_supply(shifted, now_.on_liner, shift * film::kBeadLength);
  film::OnLiner more = now_.on_liner;
  (leads_left ? more.left : more.right) += shift;
  by_film_ = slope_of_supply(state_, more, shift);
  const double later = std::min(kShiftOfAngle, 0.5 * (to_deg - now_.angle_deg));
  MenisciConditions shifted_angle = conditions(now_.angle_deg + later, inputs.oil.high());
  by_time_ = (rate(state_,
                   solve(shifted_angle.inputs, state_, now_.on_liner, now_.balance.lift_rate, film::Iteration::kOnce)) -
              begin_.rate) /
             later;
  speed_by_time_ = (std::abs(shifted_angle.inputs.film.U) - std::abs(inputs.film.U)) / later;
}

/// A leading meniscus at the edge of the face meets all oil up to its place: its bead has what the step has missed of
/// it, since the film on the liner is rough. @param oil_by_time slope of that film with which the step was taken
void MenisciIntegration::take_up_all(const MenisciConditions& at, const film::OnLiner& ahead, double oil_by_time,
                                     double length, film::MenisciState& state) const {
  const bool leads_left = at.inputs.left_leads();
  const film::Meniscus& leading = leads_left ? state_.left : state_.right;
  if (leading.place != MeniscusPlace::kAtEdge) return;
  const double before = leads_left ? now_.on_liner.left : now_.on_liner.right;
  const double after = leads_left ? ahead.left : ahead.right;
  const double speed = std::abs(now_.conditions.inputs.film.U), end_speed = std::abs(at.inputs.film.U);
  const double slope = speed_by_time_ * before + speed * oil_by_time;
  const double came = length * ((2 * speed * before + end_speed * after) / 3 + length * slope / 6);
  state.bead += liner_.met(leads_left, at.at.below_tdc + leading.x).mass - came / degrees_per_second_;
}

std::optional<MenisciIntegration::Candidate> MenisciIntegration::candidate(double to_deg) {
  const double length = to_deg - now_.angle_deg;
  Candidate found{{to_deg, conditions(to_deg), state_, {}, {}}, 0, 0};
  Instant& end = found.end;
  // The film on the liner is rough. The method weighs its begin, its end and its slope by 2/3, 1/3 and 1/6: this slope
  // gives the mean of what is met.
  const film::OnLiner ahead = read(end.conditions.at, state_);
  const bool leads_left = end.conditions.inputs.left_leads();
  const double begins = leads_left ? now_.on_liner.left : now_.on_liner.right;
  const double ends = leads_left ? ahead.left : ahead.right;
  const double place = end.conditions.at.below_tdc + (leads_left ? state_.left.x : state_.right.x);
  const double oil_by_time = (6 * liner_.met(leads_left, place).mean - 4 * begins - 2 * ends) / length;
  const Vector by_time = by_time_ + by_film_ * oil_by_time;
  try {
    const auto expected_lift = [&](const Vector& y) {
      const double per_degree = begin_.rate[0] + begin_.by_unknowns.row(0).dot(y - begin_.y) + length * by_time[0];
      return per_degree * degrees_per_second_ * std::exp(y[0]);
    };
    const auto rate_of = [&](double, const Vector& y) -> Vector {
      const film::MenisciState state = with(y);
      return rate(state, solve(end.conditions.inputs, state, read(end.conditions.at, state), expected_lift(y)));
    };
    const Rosenbrock::End taken = Rosenbrock::take(begin_, length, by_time, rate_of);
    end.state = with(taken.y);
    take_up_all(end.conditions, ahead, oil_by_time, length, end.state);
    end.on_liner = read(end.conditions.at, end.state);
    end.balance = solve(end.conditions.inputs, end.state, end.on_liner, expected_lift(taken.y));
    const double width = grid_.width;
    const double bead = kBeadScale * end.conditions.inputs.leading().density * std::exp(end.state.ln_h_m) * width;
    const Vector scaled = taken.error.cwiseQuotient(Vector(1, width / 4, width / 4, bead));
    found.error = scaled.norm() / 2 / tolerance_;
    found.margin = film::margin_of_places(film_, end.conditions.inputs, end.state, end.balance);
  } catch (const ConvergenceError&) {
    return std::nullopt;  // the step is too long
  }
  if (!std::isfinite(found.error)) return std::nullopt;
  return found;
}

/// The part of a step up to the first change of a place, by the Illinois rule on its length: its margin is below 0, so
/// that the change is due, by half of what is allowed if the search succeeds.
MenisciIntegration::Candidate MenisciIntegration::up_to_change(Candidate beyond) {
  constexpr double kAimed = 0.5 * film::kReachedMargin;
  const double margin = film::margin_of_places(film_, now_.conditions.inputs, state_, now_.balance);
  double low = now_.angle_deg, at_low = std::max(margin, 0.0) + kAimed, at_high = beyond.margin + kAimed;
  bool was_low = false, was_high = false;
  for (int k = 0; k < kMaxSearch && at_high < -kAimed && beyond.end.angle_deg - low > kMinLength; ++k) {
    const double share = std::clamp(at_low / (at_low - at_high), 0.01, 0.99);
    std::optional<Candidate> between = candidate(low + share * (beyond.end.angle_deg - low));
    if (!between) break;
    const double found = between->margin + kAimed;
    const bool is_low = between->margin >= 0;
    if (is_low) {
      low = between->end.angle_deg;
      at_low = found;
      if (was_low) at_high *= 0.5;
    } else {
      beyond = std::move(*between);
      at_high = found;
      if (was_high) at_low *= 0.5;
    }
    was_low = is_low;
    was_high = !is_low;
  }
  return beyond;
}

void MenisciIntegration::step(double to_deg) {
  begin_step(to_deg);
  bool is_repeated = false;
  for (int k = 0; k < kMaxTries && next_length_deg_ > kMinLength; ++k) {
    const double rest = to_deg - now_.angle_deg, longest = std::min(next_length_deg_, kMaxLength);
    const double length = longest >= rest ? rest : std::min(longest, 0.5 * rest);
    std::optional<Candidate> found = candidate(longest >= rest ? to_deg : now_.angle_deg + length);
    const double growth =
        found ? std::clamp(kAimedError * std::pow(std::max(found->error, 1e-9), -1 / kOrder), kMinGrowth, kMaxGrowth)
              : kAfterFailure;
    if (!found || found->error > 1) {
      next_length_deg_ = length * std::min(growth, 0.9);
      is_repeated = true;
      ++effort_.rejected;
      continue;
    }
    if (found->margin < 0) *found = up_to_change(std::move(*found));
    if (found->error > 1) {
      next_length_deg_ = 0.5 * (found->end.angle_deg - now_.angle_deg);
      is_repeated = true;
      ++effort_.rejected;
      continue;
    }
    next_length_deg_ = std::max(length * (is_repeated ? std::min(growth, 1.0) : growth), kMinLength * 2);
    accept(found->end);
    settle_places();
    return;
  }
  throw ConvergenceError(
      formatted("no step of the film between its menisci is found at %.6g degree", wrapped(now_.angle_deg)),
      wrapped(now_.angle_deg));
}

}  // namespace ringfilm::cycle
