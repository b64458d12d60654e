#include "ringfilm/cycle/pack/simulate_pack.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

using Runs = std::vector<std::unique_ptr<CycleRun>>;

/// Cells and crank step with which the oil of a pack settles first: it moves little more on finer ones.
constexpr int kCoarseCells = 50;
constexpr double kCoarseStepDeg = 2;

/// Height of the piston land below a ring. Where the case leaves it open, with a note: as high as the face is wide.
/// The note names no number: results label it with that of the ring as the case counts, which rails do not change.
double land_below(Setup& ring) {
  if (const auto& stated = ring.input.ring.land_below) return *stated;
  const double width = ring.input.ring.face_width;
  ring.notes.push_back({kRingDistanceAssumed,
                        "the piston land below the ring is taken to be as high as its face is wide, " +
                            text_in(width, kMillimetre) + ", since land_below of this [[ring]] is not stated",
                        1});
  return width;
}

/// Distances of the chamber edges from that of the first ring.
std::vector<double> below_first_ring(std::vector<Setup>& rings) {
  std::vector<double> below{0};
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    below.push_back(below.back() + rings[i].input.ring.face_width + land_below(rings[i]));
  }
  return below;
}

Runs started(const std::vector<Setup>& rings, const std::vector<double>& below,
             const std::shared_ptr<LinerFilm>& liner) {
  Runs runs;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    runs.push_back(std::make_unique<CycleRun>(rings[i], PlaceOnLiner{liner, below[i], i + 1 == rings.size()}));
  }
  return runs;
}

/// One ring to the next dead centre. @returns whether it got there
bool finish_stroke(CycleRun& ring, Observer* observer) {
  const int stroke = stroke_at(ring.crank_angle_deg()), n_steps = steps_per_cycle(ring.setup().input.solver);
  while (!ring.stop() && stroke_at(ring.crank_angle_deg()) == stroke) {
    const int before = ring.steps_integrated();
    ring.integration().propose();
    ring.conclude(ring.integration().solve());
    if (observer != nullptr && ring.steps_integrated() > before) {
      observer->advanced(1 + before / n_steps, ring.crank_angle_deg());
    }
  }
  return !ring.stop();
}

/// All rings until each repeats itself or one stops.
void integrate(Runs& runs, LinerFilm& liner, OilSettling& settling, Observer* observer) {
  settling.begin(liner);
  std::vector<CycleRun*> rings;
  for (const auto& run : runs) rings.push_back(run.get());
  const auto repeats = [](const auto& run) { return !run->stop() && run->done(); };
  const auto finish = [&](const auto& run) { return finish_stroke(*run, observer); };
  bool goes_on = true;
  while (goes_on && !std::all_of(runs.begin(), runs.end(), repeats)) {
    const bool down = stroke_at(runs.front()->crank_angle_deg()) % 2 == 0;
    goes_on = down ? std::all_of(runs.rbegin(), runs.rend(), finish) : std::all_of(runs.begin(), runs.end(), finish);
    if (goes_on && runs.front()->begins_compression()) settling.begin_next_cycle(liner, rings);
  }
}

/// The oil with which the rings begin, and what is known of how it settles.
struct Start {
  LinerFilm liner;
  double approach = AndersonMixing::kUnknownApproach;  ///< as of AndersonMixing
};

/// Where it pays, settled on coarse cells and steps, else a fresh liner.
Start start_of_oil(const std::vector<Setup>& rings, const std::vector<double>& below, OilIteration iteration) {
  Start fresh{fresh_liner(rings.back(), below.back())};
  std::vector<Setup> coarse = rings;
  bool pays = iteration == OilIteration::kMixed;
  for (Setup& ring : coarse) {
    Solver& solver = ring.input.solver;
    pays &= solver.cells > kCoarseCells && solver.crank_step_deg < kCoarseStepDeg &&
            ring.cells == CellsOfFace::kUniform && ring.surfaces == Surfaces::kRigid && !ring.input.is_unrolled();
    solver.cells = kCoarseCells;
    solver.crank_step_deg = kCoarseStepDeg;
    solver.crank_step_control = StepControl::kFixed;
  }
  if (!pays) return fresh;
  const auto liner = std::make_shared<LinerFilm>(fresh.liner);
  Runs runs = started(coarse, below, liner);
  OilSettling settling(iteration);
  integrate(runs, *liner, settling, nullptr);
  if (std::any_of(runs.begin(), runs.end(), [](const auto& run) { return run->stop(); })) return fresh;
  return {*liner, std::max(settling.cycles_ahead(), fresh.approach)};
}

}  // namespace

bool shares_oil(const Case& pack) {
  return pack.rings.size() > 1 && pack.rings.front().film.supply_at_inlet() == OilSupply::kFilmOnLiner;
}

std::vector<RingOutcome> simulate_pack(std::vector<Setup> rings, Observer* observer, OilIteration iteration) {
  const std::vector<double> below = below_first_ring(rings);
  for (;;) {
    const Start start = start_of_oil(rings, below, iteration);
    const auto liner = std::make_shared<LinerFilm>(start.liner);
    Runs runs = started(rings, below, liner);
    OilSettling settling(iteration, start.approach);
    integrate(runs, *liner, settling, observer);
    const auto stopped =
        std::find_if(runs.begin(), runs.end(), [](const auto& run) { return run->stop().has_value(); });
    if (stopped != runs.end()) {
      if (std::optional<Setup> graded = second_attempt((*stopped)->setup(), *(*stopped)->stop())) {
        rings[stopped - runs.begin()] = std::move(*graded);
        continue;
      }
    }
    const Completeness all = stopped == runs.end() ? Completeness::kComplete : Completeness::kStopped;
    std::vector<RingOutcome> outcomes;
    for (const auto& run : runs) outcomes.push_back({run->result(all), run->stop()});
    return outcomes;
  }
}

std::vector<RingOutcome> simulate_rings(const Case& c, Observer* observer, AtStop at_stop,
                                        const std::function<void(std::size_t)>& begins) {
  const std::vector<Case> rings = c.is_pack() ? c.rings : std::vector{c};
  if (shares_oil(c)) {
    std::vector<Setup> setups;
    for (const Case& ring : rings) setups.push_back(prepare(ring));
    return simulate_pack(std::move(setups), observer);
  }
  std::vector<RingOutcome> outcomes;
  for (const Case& ring : rings) {
    if (begins) begins(outcomes.size());
    try {
      outcomes.push_back({simulate(prepare(ring), observer), std::nullopt});
    } catch (const StoppedCycle& stop) {
      outcomes.push_back({stop.result, Stop{stop.what(), stop.crank_angle_deg()}});
      if (at_stop == AtStop::kEnd) break;
    }
  }
  return outcomes;
}

}  // namespace ringfilm::cycle
