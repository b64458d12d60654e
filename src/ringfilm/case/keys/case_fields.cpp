#include "ringfilm/case/keys/case_fields.hpp"

#include <algorithm>
#include <set>

#include "ringfilm/case/keys/case_fields_table.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"

namespace ringfilm::cycle {
namespace {

using namespace table;

/// Is it the key of a number that laws of viscosity take?
bool is_law_parameter(const std::string& key) {
  const auto parameters = models::law_parameters();
  return std::any_of(parameters.begin(), parameters.end(),
                     [&](const models::LawParameter& parameter) { return key == "lubricant." + parameter.key; });
}

/// Keys of a ring's case that a pad has as well; of the others `pad` and the pad's viscosity are its own.
std::optional<Problem> problem_of(const std::string& key) {
  static const std::set<std::string> shared = {"title",
                                               "lubricant.name",
                                               "lubricant.density",
                                               "lubricant.viscosity_pressure",
                                               "lubricant.compressibility",
                                               "lubricant.dh_a",
                                               "lubricant.dh_b",
                                               "film.cavitation",
                                               "lubricant.shear_thinning",
                                               "lubricant.second_newtonian_ratio",
                                               "lubricant.critical_shear_rate",
                                               "lubricant.shear_exponent",
                                               "lubricant.critical_shear_rate_temperature",
                                               "lubricant.hths_viscosity",
                                               "lubricant.file",
                                               "lubricant.grade",
                                               "lubricant.kinematic_viscosity",
                                               "lubricant.viscosity_temperature",
                                               "lubricant.temperature_viscosity_coefficient",
                                               "lubricant.reference_temperature",
                                               "lubricant.density_temperature",
                                               "lubricant.thermal_expansivity",
                                               "lubricant.thermal_conductivity",
                                               "lubricant.specific_heat",
                                               "thermal.ring",
                                               "thermal.liner",
                                               "thermal.film",
                                               "contact.model",
                                               "contact.asperity_density",
                                               "contact.asperity_radius",
                                               "contact.roughness",
                                               "contact.ring_roughness_share",
                                               "contact.roughness_measure",
                                               "contact.boundary_shear_strength_coefficient",
                                               "contact.eyring_shear_stress",
                                               "contact.composite_modulus",
                                               "contact.integrals",
                                               "contact.lambda_ratio",
                                               "film.flow_factors",
                                               "film.shear_flow",
                                               "film.stress_factors",
                                               "film.average_gap",
                                               "film.orientation",
                                               "film.cavitation_pressure",
                                               "solver.cells",
                                               "solver.cells_y",
                                               "solver.tolerance"};
  if (shared.contains(key) || is_law_parameter(key)) return std::nullopt;
  static const std::set<std::string> of_pad = {"lubricant.viscosity", "film.left_edge", "film.right_edge",
                                               "film.supply_left", "film.supply_right"};
  return key.rfind("pad.", 0) == 0 || of_pad.contains(key) ? Problem::kPad : Problem::kCycle;
}

/// Keys of a ring's case that its static closure uses.
bool is_of_closure(const std::string& key) {
  static const std::set<std::string> keys = {
      "title",
      "engine.bore",
      "ring.name",
      "ring.face_width",
      "ring.free_gap",
      "ring.free_shape",
      "ring.free_shape_smoothing",
      "ring.youngs_modulus",
      "ring.end_gap",
      "ring.elastic_pressure",
      "ring.gap_position",
      "ring.tangential_force",
      "ring.pressure_orders",
      "ring.pressure_points",
      "ring.pressure_points_orders",
      "ring.radial_thickness",
  };
  return keys.contains(key) || key.rfind("liner.distortion", 0) == 0 || key == "liner.thermal_distortion" ||
         key.rfind("conform.", 0) == 0;
}

std::vector<Field> all_fields() {
  std::vector<Field> fields{
      field("title", TextKind{member<&Case::title>}, kNoUnit, {}, Need::kRequiredInCycle, {},
            {"what this case is, for people", "\"My engine, compression ring\""}),
      field("conditions", choice<&Case::conditions>({"of-the-case", "as-in-the-paper", "engine"}), kNoUnit, {},
            Need::kDefault, {},
            {"edges, supply of oil and temperatures that the case starts from: those of its keys alone, oil at the "
             "edges and one temperature, or gas at the edges, oil on the liner and hot walls; keys that are stated "
             "replace them",
             "\"engine\""}),
      field("engine.bore", NumberKind{member<&Case::engine, &Engine::bore>}, {"m", "mm"}, above(0, 2), Need::kRequired,
            {}, {"bore of the cylinder, B", "\"89.0 mm\""}),
      field("engine.stroke", NumberKind{member<&Case::engine, &Engine::stroke>}, {"m", "mm"}, above(0, 5),
            Need::kRequired, {}, {"stroke, twice the crank radius r", "\"79.5 mm\""}),
      field("engine.connecting_rod_length", NumberKind{member<&Case::engine, &Engine::connecting_rod_length>},
            {"m", "mm"}, above(0, 10), Need::kRequired, {},
            {"connecting rod between the centres of its bearings, l", "\"138.1 mm\""}),
      field("operating.speed", NumberKind{member<&Case::operating, &Operating::speed>}, {"rad/s", "rpm"},
            above(0, 2094.39510239320), Need::kRequired, {}, {"speed of the crankshaft, omega", "\"1500 rpm\""}),
      field("operating.oil_temperature", NumberKind{member<&Case::operating, &Operating::oil_temperature>},
            {"K", "degC"}, strictly_between(models::kColdestOil, models::kHottestOil), Need::kRequired,
            {[](const Case& c) { return !c.thermal.is_stated(); }, "no thermal.ring or thermal.liner is stated"},
            {"temperature of the oil film, T; one value for the whole stroke", "\"120 degC\""}),
  };
  append_thermal_fields(fields);
  append_gas_fields(fields);
  append_ring_fields(fields);
  append_gas_path_fields(fields);
  append_contact_fields(fields);
  append_measured_fields(fields);
  append_lubricant_fields(fields);
  append_run_fields(fields);
  append_pad_fields(fields);
  for (Field& field : fields) field.problem = problem_of(field.key);
  return fields;
}

}  // namespace

const std::vector<Field>& case_fields() {
  static const std::vector<Field> fields = all_fields();
  return fields;
}

const Field* find_field(const std::string& key) {
  for (const Field& field : case_fields()) {
    if (field.key == key) return &field;
  }
  return nullptr;
}

std::optional<RingKey> ring_key(const std::string& key) {
  const std::string section = "ring.";
  if (key.rfind(section, 0) != 0) return std::nullopt;
  std::size_t at = section.size(), ring = 0;
  for (; at < key.size() && key[at] >= '0' && key[at] <= '9' && at < section.size() + 3; ++at) {
    ring = 10 * ring + static_cast<std::size_t>(key[at] - '0');
  }
  if (at == section.size() || at + 1 >= key.size() || key[at] != '.' || ring == 0) return std::nullopt;
  const std::string rest = key.substr(at + 1);
  return RingKey{ring, rest.rfind("contact.", 0) == 0 ? rest : section + rest};
}

std::string pack_key(std::size_t ring, const std::string& key) {
  if (!is_of_ring(key)) return key;
  const std::string rest = key.rfind("ring.", 0) == 0 ? key.substr(5) : key;
  return "ring." + std::to_string(ring) + "." + rest;
}

bool is_implied_in_pack(std::size_t ring, const std::string& key) { return ring > 1 && key == "ring.pressure_above"; }

bool is_of_ring(const std::string& key) { return key.rfind("ring.", 0) == 0 || key.rfind("contact.", 0) == 0; }

bool belongs(const Field& field, const Case& c) {
  if (c.problem == Problem::kClosure) return is_of_closure(field.key);
  return !field.problem || *field.problem == c.problem;
}

bool is_active(const Field& field, const Case& c) {
  return belongs(field, c) && (field.active == nullptr || field.active(c));
}

bool is_for_record(const Field& field) {
  static const std::set<std::string> alone = {"title", "lubricant.name", "gas.trace_origin", "ring.name"};
  return alone.contains(field.key) || field.key.rfind("output.", 0) == 0 ||
         field.key.find(".measured.") != std::string::npos;
}

bool is_of_gas_path(const Field& field) {
  static const std::set<std::string> others = {"title",
                                               "operating.speed",
                                               "ring.kind",
                                               "ring.gap_area",
                                               "ring.end_gap",
                                               "ring.volume_below",
                                               "ring.mass",
                                               "ring.temperature_below",
                                               "ring.density",
                                               "ring.groove_volume",
                                               "ring.face_width",
                                               "ring.groove_temperature",
                                               "ring.free_gap",
                                               "ring.free_shape",
                                               "ring.free_shape_smoothing",
                                               "ring.side_clearance",
                                               "ring.name",
                                               "ring.land_clearance",
                                               "ring.pressure_above",
                                               "ring.elastic_pressure",
                                               "ring.pressure_below",
                                               "ring.tangential_force",
                                               "ring.radial_thickness",
                                               "ring.youngs_modulus",
                                               "ring.bore_friction_coefficient"};
  const auto lies_in = [&](const char* section) { return field.key.rfind(section, 0) == 0; };
  if (field.key == "gas.pressure_behind_ring" || field.key == "gas_path.film") return false;  // of gas with films
  return lies_in("engine.") || lies_in("gas.") || lies_in("gas_path.") || others.contains(field.key);
}

bool is_required(const Field& field, const Case& c) {
  return field.need == Need::kRequired || (field.need == Need::kRequiredInCycle && c.problem == Problem::kCycle);
}

}  // namespace ringfilm::cycle
