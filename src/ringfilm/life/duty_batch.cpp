#include "ringfilm/life/duty_batch.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ringfilm::life {
namespace {

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

/// The zero of stored heights: the lowest point, or that of the input where the case asks for it.
double stored_minimum(const RingState& ring, const cycle::CycleResult& result) {
  if (ring.face.height_zero != cycle::HeightZero::kAsGiven) return 0;
  const auto minimum = result.derived.find("face_height_minimum");
  return minimum == result.derived.end() ? 0 : minimum->second;
}

}  // namespace

void DutyBatch::add(const RingState& ring, const std::string& name, DutyTaker take) {
  for (std::size_t i = 0; i < n_points_; ++i) {
    const OperatingPoint& point = life_.points[i];
    requests_.push_back(
        {gas_.with_pressures(with_ring_state(point.input, ring), i, ring.gap), name + ", " + point.name});
    cycle::Output& output = requests_.back().input.output;  // the values of a cycle do not depend on it
    output = {};
    output.crank_angles_deg = {0};
  }
  takers_.push_back(std::move(take));
}

long DutyBatch::integrate(const CycleIntegrator& integrator) {
  std::vector<cycle::CycleResult> results = integrator(requests_);
  auto next = results.begin();
  for (const DutyTaker& take : takers_) {
    const auto end = next + static_cast<std::ptrdiff_t>(n_points_);
    take({std::make_move_iterator(next), std::make_move_iterator(end)});
    next = end;
  }
  return static_cast<long>(results.size());
}

std::vector<double> cycle_shares(const Life& life) {
  double cycles = 0;
  for (const OperatingPoint& point : life.points) cycles += point.share * point.input.operating.speed;
  std::vector<double> shares;
  for (const OperatingPoint& point : life.points) shares.push_back(point.share * point.input.operating.speed / cycles);
  return shares;
}

std::vector<LifeValues> values_of(const std::vector<cycle::CycleResult>& results) {
  std::vector<LifeValues> all;
  for (const cycle::CycleResult& result : results) all.push_back(life_values(result.values));
  return all;
}

LifeValues of_duty(const Life& life, const std::vector<LifeValues>& points) {
  const std::vector<double> shares = cycle_shares(life);
  std::vector<WeightedValues> weighted;
  for (std::size_t i = 0; i < n_duty_points(life); ++i) {
    weighted.push_back({life.points[i].share, shares[i], points[i]});
  }
  return combined(weighted);
}

void take_duty(const Life& life, const std::vector<cycle::CycleResult>& results, LifeState& state,
               std::vector<cycle::Note>& notes) {
  state.x = results.front().fields.x;
  state.face_height = results.front().fields.face_height;
  const double minimum = stored_minimum(state.ring, results.front());
  for (double& height : state.face_height) height -= minimum;
  state.points = values_of(results);
  state.values = of_duty(life, state.points);
  for (const cycle::CycleResult& result : results) add_notes(result.notes, notes);
}

DutyTaker into(const Life& life, LifeValues& values) {
  return
      [&life, &values](const std::vector<cycle::CycleResult>& results) { values = of_duty(life, values_of(results)); };
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

void add_parts(const Life& life, std::vector<LifeState>& states, DutyBatch& batch) {
  for (std::size_t i = 1; i < states.size(); ++i) {
    for (const Part part : {Part::kFace, Part::kRoughness, Part::kShearStrength}) {
      batch.add(with_part(states.front().ring, states[i].ring, part), hours_text(states[i].time) + ", one part changed",
                into(life, states[i].parts[static_cast<std::size_t>(part)]));
    }
  }
}

}  // namespace ringfilm::life
