#include "ringfilm/io/pad/pad_output.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

/// The sign of a zero has no meaning.
double unsigned_zero(double value) { return value + 0.0; }

ordered_json history_object(const pad::PadResult& result) {
  ordered_json history = ordered_json::object();
  for (const auto& quantity : pad::reported_quantities(result)) {
    ordered_json& values = history[quantity.name] = ordered_json::array();
    for (const pad::Sample& sample : result.samples) values.push_back(unsigned_zero(sample.*quantity.value));
  }
  for (const auto& quantity : pad::front_quantities()) {
    ordered_json& values = history[quantity.name] = ordered_json::array();
    for (const pad::Sample& sample : result.samples) values.push_back(sample.*quantity.value);
  }
  return history;
}

ordered_json notes_array(const PadDocument& document) {
  ordered_json notes = ordered_json::array();
  for (const std::string& message : document.input_notes) notes.push_back({{"topic", "input"}, {"message", message}});
  for (const auto& [topic, message, count] : document.result.notes) {
    notes.push_back({{"topic", topic}, {"message", message}, {"count", count}});
  }
  return notes;
}

ordered_json effort_object(const pad::Effort& effort) {
  return {{"time_steps", effort.time_steps},
          {"sub_steps", effort.sub_steps},
          {"newton_iterations", effort.newton_iterations},
          {"cut_steps", effort.cut_steps},
          {"eased_starts", effort.eased_starts},
          {"max_newton_step", effort.max_newton_step}};
}

}  // namespace

std::string pad_json(const PadDocument& document) {
  const pad::PadResult& result = document.result;
  const pad::Sample& last = result.samples.back();
  ordered_json units = ordered_json::object();
  ordered_json object = {{"title", document.title}};
  for (const auto& quantity : pad::reported_quantities(result)) {
    object[quantity.name] = unsigned_zero(last.*quantity.value);
    units[quantity.name] = quantity.unit;
  }
  for (const auto& quantity : pad::front_quantities()) {
    object[quantity.name] = last.*quantity.value;
    units[quantity.name] = quantity.unit;
  }
  if (result.is_history) object["history"] = history_object(result);
  object["units"] = units;
  object["notes"] = notes_array(document);
  ordered_json assumed = ordered_json::object();
  for (const CaseEntry& entry : document.inputs) {
    if (entry.assumed) assumed[entry.key] = entry.shown;
  }
  object["assumed"] = assumed;
  object["effort"] = effort_object(result.effort);
  object["program"] = document.provenance.program;
  object["commit"] = document.provenance.commit;
  object["kernels"] = document.provenance.kernels;
  object["complete"] = result.complete;
  // A title in another encoding than UTF-8 must not lose the result.
  return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string pad_csv(const pad::PadResult& result) {
  std::string csv;
  const char* separator = "";
  for (const auto& quantity : pad::profile_quantities()) {
    csv += separator + quantity.name;
    if (quantity.unit != "1") csv += " [" + quantity.unit + "]";
    separator = ",";
  }
  csv += '\n';
  for (const pad::Profile& along : result.profiles) {
    for (std::size_t i = 0; i < result.x.size(); ++i) {
      fmt::format_to(std::back_inserter(csv), "{},{},{},{},{}\n", unsigned_zero(along.time), result.x[i],
                     along.film_thickness[i], unsigned_zero(along.pressure[i]), along.film_content[i]);
    }
  }
  return csv;
}

}  // namespace ringfilm::io
