#include "ringfilm/life/life_run.hpp"

#include <algorithm>
#include <functional>

#include "ringfilm/cycle/note_topics.hpp"

namespace ringfilm::life {
namespace {

/// Factors of the time constant that a band covers.
constexpr double kShorter = 0.3, kLonger = 10;

/// Requests of the duty at one ring state, and where the values go.
class DutyBatch {
 public:
  explicit DutyBatch(const Life& life) : life_(life) {}

  /// @param take receives the values of the operating points once they are there
  void add(const RingState& ring, const std::string& name, std::function<void(std::vector<cycle::CycleResult>)> take) {
    for (const OperatingPoint& point : life_.points) {
      requests_.push_back({with_ring_state(point.input, ring), name + ", " + point.name});
      cycle::Output& output = requests_.back().input.output;  // the values of a cycle do not depend on it
      output = {};
      output.crank_angles_deg = {0};
    }
    takers_.push_back(std::move(take));
  }

  /// @returns how many cycles were integrated
  long integrate(const CycleIntegrator& integrator) {
    std::vector<cycle::CycleResult> results = integrator(requests_);
    auto next = results.begin();
    for (const auto& take : takers_) {
      const auto end = next + static_cast<std::ptrdiff_t>(life_.points.size());
      take({std::make_move_iterator(next), std::make_move_iterator(end)});
      next = end;
    }
    return static_cast<long>(results.size());
  }

 private:
  const Life& life_;
  std::vector<CycleRequest> requests_;
  std::vector<std::function<void(std::vector<cycle::CycleResult>)>> takers_;
};

std::vector<LifeValues> values_of(const std::vector<cycle::CycleResult>& results) {
  std::vector<LifeValues> all;
  for (const cycle::CycleResult& result : results) all.push_back(life_values(result.values));
  return all;
}

LifeValues of_duty(const Life& life, const std::vector<LifeValues>& points) {
  double cycles = 0;
  for (const OperatingPoint& point : life.points) cycles += point.share * point.input.operating.speed;
  std::vector<WeightedValues> weighted;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const OperatingPoint& point = life.points[i];
    weighted.push_back({point.share, point.share * point.input.operating.speed / cycles, points[i]});
  }
  return combined(weighted);
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

/// One note of each topic, as the first cycle has it, with the number of cycles that carry it.
void add_notes(const std::vector<cycle::Note>& notes, std::vector<cycle::Note>& all) {
  for (const cycle::Note& note : notes) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const cycle::Note& one) { return one.topic == note.topic; });
    if (found == all.end()) {
      all.push_back({note.topic, note.message, 1});
    } else {
      ++found->count;
    }
  }
}

void take_duty(const Life& life, std::vector<cycle::CycleResult> results, LifeState& state,
               std::vector<cycle::Note>& notes) {
  const cycle::FaceFields& fields = results.front().fields;
  state.x = fields.x;
  state.face_height = fields.face_height;
  const double lowest = *std::min_element(state.face_height.begin(), state.face_height.end());
  const cycle::CycleResult& first = results.front();
  const auto minimum = first.derived.find("face_height_minimum");
  const bool is_as_given = state.ring.face.height_zero == cycle::HeightZero::kAsGiven;
  const double zero = is_as_given && minimum != first.derived.end() ? minimum->second : std::min(lowest, 0.0);
  for (double& height : state.face_height) height -= zero;
  state.points = values_of(results);
  state.values = of_duty(life, state.points);
  for (const cycle::CycleResult& result : results) add_notes(result.notes, notes);
}

void append_held_note(const Life& life, LifeResult& result) {
  const double last = life.states.back().time;
  const auto n =
      std::count_if(life.times.begin(), life.times.end(), [last](const ReportedTime& now) { return now.time > last; });
  if (n == 0) return;
  result.notes.push_back({"state-held",
                          "after " + hours_text(last) + ", the last measured state, the ring is held as it was then: " +
                              "nothing is known of later hours",
                          static_cast<long>(n)});
}

void append_orientation_note(const Life& life, LifeResult& result) {
  const cycle::Orientation of_states = life.states.front().input.ring.face.orientation;
  if (life.points.front().input.ring.face.orientation == of_states) return;
  result.notes.push_back({"orientation-of-states",
                          "the states have another ring.face.orientation than the base case; that of the states is "
                          "used, as their faces are",
                          1});
}

}  // namespace

LifeResult run_life(const Life& life, const CycleIntegrators& integrators) {
  LifeResult result;
  const double tau = life.path.time_constant;
  if (life.path.scale == TimeScale::kLogarithmic) {
    result.other_paths = {{"time constant x 0.3", {TimeScale::kLogarithmic, kShorter * tau}},
                          {"time constant x 10", {TimeScale::kLogarithmic, kLonger * tau}},
                          {"linear in time", {TimeScale::kLinear, tau}}};
  }
  const int cells = life.points.front().input.solver.cells;
  const auto at = [&](const Interpolation& path, double time) { return state_on_path(life.states, path, time, cells); };
  DutyBatch reported(life), others(life);
  result.states.resize(life.times.size());
  const RingState first = at(life.path, life.times.front().time);
  for (std::size_t i = 0; i < life.times.size(); ++i) {
    LifeState& state = result.states[i];
    state.time = life.times[i].time;
    state.standing = standing_at(life.states, state.time);
    state.ring = at(life.path, state.time);
    state.other_paths.resize(result.other_paths.size());
    const std::string name = hours_text(state.time);
    reported.add(state.ring, name, [&](auto results) { take_duty(life, std::move(results), state, result.notes); });
    const auto into = [&life](LifeValues& values) {
      return [&life, &values](const auto& results) { values = of_duty(life, values_of(results)); };
    };
    if (state.standing == Standing::kInterpolated) {
      for (std::size_t k = 0; k < result.other_paths.size(); ++k) {
        others.add(at(result.other_paths[k].path, state.time), name + ", " + result.other_paths[k].name,
                   into(state.other_paths[k]));
      }
    }
    if (state.ring.face.orientation != cycle::Orientation::kLeadingEdge) {
      others.add(turned(state.ring), name + ", turned over", into(state.turned));
    }
    if (i == 0) continue;
    for (const Part part : {Part::kFace, Part::kRoughness, Part::kShearStrength}) {
      others.add(with_part(first, state.ring, part), name + ", one part changed",
                 into(state.parts[static_cast<std::size_t>(part)]));
    }
  }
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

}  // namespace ringfilm::life
