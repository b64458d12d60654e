#include "ringfilm/life/life_run.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/base/table.hpp"
#include "ringfilm/cycle/advice/gas_plausibility.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/integration/cycle_film.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/life/archard_run.hpp"
#include "ringfilm/life/duty_batch.hpp"
#include "ringfilm/life/end_of_life.hpp"
#include "ringfilm/life/wear/wear_bounds.hpp"

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

void append_orientation_note(const Life& life, LifeResult& result) {
  const cycle::Orientation of_states = life.states.front().input.ring.face.orientation;
  if (life.points.front().input.ring.face.orientation == of_states) return;
  result.notes.push_back({"orientation-of-states",
                          "the states have another ring.face.orientation than the base case; that of the states is "
                          "used, as their faces are"});
}

/// Depths that faces of one datum have lost since the first of them, at a running time by an interpolation; `x` of
/// all of them.
std::vector<double> lost_since_first(const Life& life, const Interpolation& path, double time,
                                     const std::vector<double>& x) {
  const auto at = [&](std::size_t i) {
    const FaceHeights face = face_heights(life.states[i].input, cycle::HeightZero::kAsGiven);
    std::vector<double> heights;
    for (const double place : x) heights.push_back(interpolate_linear(face.x, face.height, place));
    return heights;
  };
  std::size_t later = 0;
  while (later + 1 < life.states.size() && life.states[later].time < time) ++later;
  const std::size_t earlier = later == 0 ? 0 : later - 1;
  double share = 1;
  if (life.states[later].time > time) {
    share = path_share(path, life.states[earlier].time, life.states[later].time, time);
  }
  const std::vector<double> first = at(0), from = at(earlier), to = at(later);
  std::vector<double> lost;
  for (std::size_t i = 0; i < x.size(); ++i) lost.push_back((1 - share) * from[i] + share * to[i] - first[i]);
  return lost;
}

/// What faces state about wear: with one datum the wear itself, else lower bounds at measured states.
void put_wear(const Life& life, const std::vector<NamedPath>& other_paths, PackGas& gas, LifeState& state) {
  if (life.datum == Datum::kCommon) {
    const auto lost = [&](const Interpolation& path) {
      std::vector<double> depth = lost_since_first(life, path, state.time, state.x);
      const double area = area_under(state.x, depth);
      return worn_profile(std::move(depth), area, life.points.front().input.ring.coating.thickness);
    };
    gas.put_blow_by(state.worn.emplace(lost(life.path)));
    for (const NamedPath& other : other_paths) gas.put_blow_by(*state.other_worn.emplace_back(lost(other.path)));
    return;
  }
  const FaceHeights first = face_heights(life.states.front().input);
  for (const MeasuredState& measured : life.states) {
    if (measured.time != state.time || measured.time == life.states.front().time) continue;
    const FaceHeights face = face_heights(measured.input);
    for (const double share : trusted_margins()) {
      state.least_wear.push_back(least_wear(first, face, share * first.width(), Tilt::kFree));
    }
  }
}

/// The ring on a path, with its end gap as far as the faces determine it.
class PathRing {
 public:
  explicit PathRing(const Life& life) : life_(life) {
    if (life.pack) x_ = cycle::face_grid(cycle::prepare(life.points.front().input)).x;
  }

  RingState at(const Interpolation& path, double time) const {
    RingState ring = state_on_path(life_.states, path, time, life_.points.front().input.solver.cells);
    if (x_.empty()) return ring;
    const std::vector<double> lost = lost_since_first(life_, path, time, x_);
    ring.gap.ring_depth = std::max(0.0, *std::max_element(lost.begin(), lost.end()));
    return ring;
  }

 private:
  const Life& life_;
  std::vector<double> x_;  ///< nodes of the film; empty without a pack [m]
};

LifeResult run_path(const Life& life, const CycleIntegrators& integrators, PackGas& gas) {
  LifeResult result;
  result.other_paths = other_paths_of(life.path);
  const PathRing path_ring(life);
  DutyBatch reported(life, gas, Points::kAll), others(life, gas, Points::kOfTheDuty);
  result.states.resize(life.times.size());
  for (std::size_t i = 0; i < life.times.size(); ++i) {
    LifeState& state = result.states[i];
    state.time = life.times[i].time;
    state.state_origin = state_origin_at(life.states, state.time);
    state.ring = path_ring.at(life.path, state.time);
    state.point_gas = gas.sums(state.ring.gap);
    state.other_paths.resize(result.other_paths.size());
    const std::string name = hours_text(state.time);
    reported.add(state.ring, name, [&](const auto& results) { take_duty(life, results, state, result.notes); });
    if (state.state_origin == StateOrigin::kInterpolated) {
      for (std::size_t k = 0; k < result.other_paths.size(); ++k) {
        const NamedPath& other = result.other_paths[k];
        others.add(path_ring.at(other.path, state.time), name + ", " + other.name, into(life, state.other_paths[k]));
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
    put_wear(life, result.other_paths, gas, state);
    // At a measured state and after the last one all paths agree.
    for (LifeValues& other : state.other_paths) {
      if (other.empty()) other = state.values;
    }
  }
  cycle::sort_notes(result.notes);
  append_orientation_note(life, result);
  append_held_note(life, result);
  if (life.datum == Datum::kOwn) {
    result.notes.push_back({"wear-not-determined",
                            "each face counts from a datum of its own, so that offset and tilt between them are not "
                            "known: worn area and depth are not determined, only lower bounds of them"});
  }
  return result;
}

void append_pressure_note(const Life& life, LifeResult& result) {
  std::vector<const cycle::Case*> points;
  for (const OperatingPoint& point : life.points) points.push_back(&point.input);
  const std::optional<std::string> kept = cycle::kept_pressure(points);
  if (!kept) return;
  result.notes.push_back({"pressure-kept", *kept + "; state peak_pressure or cylinder_pressure at each point"});
}

}  // namespace

LifeResult run_life(const Life& life, const CycleIntegrators& integrators) {
  PackGas gas(life);
  LifeResult result =
      life.mode == Mode::kArchard ? run_archard(life, integrators, gas) : run_path(life, integrators, gas);
  result.unworn.coating_left = life.wear.coating_thickness;
  gas.put_blow_by(result.unworn);
  for (cycle::Note& note : gas.notes()) result.notes.push_back(std::move(note));
  if (!life.accuracy.empty()) result.notes.push_back({"accuracy-asked-for", life.accuracy});
  append_pressure_note(life, result);
  result.ends = ends_of_life(life, result);
  append_notes_of_ends(life, result);
  return result;
}

}  // namespace ringfilm::life
