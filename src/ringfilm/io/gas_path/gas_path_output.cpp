#include "ringfilm/io/gas_path/gas_path_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/pack/gas_of_pack.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/measurement/section_numbers.hpp"
#include "ringfilm/io/result/gas_json.hpp"
#include "ringfilm/io/result/pack_gas_layout.hpp"
#include "ringfilm/io/result/provenance_attributes.hpp"
#include "ringfilm/io/result/record_json.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/result/result_file_layout.hpp"
#include "ringfilm/io/result/result_file_writer.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

/// Raised by one whenever a name or a meaning of the file of the gas alone changes.
constexpr long kGasSchema = 1;

/// Is it a key that the gas uses, of one ring or of a ring of a pack?
bool is_gas_entry(const CaseEntry& entry, const cycle::Case& c) {
  const auto of_ring = cycle::ring_key(entry.key);
  const cycle::Field* field = cycle::find_field(of_ring ? of_ring->key : entry.key);
  if (field == nullptr || !field->uses.gas) return false;
  // An oil ring does not twist.
  const bool is_of_oil_ring = of_ring && of_ring->ring >= 1 && of_ring->ring <= c.rings.size() &&
                              c.rings[of_ring->ring - 1].ring.gas_path.kind == cycle::RingKind::kOil;
  if (is_of_oil_ring && field->key == "ring.youngs_modulus") return false;
  // What only the film requires has no value where the case does not state it.
  return !(entry.assumed && field->need == cycle::Need::kRequired);
}

std::string column_name(const std::string& what, std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return what + "_" + name;
}

ordered_json section_object(const cycle::SectionValues& section, ordered_json& units) {
  ordered_json object = ordered_json::object();
  for (const SectionNumbers& one : section_numbers(section)) {
    object[one.name] = one.value.size() == 1 ? ordered_json(one.value.front()) : ordered_json(one.value);
    units[one.name] = one.unit;
  }
  return object;
}

/// The section of the first ring that states one, and in a pack those of all rings.
void put_sections(const GasPathDocument& document, ordered_json& object) {
  ordered_json all = ordered_json::array();
  for (std::size_t i = 0; i < document.sections.size(); ++i) {
    if (!document.sections[i]) continue;
    ordered_json one = section_object(*document.sections[i], object["units"]);
    if (all.empty()) object["section"] = one;
    one["ring"] = i + 1;
    all.push_back(std::move(one));
  }
  if (document.sections.size() > 1 && !all.empty()) object["sections"] = std::move(all);
}

}  // namespace

GasPathDocument gas_path_document(const cycle::Case& c, const gas_path::Pack& pack, gas_path::GasPathResult result) {
  GasPathDocument document;
  document.result = std::move(result);
  document.title = c.title;
  for (CaseEntry& entry : case_entries(c)) {
    if (is_gas_entry(entry, c)) document.inputs.push_back(std::move(entry));
  }
  document.files = c.files;
  document.input_notes = c.notes;
  if (c.gas_path.passes_films()) {
    document.input_notes.push_back(
        "gas_path.film = \"breakthrough\" is not used where the gas alone is computed: the films hold the gas here, "
        "and ringfilm run computes what passes them");
  }
  document.notes = cycle::gas_path_notes(c, pack, document.result);
  document.provenance = this_program();
  document.gas = pack_gas(document.result, pack.gas.gas_constant, c.engine.cylinders);
  for (const cycle::Case& ring : c.is_pack() ? std::span(c.rings) : std::span(&c, 1)) {
    document.sections.push_back(cycle::section_values(ring));
  }
  return document;
}

std::string gas_path_json(const GasPathDocument& document) {
  ordered_json object = {{"title", document.title}};
  object.update(gas_object(document.gas));
  put_sections(document, object);
  object["notes"] = notes_array(document.input_notes, document.notes);
  object["assumed"] = assumed_object(document.inputs);
  put_provenance(document.provenance, object);
  return json_text(object);
}

void write_gas_path(const std::string& path, const GasPathDocument& document) {
  ResultFileWriter file(path);
  file.attribute("Conventions", std::string("CF-1.10"));
  file.attribute("ringfilm_gas_schema", kGasSchema);
  file.attribute("title", document.title);
  exchange_provenance(file, document.provenance);
  const struct { std::optional<PackGas> gas; } content{document.gas};
  exchange_pack_gas(file, content);
  exchange_notes(file, document.input_notes, document.notes);
  exchange_inputs(file, document);
  write_atomically(path, file.bytes());
}

std::string gas_path_csv(const GasPathDocument& document) {
  const gas_path::GasPathResult& result = document.result;
  std::string csv = "crank_angle [degree]";
  for (const auto& region : result.regions) csv += "," + column_name("pressure", region.name) + " [Pa]";
  for (const auto& path : result.paths) csv += "," + column_name("flow", path_name(path)) + " [kg/s]";
  for (std::size_t i = 0; i < result.motion.size(); ++i) {
    if (result.motion[i].has_groove) csv += fmt::format(",position_ring_{} [m]", i + 1);
  }
  const std::vector<gas_path::ScalarValues>& scalars = document.gas.scalars;
  for (const auto& region : result.regions) {
    for (const auto& scalar : scalars) {
      csv += "," + column_name(column_name("share", scalar.name), region.name) + " [-]";
    }
  }
  const std::size_t n_shares = result.regions.size() * scalars.size();
  csv += '\n';
  for (std::size_t k = 0; k < result.pressure.size(); ++k) {
    csv += std::to_string(k);
    const auto add = [&csv](double value) { csv += fmt::format(",{}", value + 0.0); };  // a zero has no sign
    for (const double p : result.pressure[k]) add(p);
    for (const double m : result.flow[k]) add(m);
    for (std::size_t i = 0; i < result.motion.size(); ++i) {
      if (result.motion[i].has_groove) add(result.position[k][i]);
    }
    for (std::size_t i = 0; i < n_shares; ++i) add(document.gas.share[k * n_shares + i]);
    csv += '\n';
  }
  return csv;
}

}  // namespace ringfilm::io
