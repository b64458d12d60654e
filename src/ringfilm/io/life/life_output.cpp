#include "ringfilm/io/life/life_output.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/io/life/wear_json.hpp"
#include "ringfilm/io/result/provenance_attributes.hpp"
#include "ringfilm/io/result/record_json.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"
#include "ringfilm/io/result/result_file_writer.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::pair<life::Part, const char*>, 3> kParts = {{{life::Part::kFace, "face"},
                                                                       {life::Part::kRoughness, "roughness"},
                                                                       {life::Part::kShearStrength, "shear_strength"}}};

ordered_json values_object(const life::LifeValues& values) {
  ordered_json object = ordered_json::object();
  for (std::size_t i = 0; i < values.size(); ++i) object[life::life_quantities()[i].name] = values[i];
  return object;
}

ordered_json band_object(const life::LifeState& state) {
  ordered_json object = ordered_json::object();
  for (std::size_t i = 0; i < state.values.size(); ++i) {
    const life::Band band = life::band_of(state, i);
    object[life::life_quantities()[i].name] = {band.low, band.high};
  }
  if (state.other_worn.empty()) return object;
  for (const life::WornQuantity& quantity : life::worn_quantities()) {
    if (!life::value_of(quantity, *state.worn)) continue;
    const life::Band band = life::band_of(state, quantity);
    object[quantity.name] = {band.low, band.high};
  }
  return object;
}

/// What is lost, and the gas that passes then.
void put_lost(const life::WornProfile& worn, ordered_json& object) {
  for (const life::WornQuantity& quantity : life::worn_quantities()) {
    if (const auto value = life::value_of(quantity, worn)) object[quantity.name] = *value;
  }
}

ordered_json attribution_object(const life::LifeState& state) {
  ordered_json object = ordered_json::object();
  for (const auto& [part, name] : kParts) {
    const life::LifeValues& values = state.parts[static_cast<std::size_t>(part)];
    if (!values.empty()) object[name] = values_object(values);
  }
  return object;
}

ordered_json state_object(const LifeDocument& document, const life::LifeState& state) {
  ordered_json object = {{"hours", state.time / life::kHour}, {"state_origin", state_origin_word(state.state_origin)}};
  for (const char* name : {"worn_area", "largest_worn_depth"}) object[name] = nullptr;
  if (state.worn) put_lost(*state.worn, object);
  object.update(values_object(state.values));
  put_members(state.ring, object);
  object["face_height_chamber_edge"] = state.face_height.front();
  object["face_height_crankcase_edge"] = state.face_height.back();
  object["face_height"] = state.face_height;
  if (state.worn) {
    object["worn_depth"] = state.worn->depth;
    if (!state.worn->liner_depth.empty()) object["liner_worn_depth"] = state.worn->liner_depth;
  }
  if (!state.least_wear.empty()) object["least_wear"] = record_array(state.least_wear);
  if (!state.from_measured.empty()) object["measured_face_distance"] = record_array(state.from_measured);
  if (!state.other_paths.empty()) {
    object["band"] = band_object(state);
    ordered_json& others = object["interpolations"] = ordered_json::object();
    for (std::size_t k = 0; k < state.other_paths.size(); ++k) {
      ordered_json one = values_object(state.other_paths[k]);
      if (k < state.other_worn.size() && state.other_worn[k]) put_lost(*state.other_worn[k], one);
      others[document.result.other_paths[k].name] = std::move(one);
    }
  }
  if (!state.turned.empty()) object["turned"] = values_object(state.turned);
  if (state.turned_worn) put_lost(*state.turned_worn, object["turned"]);
  const ordered_json attribution = attribution_object(state);
  if (!attribution.empty()) object["attribution"] = attribution;
  ordered_json& points = object["points"] = ordered_json::array();
  for (std::size_t i = 0; i < state.points.size(); ++i) {
    const life::OperatingPoint& point = document.file.life.points[i];
    ordered_json one = {{"name", point.name}, {"share", point.share}};
    one.update(values_object(state.points[i]));
    if (!state.point_gas.empty()) put_quantities(cycle::gas_sum_quantities(), state.point_gas[i], one);
    points.push_back(std::move(one));
  }
  return object;
}

ordered_json units_object() {
  ordered_json units = {{"hours", "h"},
                        {"share", "1"},
                        {"x", "m"},
                        {"worn_depth", "m"},
                        {"liner_worn_depth", "m"},
                        {"liner_position", "m"},
                        {"face_height", "m"},
                        {"face_height_chamber_edge", "m"},
                        {"face_height_crankcase_edge", "m"}};
  put_member_units<life::RingState>(units);
  put_member_units<life::WearBound>(units);
  put_member_units<life::FaceDistance>(units);
  units.update(wear_units());
  put_units(cycle::gas_sum_quantities(), units);
  put_units(life::worn_quantities(), units);
  put_units(life::life_quantities(), units);
  return units;
}

ordered_json ends_array(const LifeDocument& document) {
  ordered_json ends = ordered_json::array();
  for (std::size_t i = 0; i < document.result.ends.size(); ++i) {
    const life::EndRule& rule = document.file.life.end_rules[i];
    const life::EndOfLife& end = document.result.ends[i];
    ordered_json object = {{"quantity", rule.quantity}, {"limit", rule.limit}, {"hours", hours_or_null(end.time)}};
    if (end.starts_above) object["starts"] = *end.starts_above ? "above" : "below";
    for (std::size_t k = 0; k < end.other_paths.size(); ++k) {
      object["interpolations"][document.result.other_paths[k].name] = hours_or_null(end.other_paths[k]);
    }
    object["turned"] = hours_or_null(end.turned);
    ends.push_back(std::move(object));
  }
  return ends;
}

constexpr const char* kTime = "running_time";

/// A number of each reported time as a variable over the running time.
template <class Value>
void put_over_time(ResultFileWriter& file, const cycle::Quantity& quantity, const LifeDocument& document,
                   const Value& value) {
  std::vector<double> values;
  for (const life::LifeState& state : document.result.states) values.push_back(value(state));
  file.numbers({kTime}, quantity, values);
}

void put_ring(ResultFileWriter& file, const LifeDocument& document) {
  const std::vector<life::LifeState>& states = document.result.states;
  std::vector<std::string> state_origins;
  std::vector<double> heights;
  for (const life::LifeState& state : states) {
    state_origins.push_back(state_origin_word(state.state_origin));
    heights.insert(heights.end(), state.face_height.begin(), state.face_height.end());
  }
  file.texts(kTime, text("state_origin", "how face, roughness and shear strength are known"), state_origins);
  file.numbers({"x"}, described("x", "m", "distance from the chamber edge", "x"), states.front().x);
  file.numbers({kTime, "x"}, described("face_height", "m", "height of the face above its lowest point", "h_s"),
               heights);
  for_each_member<life::RingState>([&](const auto& member) {
    put_over_time(file, described("", member), document,
                  [&member](const life::LifeState& state) { return state.ring.*member.value; });
  });
}

/// The quantity with a suffix to its name and its long name.
cycle::Quantity variant(cycle::Quantity quantity, const std::string& suffix, const std::string& words) {
  quantity.name += "_" + suffix;
  quantity.long_name += ", " + words;
  return quantity;
}

void put_values(ResultFileWriter& file, const LifeDocument& document) {
  const bool is_fitted = document.result.wear && document.result.wear->fit;
  const std::string band =
      is_fitted ? "the geometric mean and both ends of the fitted coefficients" : "all interpolations";
  for (std::size_t i = 0; i < life::life_quantities().size(); ++i) {
    const cycle::Quantity& quantity = life::life_quantities()[i];
    put_over_time(file, quantity, document, [i](const life::LifeState& state) { return state.values[i]; });
    if (!document.result.other_paths.empty()) {
      put_over_time(file, variant(quantity, "low", "least of " + band), document,
                    [i](const life::LifeState& state) { return life::band_of(state, i).low; });
      put_over_time(file, variant(quantity, "high", "largest of " + band), document,
                    [i](const life::LifeState& state) { return life::band_of(state, i).high; });
    }
    if (document.file.life.points.size() == 1) continue;
    std::vector<double> of_points;
    for (const life::LifeState& state : document.result.states) {
      for (const life::LifeValues& point : state.points) of_points.push_back(point[i]);
    }
    file.numbers({kTime, "operating_point"}, variant(quantity, "at_point", "at each operating point"), of_points);
  }
}

void put_wear(ResultFileWriter& file, const LifeDocument& document) {
  std::vector<double> depths, liner;
  for (const life::LifeState& state : document.result.states) {
    depths.insert(depths.end(), state.worn->depth.begin(), state.worn->depth.end());
    liner.insert(liner.end(), state.worn->liner_depth.begin(), state.worn->liner_depth.end());
  }
  for (const life::WornQuantity& quantity : life::worn_quantities()) {
    const auto value = [&](const life::LifeState& state) { return life::value_of(quantity, *state.worn); };
    if (!value(document.result.states.front())) continue;
    put_over_time(file, quantity, document, [&](const life::LifeState& state) { return value(state).value(); });
  }
  file.numbers({kTime, "x"}, described("worn_depth", "m", "worn depth of the face", "w", "eq-life-archard"), depths);
  if (liner.empty()) return;
  file.numbers({"liner_position"}, described("liner_position", "m", "distance below the TDC position of the ring"),
               document.result.liner_position);
  file.numbers({kTime, "liner_position"}, described("liner_worn_depth", "m", "worn depth of the liner"), liner);
}

void put_words(ResultFileWriter& file, const LifeDocument& document) {
  std::vector<std::string> notes;
  for (const cycle::Note& note : document.result.notes) notes.push_back(note.topic + ": " + note.message);
  if (!notes.empty()) file.texts("note", text("note_text", "what to consider before using the numbers"), notes);
}

}  // namespace

std::string state_origin_word(life::StateOrigin state_origin) {
  switch (state_origin) {
    case life::StateOrigin::kMeasured:
      return "measured";
    case life::StateOrigin::kInterpolated:
      return "interpolated";
    case life::StateOrigin::kScenario:
      return "scenario";
    case life::StateOrigin::kHeld:
      break;
  }
  return "held";
}

std::string life_json(const LifeDocument& document) {
  const life::LifeResult& result = document.result;
  const bool wears = result.wear.has_value();
  ordered_json object = {{"title", document.file.life.title}, {"mode", wears ? "archard" : "measured-path"}};
  ordered_json& states = object["states"] = ordered_json::array();
  for (const life::LifeState& state : result.states) states.push_back(state_object(document, state));
  if (!result.states.empty()) object["x"] = result.states.front().x;
  if (wears && !result.states.empty() && !document.file.life.states.empty()) {
    object["measured_faces"] = measured_faces(document);
  }
  if (!result.liner_position.empty()) object["liner_position"] = result.liner_position;
  if (wears) object["wear"] = wear_object(document);
  if (!result.ends.empty()) object["end_of_life"] = ends_array(document);
  object["units"] = units_object();
  object["notes"] = record_array(result.notes);
  object["cycles"] = result.cycles;
  put_provenance(document.provenance, object);
  return json_text(object);
}

void write_life(const std::string& path, const LifeDocument& document) {
  constexpr long kSchema = 3;
  ResultFileWriter file(path);
  file.attribute("Conventions", std::string("CF-1.10"));
  file.attribute("ringfilm_life_schema", kSchema);
  file.attribute("title", document.file.life.title);
  exchange_provenance(file, document.provenance);
  file.rows(kTime, document.result.states);
  put_over_time(file, described(kTime, "h", "running time", "t"), document,
                [](const life::LifeState& state) { return state.time / life::kHour; });
  if (document.file.life.points.size() > 1) {
    std::vector<std::string> names;
    for (const life::OperatingPoint& point : document.file.life.points) names.push_back(point.name);
    file.texts("operating_point", text("operating_point_name", "operating points of the duty"), names);
  }
  put_ring(file, document);
  put_values(file, document);
  if (document.result.states.front().worn) put_wear(file, document);
  put_words(file, document);
  write_atomically(path, file.bytes());
}

}  // namespace ringfilm::io
