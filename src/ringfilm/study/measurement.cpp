#include "ringfilm/study/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/cycle/closure/static_closure.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/cycle/pack/gas_through_films.hpp"
#include "ringfilm/cycle/pack/oil_consumption.hpp"
#include "ringfilm/cycle/setup/gas_mixture.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"
#include "ringfilm/models/gas/gas_flow.hpp"
#include "ringfilm/pad/solve_pad.hpp"

namespace ringfilm::study {
namespace {

/// What is reported of a whole history of a pad, and of a ring's balance of mass.
const std::vector<cycle::Quantity> kOfWholeRun = {
    {"first_cavity_time", "s", "s", "first instant with a cavity", "t_r", "eq-complementarity"},
    {"full_again_time", "s", "s", "first full instant after the last with a cavity", "t_f", "eq-complementarity"},
    {"largest_front", "m", "mm", "farthest place that a cavity reaches", "x_f", "eq-complementarity"},
    {"largest_mass_residual", "1", "1", "worst balance of mass of a step, relative to the largest flow", "r_m",
     "eq-discrete-balance"},
    {"cycle_mass_residual", "1", "1", "mean inflow less mean outflow over a cycle, relative to the mean flow", "r_c",
     "eq-discrete-balance"},
};

/// Quantities of the gas between the rings.
const std::vector<cycle::Quantity> kOfGas = {
    cycle::gas_sum_quantity("blow_by_per_cycle"),
    {"gas_mass_defect", "1", "1", "balance of the gas over a cycle, relative to what passes", "d_m", "eq-blow-by"},
    {"critical_pressure_ratio", "1", "1", "pressure ratio below which an orifice is choked", "r_c",
     "eq-critical-ratio"},
    {"region_peak_pressure", "Pa", "bar", "highest pressure of a region", "p", "eq-gas-region"},
    {"region_peak_fuel_share", "1", "%", "highest mass share of fuel in a region", "Y", "eq-scalar-balance"},
    cycle::gas_sum_quantity("crankcase_fuel_share"),
    cycle::gas_sum_quantity("composition_defect"),
    {"region_mean_pressure", "Pa", "bar", "mean pressure of a region over the cycle", "p", "eq-gas-region"},
    {"ring_event_angle", "degree", "degree", "crank angle of a change of flank contact", "varphi",
     "eq-ring-acceleration"},
};

/// `rupture_positions.2` and the like.
std::string numbered(const std::string& list, std::size_t i) { return list + "." + std::to_string(i + 1); }

template <typename Quantities, typename Record>
void add_values(const Quantities& quantities, const Record& record, Measurement& measurement) {
  for (const auto& quantity : quantities) measurement.values[quantity.name] = {record.*quantity.value};
}

/// Appends the values of an instant to the lists over all instants.
template <typename Quantities, typename Record>
void append_values(const Quantities& quantities, const Record& record,
                   std::map<std::string, std::vector<double>>& lists) {
  for (const auto& quantity : quantities) lists[quantity.name].push_back(record.*quantity.value);
}

void add_fronts(const pad::PadResult& result, Measurement& measurement) {
  for (const auto& quantity : pad::front_quantities()) {
    std::size_t most = 0;
    for (const pad::Sample& sample : result.samples) most = std::max(most, (sample.*quantity.value).size());
    for (std::size_t i = 0; i < most; ++i) {
      auto& values = measurement.values[numbered(quantity.name, i)];
      for (const pad::Sample& sample : result.samples) {
        const auto& places = sample.*quantity.value;
        values.push_back(i < places.size() ? places[i] : std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
}

void add_events(const pad::PadResult& result, Measurement& measurement) {
  bool was_cavitated = false;
  double farthest = -std::numeric_limits<double>::infinity(), worst = 0;
  for (const pad::Sample& sample : result.samples) {
    const bool cavitated = !sample.rupture_positions.empty();
    if (cavitated) measurement.values.try_emplace("first_cavity_time", std::vector{sample.time});
    if (was_cavitated && !cavitated) measurement.values["full_again_time"] = {sample.time};
    for (const double place : sample.reformation_positions) {
      if (place <= farthest) continue;
      farthest = place;
      measurement.values["largest_front"] = {place};
    }
    worst = std::max(worst, std::abs(sample.mass_residual));
    was_cavitated = cavitated;
  }
  measurement.values["largest_mass_residual"] = {worst};
}

Measurement of_pad(const pad::PadResult& result) {
  Measurement measurement;
  const std::vector<pad::PadQuantity> reported = pad::reported_quantities(result);
  for (const pad::Sample& sample : result.samples) {
    measurement.instants.push_back(sample.time);
    append_values(reported, sample, measurement.values);
  }
  add_fronts(result, measurement);
  add_events(result, measurement);
  return measurement;
}

Measurement of_ring(const cycle::CycleResult& result) {
  Measurement measurement;
  double difference = 0, size = 0;
  for (const cycle::Sample& sample : result.samples) {
    measurement.instants.push_back(sample.crank_angle_deg);
    append_values(cycle::curve_quantities(), sample, measurement.curves);
    difference += sample.oil_flow_chamber_edge - sample.oil_flow_crankcase_edge;
    size += std::abs(sample.oil_flow_middle);
  }
  for (const cycle::UnrolledSample& sample : result.unrolled_samples) {
    append_values(cycle::unrolled_quantities(), sample, measurement.curves);
  }
  add_values(cycle::cycle_quantities(), result.values, measurement);
  if (!result.unrolled_samples.empty()) {
    add_values(cycle::unrolled_cycle_quantities(), result.unrolled_values, measurement);
  }
  measurement.values["cycle_mass_residual"] = {std::abs(difference) / size};
  measurement.values["largest_mass_residual"] = {result.effort.max_mass_residual};
  return measurement;
}

/// Of a ring whose oil on the liner is followed.
void add_oil_losses(const cycle::CaseWithGas& found, const cycle::CycleResult& result, Measurement& measurement) {
  const cycle::CycleResult* const rings[] = {&result};
  const std::vector<cycle::OilLoss> losses = cycle::oil_losses(found.input, rings, found.gas);
  for (const cycle::OilLossQuantity& quantity : cycle::oil_loss_quantities()) {
    const auto loss = std::ranges::find(losses, quantity.loss, &cycle::OilLoss::name);
    if (loss != losses.end()) measurement.values[quantity.name] = {(*loss).*quantity.member};
  }
}

Measurement of_gas(const cycle::Case& c) {
  const gas_path::GasPathResult result = gas_path::solve_gas_path(cycle::gas_pack(c), cycle::given_pressures(c));
  Measurement measurement;
  auto& values = measurement.values;
  values["blow_by_per_cycle"] = {result.blow_by};
  values["gas_mass_defect"] = {result.mass_defect};
  values["critical_pressure_ratio"] = {models::critical_pressure_ratio(cycle::gas_properties(c).heat_capacity_ratio)};
  for (std::size_t i = 0; i < result.regions.size(); ++i) {
    values[numbered("region_peak_pressure", i)] = {result.regions[i].peak_pressure};
    values[numbered("region_mean_pressure", i)] = {result.regions[i].mean_pressure};
  }
  if (result.composition) {
    const gas_path::CompositionResult& composition = *result.composition;
    values["crankcase_fuel_share"] = {composition.scalars[gas_path::kFuelScalar].crankcase_mole_share};
    values["composition_defect"] = {composition.defect};
    const std::size_t n = composition.scalars.size(), n_regions = result.regions.size();
    for (std::size_t region = 0; region < n_regions; ++region) {
      double peak = 0;
      for (std::size_t row = region; row * n < composition.share.size(); row += n_regions) {
        peak = std::max(peak, composition.share[row * n + gas_path::kFuelScalar]);
      }
      values[numbered("region_peak_fuel_share", region)] = {peak};
    }
  }
  for (std::size_t i = 0; i < result.events.size(); ++i) {
    values[numbered("ring_event_angle", i)] = {result.events[i].crank_angle_deg};
  }
  return measurement;
}

Measurement of_closure(const cycle::StaticClosure& closure) {
  Measurement measurement;
  add_values(cycle::closure_quantities(), closure.values, measurement);
  std::vector<double> edges;
  for (const models::ContactArc& arc : closure.ring.arcs()) {
    for (const double edge : {arc.from, arc.to}) edges.push_back(edge * 180 / std::numbers::pi);
  }
  for (std::size_t i = 0; i < edges.size(); ++i) measurement.values[numbered("arc_edges", i)] = {edges[i]};
  for (const cycle::SectionQuantity& one : cycle::section_quantities()) {
    const auto value = closure.section ? one.value(*closure.section) : std::nullopt;
    if (value) measurement.values[one.name] = {*value};
  }
  return measurement;
}

template <typename Quantities>
std::optional<cycle::Quantity> found_in(const Quantities& quantities, const std::string& name) {
  const cycle::Quantity* found = find_by_name(quantities, name);
  return found ? std::optional(*found) : std::nullopt;
}

template <typename Quantities>
void add_all(const Quantities& quantities, std::vector<cycle::Quantity>& all) {
  for (const cycle::Quantity& quantity : quantities) all.push_back(quantity);
}

}  // namespace

const std::vector<cycle::Quantity>& measured_quantities() {
  static const std::vector<cycle::Quantity> table = [] {
    std::vector<cycle::Quantity> all;
    add_all(pad::pad_quantities(), all);
    add_all(pad::width_quantities(), all);
    add_all(pad::front_quantities(), all);
    add_all(kOfWholeRun, all);
    add_all(kOfGas, all);
    add_all(cycle::closure_quantities(), all);
    add_all(cycle::section_quantities(), all);
    all.push_back({"arc_edges", "degree", "degree", "edge of a contact arc, from the middle of the gap", "phi_e",
                   "eq-closure-complementarity"});
    add_all(cycle::cycle_quantities(), all);
    add_all(cycle::curve_quantities(), all);
    add_all(cycle::oil_loss_quantities(), all);
    add_all(cycle::unrolled_cycle_quantities(), all);
    add_all(cycle::unrolled_quantities(), all);
    return all;
  }();
  return table;
}

std::optional<cycle::Quantity> find_measured(const std::string& name) {
  return found_in(measured_quantities(), name.substr(0, name.find('.')));
}

bool is_of_gas(const std::string& name) { return find_by_name(kOfGas, name.substr(0, name.find('.'))) != nullptr; }

std::optional<cycle::Quantity> find_curve(const std::string& name) {
  const auto of_cycle = found_in(cycle::curve_quantities(), name);
  return of_cycle ? of_cycle : found_in(cycle::unrolled_quantities(), name);
}

Measurement measure(const cycle::Case& c) {
  if (c.problem == cycle::Problem::kPad) return of_pad(pad::solve_pad(c));
  if (c.problem == cycle::Problem::kClosure) return of_closure(cycle::static_closure(c));
  if (c.purpose == cycle::CasePurpose::kGasPath) return of_gas(c);
  const cycle::CaseWithGas found = cycle::solve_gas_through_films(c);
  const cycle::CycleResult result = cycle::simulate(cycle::prepare(found.input));
  Measurement measurement = of_ring(result);
  add_oil_losses(found, result, measurement);
  return measurement;
}

double value(const Measurement& measurement, const Probe& probe) {
  const auto found = measurement.values.find(probe.quantity);
  if (found == measurement.values.end()) return std::numeric_limits<double>::quiet_NaN();
  const std::vector<double>& values = found->second;
  if (!probe.time || values.size() == 1) return values.back();
  // Steps in time add up rounding: the instant asked for is the nearest.
  constexpr double kHalf = 0.5 + 1e-6;  // an instant in the middle of a step is near to both its ends
  const std::vector<double>& instants = measurement.instants;
  const auto distance = [&](std::size_t i) { return std::abs(instants[i] - *probe.time); };
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < values.size(); ++k) {
    if (distance(k) < distance(nearest)) nearest = k;
  }
  const std::size_t after = std::max<std::size_t>(nearest, 1);
  const bool is_near = distance(nearest) <= kHalf * (instants[after] - instants[after - 1]);
  return is_near ? values[nearest] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ringfilm::study
