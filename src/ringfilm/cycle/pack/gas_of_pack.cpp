#include "ringfilm/cycle/pack/gas_of_pack.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/advice/gas_plausibility.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/setup/charge.hpp"
#include "ringfilm/cycle/setup/gas_mixture.hpp"
#include "ringfilm/cycle/setup/land_pressure.hpp"
#include "ringfilm/cycle/setup/ring_section.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"

namespace ringfilm::cycle {
namespace {

/// Force off its lower flank from where a ring that the case keeps there has a note (assumed): the inertia of a light
/// ring makes 10 N at 1500 rpm, over half of the cycle [N].
constexpr double kLargeLift = 50;

/// Below that the straight line of an orifice is as steep as a step to the integration [-].
constexpr double kMinSmoothing = 1e-6;

double ring_mass(const Case& c) {
  const RingGasPath& gas = c.ring.gas_path;
  if (gas.mass) return *gas.mass;
  if (c.ring.section.is_stated()) return section_mass(c);
  const double t = c.ring.radial_thickness.value();
  return gas.density.value() * c.ring.face_width * t * std::numbers::pi * (c.engine.bore - t);
}

bool has_mass(const Case& c) {
  const RingGasPath& gas = c.ring.gas_path;
  return gas.mass || (gas.density && c.ring.face_width > 0);
}

bool has_tension(const Ring& ring) {
  return ring.face_width > 0 && (ring.elastic_pressure || ring.tangential_force || ring.free_gap || ring.free_shape);
}

gas_path::Ring gas_ring(const Case& c) {
  const Ring& ring = c.ring;
  const RingGasPath& gas = ring.gas_path;
  gas_path::Ring of;
  of.kind = gas.kind;
  of.gap_area = gas.gap_area ? *gas.gap_area : ring.end_gap.value() * gas.land_clearance.value();
  of.volume_below = gas.volume_below;
  of.temperature_below = gas.temperature_below;
  of.face_opening = gas.face_opening;
  of.face_width = ring.face_width;
  if (of.kind == RingKind::kOil) return of;
  of.groove_volume = gas.groove_volume.value();
  of.groove_temperature = gas.groove_temperature;
  of.side_clearance = side_clearance(ring).value();
  of.land_clearance = gas.land_clearance.value();
  of.radial_thickness = ring.thickness().value();
  if (ring.section.is_stated()) of.section = twisting_ring(c);
  of.youngs_modulus = ring.youngs_modulus;
  // A seated ring may lack what moves it.
  const bool moves = c.gas_path.ring_motion == RingMotion::kAxial;
  if (moves || has_mass(c)) of.mass = ring_mass(c);
  if (moves || has_tension(ring)) {
    of.elastic_pressure = elastic_pressure(c);
    of.bore_friction_coefficient = gas.bore_friction_coefficient;
    of.collapse = radial_collapse(c);
  }
  return of;
}

/// Distance of the end gaps of two rings around the bore, the shorter way; nothing where a case does not state both
/// positions [m].
std::optional<double> gap_distance(const Case& one, const Case& other) {
  const auto states = [](const Case& c) { return c.stated.contains("ring.gap_position"); };
  if (!states(one) || !states(other)) return std::nullopt;
  const double turn_deg = std::abs(std::remainder(one.ring.gap_position_deg - other.ring.gap_position_deg, 360.0));
  return 0.5 * one.engine.bore * turn_deg * std::numbers::pi / 180;
}

/// End gaps that lie below one another pass more gas than through a piston land at rest, eq-gap-carry-over. Where no
/// piston land is between two rings, nothing is changed.
void recover_velocity_heads(const Case& pack, std::vector<gas_path::Ring>& rings) {
  const GasPath& path = pack.gas_path;
  double area_above = rings.front().gap_area;
  for (std::size_t i = 1; i < rings.size(); ++i) {
    const double area = rings[i].gap_area;
    const std::optional<double> distance = gap_distance(pack.rings[i - 1], pack.rings[i]);
    if (distance && *distance < path.gap_reach && rings[i - 1].volume_below > 0 && area_above > 0) {
      const double share = path.gap_carry_over * (1 - *distance / path.gap_reach);
      rings[i].gap_area = area / std::sqrt(1 - share * std::pow(std::min(area / area_above, 1.0), 2));
    }
    area_above = area;
  }
}

/// The pressure that a case states next to a ring, or another one.
models::CyclePressure stated_or(const Case& c, const LandPressure& land, const models::CyclePressure& other) {
  return land.is_stated() ? land_pressure(c, land) : other;
}

/// The pressure of a region, degree by degree.
base::Shared<SampledTrace> region_trace(const gas_path::GasPathResult& result, std::size_t region) {
  SampledTrace trace;
  for (std::size_t k = 0; k < result.pressure.size(); ++k) {
    trace.crank_angle_deg.push_back(static_cast<double>(k));
    trace.value.push_back(result.pressure[k][region]);
  }
  return trace;
}

std::string joined_numbers(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (const std::size_t number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
  return text;
}

}  // namespace

gas_path::Pack gas_pack(const Case& c) {
  const GasPath& path = c.gas_path;
  gas_path::Pack pack;
  pack.bore = c.engine.bore;
  pack.crank = crank_slider(c);
  pack.speed = c.operating.speed;
  pack.chamber = cylinder_pressure(c);
  pack.crankcase = crankcase_pressure(c);
  if (!path.is_computed()) {
    const Case &first = c.is_pack() ? c.rings.front() : c, &last = c.is_pack() ? c.rings.back() : c;
    pack.chamber = stated_or(first, first.ring.pressure_above, pack.chamber);
    pack.crankcase = stated_or(last, last.ring.pressure_below, pack.crankcase);
  }
  pack.chamber_temperature = path.chamber_temperature;
  pack.crankcase_temperature = path.crankcase_temperature;
  const models::MixtureProperties gas = gas_properties(c);
  pack.gas = {gas.gas_constant, gas.heat_capacity_ratio, gas.viscosity, path.discharge_coefficient,
              std::max(path.choking_smoothing, kMinSmoothing)};
  if (c.gas.composition.is_stated()) pack.composition = gas_composition(c);
  pack.ring_motion = path.ring_motion;
  pack.sliding_smoothing_speed = path.sliding_smoothing_speed;
  pack.trapped_mass = Charge(c).mass();
  if (!c.is_pack()) pack.rings.push_back(gas_ring(c));
  for (const Case& ring : c.rings) pack.rings.push_back(gas_ring(ring));
  if (c.is_pack()) recover_velocity_heads(c, pack.rings);
  return pack;
}

/// Chamber and crankcase stay those of the case.
void put_gas_pressures(Ring& ring, const gas_path::Pack& pack, const gas_path::GasPathResult& result,
                       std::size_t index) {
  const gas_path::Network network(pack);
  const gas_path::RingBorders& at = network.borders(index);
  if (at.above > 0) ring.pressure_above.computed = region_trace(result, at.above);
  if (at.below + 1 < result.regions.size()) ring.pressure_below.computed = region_trace(result, at.below);
  if (network.has_groove(index)) ring.pressure_behind = region_trace(result, at.groove);
  ring.gas_path.computed_temperature_above = network.regions()[at.above].temperature;
  ring.gas_path.computed_temperature_below = network.regions()[at.below].temperature;
  ring.has_computed_gas = true;
}

gas_path::GivenPressures given_pressures(const Case& c) {
  gas_path::GivenPressures below;
  if (c.gas_path.is_computed()) return below;
  for (const Case& ring : c.rings) {
    const LandPressure& stated = ring.ring.pressure_below;
    below.push_back(stated.is_stated() ? std::optional(land_pressure(ring, stated)) : std::nullopt);
  }
  return below;
}

CaseWithGas solve_gas_of_case(Case c) {
  if (c.problem == Problem::kPad || !c.gas_path.is_computed()) return {std::move(c), std::nullopt};
  put_gas_properties(c);
  const gas_path::Pack pack = gas_pack(c);
  gas_path::GasPathResult result = gas_path::solve_gas_path(pack);
  put_gas_pressures(c.ring, pack, result, 0);
  for (std::size_t i = 0; i < c.rings.size(); ++i) put_gas_pressures(c.rings[i].ring, pack, result, i);
  std::vector<std::string>& notes = c.is_pack() ? c.rings.front().notes : c.notes;
  notes.push_back("the gas between the rings is computed: blow-by per cylinder " + text_in(result.blow_by, kMilligram) +
                  " per cycle, " + text_in(volume_flow(result, pack.gas.gas_constant), kLitrePerMinute) +
                  " at 1.01325 bar and 25 degC");
  for (const Note& note : gas_path_notes(c, pack, result)) {
    const bool is_of_trace =
        note.topic == kSyntheticTrace || (note.topic.rfind("gas-", 0) == 0 && note.topic != "gas-path-not-periodic");
    if (!is_of_trace) notes.push_back(note.message);
  }
  return {std::move(c), std::move(result)};
}

Case with_gas_path(Case c) { return solve_gas_of_case(std::move(c)).input; }

namespace {

/// What acts on a ring along the bore, with its verb.
std::string pressing(const gas_path::Ring& ring) {
  const bool has_inertia = ring.mass > 0, rubs = ring.bore_friction_coefficient > 0;
  if (!has_inertia && !rubs) return "gas (ring.mass is not stated) presses it";
  return std::string(has_inertia && rubs ? "gas, inertia and friction"
                     : has_inertia       ? "gas and inertia"
                                         : "gas and friction") +
         " press it";
}

}  // namespace

std::vector<Note> ring_motion_notes(const Case& c, const gas_path::Pack& pack, const gas_path::GasPathResult& result) {
  std::vector<Note> notes;
  std::vector<std::size_t> fluttering;
  for (std::size_t i = 0; i < result.motion.size(); ++i) {
    if (result.motion[i].flutters) fluttering.push_back(i + 1);
  }
  if (!fluttering.empty()) {
    notes.push_back({"ring-flutter",
                     "a ring leaves its lower flank more than once in a stroke: ring " + joined_numbers(fluttering),
                     static_cast<int>(fluttering.size())});
  }
  for (std::size_t i = 0; i < result.motion.size() && c.gas_path.ring_motion == RingMotion::kSeated; ++i) {
    const gas_path::RingMotionValues& ring = result.motion[i];
    if (!ring.has_groove || ring.least_seating_force > -kLargeLift) continue;
    notes.push_back({"ring-unseated",
                     "ring " + std::to_string(i + 1) + " is kept on its lower flank, off which " +
                         pressing(pack.rings[i]) + " over " + std::to_string(std::lround(100 * ring.unseated_share)) +
                         " % of the cycle, with up to " + number_text(std::round(-ring.least_seating_force)) +
                         " N (at " + number_text(ring.least_seating_force_angle_deg) +
                         " degree): gas_path.ring_motion = \"axial\" computes when it leaves, and the blow-by then",
                     1});
  }
  return notes;
}

namespace {

/// Lower flammability limit in air at 25 degC and atmospheric pressure, zabetakis1965: mole share [-].
double flammability_limit(Fuel fuel) {
  switch (fuel) {
    case Fuel::kHydrogen:
      return 0.04;
    case Fuel::kMethane:
      return 0.05;
    case Fuel::kGasoline:
      return 0.013;
    default:
      return 1;  // diesel fuel has no such vapour at the temperatures of a crankcase
  }
}

/// Notes on water that may condense and on fuel in the crankcase.
void append_composition_notes(const gas_path::Pack& pack, const gas_path::GasPathResult& result,
                              std::vector<Note>& notes) {
  if (!result.composition) return;
  std::string where;
  for (const gas_path::RegionValues& region : result.regions) {
    if (region.condensing_share.value_or(0) == 0) continue;
    where += (where.empty() ? "" : ", ") + region.name + " (dew point up to " +
             text_in(*region.peak_dew_point, kCelsius, 3) + ", wall " + text_in(*region.wall_temperature, kCelsius, 3) +
             ")";
  }
  if (!where.empty()) {
    notes.push_back({"water-condenses",
                     "water of the gas can condense on the walls of " + where +
                         ": it is reported alone, no water is taken from the gas and none is added to the oil",
                     1});
  }
  const double fuel = result.composition->scalars[gas_path::kFuelScalar].crankcase_mole_share;
  const double limit = flammability_limit(pack.composition->fuel);
  if (fuel < limit) return;
  notes.push_back({"crankcase-flammable",
                   std::string(models::fuel_name(pack.composition->fuel)) + " makes " + number_text(100 * fuel, 3) +
                       " % of the gas in the crankcase by volume, its lower flammability "
                       "limit in air is " +
                       number_text(100 * limit, 3) + " %: gas.composition.crankcase_air states the ventilation",
                   1});
}

}  // namespace

std::vector<Note> gas_path_notes(const Case& c, const gas_path::Pack& pack, const gas_path::GasPathResult& result) {
  std::vector<Note> notes;
  append_gas_notes(c, pack.chamber, notes);
  append_origin_note(c, notes);
  const auto is_oil_ring = [](const gas_path::Ring& ring) { return ring.kind == RingKind::kOil; };
  if (std::none_of(pack.rings.begin(), pack.rings.end(), is_oil_ring)) {
    notes.push_back({"oil-ring-missing", "the pack has no oil ring: the crankcase is below its last ring", 1});
  }
  for (Note& note : ring_motion_notes(c, pack, result)) notes.push_back(std::move(note));
  append_composition_notes(pack, result, notes);
  if (!result.repeats) {
    const std::string when =
        result.period > 0 ? "it repeats every " + std::to_string(result.period) +
                                " cycles: blow-by is their mean, curves are those of the last"
                          : "after " + std::to_string(result.cycles) + " cycles a pressure changes by a share of " +
                                number_text(result.periodicity) + ", and no period of several cycles is found";
    notes.push_back(
        {"gas-path-not-periodic", "the gas between the rings does not repeat from cycle to cycle: " + when, 1});
  }
  sort_notes(notes);
  return notes;
}

}  // namespace ringfilm::cycle
