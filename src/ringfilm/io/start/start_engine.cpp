#include "ringfilm/io/start/start_engine.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <variant>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_table.hpp"

namespace ringfilm::io {

const std::string kAssumed = "typical, assumed";

namespace {

namespace fs = std::filesystem;

constexpr const char* kEngines = "data/engines";
constexpr const char* kToml = ".toml";
constexpr std::size_t kStates = 3, kMinPoints = 2;  // new, run-in, worn; part load and full load

/// A value as TOML has it.
std::string toml_text(const TomlValue& value) {
  if (value.kind == TomlValue::Kind::kText) return quoted(value.text);
  if (value.is_number()) return number_text(value.number);
  std::vector<std::string> items;
  for (const TomlValue& item : value.items) items.push_back(toml_text(item));
  return "[" + joined(items, ", ") + "]";
}

class EngineReader {
 public:
  explicit EngineReader(const TomlValue& root) : root_(root) {}

  StartEngine read() {
    StartEngine engine;
    TomlTable table(root_, "an engine",
                    {"title", "grade", "pack", "crown_heights", "engine", "ring", "gas", "remarks", "of_pack", "point"},
                    faults_);
    engine.title = table.needed_text("title", "\"Passenger-car engine\"");
    engine.grade = table.needed_text("grade", "\"SAE 5W-30\"");
    engine.pack = table.needed_text("pack", "\"passenger-car\"");
    engine.crown_height = table.texts("crown_heights");
    for (const TomlValue& height : table.items("crown_heights")) check("ring.face.crown_height", height);
    if (engine.crown_height.size() != kStates) {
      table.refuse(table.mark(), "crown_heights states " + std::to_string(engine.crown_height.size()) + " heights",
                   "state those of a new, a run-in and a worn face, for example [\"10 um\", \"6 um\", \"3 um\"]");
    }
    if (const TomlValue* remarks = root_.find("remarks")) {
      for (const TomlEntry& one : flatten(*remarks, "").entries) {
        remarks_[one.key] = one.value.text;
        known_field(one.key, one.value);
      }
    }
    engine.engine = section("engine", "engine.");
    engine.ring = section("ring", "ring.");
    engine.gas = section("gas", "gas.");
    engine.composition = section("of_pack", "");
    for (const TomlValue& item : table.items("point")) engine.points.push_back(point(item));
    if (engine.points.size() < kMinPoints) {
      table.refuse(table.mark(), "there are " + std::to_string(engine.points.size()) + " operating points",
                   "state part load in the first [[point]] and full load in the second");
    }
    for (const StartPoint& one : engine.points) {
      const auto& first = engine.points.front().gas;
      if (std::ranges::equal(one.gas, first, {}, &StartValue::key, &StartValue::key)) continue;
      table.refuse(table.mark(), "the point " + quoted(one.name) + " states other keys of gas than the first one",
                   "state the same keys of gas at each [[point]], in one order");
    }
    for (const char* key : {"engine.bore", "engine.stroke", "engine.connecting_rod_length"}) need(engine.engine, key);
    for (const char* key : {"ring.face_width", "ring.elastic_pressure"}) need(engine.ring, key);
    if (!faults_.empty()) throw InputError(std::move(faults_));
    return engine;
  }

 private:
  std::vector<StartValue> section(const std::string& name, const std::string& prefix) {
    const TomlValue* table = root_.find(name);
    return table == nullptr ? std::vector<StartValue>() : values(*table, prefix);
  }

  std::vector<StartValue> values(const TomlValue& table, const std::string& prefix) {
    std::vector<StartValue> all;
    for (const TomlEntry& entry : flatten(table, "").entries) {
      const std::string key = prefix + entry.key;
      check(key, entry.value);
      const auto remark = remarks_.find(key);
      all.push_back({key, toml_text(entry.value), remark == remarks_.end() ? "" : remark->second});
    }
    return all;
  }

  /// The field of a key; nullptr, with a fault reported, for one that no case has.
  const cycle::Field* known_field(const std::string& key, const TomlValue& value) {
    const cycle::Field* field = cycle::find_field(key);
    if (field == nullptr) {
      faults_.push_back({value.key_mark, "a case has no key " + key, "`ringfilm fields` lists all keys"});
    }
    return field;
  }

  void check(const std::string& key, const TomlValue& value) {
    const cycle::Field* field = known_field(key, value);
    if (field == nullptr) return;
    if (value.kind != TomlValue::Kind::kList && (std::holds_alternative<cycle::NumberKind>(field->kind) ||
                                                 std::holds_alternative<cycle::OptionalNumberKind>(field->kind))) {
      try {
        quantity_of(value, field->unit, field->example, units_);
      } catch (const UnitError& problem) {
        faults_.push_back({value.mark, key + " " + problem.what(), "for example " + field->example});
      }
    }
  }

  StartPoint point(const TomlValue& item) {
    StartPoint point;
    TomlTable table(item, "[[point]]", {"name", "weight", "operating", "thermal", "gas"}, faults_);
    point.name = table.needed_text("name", "\"part load\"");
    table.need("weight", "0.7");
    point.weight = table.number("weight").value_or(0);
    if (!(point.weight >= 0)) table.refuse_value("weight", "is below 0", "state the share of the time");
    for (const char* name : {"operating", "thermal"}) {
      const TomlValue* of = table.find(name);
      if (of == nullptr) continue;
      for (StartValue& value : values(*of, std::string(name) + ".")) point.operation.push_back(std::move(value));
    }
    if (const TomlValue* gas = table.find("gas")) point.gas = values(*gas, "gas.");
    return point;
  }

  void need(const std::vector<StartValue>& all, const std::string& key) {
    if (std::ranges::find(all, key, &StartValue::key) != all.end()) return;
    faults_.push_back({root_.key_mark, "the engine states no " + key, "state it in its section"});
  }

  const TomlValue& root_;
  std::map<std::string, std::string> remarks_;
  std::vector<Fault> faults_;
  Units units_;
};

}  // namespace

std::vector<std::string> start_engines() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::path(shipped_folder()) / kEngines, error)) {
    if (entry.path().extension() == kToml) names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  std::ranges::stable_partition(names, [](const std::string& name) { return name == kDefaultEngine; });
  return names;
}

StartEngine start_engine(const std::string& name) {
  if (fs::path(name).extension() == kToml) return read_start_engine({name, name}, fs::path(name).stem().string());
  const std::vector<std::string> names = start_engines();
  if (std::ranges::find(names, name) == names.end()) {
    throw InputError("there is no start case for the engine " + quoted(name) + did_you_mean(name, names),
                     "one of: " + joined(names, ", ") + ", or an own file like those in " + kEngines);
  }
  return read_start_engine(locate(std::string(kEngines) + "/" + name + kToml, ""), name);
}

StartEngine read_start_engine(const NamedFile& file, const std::string& name) {
  const TomlValue root = parse_toml(read_source_text(file.path, file.shown, kMaxToml));
  StartEngine engine = EngineReader(root).read();
  engine.name = name;
  if (engine.pack.ends_with(kToml)) engine.pack = (fs::path(file.path).parent_path() / engine.pack).string();
  return engine;
}

}  // namespace ringfilm::io
