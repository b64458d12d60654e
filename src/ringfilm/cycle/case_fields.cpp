#include "ringfilm/cycle/case_fields.hpp"

#include "ringfilm/cycle/case_fields_table.hpp"

namespace ringfilm::cycle {
namespace {

using namespace table;

std::vector<Field> all_fields() {
  std::vector<Field> fields{
      field("title", TextKind{member<&Case::title>}, kNoUnit, {}, Need::kRequired, {},
            {"what this case is, for people", "\"My engine, compression ring\""}),
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
            {"K", "degC"}, strictly_between(200, 600), Need::kRequired, {},
            {"temperature of the oil film, T; one value for the whole stroke", "\"120 degC\""}),
  };
  append_gas_fields(fields);
  append_ring_fields(fields);
  append_contact_fields(fields);
  append_lubricant_fields(fields);
  append_run_fields(fields);
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

bool is_active(const Field& field, const Case& c) { return field.active == nullptr || field.active(c); }

}  // namespace ringfilm::cycle
