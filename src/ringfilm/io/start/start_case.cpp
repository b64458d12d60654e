#include "ringfilm/io/start/start_case.hpp"

#include <algorithm>
#include <array>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/io/case/case_text.hpp"
#include "ringfilm/io/start/trace_keys.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {
namespace {

const std::string kAssumed = "typical, assumed";

/// An engine with its top ring. Sizes of real ones of its kind, none of them measured.
struct Engine {
  const char* name;
  const char* title;
  std::vector<StartValue> values;  ///< values of engine, operation and ring; a remark is empty where it is kAssumed
  std::vector<StartValue> gas;     ///< values of the gas where no trace is given
  const char* grade;               ///< viscosity grade of its oil
};

const std::vector<Engine>& engines() {
  static const std::vector<Engine> all = {
      {"passenger-car",
       "Passenger-car engine, top ring",
       {{"engine.bore", "\"89 mm\"", ""},
        {"engine.stroke", "\"79.5 mm\"", ""},
        {"engine.connecting_rod_length", "\"138.1 mm\"", ""},
        {"operating.speed", "\"1500 rpm\"", ""},
        {"ring.face_width", "\"1.2 mm\"", ""},
        {"ring.elastic_pressure", "\"0.2 MPa\"", kAssumed + "; 0.12 to 0.25 MPa are usual"},
        {"ring.face.form", "\"parabola\"", ""},
        {"ring.face.crown_height", "\"15 um\"", ""}},
       {},
       "SAE 5W-30"},
      {"heavy-duty",
       "Heavy-duty diesel engine, top ring",
       {{"engine.bore", "\"130 mm\"", ""},
        {"engine.stroke", "\"160 mm\"", ""},
        {"engine.connecting_rod_length", "\"260 mm\"", ""},
        {"operating.speed", "\"1200 rpm\"", ""},
        {"ring.face_width", "\"3 mm\"", ""},
        {"ring.elastic_pressure", "\"0.2 MPa\"", kAssumed + "; 0.12 to 0.25 MPa are usual"},
        {"ring.face.form", "\"parabola\"", ""},
        {"ring.face.crown_height", "\"8 um\"", ""}},
       {{"gas.compression_ratio", "17", ""},
        {"gas.peak_pressure", "\"160 bar\"", ""},
        {"gas.peak_angle", "\"15 degree\"", ""},
        {"gas.intake_pressure", "\"2.5 bar\"", ""},
        {"gas.exhaust_pressure", "\"2.2 bar\"", ""}},
       "SAE 15W-40"}};
  return all;
}

/// A pair of smooth run-in surfaces in oil: N beta sigma = 0.05, the upper end of its range (greenwood1971), and an
/// rms slope of 0.15 (eq-spectral-moments).
const std::vector<StartValue>& contact() {
  static const std::vector<StartValue> values = {
      {"contact.model", quoted("greenwood-williamson"), "with the next three: docs/manual/guide/contact-law.md"},
      {"contact.asperity", quoted("zhao-maietta-chang"), "asperities flow from the hardness on"},
      {"contact.summit_plane", quoted("nayak"), "summits lie above the mean plane of the surface"},
      {"contact.hardness", "\"2.5 GPa\"", kAssumed + ": grey iron, the softer face"},
      {"contact.asperity_density", "\"0.0125 um-2\"", kAssumed + ": N beta sigma = 0.05"},
      {"contact.asperity_radius", "\"10 um\"", ""},
      {"contact.roughness", "\"0.4 um\"", ""},
      {"contact.boundary_shear_strength_coefficient", "0.12", kAssumed + ": engine oil with anti-wear additive"}};
  return values;
}

const Engine& engine_of(const std::string& name) {
  const std::vector<std::string> names = start_engines();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return engines()[static_cast<std::size_t>(found - names.begin())];
  throw InputError("there is no start case for the engine " + quoted(name) + did_you_mean(name, names),
                   "one of: " + joined(names, ", "));
}

/// Crank of an engine.
cycle::Engine dimensions(const Engine& engine, const Units& units) {
  const auto length = [&](const std::string& key) {
    const auto found = std::find_if(engine.values.begin(), engine.values.end(),
                                    [&](const StartValue& value) { return value.key == key; });
    return units.quantity(found->value.substr(1, found->value.size() - 2), "m", "89 mm");
  };
  cycle::Engine of;
  of.bore = length("engine.bore");
  of.stroke = length("engine.stroke");
  of.connecting_rod_length = length("engine.connecting_rod_length");
  return of;
}

std::string head(const Engine& engine) {
  return "# A case of ringfilm: " + std::string(engine.title) +
         ".\n"
         "# A quantity is text with its unit; a bare number has none.\n"
         "# \"typical, assumed\" marks an estimate (docs/manual/guide/typical-inputs.md): state your own "
         "value.\n"
         "# A line \"# key = value  # default\" is a default input; take the first # away to state another value.\n"
         "# A line \"# key = value  # example\" is an optional key, or one of another model.\n"
         "# `ringfilm fields` shows all keys; `ringfilm check` reads this file without running it.\n"
         "# A line \"# key = value  # of the oil\" is a value of the oil that lubricant.grade names.\n"
         "# include = [\"fragment.toml\"] would read more keys from another file.\n";
}

void append(const std::vector<StartValue>& values, std::vector<StartValue>& to) {
  for (StartValue value : values) {
    if (value.remark.empty()) value.remark = kAssumed;
    to.push_back(std::move(value));
  }
}

}  // namespace

std::vector<std::string> start_engines() {
  std::vector<std::string> names;
  for (const Engine& engine : engines()) names.emplace_back(engine.name);
  return names;
}

StartCase start_case(const StartOptions& options) {
  const Engine& engine = engine_of(options.engine);
  StartCase start;
  std::vector<StartValue> values = {
      {"title", quoted(engine.title), "for people"},
      {"conditions", quoted("engine"), kAssumed + ": gas at the edges, oil on the liner, hot walls at full load"}};
  append(engine.values, values);
  if (options.trace) {
    const Units units;
    TraceKeys trace = trace_keys(*options.trace, options.case_folder, dimensions(engine, units), units);
    append(trace.values, values);
    start.found = std::move(trace.found);
    start.missing = std::move(trace.missing);
    start.notes = std::move(trace.notes);
  } else {
    values.push_back({"gas.model", "\"wiebe\"", "a computed pressure; a measured trace is better"});
    append(engine.gas, values);
  }
  append(contact(), values);
  values.push_back({"lubricant.grade", quoted(engine.grade), kAssumed + "; `ringfilm oils` lists others"});
  values.push_back({"output.fields", quoted("all"), "for the slider along the face in the report; 3 MB in the result"});
  start.text = commented_case(head(engine), values);
  return start;
}

}  // namespace ringfilm::io
