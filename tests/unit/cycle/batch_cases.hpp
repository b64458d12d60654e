#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "../../scenarios/engine_scenario.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/cycle/simulate_batch.hpp"
#include "styles_case.hpp"

/// Batches of unlike engines, and how far two results of one engine lie apart.
namespace ringfilm::cycle::testing {

/// Member `index` of the sample of benchmarks/robustness, on few cells and with long steps.
inline Case small_engine(int index) {
  Case c = engine_scenario(1, index).input;
  c.solver.cells = std::min(c.solver.cells, 40 + index % 5 * 5);
  c.solver.crank_step_deg = std::max(c.solver.crank_step_deg, 2.0);
  return c;
}

/// A narrow crown, turning slowly: at the dead centres the film is a few nanometres thin and less than a uniform cell
/// long.
inline Case narrow_crown(int cells) {
  Case c = styles_new_ring();
  c.operating.speed = 500 * std::numbers::pi / 30;
  c.ring.elastic_pressure.reset();
  c.ring.tangential_force = 10;
  c.ring.face.form = FaceForm::kParabola;
  c.ring.face.crown_height = 100e-6;
  c.contact.roughness = 0.1e-6;
  c.film.cavitation = Cavitation::kMassConserving;
  c.solver.crank_step_control = StepControl::kAdaptive;
  c.solver.cells = cells;
  return c;
}

/// A smooth ring in contact close to one edge, where the other edge is far out of its reach.
inline Case ring_on_its_edge(double apex) {
  Case c = styles_new_ring();
  c.ring.face = {};
  c.ring.face.form = FaceForm::kParabola;
  c.ring.face.crown_height = 90e-6;
  c.ring.face.apex = apex;
  c.contact.roughness = 0.03e-6;
  c.contact.asperity_radius = 1e-6;
  c.contact.asperity_density = 0.05 / (c.contact.asperity_radius * c.contact.roughness);
  c.operating.oil_temperature = 430;
  c.film.cavitation = Cavitation::kMassConserving;
  c.solver.cells = 60;
  c.solver.crank_step_deg = 2;
  return c;
}

struct Batch {
  std::map<int, BatchOutcome> outcomes;  ///< by place in the list of cases
  LaneEffort effort;
};

/// Those `order` of `cases`, given in that order, with the kernels of that name.
inline Batch batch_of(const std::vector<Case>& cases, const std::vector<int>& order, std::string_view kernels) {
  Batch batch;
  std::size_t given = 0;
  const auto next = [&]() -> std::optional<Setup> {
    if (given == order.size()) return std::nullopt;
    Setup setup = prepare(cases[order[given++]]);
    setup.kernels = &film::kernels(kernels);
    return setup;
  };
  batch.effort = simulate_batch(
      next, [&](BatchOutcome outcome) { batch.outcomes.emplace(order[outcome.index], std::move(outcome)); });
  return batch;
}

/// Is this value an angle, or a count of angles or nodes? These jump where the others move.
inline bool jumps(const CycleQuantity& quantity) {
  return quantity.unit == "degree" || quantity.name == "mean_cavitated_fraction";
}

/// What a difference in a value of `result` is to be measured by: the value itself, but for a part the whole, because a
/// part may vanish: film and asperities share the load, boundary and viscous friction the friction, the strokes the
/// energy, regimes the cycle, and the net flow is what is left of flows to and fro.
inline double fair_scale(const CycleResult& result, const CycleQuantity& quantity) {
  if (is_regime_share(quantity)) return 1;
  const CycleValues& v = result.values;
  const std::string& name = quantity.name;
  if (name.find("_stroke_energy") != std::string::npos) return v.energy_per_cycle;
  if (name == "mean_boundary_power" || name == "mean_viscous_power") return v.mean_power_loss;
  if (name == "mean_boundary_friction" || name == "mean_viscous_friction") return v.mean_total_friction;
  if (name == "peak_boundary_friction" || name == "peak_viscous_friction") return v.peak_total_friction;
  if (name == "net_oil_flow") return v.mean_absolute_oil_flow;
  if (name == "peak_mean_real_pressure") return std::max(v.peak_mean_real_pressure, 1e9);  // 0 without contact
  if (name == "peak_flash_temperature") return std::max(v.peak_flash_temperature, 1.0);    // likewise
  if (name == "archard_wear_load") {  // as if the asperities carried all of the load
    double power = 0;
    for (const Sample& sample : result.samples) power += sample.applied_load * std::abs(sample.piston_velocity);
    const double duration = v.energy_per_cycle / v.mean_power_loss;
    return power / static_cast<double>(result.samples.size()) * duration;
  }
  return std::abs(v.*quantity.value);
}

/// How two results of one engine differ.
struct Difference {
  double largest = 0;     ///< in a value that does not jump, by its fair scale
  std::string value;      ///< which
  int jumps = 0;          ///< angles and counts that are not the same
  bool same_end = false;  ///< both complete, or both stopped at the same angle with the same words
};

inline Difference difference(const CycleResult& a, const std::optional<Stop>& stop_a, const CycleResult& b,
                             const std::optional<Stop>& stop_b) {
  Difference found;
  found.same_end = stop_a.has_value() == stop_b.has_value();
  if (stop_a && stop_b) {
    found.same_end = stop_a->message == stop_b->message && stop_a->crank_angle_deg == stop_b->crank_angle_deg;
  }
  if (stop_a || stop_b) return found;
  for (const CycleQuantity& quantity : cycle_quantities()) {
    const double off = std::abs(a.values.*quantity.value - b.values.*quantity.value);
    if (off == 0) continue;
    if (jumps(quantity)) {
      found.jumps += off > 1e-9;  // one node in a cycle is a share of 1e-5
    } else if (off / fair_scale(a, quantity) > found.largest) {
      found.largest = off / fair_scale(a, quantity);
      found.value = quantity.name;
    }
  }
  return found;
}

/// The same engine without neighbours, by `simulate`.
inline BatchOutcome single(const Case& c) {
  try {
    return {0, simulated(c), std::nullopt};
  } catch (const StoppedCycle& stopped) {
    return {0, stopped.result, Stop{stopped.what(), stopped.crank_angle_deg()}};
  }
}

}  // namespace ringfilm::cycle::testing
