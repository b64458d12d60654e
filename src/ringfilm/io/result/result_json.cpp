#include "ringfilm/io/result/result_json.hpp"

#include <nlohmann/json.hpp>
#include <variant>

#include "ringfilm/cycle/result/effort_quantities.hpp"
#include "ringfilm/io/result/gas_json.hpp"
#include "ringfilm/io/result/pack_sums.hpp"
#include "ringfilm/io/result/result_document.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

ordered_json effort_object(const cycle::Effort& effort) {
  ordered_json object = ordered_json::object();
  for (const cycle::EffortQuantity& quantity : cycle::effort_quantities()) {
    std::visit([&](auto member) { object[quantity.name] = effort.*member; }, quantity.value);
  }
  return object;
}

ordered_json notes_array(const ResultDocument& document) {
  ordered_json notes = ordered_json::array();
  for (const std::string& message : document.input_notes) notes.push_back({{"topic", "input"}, {"message", message}});
  for (const auto& [topic, message, count] : document.result.notes) {
    notes.push_back({{"topic", topic}, {"message", message}, {"count", count}});
  }
  return notes;
}

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
      variants.push_back({{"setting", variant.setting}, {"solved", variant.solved}, {"changed", changed}});
      if (!variant.solved) variants.back()["reason"] = variant.reason;
    }
    ledger.push_back({{"topic", entry.topic},
                      {"statement", entry.statement},
                      {"consequence", entry.consequence},
                      {"source", entry.source},
                      {"can_be_lifted", entry.can_be_lifted},
                      {"variants", variants}});
  }
  return ledger;
}

ordered_json cycle_object(const cycle::CycleValues& values) {
  ordered_json object = ordered_json::object();
  for (const auto& quantity : cycle::cycle_quantities()) object[quantity.name] = values.*quantity.value;
  return object;
}

ordered_json error_estimate_object(const study::ErrorEstimate& estimate) {
  return {{"runs", grid_runs_array(estimate)},
          {"order_in_cells", cycle_object(estimate.order_in_cells)},
          {"order_in_step", cycle_object(estimate.order_in_step)}};
}

ordered_json result_object(const ResultDocument& document) {
  const cycle::CycleResult& result = document.result;
  ordered_json units = ordered_json::object();
  ordered_json object = {{"title", document.title}};
  for (const auto& quantity : cycle::cycle_quantities()) {
    object[quantity.name] = result.values.*quantity.value;
    units[quantity.name] = quantity.unit;
  }
  for (const auto& quantity : cycle::unrolled_cycle_quantities()) {
    if (result.unrolled.is_absent()) break;
    object[quantity.name] = result.unrolled_values.*quantity.value;
    units[quantity.name] = quantity.unit;
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
  object["notes"] = notes_array(document);
  ordered_json assumed = ordered_json::object();
  for (const CaseEntry& entry : document.inputs) {
    if (entry.assumed) assumed[entry.key] = entry.shown;
  }
  object["assumed"] = assumed;
  if (document.ledger_computed) object["ledger"] = ledger_array(document);
  object["effort"] = effort_object(result.effort);
  object["program"] = document.provenance.program;
  object["commit"] = document.provenance.commit;
  object["kernels"] = document.provenance.kernels;
  object["complete"] = result.complete;
  return object;
}

ordered_json oil_object(const PackOil& oil) {
  ordered_json object, units;
  for (const PackOilQuantity& quantity : pack_oil_quantities()) {
    object[quantity.name] = oil.*quantity.value;
    units[quantity.name] = quantity.unit;
  }
  object["units"] = std::move(units);
  return object;
}

ordered_json sums_object(const cycle::CycleValues& values) {
  ordered_json object;
  for (const cycle::CycleQuantity& quantity : cycle::summed_quantities())
    object[quantity.name] = values.*quantity.value;
  return object;
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
  for (const cycle::Quantity& quantity : cycle::summed_quantities()) object["units"][quantity.name] = quantity.unit;
  if (const std::optional<PackOil> oil = pack_oil(document)) object["oil"] = oil_object(*oil);
  if (document.gas) object["gas"] = gas_object(*document.gas);
  object["program"] = document.provenance.program;
  object["commit"] = document.provenance.commit;
  object["kernels"] = document.provenance.kernels;
  object["complete"] = document.result.complete;
  return object;
}

}  // namespace

ordered_json grid_runs_array(const study::ErrorEstimate& estimate) {
  ordered_json runs = ordered_json::array();
  for (const study::GridRun& run : estimate.runs) {
    runs.push_back({{"cells", run.cells},
                    {"crank_step", run.crank_step_deg},
                    {"step_error", run.step_error},
                    {"solved", run.solved}});
    if (run.cells_y > 0) runs.back()["cells_y"] = run.cells_y;
    if (!run.solved) runs.back()["reason"] = run.reason;
  }
  return runs;
}

std::string result_json(const ResultDocument& document) {
  const ordered_json object = document.is_pack() ? pack_object(document) : result_object(document);
  // A title in another encoding than UTF-8 must not lose the result.
  return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string check_json(const CaseCheck& check) {
  ordered_json stated = ordered_json::array(), defaults = ordered_json::array();
  for (const CaseEntry& entry : check.inputs) {
    (entry.assumed ? defaults : stated)
        .push_back({{"key", entry.key}, {"value", entry.value}, {"shown", entry.shown}, {"help", entry.help}});
  }
  ordered_json assumptions = ordered_json::array();
  for (std::size_t i = 0; i < check.assumptions.size(); ++i) {
    for (const study::LedgerEntry& entry : check.assumptions[i]) {
      assumptions.push_back({{"ring", i + 1},
                             {"topic", entry.topic},
                             {"statement", entry.statement},
                             {"consequence", entry.consequence},
                             {"source", entry.source},
                             {"can_be_lifted", entry.can_be_lifted}});
    }
  }
  ordered_json notes = ordered_json::array();
  for (const auto& [topic, message, count] : check.notes) notes.push_back({{"topic", topic}, {"message", message}});
  const ordered_json object = {{"case", check.path},
                               {"stated", stated},
                               {"default_inputs", defaults},
                               {"modelling_assumptions", assumptions},
                               {"notes", notes},
                               {"errors", ordered_json::array()}};
  return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
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
  return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace ringfilm::io
