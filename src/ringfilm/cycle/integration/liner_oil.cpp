#include "ringfilm/cycle/integration/liner_oil.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "ringfilm/case/conditions.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

/// Less than this share of the oil that the ring takes up in a cycle is rounding of sums over thousands of steps [-].
constexpr double kRounding = 1e-12;
/// Share of its mean speed with which a step of second order ends at the least: one that ends at a dead centre takes up
/// oil, too [-].
constexpr double kMinSpeed = 0.02;
/// Films on the liner that are thinner than this do not matter between smooth surfaces either [m].
constexpr double kSmooth = 0.1e-6;

}  // namespace

LinerFilm::LinerFilm(double length, double mass_per_area)
    : cell_(length / kCells), mass_per_area_(kCells, mass_per_area) {}

LinerFilm::LinerFilm(double cell, std::vector<double> mass_per_area)
    : cell_(cell), mass_per_area_(std::move(mass_per_area)) {}

int LinerFilm::cell_at(double place) const { return std::clamp(static_cast<int>(place / cell_), 0, kCells - 1); }

double LinerFilm::mass(double begin, double end) const {
  double sum = 0;
  for (int c = cell_at(begin); c <= cell_at(end); ++c) {
    const double overlap = std::min(end, (c + 1) * cell_) - std::max(begin, c * cell_);
    if (overlap > 0) sum += mass_per_area_[c] * overlap;
  }
  return sum;
}

void LinerFilm::lay(double begin, double end, double mass, bool open_below) {
  if (!(end > begin)) return;
  const double laid = mass / (end - begin);
  for (int c = cell_at(begin); c <= cell_at(end); ++c) {
    const double low = c * cell_, high = (c + 1) * cell_;
    const double overlap = std::min(end, high) - std::max(begin, low);
    if (overlap <= 0) continue;
    const double open =
        open_below ? std::max(high - std::max(end, low), 0.0) : std::max(std::min(begin, high) - low, 0.0);
    mass_per_area_[c] = (mass_per_area_[c] * open + laid * overlap) / (open + overlap);
  }
}

namespace {

/// What the oil ring leaves, all along the liner.
LinerFilm film_of_oil_ring(const Setup& setup, double length, double below_first_ring) {
  const std::vector<StrokeValue>& film = setup.input.supply.film;
  LinerFilm fresh(length, 0);
  if (film.empty()) return fresh;
  std::vector<double> mass_per_area = fresh.mass_per_area();
  for (std::size_t c = 0; c < mass_per_area.size(); ++c) {
    const double place = (static_cast<double>(c) + 0.5) * fresh.cell();
    mass_per_area[c] = setup.ring.oil.density * along_stroke(film, place - below_first_ring);
  }
  return {fresh.cell(), std::move(mass_per_area)};
}

}  // namespace

double share_elsewhere(const std::vector<double>& mass_per_area, const std::vector<double>& other) {
  double moved = 0, largest = 0, all = 0;
  for (std::size_t c = 0; c < mass_per_area.size(); ++c) {
    moved += mass_per_area[c] - other[c];
    largest = std::max(largest, std::abs(moved));
    all += mass_per_area[c];
  }
  return all > 0 ? largest / all : 0.0;
}

double least_oil(const Setup& setup) {
  const double roughness = std::max(setup.input.contact.roughness, kSmooth);
  return setup.ring.oil.density * roughness * setup.input.ring.face_width;
}

LinerFilm fresh_liner(const Setup& last_ring, double below_first_ring) {
  const double length = below_first_ring + last_ring.engine.crank.stroke() + last_ring.input.ring.face_width;
  const double reach = last_ring.input.supply.reach.value_or(0);
  LinerFilm film = film_of_oil_ring(last_ring, length, below_first_ring);
  film.lay(0, reach, kFirstAboveReach * film.mass(0, reach), false);
  return film;
}

LinerOil::LinerOil(const Setup& setup, const film::FilmGrid& grid, const PlaceOnLiner& place)
    : setup_(&setup),
      begin_(0.5 * grid.spacing.front()),
      end_(grid.width - 0.5 * grid.spacing.back()),
      reach_(place.is_last ? setup.input.supply.reach.value_or(0) : std::numeric_limits<double>::infinity()),
      below_first_ring_(place.below_first_ring),
      film_(place.film ? place.film : std::make_shared<LinerFilm>(fresh_liner(setup, 0))),
      fresh_(film_of_oil_ring(setup, film_->length(), below_first_ring_)),
      left_(*film_) {}

LinerOil::Sweep LinerOil::sweep(double from_deg, double to_deg) const {
  const auto place = [this](double angle) {
    return below_first_ring_ + setup_->engine.crank.position(radians(wrapped(angle)));
  };
  const double from = place(from_deg), to = place(to_deg);
  if (to < from) return {to + begin_, from + begin_, to + end_, from + end_, true};
  return {from + end_, to + end_, from + begin_, to + begin_, false};
}

double LinerOil::mass_ahead(const Sweep& swept) const {
  if (swept.up) return film_->mass(swept.lead_begin, swept.lead_end);
  const double reach = std::clamp(reach_, swept.lead_begin, swept.lead_end);
  return film_->mass(swept.lead_begin, reach) + fresh_.mass(reach, swept.lead_end);
}

void LinerOil::limit(RingConditions& at, double from_deg, double to_deg) const {
  const Sweep swept = sweep(from_deg, to_deg);
  if (!(swept.length() > 0)) {
    at.inputs.left.supply = at.inputs.right.supply = 0;  // nothing moves, so nothing comes
    return;
  }
  const double speed = swept.length() / at.inputs.time_step;
  at.inputs.U = swept.up ? speed : -speed;
  film::EdgeState& lead = swept.up ? at.inputs.left : at.inputs.right;
  if (lead.fluid != film::EdgeFluid::kGas) return;
  const double bead = swept.up == up_ ? bead_ : 0;
  at.oil_ahead = mass_ahead(swept) / swept.length();
  lead.supply = std::max(at.oil_ahead + bead / swept.length(), 0.0);
}

void LinerOil::limit(RingConditions& at, double from_deg, double to_deg, double of_flow_before) const {
  const Sweep swept = sweep(from_deg, to_deg);
  if (!(swept.length() > 0)) {
    limit(at, from_deg, to_deg);
    return;
  }
  const double mean = swept.length() * setup_->engine.speed / radians(to_deg - from_deg);
  const double speed = std::max(std::abs(at.piston_velocity), kMinSpeed * mean);
  at.inputs.U = swept.up ? speed : -speed;
  film::EdgeState& lead = swept.up ? at.inputs.left : at.inputs.right;
  if (lead.fluid != film::EdgeFluid::kGas) return;
  const double ahead = mass_ahead(swept);
  at.oil_ahead = ahead / swept.length();
  const double before = of_flow_before * passed_.in;
  lead.supply = std::max(ahead + bead_ - before, 0.0) / (at.inputs.time_step * speed);
}

void LinerOil::turn(bool up) {
  if (begun_) (up_ ? account_.scraped_up : account_.scraped_down) += bead();
  // What each edge owes to the liner, it owes on the way back.
  std::tie(bead_, owed_) = std::pair(owed_, std::min(bead_, 0.0));
  up_ = up;
  begun_ = true;
  std::rotate(at_turns_.begin(), at_turns_.end() - 1, at_turns_.end());
  at_turns_.front() = account_;
}

LinerOil::Account LinerOil::of_last_cycle() const {
  const Account &now = at_turns_.front(), &before = at_turns_.back();
  const double taken = now.taken - before.taken;
  const auto change = [taken](double from, double to) {
    return std::abs(to - from) < kRounding * std::abs(taken) ? 0 : to - from;
  };
  return {change(before.replenished, now.replenished), change(before.scraped_up, now.scraped_up),
          change(before.scraped_down, now.scraped_down), taken, now.left - before.left};
}

double LinerOil::mean(const std::vector<double>& films, double begin, double end, bool below) const {
  const double shift = below_first_ring_ + (below ? setup_->input.ring.face_width : 0);
  return LinerFilm(film_->cell(), films).mass(begin + shift, end + shift) / (end - begin);
}

film::PassedOil LinerOil::passed(const RingConditions& at, double of_flow_before, double from_chamber,
                                 double to_crankcase) const {
  const bool up = at.inputs.U > 0;
  return {of_flow_before * passed_.in + at.inputs.time_step * (up ? from_chamber : -to_crankcase),
          of_flow_before * passed_.out + at.inputs.time_step * (up ? to_crankcase : -from_chamber)};
}

void LinerOil::pass(const RingConditions& at, double from_deg, double to_deg, const film::PassedOil& passed) {
  const Sweep swept = sweep(from_deg, to_deg);
  const auto stroke = static_cast<std::size_t>(stroke_at(0.5 * (from_deg + to_deg))) % kStrokes;
  if (swept.up != up_ || !begun_) {
    passes_[(stroke + kStrokes - 1) % kStrokes].after = left_.mass_per_area();
    turn(swept.up);
    left_ = *film_;
    std::vector<double>& before = passes_[stroke].before = film_->mass_per_area();
    const double first = reach_ / film_->cell();
    if (!swept.up && first < static_cast<double>(before.size())) {
      const auto cell = static_cast<std::ptrdiff_t>(first);
      std::copy(fresh_.mass_per_area().begin() + cell, fresh_.mass_per_area().end(), before.begin() + cell);
    }
  }
  const double ahead = mass_ahead(swept);
  passed_ = passed;
  account_.replenished += ahead - film_->mass(swept.lead_begin, swept.lead_end);
  account_.taken += passed.in;
  account_.left += passed.out;
  bead_ += ahead - passed.in;
  const film::EdgeState& lead = swept.up ? at.inputs.left : at.inputs.right;
  if (bead_ < 0 && lead.fluid != film::EdgeFluid::kGas) {
    // An inlet of oil takes more than lies on the liner: that is oil from elsewhere.
    account_.replenished -= bead_;
    bead_ = 0;
  }
  if (setup_->input.supply.scraped == Scraped::kDiscarded && bead_ > 0) {
    (up_ ? account_.scraped_up : account_.scraped_down) += bead_;
    bead_ = 0;
  }
  const double laid = passed.out + owed_;
  owed_ = std::min(laid, 0.0);
  for (LinerFilm* film : {film_.get(), &left_}) {
    film->lay(swept.trail_begin, swept.trail_end, std::max(laid, 0.0), swept.up);
  }
}

double LinerOil::on_liner(double crank_angle_deg) const {
  const double place = below_first_ring_ + setup_->engine.crank.position(radians(wrapped(crank_angle_deg)));
  return film_->mass(0, place + begin_) + film_->mass(place + end_, film_->length()) + std::min(bead_, 0.0) + owed_;
}

}  // namespace ringfilm::cycle
