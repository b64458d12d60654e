#include "ringfilm/cycle/cycle_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/advice/validity.hpp"
#include "ringfilm/cycle/menisci_cycle.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/cycle/start_of_oil.hpp"

namespace ringfilm::cycle {
namespace {

/// The integration starts here, from a steady film: mid exhaust stroke, high speed and low load. With oil on the liner
/// at BDC before compression, where a cycle of the oil begins.
constexpr double kStartAngleDeg = 270, kStartOfOilDeg = 540;
/// States are compared with those of one cycle before at this spacing, over the first stroke.
constexpr double kCheckSpacingDeg = 15;
constexpr double kCheckedDeg = 180;
constexpr int kCompression = 3;  ///< stroke_at
constexpr double kNotKnown = std::numeric_limits<double>::infinity();

/// A ring that is not part of a pack has a liner of its own.
PlaceOnLiner& with_liner(const Setup& setup, PlaceOnLiner& place, OilIteration iteration) {
  const bool needs_own = setup.input.film.supply_at_inlet() == OilSupply::kFilmOnLiner && !place.film;
  if (needs_own) {
    place.film = std::make_shared<LinerFilm>(iteration == OilIteration::kMixed ? start_of_oil({setup}, {0})
                                                                               : fresh_liner(setup, 0));
  }
  return place;
}

}  // namespace

CycleRun::CycleRun(Setup setup, PlaceOnLiner place, OilIteration of_own_liner)
    : setup_(setup.input.solver.method == Method::kMenisci
                 ? without_menisci(setup, "rings of a pack share the oil on the liner")
                 : std::move(setup)),
      shares_liner_(place.film != nullptr),
      place_(std::move(place)),
      n_steps_(steps_per_cycle(setup_.input.solver)),
      step_deg_(kCycleDeg / n_steps_),
      check_every_(std::max(1, static_cast<int>(std::lround(kCheckSpacingDeg / step_deg_)))),
      film_(static_cast<std::size_t>(n_steps_)),
      integration_(setup_, with_liner(setup_, place_, of_own_liner)),
      recorder_(setup_),
      k_(static_cast<int>(std::lround((place_.film ? kStartOfOilDeg : kStartAngleDeg) / step_deg_)) % n_steps_),
      distance_{kNotKnown, kNotKnown},
      oil_ahead_(place_.film != nullptr ? kNotKnown : 0),
      approach_(setup_.input) {
  attempt([this] { integration_.start(k_); });
  if (place_.film && !shares_liner_) {
    settling_.emplace(least_oil(setup_) / place_.film->cell(), of_own_liner);
    settling_->begin(*place_.film);
  }
}

template <class Part>
void CycleRun::attempt(const Part& part) {
  try {
    part();
  } catch (const NoBalance& error) {
    stopped(error, error.failure);
  } catch (const ConvergenceError& error) {
    stopped(error, std::nullopt);
  }
}

void CycleRun::conclude(const film::FilmReport& report) {
  attempt([&] {
    integration_.conclude(report, recorder_);
    if (integration_.at_base_angle()) arrived();
  });
}

void CycleRun::arrived() {
  k_ = (k_ + 1) % n_steps_;
  ++steps_integrated_;
  film_.add(static_cast<std::size_t>(k_), integration_.instant().state->h_m);
  const int since_start = steps_integrated_ % n_steps_;
  const bool has_oil = place_.film != nullptr;
  const bool is_checked = since_start * step_deg_ <= kCheckedDeg;
  if (has_oil && begins_compression()) {
    CycleRun* const alone = this;
    film_.end_cycle();
    if (!shares_liner_) settling_->begin_next_cycle(*place_.film, {&alone, 1});
  } else if (k_ % check_every_ == 0 && is_checked) {
    compare_with_last_cycle();
  }
  if (!repeats_ && !approach_.moves_on() && since_start == 0) {
    approach_.add(distance_ahead(), distance_.film, allowed_distance(setup_.input), crank_angle_deg());
  }
}

bool CycleRun::begins_compression() const {
  return stroke_at(k_ * step_deg_) == kCompression && stroke_at((k_ - 1) * step_deg_) != kCompression;
}

void CycleRun::compare_with_last_cycle() {
  const auto before = one_cycle_ago_.find(k_);
  if (before != one_cycle_ago_.end()) {
    distance_ = integration_.distance(before->second);
    repeats_ = distance_.film <= allowed_distance(setup_.input) && oil_repeats();
  }
  const bool goes_on = !repeats_ || shares_liner_;  // until all rings of the pack repeat themselves
  if (goes_on) one_cycle_ago_[k_] = integration_.snapshot();
}

void CycleRun::forget_last_cycle() {
  one_cycle_ago_.clear();
  one_cycle_ago_[k_] = integration_.snapshot();
}

bool CycleRun::oil_repeats() const {
  const double allowed = setup_.input.solver.step_error;
  if (approach_.takes_unsettled()) return distance_.on_liner <= allowed;
  return std::max(distance_.on_liner, oil_ahead_) <= allowed && film_ahead_ <= kFilmAhead * allowed;
}

double CycleRun::distance_ahead() const { return std::max(distance_.largest(), oil_ahead_); }

void CycleRun::stopped(const ConvergenceError& error, std::optional<film::Failure> failure) {
  stop_ = Stop{error.what(), error.crank_angle_deg(), failure};
}

std::optional<Setup> second_attempt(const Setup& setup, const Stop& stop) {
  const Case& c = setup.input;
  if (stop.failure && stop.failure != film::Failure::kLiftedOff && c.bends() && setup.surfaces == Surfaces::kRigid) {
    const std::string at_angle =
        stop.crank_angle_deg ? " at " + number_text(*stop.crank_angle_deg) + " degree" : std::string();
    Setup flat = setup;
    flat.surfaces = Surfaces::kFlattening;
    flat.notes.push_back(
        {kSurfacesFlattened,
         std::string("computed with a ring and a liner that flatten where they are pressed together") +
             (setup.ring.contact ? ", and asperities that carry what the film cannot where it closes" : "") +
             ", since rigid ones have no film" + at_angle,
         1});
    return flat;
  }
  const bool can_help = stop.failure && stop.failure != film::Failure::kLiftedOff && !c.is_unrolled() &&
                        c.solver.method != Method::kPointRelaxation;
  if (!can_help || setup.cells == CellsOfFace::kGraded) return std::nullopt;
  Setup graded = setup;
  graded.cells = CellsOfFace::kGraded;
  const film::FilmGrid grid = face_grid(graded);
  const std::string cells =
      formatted("computed on %d cells that are graded towards the lowest places of the face, down to %.3g um, since ",
                grid.n_cells(), number_in(*std::min_element(grid.spacing.begin(), grid.spacing.end()), kMicrometre));
  graded.notes.push_back({kCellsGraded, cells + stop.message, 1});
  return graded;
}

CycleResult CycleRun::result(Completeness others) const {
  CycleResult result = recorder_.result(integration_, distance_ahead(), steps_integrated_,
                                        stop_ || !done() ? Completeness::kStopped : others);
  if (result.complete && approach_.takes_unsettled() && distance_ahead() > setup_.input.solver.step_error) {
    result.notes.push_back(settling_note(result.effort.cycles_integrated, distance_ahead()));
    sort_notes(result.notes);
  }
  return result;
}

}  // namespace ringfilm::cycle
