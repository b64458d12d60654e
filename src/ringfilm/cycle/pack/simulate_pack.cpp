#include "ringfilm/cycle/pack/simulate_pack.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/pack_runs.hpp"
#include "ringfilm/cycle/start_of_oil.hpp"

namespace ringfilm::cycle {
namespace {

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

/// All rings until each repeats itself or one stops.
void integrate(PackRuns& pack, OilSettling& settling, Observer* observer) {
  settling.begin(pack.liner());
  std::vector<CycleRun*> rings;
  for (const auto& run : pack.runs()) rings.push_back(run.get());
  const auto repeats = [](const CycleRun* run) { return !run->stop() && run->done(); };
  bool goes_on = true;
  while (goes_on && !std::all_of(rings.begin(), rings.end(), repeats)) {
    goes_on = pack.finish_stroke(observer);
    if (goes_on && pack.begins_compression()) settling.begin_next_cycle(pack.liner(), rings);
  }
}

}  // namespace

bool shares_oil(const Case& pack) {
  return pack.rings.size() > 1 && pack.rings.front().film.supply_at_inlet() == OilSupply::kFilmOnLiner;
}

std::vector<RingOutcome> simulate_pack(std::vector<Setup> rings, Observer* observer, OilIteration iteration) {
  const std::vector<double> below = below_first_ring(rings);
  for (;;) {
    const bool settles_first = iteration == OilIteration::kMixed;
    PackRuns pack(rings, below, settles_first ? start_of_oil(rings, below) : fresh_liner(rings.back(), below.back()));
    OilSettling settling(least_oil(rings.front()) / pack.liner().cell(), iteration);
    integrate(pack, settling, observer);
    const auto& runs = pack.runs();
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
