#include "ringfilm/io/result/result_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "ringfilm/cycle/result/effort_quantities.hpp"
#include "ringfilm/io/result/gas_json.hpp"
#include "ringfilm/io/result/oil_consumption_json.hpp"
#include "ringfilm/io/result/pack_sums.hpp"
#include "ringfilm/io/result/record_json.hpp"
#include "ringfilm/io/result/result_document.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

/// What is taken for granted; of a variant the cycle values that differ, SI.
ordered_json ledger_array(const ResultDocument& document) {
  ordered_json ledger = ordered_json::array();
  for (const study::LedgerEntry& entry : document.ledger) {
    ordered_json variants = ordered_json::array();
    for (const study::LedgerVariant& variant : entry.variants) {
      ordered_json changed = ordered_json::object();
      for (const auto& quantity : cycle::cycle_quantities()) {
        const double value = variant.values.*quantity.value;
        if (variant.solved && value != document.result.values.*quantity.value) changed[quantity.name] = value;
      }
      variants.push_back(record_object(variant));
      variants.back()["changed"] = std::move(changed);
    }
    ledger.push_back(record_object(entry));
    ledger.back()["variants"] = std::move(variants);
  }
  return ledger;
}

ordered_json cycle_object(const cycle::CycleValues& values) {
  return quantities_object(cycle::cycle_quantities(), values);
}

ordered_json error_estimate_object(const study::ErrorEstimate& estimate) {
  return {{"runs", record_array(estimate.runs)},
          {"order_in_cells", cycle_object(estimate.order_in_cells)},
          {"order_in_step", cycle_object(estimate.order_in_step)}};
}

ordered_json result_object(const ResultDocument& document) {
  const cycle::CycleResult& result = document.result;
  ordered_json units = ordered_json::object();
  ordered_json object = {{"title", document.title}};
  put_quantities(cycle::cycle_quantities(), result.values, object);
  put_units(cycle::cycle_quantities(), units);
  if (!result.unrolled.is_absent()) {
    put_quantities(cycle::unrolled_cycle_quantities(), result.unrolled_values, object);
    put_units(cycle::unrolled_cycle_quantities(), units);
  }
  for (const auto& quantity : cycle::derived_quantities()) {
    if (const auto entry = result.derived.find(quantity.name); entry != result.derived.end()) {
      object[quantity.name] = entry->second;
      units[quantity.name] = quantity.unit;
    }
  }
  object["units"] = units;
  if (document.errors) {
    object["errors"] = cycle_object(document.errors->values);
    object["error_estimate"] = error_estimate_object(*document.errors);
  }
  if (!document.oil_losses.empty()) object["oil_consumption"] = oil_consumption_object(document.oil_losses);
  object["notes"] = notes_array(document.input_notes, result.notes);
  object["assumed"] = assumed_object(document.inputs);
  if (document.ledger_computed) object["ledger"] = ledger_array(document);
  if (!document.comparison.empty()) object["comparison"] = comparison_array(document.comparison);
  object["effort"] = quantities_object(cycle::effort_quantities(), result.effort);
  put_provenance(document.provenance, object);
  object["complete"] = result.complete;
  return object;
}

ordered_json oil_object(const PackOil& oil) {
  ordered_json object = quantities_object(pack_oil_quantities(), oil);
  put_units(pack_oil_quantities(), object["units"]);
  return object;
}

ordered_json sums_object(const cycle::CycleValues& values) {
  return quantities_object(cycle::summed_quantities(), values);
}

/// The rings of a pack, and what their friction adds up to.
ordered_json pack_object(const ResultDocument& document) {
  ordered_json object = {{"title", document.title}, {"rings", ordered_json::array()}};
  const std::vector<std::size_t> numbers = ring_numbers(document);
  for (std::size_t i = 0; i < document.rings.size(); ++i) {
    ordered_json ring = {{"ring", numbers[i]}};
    if (document.rings[i].rail > 0) ring["rail"] = document.rings[i].rail;
    ring.update(result_object(document.rings[i]));
    object["rings"].push_back(std::move(ring));
  }
  object["all_rings"] = sums_object(document.result.values);
  object["by_ring"] = ordered_json::array();
  for (const RingSums& one : ring_sums(document)) {
    object["by_ring"].push_back({{"ring", one.ring}});
    object["by_ring"].back().update(sums_object(one.values));
  }
  put_units(cycle::summed_quantities(), object["units"]);
  if (const std::optional<PackOil> oil = pack_oil(document)) object["oil"] = oil_object(*oil);
  if (!document.oil_losses.empty()) object["oil_consumption"] = oil_consumption_object(document.oil_losses);
  if (document.gas) object["gas"] = gas_object(*document.gas);
  put_provenance(document.provenance, object);
  object["complete"] = document.result.complete;
  return object;
}

}  // namespace

ordered_json comparison_array(const std::vector<study::ComparisonRow>& rows) {
  ordered_json list = ordered_json::array();
  for (const study::ComparisonRow& row : rows) put_members(row, list.emplace_back(record_object(row.published)));
  return list;
}

std::string result_json(const ResultDocument& document) {
  return json_text(document.is_pack() ? pack_object(document) : result_object(document));
}

std::string check_json(const CaseCheck& check) {
  ordered_json stated = ordered_json::array(), defaults = ordered_json::array();
  for (const CaseEntry& entry : check.inputs) (entry.assumed ? defaults : stated).push_back(record_object(entry));
  ordered_json assumptions = ordered_json::array();
  for (std::size_t i = 0; i < check.assumptions.size(); ++i) {
    for (const study::LedgerEntry& entry : check.assumptions[i]) {
      put_members(entry, assumptions.emplace_back(ordered_json{{"ring", i + 1}}));
    }
  }
  const ordered_json object = {
      {"case", check.path},
      {"stated", stated},
      {"default_inputs", defaults},
      {"modelling_assumptions", assumptions},
      {"assumed_inputs", check.assumed_inputs ? record_array(*check.assumed_inputs) : ordered_json()},
      {"notes", record_array(check.notes)},
      {"errors", ordered_json::array()}};
  return json_text(object);
}

std::string errors_json(const std::string& case_path, const std::vector<Fault>& faults) {
  const auto text = [](const std::string& one) { return one.empty() ? ordered_json() : ordered_json(one); };
  const auto number = [](int one) { return one == 0 ? ordered_json() : ordered_json(one); };
  ordered_json errors = ordered_json::array();
  for (const auto& [mark, message, remedy] : faults) {
    errors.push_back({{"file", text(mark.file)},
                      {"line", number(mark.line)},
                      {"column", number(mark.column)},
                      {"line_text", text(mark.line_text)},
                      {"message", message},
                      {"remedy", text(remedy)}});
  }
  const ordered_json object = {{"case", case_path}, {"errors", errors}};
  return json_text(object);
}

}  // namespace ringfilm::io
