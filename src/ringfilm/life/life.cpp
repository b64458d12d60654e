#include "ringfilm/life/life.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/table.hpp"
#include "ringfilm/life/ring_state.hpp"
#include "ringfilm/life/wear/wear_bounds.hpp"

namespace ringfilm::life {
namespace {

void check_times(const Life& life, std::vector<Fault>& faults) {
  for (std::size_t i = 0; i < life.times.size(); ++i) {
    const ReportedTime& now = life.times[i];
    if (now.time > kMaxTime) {
      faults.push_back({now.mark, "the running time " + hours_text(now.time) + " is more than a century",
                        "running times are up to " + hours_text(kMaxTime)});
    }
    if (now.time < 0) {
      faults.push_back({now.mark, "the running time " + hours_text(now.time) + " is below zero",
                        "running times count from the start of the life, 0 h"});
    } else if (i > 0 && now.time <= life.times[i - 1].time) {
      faults.push_back(
          {now.mark,
           "the running time " + hours_text(now.time) + " does not follow " + hours_text(life.times[i - 1].time),
           "list the hours in increasing order, each once"});
    }
  }
}

void check_order_of_states(const Life& life, std::vector<Fault>& faults) {
  for (std::size_t i = 0; i < life.states.size(); ++i) {
    const MeasuredState& now = life.states[i];
    if (now.time < 0) {
      faults.push_back({now.mark, "a state after " + hours_text(now.time) + " is before the start of the life",
                        "running times count from 0 h"});
    }
    if (i == 0) continue;
    const MeasuredState& before = life.states[i - 1];
    if (now.time == before.time) {
      faults.push_back({now.mark, "two states have the running time " + hours_text(now.time),
                        "between them nothing can be interpolated; give each state its own hours"});
    } else if (now.time < before.time) {
      faults.push_back({now.mark,
                        "the state after " + hours_text(now.time) + " follows that after " + hours_text(before.time),
                        "list the states in the order of their running times"});
    }
  }
}

void check_rings_of_states(const Life& life, std::vector<Fault>& faults) {
  const cycle::Case& base = life.points.front().input;
  for (const MeasuredState& state : life.states) {
    const double width = state.input.ring.face_width;
    if (width != base.ring.face_width) {
      faults.push_back({state.mark,
                        "the ring of this state has a face of " + text_in(width, kMillimetre) +
                            ", that of the base case one of " + text_in(base.ring.face_width, kMillimetre),
                        "a life is that of one ring: give both the same ring.face_width"});
    }
    if (state.input.ring.face.orientation != life.states.front().input.ring.face.orientation) {
      faults.push_back({state.mark, "this state has another ring.face.orientation than the first one",
                        "faces are interpolated from the same edge: give all states the same orientation"});
    }
    if (state.input.contact.roughness_measure != life.states.front().input.contact.roughness_measure) {
      faults.push_back({state.mark, "this state has another contact.roughness_measure than the first one",
                        "give all states their roughness by the same measure"});
    }
    if (state.input.contact.plateau != base.contact.plateau) {
      faults.push_back({state.mark, "this state has another [contact.plateau] than the base case",
                        "a life does not interpolate it: give all the same one, or state contact.roughness"});
    }
  }
}

void check_wear(const Life& life, std::vector<Fault>& faults) {
  for (const OperatingPoint& point : life.points) {
    if (point.input.ring.face.orientation == cycle::Orientation::kLeadingEdge) {
      faults.push_back({life.wear.mark,
                        "a ring that turns over at each reversal (orientation = \"leading-edge\") cannot "
                        "wear: its two edges are one",
                        "state ring.face.orientation = \"x0-chamber\" or \"x0-crankcase\""});
      break;
    }
    if (point.input.is_unrolled()) {
      faults.push_back({life.wear.mark,
                        "film.dimension = \"unrolled\" has a face at each place around the ring, and "
                        "wear is that of one face",
                        "state film.dimension = \"face\""});
      break;
    }
  }
  const bool is_fitted = life.wear.source == CoefficientSource::kFitted;
  if (is_fitted && life.wear.surface == WornSurface::kPath) {
    faults.push_back(
        {life.wear.mark,
         "wear.surface = \"path\" cannot be combined with coefficient = \"fit\": the faces that a scenario "
         "passes are independent of its coefficient only while roughness and shear strength are constant",
         "leave wear.surface out, or state wear.coefficient"});
  }
  if (life.wear.surface == WornSurface::kFrozen && !life.states.empty() && !is_fitted) {
    faults.push_back({life.states.front().mark, "[[state]] means nothing with wear.surface = \"frozen\"",
                      "leave the states out, or take wear.surface = \"path\""});
  }
}

/// With one datum no place of a face may rise; scans repeat within the noise that is allowed here.
void check_gains(const Life& life, std::vector<Fault>& faults) {
  constexpr double kNoise = 0.01e-6;
  for (std::size_t i = 1; i < life.states.size(); ++i) {
    const MeasuredState &before = life.states[i - 1], &now = life.states[i];
    const Gain gain = largest_gain(face_heights(before.input, cycle::HeightZero::kAsGiven),
                                   face_heights(now.input, cycle::HeightZero::kAsGiven));
    if (gain.height <= kNoise) continue;
    faults.push_back({now.mark,
                      "the face after " + hours_text(now.time) + " has gained " + text_in(gain.height, kMicrometre) +
                          " of material at " + text_in(gain.x, kMillimetre) + " since " + hours_text(before.time) +
                          ", and with path.datum = \"common\" material only disappears",
                      "leave path.datum out unless all scans count from one datum on the ring"});
  }
}

/// A coefficient follows only from faces between which something must have been lost.
void check_fit(const Life& life, std::vector<Fault>& faults) {
  const MeasuredState &first = life.states.front(), &last = life.states.back();
  const FaceHeights base = face_heights(life.points.front().input), at_start = face_heights(first.input);
  double difference = 0;
  for (std::size_t i = 0; i < base.x.size(); ++i) {
    const double height = interpolate_linear(at_start.x, at_start.height, base.x[i]);
    difference = std::max(difference, std::abs(base.height[i] - height));
  }
  constexpr double kSameFace = 1e-9;  // [m]
  if (difference > kSameFace) {
    faults.push_back({first.mark,
                      "the face of the base case and that of the first state differ by up to " +
                          text_in(difference, kMicrometre) + ", and a fit wears the one to compare it with the others",
                      "name the same case in both, with the same ring.face.orientation"});
    return;
  }
  const WearBound bound = least_wear(at_start, face_heights(last.input), 0, Tilt::kFree);
  if (bound.area > kNegligibleArea) return;
  faults.push_back({last.mark,
                    "between the faces after " + hours_text(first.time) + " and " + hours_text(last.time) +
                        " nothing need have been lost: no wear coefficient can be fitted",
                    "state wear.coefficient, or name faces that differ by more than an offset and a tilt"});
}

void check_path(const Life& life, std::vector<Fault>& faults) {
  if (life.states.size() < 2) {
    faults.push_back({life.states.empty() ? SourceMark{} : life.states.front().mark,
                      "a path needs at least two measured states, not " + std::to_string(life.states.size()),
                      "write [[state]] with hours = \"10 h\" and case = \"run-in.toml\" for each"});
    return;
  }
  check_order_of_states(life, faults);
  check_rings_of_states(life, faults);
  if (!faults.empty()) return;
  const double first = life.states.front().time;
  if (life.mode == Mode::kArchard && first > 0) {
    faults.push_back({life.states.front().mark,
                      "wear starts at 0 h, before the first state, after " + hours_text(first),
                      "add a state with hours = \"0 h\""});
  }
  for (const ReportedTime& now : life.times) {
    if (now.time >= first) continue;
    faults.push_back(
        {now.mark,
         "the running time " + hours_text(now.time) + " is before the first state, after " + hours_text(first),
         "ask for later hours, or add a state that was measured earlier"});
  }
  if (!faults.empty()) return;
  if (life.datum == Datum::kCommon) check_gains(life, faults);
  if (life.wear.source == CoefficientSource::kFitted) check_fit(life, faults);
}

const cycle::Ring& worn_ring(const RingPack& pack) {
  return pack.input.is_pack() ? pack.input.rings[pack.ring - 1].ring : pack.input.ring;
}

/// The crank that moves the ring must be that of the pack.
void check_engine_of_pack(const Life& life, std::vector<Fault>& faults) {
  const cycle::Engine &of_pack = life.pack->input.engine, &of_ring = life.points.front().input.engine;
  const auto compare = [&](const char* key, double pack, double ring) {
    if (pack == ring) return;
    faults.push_back({life.pack->mark,
                      std::string("the pack has ") + key + " = " + text_in(pack, kMillimetre) + ", the base case " +
                          text_in(ring, kMillimetre),
                      "a ring and its pack are of one engine: give both the same"});
  };
  compare("engine.bore", of_pack.bore, of_ring.bore);
  compare("engine.stroke", of_pack.stroke, of_ring.stroke);
  compare("engine.connecting_rod_length", of_pack.connecting_rod_length, of_ring.connecting_rod_length);
}

/// The gas of the pack is computed, beside films that seal.
void check_gas_of_pack(const RingPack& pack, std::vector<Fault>& faults) {
  const cycle::GasPath& path = pack.input.gas_path;
  if (!path.is_computed()) {
    faults.push_back({pack.mark,
                      "the gas pressures of the pack are given, and [pack] computes them with the worn end gap",
                      "state gas_path.model = \"orifice-volume\" in the case of the pack"});
  }
  if (path.passes_films()) {
    faults.push_back({pack.mark,
                      "the pack states gas_path.film = \"breakthrough\", and a life computes the gas of its pack "
                      "without the films",
                      "state gas_path.film = \"sealing\", or leave it out"});
  }
}

/// The gas passes the end gap of the worn ring, and wear opens it.
void check_worn_gap(const RingPack& pack, std::vector<Fault>& faults) {
  const cycle::Ring& ring = worn_ring(pack);
  const std::string name = "ring " + std::to_string(pack.ring) + " of the pack";
  if (!ring.end_gap || ring.gas_path.gap_area) {
    faults.push_back(
        {pack.mark,
         name + " states gap_area" + (ring.end_gap ? "" : " alone") + ", which does not show by how much wear opens it",
         "state end_gap and land_clearance of that ring in place of gap_area, for example "
         "end_gap = \"0.3 mm\" and land_clearance = \"0.25 mm\""});
  }
  if (pack.ring > 1 && pack.input.rings[pack.ring - 2].ring.gas_path.volume_below == 0) {
    const std::string above = std::to_string(pack.ring - 1);
    faults.push_back({pack.mark, name + " has no piston land with a volume above it: the gas does not pass this gap",
                      "state volume_below of ring " + above + ", for example volume_below = \"500 mm3\""});
  }
}

/// The pressures of the pack act on a ring of the same kind.
void check_kind_of_ring(const Life& life, std::vector<Fault>& faults) {
  const auto name = [](const cycle::Ring& ring) {
    return std::string(ring.gas_path.kind == cycle::RingKind::kOil ? "an oil ring" : "a compression ring");
  };
  const cycle::Ring &of_pack = worn_ring(*life.pack), &of_base = life.points.front().input.ring;
  if (of_pack.gas_path.kind == of_base.gas_path.kind) return;
  faults.push_back({life.pack->mark,
                    "ring " + std::to_string(life.pack->ring) + " of the pack is " + name(of_pack) +
                        ", that of the base case " + name(of_base) +
                        ", and pressures = \"computed\" puts the "
                        "pressures of the one on the other",
                    "give both the same ring.kind, or name another ring as pack.ring"});
}

/// A pack needs the depth that opens its end gap, and the gap itself.
void check_pack(const Life& life, std::vector<Fault>& faults) {
  const RingPack& pack = *life.pack;
  check_gas_of_pack(pack, faults);
  check_worn_gap(pack, faults);
  if (life.mode == Mode::kMeasuredPath && life.datum == Datum::kOwn) {
    faults.push_back({pack.mark,
                      "[pack] needs the worn depth, which opens the end gap, and faces with data of their own do not "
                      "determine it",
                      "state path.datum = \"common\" if all scans count from one datum, or mode = \"archard\""});
  }
  check_engine_of_pack(life, faults);
  if (pack.pressures == RingPressures::kGiven) return;
  check_kind_of_ring(life, faults);
  for (const OperatingPoint& point : life.points) {
    const cycle::Ring& ring_of_point = point.input.ring;
    if (!ring_of_point.pressure_above.is_stated() && !ring_of_point.pressure_below.is_stated()) continue;
    faults.push_back({pack.mark, "the pressures above and below the ring are stated, and computed by [pack]",
                      "leave ring.pressure_above and ring.pressure_below out of the base case, or pack.pressures"});
    break;
  }
}

/// The key by which a case chooses other nodes for each face; nothing where it states none. A life that is read from a
/// file has an accuracy no longer: its cases state what that stands for.
std::optional<std::string> key_of_own_nodes(const cycle::Case& c) {
  if (c.solver.accuracy) return "solver.accuracy";
  if (c.solver.cell_lengths == cycle::CellLengths::kByGap) return "solver.cell_lengths = \"by-gap\"";
  return std::nullopt;
}

/// All states have their faces at the same nodes.
void check_nodes(const Life& life, std::vector<Fault>& faults) {
  const auto check = [&](const cycle::Case& c, const SourceMark& mark, const std::string& name) {
    const std::optional<std::string> key = key_of_own_nodes(c);
    if (!key) return false;
    faults.push_back({mark, name + " states " + *key + ", by which each face has nodes of its own",
                      "leave it out: the states of a life share the nodes of the face"});
    return true;
  };
  for (std::size_t i = 0; i < life.points.size(); ++i) {
    const OperatingPoint& point = life.points[i];
    // Those after the first are readings of the same case.
    if (check(point.input, {}, i == 0 ? "the base case" : "the case of the operating point " + point.name)) break;
  }
  for (const MeasuredState& state : life.states) {
    check(state.input, state.mark, "the state after " + hours_text(state.time));
  }
}

/// The gas path of a single ring is computed with its pack.
void check_gas_path(const Life& life, std::vector<Fault>& faults) {
  if ((life.pack && life.pack->pressures == RingPressures::kComputed) ||
      !life.points.front().input.gas_path.is_computed())
    return;
  faults.push_back({{},
                    "the base case computes its gas path (gas_path.model = \"orifice-volume\"), and the life has no "
                    "[pack] with pressures = \"computed\"",
                    "write it, with case = the file that has the gas path, or take gas_path.model = \"given\" in the "
                    "base case"});
}

/// How the roughness of a scenario may change, and whose depth that is.
void check_use_of_running_in(const Life& life, std::vector<Fault>& faults) {
  const RunningIn& law = *life.running_in;
  const auto refuse = [&](const std::string& message, const std::string& remedy) {
    faults.push_back({law.mark, "[running_in] " + message, remedy});
  };
  if (life.mode == Mode::kMeasuredPath) {
    return refuse("needs the worn depth, and mode = \"measured-path\" has no wear coefficient",
                  "omit it, or take mode = \"archard\" with wear.coefficient and wear.liner_coefficient");
  }
  if (life.wear.source == CoefficientSource::kFitted) {
    refuse(
        "cannot be combined with coefficient = \"fit\": the faces that a scenario passes are independent of its "
        "coefficient only while the roughness is constant",
        "omit it, or state wear.coefficient");
  }
  if (life.wear.surface == WornSurface::kPath) {
    refuse("cannot be combined with wear.surface = \"path\", by which the roughness is that of the measured states",
           "omit one of the two");
  }
  if (law.surface == RunningInSurface::kLiner && !life.wear.liner_coefficient) {
    refuse("smooths the liner by its worn depth, and [wear] has no liner_coefficient",
           "state wear.liner_coefficient, for example \"5e-17 m2/N\", or running_in.surface = \"ring\" where the "
           "roughness is that of the ring");
  }
  for (const OperatingPoint& point : life.points) {
    if (point.input.contact.model == cycle::ContactLaw::kTable) {
      return refuse("changes a roughness, and the contact law of a measured pair (contact.model = \"table\") has none",
                    "omit it, or take a contact.model with contact.roughness or [contact.plateau]");
    }
    if (law.surface == RunningInSurface::kRing && point.input.contact.plateau.is_stated()) {
      return refuse("has surface = \"ring\", and the plateau of the base case is that of the liner",
                    "omit running_in.surface, and state wear.liner_coefficient");
    }
  }
}

/// A roughness falls to its limit, and its peaks lose no more than is worn.
void check_running_in(const Life& life, std::vector<Fault>& faults) {
  const std::size_t n_before = faults.size();
  check_use_of_running_in(life, faults);
  if (faults.size() > n_before) return;
  const RunningIn& law = *life.running_in;
  const cycle::Case& base = life.points.front().input;
  const double start = run_in_roughness(base);
  if (law.roughness_limit >= start) {
    const std::string key = base.contact.plateau.is_stated() ? "Rpq of [contact.plateau]" : "contact.roughness";
    faults.push_back({law.limit_mark,
                      "running_in.roughness_limit = " + text_in(law.roughness_limit, kMicrometre) + " is not below " +
                          key + " of the base case, " + text_in(start, kMicrometre),
                      "surfaces run in to a lower roughness: state a smaller limit, or a rougher case"});
    return;
  }
  const double least = least_depth_scale(base, law.roughness_limit);
  if (law.depth_scale >= least) return;
  constexpr double kRoundedUp = 1.005;  // in three digits
  faults.push_back({law.scale_mark,
                    "running_in.depth_scale = " + text_in(law.depth_scale, kMicrometre) +
                        " would take more material from the peaks than is worn, at first " +
                        number_text(least / law.depth_scale, 3) + " times as much",
                    "state " + text_in(kRoundedUp * least, kMicrometre, 3) + " or more"});
}

}  // namespace

std::size_t n_duty_points(const Life& life) {
  return static_cast<std::size_t>(std::count_if(life.points.begin(), life.points.end(),
                                                [](const OperatingPoint& point) { return point.share > 0; }));
}

std::string hours_text(double time) { return number_text(time / kHour) + " h"; }

std::vector<Fault> faults_of(const Life& life) {
  std::vector<Fault> faults;
  check_times(life, faults);
  check_nodes(life, faults);
  check_gas_path(life, faults);
  if (life.pack) check_pack(life, faults);
  if (life.mode == Mode::kArchard) check_wear(life, faults);
  if (life.running_in) check_running_in(life, faults);
  const bool is_fitted = life.wear.source == CoefficientSource::kFitted;
  if (life.mode == Mode::kMeasuredPath || life.wear.surface == WornSurface::kPath || is_fitted) {
    check_path(life, faults);
  }
  return faults;
}

}  // namespace ringfilm::life
