#include "ringfilm/report/payload/payload.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/result/effort_quantities.hpp"
#include "ringfilm/io/result/record_json.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/result/result_json.hpp"
#include "ringfilm/report/payload/described.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"
#include "ringfilm/report/payload/payload_pack.hpp"
#include "ringfilm/report/payload/payload_unrolled.hpp"
#include "ringfilm/report/payload/script_text.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

constexpr int kCurveDigits = 7;
constexpr int kFieldDigits = 5;
constexpr int kErrorDigits = 3;
/// Numbers of one field that a page may carry: a phone still opens some megabytes.
constexpr std::size_t kFieldNumbers = 60000;

ordered_json cycle_values(const cycle::CycleValues& values) {
  return io::quantities_object(cycle::cycle_quantities(), values);
}

ordered_json curves(const cycle::CycleResult& result) {
  ordered_json object = ordered_json::object();
  for (const cycle::CurveQuantity& q : cycle::curve_quantities()) {
    ordered_json list = ordered_json::array();
    for (const cycle::Sample& sample : result.samples) list.push_back(rounded(sample.*q.value, kCurveDigits));
    object[q.name] = std::move(list);
  }
  add_unrolled_curves(result, kCurveDigits, object);
  return object;
}

/// Errors by the names of values and curves; null where they were not estimated.
ordered_json errors(const std::optional<study::ErrorEstimate>& estimate) {
  if (!estimate) return nullptr;
  ordered_json curve_errors = ordered_json::object();
  for (const cycle::CurveQuantity& q : cycle::curve_quantities()) {
    if (!study::has_error(q)) continue;
    ordered_json list = ordered_json::array();
    for (const cycle::Sample& error : estimate->samples) list.push_back(rounded(error.*q.value, kErrorDigits));
    curve_errors[q.name] = std::move(list);
  }
  return {{"runs", io::record_array(estimate->runs)},
          {"has_values", study::has_values(*estimate)},
          {"values", cycle_values(estimate->values)},
          {"curves", std::move(curve_errors)}};
}

/// One list of node values for each crank angle that the page carries.
ordered_json field(const std::vector<double>& values, std::size_t n_nodes, const std::vector<std::size_t>& kept) {
  ordered_json list = ordered_json::array();
  for (std::size_t k : kept) {
    if ((k + 1) * n_nodes > values.size()) return ordered_json::array();
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(k * n_nodes);
    list.push_back(rounded_list({begin, begin + static_cast<std::ptrdiff_t>(n_nodes)}, kFieldDigits));
  }
  return list;
}

ordered_json stroke_profile(const cycle::StrokeProfile& stroke) {
  ordered_json object = {{"liner_position", rounded_list(stroke.liner_position, kCurveDigits)},
                         {"archard_wear_load_density", rounded_list(stroke.archard_wear_load_density, kCurveDigits)}};
  for (const cycle::StrokeFilm& film : cycle::stroke_films()) {
    const std::vector<double>& values = (stroke.*film.films)[film.stroke];
    if (!values.empty()) object[film.name] = rounded_list(values, kCurveDigits);
  }
  return object;
}

/// Which numbers along the faces the page carries.
enum class FaceNumbers { kShapeAndFields, kShape };

ordered_json face_fields(const cycle::FaceFields& fields, FaceNumbers numbers) {
  const std::size_t n_nodes = fields.x.size();
  const std::size_t n_angles = fields.crank_angle_deg.size();
  const std::size_t most = n_nodes == 0 ? 1 : std::max<std::size_t>(1, kFieldNumbers / n_nodes);
  const std::size_t stride = (n_angles + most - 1) / most;
  std::vector<std::size_t> kept;
  std::vector<double> angles;
  for (std::size_t k = 0; k < n_angles && numbers == FaceNumbers::kShapeAndFields; k += stride) {
    kept.push_back(k);
    angles.push_back(fields.crank_angle_deg[k]);
  }
  return {{"x", rounded_list(fields.x, kCurveDigits)},
          {"face_height", rounded_list(fields.face_height, kCurveDigits)},
          {"stored_angles", n_angles},
          {"crank_angle", rounded_list(angles, kCurveDigits)},
          {"film_thickness", field(fields.film_thickness, n_nodes, kept)},
          {"film_pressure", field(fields.film_pressure, n_nodes, kept)},
          {"asperity_pressure", field(fields.asperity_pressure, n_nodes, kept)},
          {"film_content", field(fields.film_content, n_nodes, kept)}};
}

/// The contact law against the separation, next to others of the same surfaces; null without contact.
ordered_json contact(const cycle::ContactCurves& curves) {
  if (curves.separation.empty()) return nullptr;
  const std::size_t places = curves.separation.size();
  const auto of_law = [&](const std::vector<double>& all, std::size_t law) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(law * places);
    return rounded_list({begin, begin + static_cast<std::ptrdiff_t>(places)}, kFieldDigits);
  };
  ordered_json laws = ordered_json::array();
  for (std::size_t k = 0; k < curves.laws.size(); ++k) {
    ordered_json& law = laws.emplace_back(io::record_object(curves.laws[k]));
    for_each_of(cycle::curves_of_laws(),
                [&](const auto& member) { law[member.name] = of_law(curves.*member.value, k); });
  }
  ordered_json object = {{"separation", rounded_list(curves.separation, kCurveDigits)}, {"laws", std::move(laws)}};
  for_each_member<cycle::ContactCurves>(
      [&](const auto& member) { object[member.name] = rounded_list(curves.*member.value, kFieldDigits); });
  return object;
}

ordered_json ledger(const std::vector<study::LedgerEntry>& entries) {
  ordered_json list = ordered_json::array();
  for (const study::LedgerEntry& entry : entries) {
    ordered_json variants = ordered_json::array();
    for (const study::LedgerVariant& variant : entry.variants) {
      variants.push_back(io::record_object(variant));
      variants.back()["values"] = cycle_values(variant.values);
    }
    list.push_back(io::record_object(entry));
    list.back()["variants"] = std::move(variants);
  }
  return list;
}

/// At which a film ruptures whose model has no film content [Pa]; nothing for other models, or if it is not reported.
std::optional<double> rupture_pressure(const std::vector<io::CaseEntry>& inputs) {
  const auto entry = [&inputs](const char* key) {
    return std::find_if(inputs.begin(), inputs.end(), [key](const auto& input) { return input.key == key; });
  };
  const auto cavitation = entry("film.cavitation"), pressure = entry("film.cavitation_pressure");
  if (cavitation == inputs.end() || pressure == inputs.end() || cavitation->shown != "reynolds-exit") return {};
  return std::isnan(pressure->value_si) ? std::nullopt : std::optional(pressure->value_si);
}

const char* word_of(cycle::NoteCount count) {
  switch (count) {
    case cycle::NoteCount::kCrankAngles:
      return "crank angles";
    case cycle::NoteCount::kCase:
      return "case";
    case cycle::NoteCount::kOccurrences:
      break;
  }
  return "occurrences";
}

/// A note with its place in the order of all notes and what it counts.
ordered_json note_object(const cycle::Note& note) {
  const cycle::NoteTopic* entry = cycle::note_topic(note.topic);
  ordered_json object = io::record_object(note);
  object["counts"] = word_of(entry == nullptr ? cycle::NoteCount::kOccurrences : entry->count);
  object["for_information"] = entry != nullptr && entry->trust == cycle::Trust::kFull;
  object["rank"] = cycle::note_rank(note.topic);
  return object;
}

ordered_json document(const io::ResultDocument& d, FaceNumbers numbers) {
  ordered_json notes = ordered_json::array();
  for (const cycle::Note& n : d.result.notes) notes.push_back(note_object(n));
  ordered_json derived = ordered_json::object();
  for (const auto& [name, value] : d.result.derived) derived[name] = exact(value);
  return {{"title", d.title},
          {"complete", d.result.complete},
          {"curves", curves(d.result)},
          {"values", cycle_values(d.result.values)},
          {"fields", face_fields(d.result.fields, numbers)},
          {"unrolled_values", unrolled_values(d.result)},
          {"unrolled", unrolled_payload(d.result.unrolled, rupture_pressure(d.inputs))},
          {"stroke", stroke_profile(d.result.stroke)},
          {"contact", contact(d.contact)},
          {"derived", std::move(derived)},
          {"notes", std::move(notes)},
          {"input_notes", d.input_notes},
          {"effort", io::quantities_object(cycle::effort_quantities(), d.result.effort)},
          {"inputs", io::record_array(d.inputs)},
          {"files", io::record_array(d.files)},
          {"resolved_case", d.resolved_case},
          {"provenance", io::record_object(d.provenance)},
          {"ledger", ledger(d.ledger)},
          {"ledger_computed", d.ledger_computed},
          {"comparison", io::comparison_array(d.comparison)},
          {"errors", errors(d.errors)}};
}

}  // namespace

std::string payload(const std::vector<io::ResultDocument>& documents, const std::vector<Overlay>& overlays) {
  ordered_json root;
  root["curve_quantities"] = described_all(cycle::curve_quantities());
  root["cycle_quantities"] = described_all(cycle::cycle_quantities());
  root["effort_quantities"] = described_all(cycle::effort_quantities());
  root["derived_quantities"] = described_all(cycle::derived_quantities());
  root["unrolled_quantities"] = described_all(cycle::unrolled_quantities());
  root["unrolled_cycle_quantities"] = described_all(cycle::unrolled_cycle_quantities());
  root["unrolled_fields"] = described_all(cycle::unrolled_fields());
  root["strip_fields"] = described_all(cycle::strip_fields());
  root["cases"] = ordered_json::array();
  root["packs"] = ordered_json::array();
  // The page draws no fields of packs beside each other: those of all their rings take most of 16 MB.
  const bool compares_packs = std::ranges::count_if(documents, &io::ResultDocument::is_pack) > 1;
  for (const io::ResultDocument& d : documents) {
    if (d.is_pack()) root["packs"].push_back(pack_payload(d, root["cases"].size()));
    const FaceNumbers numbers = d.is_pack() && compares_packs ? FaceNumbers::kShape : FaceNumbers::kShapeAndFields;
    for (const io::ResultDocument& ring : io::rings_of(d)) root["cases"].push_back(document(ring, numbers));
  }
  root["overlays"] = ordered_json::array();
  for (const Overlay& o : overlays) {
    root["overlays"].push_back({{"name", o.name},
                                {"quantity", o.quantity},
                                {"source", o.source},
                                {"crank_angle", rounded_list(o.crank_angle_deg, kCurveDigits)},
                                {"value", rounded_list(o.value, kCurveDigits)}});
  }
  // A file name or a title may hold bytes that are not UTF-8: they are shown as a replacement sign, not refused.
  return script_text(root.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

}  // namespace ringfilm::report
