#include "ringfilm/io/start/start_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_text.hpp"
#include "ringfilm/io/start/start_values.hpp"
#include "ringfilm/io/start/trace_keys.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {
namespace {

/// The place of a name. Throws InputError that lists the names.
std::size_t place_of(const std::string& what, const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw InputError("there is no start case for the " + what + " " + quoted(name) + did_you_mean(name, names),
                   "one of: " + joined(names, ", "));
}

/// Part load is the first point of an engine, full load the one after it.
const StartPoint& point_of(const StartEngine& engine, const StartOptions& options) {
  return engine.points[place_of("load", options.load, start_loads())];
}

/// Crank of an engine.
cycle::Engine dimensions(const StartEngine& engine, const Units& units) {
  const auto length = [&](const std::string& key) {
    const auto found = std::find_if(engine.engine.begin(), engine.engine.end(),
                                    [&](const StartValue& value) { return value.key == key; });
    return units.quantity(found->value.substr(1, found->value.size() - 2), "m", "89 mm");
  };
  cycle::Engine of;
  of.bore = length("engine.bore");
  of.stroke = length("engine.stroke");
  of.connecting_rod_length = length("engine.connecting_rod_length");
  return of;
}

std::string title_of(const StartEngine& engine, const StartOptions& options) {
  const std::string state = options.state == "run-in" ? "" : ", " + options.state;
  return engine.title + (options.is_pack ? ", ring pack" : ", top ring") + state + ", " + options.load + " load";
}

std::string head(const std::string& title, bool has_all_keys) {
  const std::string of_keys =
      "# A line \"# key = value  # default\" is a default input; take the first # away to state another value.\n"
      "# A line \"# key = value  # example\" is an optional key, or one of another model.\n"
      "# A line \"# key = value  # of the oil\" is a value of the oil that lubricant.grade names.\n"
      "# include = [\"fragment.toml\"] would read more keys from another file.\n";
  return "# A case of ringfilm: " + title +
         ".\n"
         "# A quantity is text with its unit; a bare number has none.\n"
         "# \"typical, assumed\" marks an estimate (docs/manual/guide/typical-inputs.md): state your own "
         "value.\n"
         "# `ringfilm fields` shows all keys, `ringfilm new --all` writes them; `ringfilm check` reads this file.\n" +
         (has_all_keys ? of_keys : "");
}

void append(const std::vector<StartValue>& values, std::vector<StartValue>& to) {
  for (StartValue value : values) {
    if (value.remark.empty()) value.remark = kAssumed;
    to.push_back(std::move(value));
  }
}

/// A section of the case with its lines. Keys of a section below it share a line: "face = { form = ..., ... }".
class SectionText {
 public:
  void add(const std::string& name, const StartValue& value) {
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos) return write(name, value);
    const std::string table = name.substr(0, dot);
    if (table != table_) finish();
    table_ = table;
    entries_.push_back(name.substr(dot + 1) + " = " + value.value);
    const bool has_more = value.remark.starts_with(kAssumed) && !remarks_.empty();
    const std::string more = has_more ? value.remark.substr(kAssumed.size()) : value.remark;
    if (more.size() > 2) remarks_.push_back(has_more ? more.substr(2) : more);
  }
  /// Once all values are added.
  const std::string& text() {
    finish();
    return text_;
  }

 private:
  void write(const std::string& name, const StartValue& value) {
    finish();
    text_ += value.value.empty()
                 ? fmt::format("# {} = {}  # MISSING: {}\n", name, cycle::find_field(value.key)->example, value.remark)
                 : fmt::format("{} = {}  # {}\n", name, value.value, value.remark);
  }
  void finish() {
    if (entries_.empty()) return;
    text_ += fmt::format("{} = {{ {} }}  # {}\n", table_, joined(entries_, ", "), joined(remarks_, "; "));
    entries_.clear();
    remarks_.clear();
  }

  std::string text_, table_;
  std::vector<std::string> entries_, remarks_;
};

/// The values alone, section by section in their order.
std::string stated_case(const std::string& head, const std::vector<StartValue>& values) {
  std::vector<std::string> order;
  std::map<std::string, SectionText> sections;
  for (const StartValue& value : values) {
    const std::size_t dot = value.key.find('.');
    const std::string section = dot == std::string::npos ? "" : value.key.substr(0, dot);
    if (!sections.contains(section)) order.push_back(section);
    sections[section].add(value.key.substr(section.empty() ? 0 : dot + 1), value);
  }
  std::string text = head;
  for (const std::string& section : order) {
    text += (section.empty() ? "" : "[" + section + "]\n") + sections[section].text();
  }
  return text;
}

/// The [[ring]] sections of the shipped pack of that name.
std::string rings_of(const StartEngine& engine) {
  const NamedFile file = engine.pack.ends_with(".toml") ? NamedFile{engine.pack, engine.pack}
                                                        : locate("data/packs/" + engine.pack + ".toml", "");
  std::string text = read_source_text(file.path, file.shown, kMaxToml).text;
  // The shipped packs name tables by their own folder, a case by that of the shipped data.
  for (std::size_t at = 0; (at = text.find("\"../lands/", at)) != std::string::npos;)
    text.replace(at, 10, "\"data/lands/");
  return "\n# All numbers of the rings are typical, assumed; their faces are run in.\n" +
         text.substr(text.find("[[ring]]"));
}

}  // namespace

std::vector<std::string> start_loads() { return {"part", "full"}; }
std::vector<std::string> start_states() { return {"new", "run-in", "worn"}; }

StartCase start_case(const StartOptions& options) {
  const StartEngine engine = start_engine(options.engine);
  const StartPoint& point = point_of(engine, options);
  const std::size_t state = place_of("state", options.state, start_states());
  const std::string title = title_of(engine, options);
  StartCase start;
  std::vector<StartValue> values = {
      {"title", quoted(title), "for people"},
      {"conditions", quoted("engine"), kAssumed + ": gas at the edges, oil on the liner"}};
  append(engine.engine, values);
  append(point.operation, values);
  append(start_walls(point), values);
  if (options.trace) {
    const Units units;
    TraceKeys trace =
        trace_keys(*options.trace, options.case_folder, dimensions(engine, units), units, options.trace_table);
    append(trace.values, values);
    start.found = std::move(trace.found);
    start.missing = std::move(trace.missing);
    start.notes = std::move(trace.notes);
  } else {
    values.push_back({"gas.model", "\"wiebe\"", "a computed pressure; a measured trace is better"});
    append(engine.gas, values);
    append(point.gas, values);
  }
  if (options.is_pack) {
    const auto is_path = [](const StartValue& value) { return value.key.starts_with("gas_path."); };
    std::vector<StartValue> composition = engine.composition;
    const auto of_path = std::stable_partition(composition.begin(), composition.end(), std::not_fn(is_path));
    append({composition.begin(), of_path}, values);
    append({{"gas_path.model", quoted("orifice-volume"), "gas between the rings, computed"},
            {"gas_path.ring_motion", quoted("axial"), "rings move in their grooves"}},
           values);
    append({of_path, composition.end()}, values);
  } else {
    append(engine.ring, values);
    append({{"ring.face.form", "\"parabola\"", ""},
            {"ring.face.crown_height", quoted(engine.crown_height[state]), kAssumed + ": " + options.state}},
           values);
  }
  append(start_contact(options.state), values);
  values.push_back({"lubricant.grade", quoted(engine.grade), kAssumed + "; `ringfilm oils` lists others"});
  if (options.is_pack) {
    append({{"supply.film", "\"5 um\"", kAssumed + ": that the crankcase throws below the oil ring"},
            {"supply.reach", "\"20 mm\"", ""}},
           values);
    start.text = stated_case(head(title, false), values) + rings_of(engine);
  } else {
    values.push_back(
        {"output.fields", quoted("all"), "for the slider along the face in the report; 3 MB in the result"});
    start.text =
        options.has_all_keys ? commented_case(head(title, true), values) : stated_case(head(title, false), values);
  }
  return start;
}

std::string start_points(const StartOptions& options, const std::string& case_path) {
  const StartEngine engine = start_engine(options.engine);
  std::string text = fmt::format(
      "# Operating points of {} with their shares of the time: typical, assumed.\n"
      "title = {}\nkind = \"compare\"\n\n[[base]]\nname = \"case\"\ncase = {}\n\n"
      "[plan]\nmethod = \"operating-points\"\n",
      case_path, quoted(engine.title + ", operating points"), quoted(case_path));
  for (const StartPoint& point : engine.points) {
    std::vector<StartValue> values;
    append(point.operation, values);
    append(start_walls(point), values);
    if (!options.trace) append(point.gas, values);
    text += fmt::format("\n[[point]]\nname = {}\nweight = {}\n\n[point.values]\n", quoted(point.name),
                        number_text(point.weight));
    for (const StartValue& value : values) {
      text += fmt::format("\"{}\" = {}  # {}\n", value.key, value.value, value.remark);
    }
  }
  return text;
}

}  // namespace ringfilm::io
