#include "ringfilm/io/pad/pad_output.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "ringfilm/io/result/record_json.hpp"

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
  object["notes"] = notes_array(document.input_notes, result.notes);
  object["assumed"] = assumed_object(document.inputs);
  object["effort"] = record_object(result.effort);
  put_provenance(document.provenance, object);
  object["complete"] = result.complete;
  return json_text(object);
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
