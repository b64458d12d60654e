#include "ringfilm/cycle/pack_runs.hpp"

#include <algorithm>
#include <cstddef>

#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

/// One ring to the next dead centre. @returns whether it got there
bool finish(CycleRun& ring, Observer* observer) {
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

}  // namespace

PackRuns::PackRuns(const std::vector<Setup>& rings, const std::vector<double>& below, const LinerFilm& liner)
    : liner_(std::make_shared<LinerFilm>(liner)) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    runs_.push_back(std::make_unique<CycleRun>(rings[i], PlaceOnLiner{liner_, below[i], i + 1 == rings.size()}));
  }
}

bool PackRuns::finish_stroke(Observer* observer) {
  const auto gets_there = [&](const auto& run) { return finish(*run, observer); };
  const bool down = stroke_at(runs_.front()->crank_angle_deg()) % 2 == 0;
  return down ? std::all_of(runs_.rbegin(), runs_.rend(), gets_there)
              : std::all_of(runs_.begin(), runs_.end(), gets_there);
}

}  // namespace ringfilm::cycle
