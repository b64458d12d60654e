#include "ringfilm/case/keys/case_fields.hpp"

#include <algorithm>

#include "ringfilm/case/keys/case_fields_table.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"

namespace ringfilm::cycle {
namespace {

using namespace table;

std::vector<Field> all_fields() {
  std::vector<Field> fields{
      field({.key = "title",
             .kind = TextKind{member<&Case::title>},
             .need = Need::kRequiredInCycle,
             .help = "what this case is, for people",
             .example = "\"My engine, compression ring\"",
             .uses = {.pad = true, .closure = true, .gas = true},
             .is_for_record = true}),
      field({.key = "conditions",
             .kind = choice<&Case::conditions>({{"of-the-case", Conditions::kOfTheCase},
                                                {"as-in-the-paper", Conditions::kAsInPaper},
                                                {"engine", Conditions::kEngine},
                                                {"hot-engine", Conditions::kHotEngine}}),
             .help =
                 "edges, supply of oil and temperatures that the case starts from: those of its keys alone, oil at the "
                 "edges and one temperature, or gas at the edges, oil on the liner and walls as measured at full load, "
                 "or hotter ones; keys that are stated replace them",
             .example = "\"engine\""}),
      field({.key = "engine.bore",
             .kind = NumberKind{member<&Case::engine, &Engine::bore>},
             .unit = kMillimetre,
             .range = above(0, 2),
             .need = Need::kRequired,
             .help = "bore of the cylinder, B",
             .example = "\"89.0 mm\"",
             .uses = {.closure = true, .gas = true}}),
      field({.key = "engine.stroke",
             .kind = NumberKind{member<&Case::engine, &Engine::stroke>},
             .unit = kMillimetre,
             .range = above(0, 5),
             .need = Need::kRequired,
             .help = "stroke, twice the crank radius r",
             .example = "\"79.5 mm\"",
             .uses = {.gas = true}}),
      field({.key = "engine.connecting_rod_length",
             .kind = NumberKind{member<&Case::engine, &Engine::connecting_rod_length>},
             .unit = kMillimetre,
             .range = above(0, 10),
             .need = Need::kRequired,
             .help = "connecting rod between the centres of its bearings, l",
             .example = "\"138.1 mm\"",
             .uses = {.gas = true}}),
      field({.key = "engine.cylinders",
             .kind = OptionalNumberKind{member<&Case::engine, &Engine::cylinders>},
             .unit = kPlainNumber,
             .range = between(1, 100),
             .need = Need::kOptional,
             .help = "number of cylinders, for the blow-by and the oil consumption of the engine",
             .example = "4",
             .uses = {.gas = true}}),
      field({.key = "operating.speed",
             .kind = NumberKind{member<&Case::operating, &Operating::speed>},
             .unit = kRpm,
             .range = above(0, 2094.39510239320),
             .need = Need::kRequired,
             .help = "speed of the crankshaft, omega",
             .example = "\"1500 rpm\"",
             .uses = {.gas = true}}),
      field(
          {.key = "operating.oil_temperature",
           .kind = NumberKind{member<&Case::operating, &Operating::oil_temperature>},
           .unit = kCelsius,
           .range = strictly_between(models::kColdestOil, models::kHottestOil),
           .need = Need::kRequired,
           .when = {[](const Case& c) { return !c.thermal.is_stated(); }, "no thermal.ring or thermal.liner is stated"},
           .help = "temperature of the oil film, T; one value for the whole stroke",
           .example = "\"120 degC\""}),
      field({.key = "operating.brake_power",
             .kind = OptionalNumberKind{member<&Case::operating, &Operating::brake_power>},
             .unit = kKilowatt,
             .range = above(0, 1e8),
             .need = Need::kOptional,
             .when = kOilFollowed,
             .help = "brake power of the engine, for its oil consumption in g/kWh",
             .example = "\"25 kW\""}),
      field({.key = "operating.fuel_rate",
             .kind = OptionalNumberKind{member<&Case::operating, &Operating::fuel_rate>},
             .unit = kKilogramPerHour,
             .range = above(0, 1e3),
             .need = Need::kOptional,
             .when = kOilFollowed,
             .help = "fuel that the engine burns, for its oil consumption as a share of it",
             .example = "\"6.5 kg/h\""}),
  };
  append_thermal_fields(fields);
  append_gas_fields(fields);
  append_gas_composition_fields(fields);
  append_ring_fields(fields);
  std::vector<Field> of_section;
  append_section_fields(of_section);
  const auto is_first_of_face = [](const Field& one) { return one.key == "ring.face.form"; };
  fields.insert(std::find_if(fields.begin(), fields.end(), is_first_of_face), of_section.begin(), of_section.end());
  append_gas_path_fields(fields);
  append_contact_fields(fields);
  append_measured_fields(fields);
  append_lubricant_fields(fields);
  append_oil_consumption_fields(fields);
  append_run_fields(fields);
  append_pad_fields(fields);
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
  return RingKey{ring, may_be_of_ring(rest) ? rest : section + rest};
}

std::string pack_key(std::size_t ring, const std::string& key) {
  if (!is_of_ring(key)) return key;
  const std::string rest = key.rfind("ring.", 0) == 0 ? key.substr(5) : key;
  return "ring." + std::to_string(ring) + "." + rest;
}

bool is_implied_in_pack(std::size_t ring, const std::string& key) { return ring > 1 && key == "ring.pressure_above"; }

bool may_be_of_ring(const std::string& key) { return key.starts_with("contact.") || key.starts_with("film.land_"); }

bool is_of_ring(const std::string& key) { return key.starts_with("ring.") || may_be_of_ring(key); }

bool belongs(const Field& field, const Case& c) {
  switch (c.problem) {
    case Problem::kCycle:
      return field.uses.cycle;
    case Problem::kPad:
      return field.uses.pad;
    case Problem::kClosure:
      break;
  }
  return field.uses.closure;
}

bool is_active(const Field& field, const Case& c) {
  return belongs(field, c) && (field.active == nullptr || field.active(c));
}

bool is_required(const Field& field, const Case& c) {
  return field.need == Need::kRequired || (field.need == Need::kRequiredInCycle && c.problem == Problem::kCycle);
}

}  // namespace ringfilm::cycle
