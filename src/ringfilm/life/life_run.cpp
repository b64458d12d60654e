#include "ringfilm/life/life_run.hpp"

#include "ringfilm/cycle/note_topics.hpp"
#include "ringfilm/life/archard_run.hpp"
#include "ringfilm/life/duty_batch.hpp"
#include "ringfilm/life/end_of_life.hpp"

namespace ringfilm::life {
namespace {

/// Factors of the time constant that a band covers.
constexpr double kShorter = 0.3, kLonger = 10;

std::vector<NamedPath> other_paths_of(const Interpolation& path) {
  if (path.scale == TimeScale::kLinear) return {};
  const double tau = path.time_constant;
  return {{"time constant x 0.3", {TimeScale::kLogarithmic, kShorter * tau}},
          {"time constant x 10", {TimeScale::kLogarithmic, kLonger * tau}},
          {"linear in time", {TimeScale::kLinear, tau}}};
}

RingState turned(RingState state) {
  using cycle::Orientation;
  Orientation& orientation = state.face.orientation;
  if (orientation == Orientation::kX0Chamber) {
    orientation = Orientation::kX0Crankcase;
  } else if (orientation == Orientation::kX0Crankcase) {
    orientation = Orientation::kX0Chamber;
  }
  return state;
}

void append_orientation_note(const Life& life, LifeResult& result) {
  const cycle::Orientation of_states = life.states.front().input.ring.face.orientation;
  if (life.points.front().input.ring.face.orientation == of_states) return;
  result.notes.push_back({"orientation-of-states",
                          "the states have another ring.face.orientation than the base case; that of the states is "
                          "used, as their faces are",
                          1});
}

LifeResult run_path(const Life& life, const CycleIntegrators& integrators) {
  LifeResult result;
  result.other_paths = other_paths_of(life.path);
  const int cells = life.points.front().input.solver.cells;
  DutyBatch reported(life), others(life);
  result.states.resize(life.times.size());
  for (std::size_t i = 0; i < life.times.size(); ++i) {
    LifeState& state = result.states[i];
    state.time = life.times[i].time;
    state.standing = standing_at(life.states, state.time);
    state.ring = state_on_path(life.states, life.path, state.time, cells);
    state.other_paths.resize(result.other_paths.size());
    const std::string name = hours_text(state.time);
    reported.add(state.ring, name, [&](const auto& results) { take_duty(life, results, state, result.notes); });
    if (state.standing == Standing::kInterpolated) {
      for (std::size_t k = 0; k < result.other_paths.size(); ++k) {
        const NamedPath& other = result.other_paths[k];
        others.add(state_on_path(life.states, other.path, state.time, cells), name + ", " + other.name,
                   into(life, state.other_paths[k]));
      }
    }
    if (state.ring.face.orientation != cycle::Orientation::kLeadingEdge) {
      others.add(turned(state.ring), name + ", turned over", into(life, state.turned));
    }
  }
  add_parts(life, result.states, others);
  result.cycles += reported.integrate(integrators.alone);
  result.cycles += others.integrate(integrators.side_by_side);
  for (LifeState& state : result.states) {
    // At a measured state and after the last one all paths agree.
    for (LifeValues& other : state.other_paths) {
      if (other.empty()) other = state.values;
    }
  }
  cycle::sort_notes(result.notes);
  append_orientation_note(life, result);
  append_held_note(life, result);
  return result;
}

}  // namespace

LifeResult run_life(const Life& life, const CycleIntegrators& integrators) {
  LifeResult result = life.mode == Mode::kArchard ? run_archard(life, integrators) : run_path(life, integrators);
  result.ends = ends_of_life(life, result);
  return result;
}

}  // namespace ringfilm::life
