#include "ringfilm/io/case/case_edit.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_checks.hpp"
#include "ringfilm/io/case/case_data.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/case/case_tree.hpp"
#include "ringfilm/io/case/case_values.hpp"
#include "ringfilm/io/case/shipped_oils.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/suggestion.hpp"

namespace ringfilm::io {
namespace {

using cycle::Case;
using cycle::Field;

const std::string kOil = "lubricant.";

/// Does the key name an oil, whose file states the others?
bool names_oil(const std::string& key) { return key == kOil + "file" || key == kOil + "grade"; }

/// Gives the members behind a key the values that they have in a blank case.
class Blank {
 public:
  Blank(Case& c, Case blank) : case_(c), blank_(std::move(blank)) {}

  void operator()(const cycle::NumberOrFileKind& kind) {
    kind.number(case_) = kind.number(blank_);
    kind.file(case_) = kind.file(blank_);
    case_.gas.crankcase_trace.reset();  // the one key of this kind
  }
  void operator()(const cycle::ChoiceKind& kind) { kind.choose(case_, kind.index(blank_)); }
  void operator()(const cycle::ConstantOrTemperatureValuesKind& kind) {
    kind.constant(case_) = kind.constant(blank_);
    kind.ref(case_) = kind.ref(blank_);
  }
  void operator()(const cycle::AnglesKind&) {
    case_.output.crank_angle_step_deg = blank_.output.crank_angle_step_deg;
    case_.output.crank_angles_deg = blank_.output.crank_angles_deg;
  }
  void operator()(const cycle::FieldAnglesKind&) {
    case_.output.fields = blank_.output.fields;
    case_.output.field_angles_deg = blank_.output.field_angles_deg;
  }
  template <class Other>
  void operator()(const Other& kind) {
    kind.ref(case_) = kind.ref(blank_);
  }

 private:
  Case& case_;
  Case blank_;
};

void take_out(Case& c, const Field& field) {
  std::visit(Blank(c, cycle::blank_case(c.problem)), field.kind);
  c.stated.erase(field.key);
  std::erase_if(c.files, [&field](const cycle::InputFile& file) { return file.role == field.key; });
  // With a pair goes the hardness that it brought.
  if (field.key == "contact.friction_pair" && !c.stated.contains("contact.hardness")) {
    take_out(c, known_field("contact.hardness"));
  }
}

/// Does the key decide how files are read?
bool moves_files(const Field& field, const Case& c) {
  const bool is_number = std::holds_alternative<cycle::NumberKind>(field.kind) ||
                         std::holds_alternative<cycle::OptionalNumberKind>(field.kind) ||
                         std::holds_alternative<cycle::CountKind>(field.kind);
  if (c.problem == cycle::Problem::kPad) {
    return field.key == "pad.length" || field.key == "pad.width" || (field.key.rfind("pad.", 0) == 0 && !is_number);
  }
  if (field.key == "ring.face_width") return c.ring.face.form == cycle::FaceForm::kPoints;
  return !is_number &&
         (field.key.rfind("gas.", 0) == 0 || field.key.rfind("ring.pressure_", 0) == 0 ||
          field.key.rfind("ring.face.", 0) == 0 || field.key == kOil + "table" || field.key == "liner.distortion_map" ||
          field.key == "liner.dynamic_distortion" || field.key == "ring.free_shape" || field.key == "contact.law" ||
          field.key == "contact.model" || field.key == "contact.friction_pair");
}

bool is_data_role(const std::string& role) { return role != "case" && role != "include" && role != kOil + "file"; }

void read_files_again(Case& c, const Units& units) {
  std::erase_if(c.files, [](const cycle::InputFile& file) { return is_data_role(file.role); });
  c.notes.clear();
  c.pad.clear_points();
  for (const DataFile& data : data_files(c, units)) read_data_file(data, c);
}

void put(Case& c, const Field& field, const TomlEntry& entry, const Units& units) {
  std::vector<Fault> faults;
  if (!set_value(c, field, entry, units, faults)) throw InputError(std::move(faults));
  c.stated.insert(field.key);
}

/// Replaces what the case states of the oil by all that the file of an oil states. @param key that names it
void read_oil(Case& c, const std::string& key_of_oil, const std::string& name, const Units& units) {
  const NamedFile file = key_of_oil == kOil + "grade" ? shipped_oil_of_grade(name) : locate(name, "");
  const SourceText source = read_source_text(file.path, file.shown, kMaxToml);
  std::erase_if(c.files,
                [](const cycle::InputFile& one) { return one.role == kOil + "file" || one.role == kOil + "table"; });
  for (const std::string& key : std::set<std::string>(c.stated)) {
    if (key.rfind(kOil, 0) == 0 && key != key_of_oil) take_out(c, known_field(key));
  }
  c.files.push_back({kOil + "file", file.shown, source.sha256});
  const std::size_t end = file.shown.rfind('/');
  const std::string folder = end == std::string::npos ? "" : file.shown.substr(0, end);
  std::vector<Fault> faults;
  const std::vector<TomlEntry> entries = oil_entries(parse_toml(source), folder, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
  for (const TomlEntry& entry : entries) put(c, known_field(entry.key), entry, units);
}

bool has_two_forms(const Field& field) {
  return std::holds_alternative<cycle::NumberOrFileKind>(field.kind) ||
         std::holds_alternative<cycle::OptionalNumberOrFileKind>(field.kind) ||
         std::holds_alternative<cycle::AnglesKind>(field.kind) ||
         std::holds_alternative<cycle::FieldAnglesKind>(field.kind);
}

enum class Files { kUnmoved, kMoved };

/// @returns must files be read again?
Files apply(const Change& change, Case& c, const Units& units) {
  const Field& field = known_field(change.key);
  const bool is_oil = names_oil(change.key) && change.value;
  if (!change.value || has_two_forms(field)) take_out(c, field);
  const cycle::Conditions before = c.conditions;
  if (change.value) put(c, field, {change.key, *change.value, ""}, units);
  if (c.conditions != before) cycle::replace_conditions(c);
  if (is_oil) read_oil(c, change.key, change.value->text, units);
  return is_oil || moves_files(field, c) ? Files::kMoved : Files::kUnmoved;
}

Files apply(std::vector<Change> changes, Case& c, const Units& units) {
  std::stable_partition(changes.begin(), changes.end(), [](const Change& change) { return names_oil(change.key); });
  // Other changes replace what the conditions set.
  std::stable_partition(changes.begin(), changes.end(),
                        [](const Change& change) { return names_oil(change.key) || change.key == "conditions"; });
  if (changes.size() > 1 && changes[0].value && changes[1].value && names_oil(changes[1].key)) {
    throw InputError("lubricant.file and lubricant.grade are both given", "keep one of them");
  }
  Files files = Files::kUnmoved;
  std::vector<Fault> faults;
  for (const Change& change : changes) {
    try {
      if (apply(change, c, units) == Files::kMoved) files = Files::kMoved;
    } catch (const UnknownKeyError&) {
      throw;
    } catch (const InputError& refusal) {
      faults.insert(faults.end(), refusal.faults().begin(), refusal.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return files;
}

/// One key, where files may have to be read again.
void change_alone(Case& c, const Change& change, const Units& units) {
  Case changed = c;
  if (apply(change, changed, units) == Files::kUnmoved) {
    c = std::move(changed);
    return;
  }
  read_files_again(changed, units);
  c = std::move(changed);
}

/// Each change to the rings that it concerns; the pressure below a ring is that above the next one.
void update_pack(Case& pack, const std::vector<Change>& changes, const Units& units) {
  std::vector<Case> rings = pack.rings;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    std::vector<Change> of_ring;
    for (const Change& change : changes) {
      const Case& concerned = located_key(pack, change.key).of;  // the first ring for keys of the engine
      const auto key = cycle::ring_key(change.key);
      if (!key) {
        of_ring.push_back(change);
      } else if (&concerned == &pack.rings[i]) {
        of_ring.push_back({key->key, change.value});
      } else if (i > 0 && &concerned == &pack.rings[i - 1] && key->key == "ring.pressure_below") {
        of_ring.push_back({"ring.pressure_above", change.value});
      }
    }
    update(rings[i], of_ring, units);
  }
  pack = ring_pack(std::move(rings));
}

}  // namespace

const Field& known_field(const std::string& key) {
  if (const Field* field = cycle::find_field(key)) return *field;
  std::vector<std::string> keys;
  for (const Field& field : cycle::case_fields()) keys.push_back(field.key);
  const KeyProposal proposal = key_proposal(key, keys);
  throw UnknownKeyError("unknown key " + key + proposal.message, proposal.remedy);
}

LocatedKey located_key(const Case& c, const std::string& key) {
  if (!c.is_pack()) return {known_field(key), c};
  const auto of_ring = cycle::ring_key(key);
  if (of_ring && of_ring->ring <= c.rings.size()) return {known_field(of_ring->key), c.rings[of_ring->ring - 1]};
  if (of_ring || cycle::is_of_ring(key)) {
    throw UnknownKeyError("unknown key " + key + " in a pack of " + std::to_string(c.rings.size()) + " rings",
                          "a key of one ring is " + cycle::pack_key(1, of_ring ? of_ring->key : key));
  }
  return {known_field(key), c.rings.front()};
}

void state(Case& c, const std::string& key, const TomlValue& value, const Units& units) {
  if (c.is_pack()) return update(c, {{key, value}}, units);
  const Field& field = known_field(key);
  const bool is_alone = !names_oil(key) && !has_two_forms(field) && !moves_files(field, c);
  if (is_alone) return put(c, field, {key, value, ""}, units);
  change_alone(c, {key, value}, units);
}

void retract(Case& c, const std::string& key, const Units& units) {
  if (c.is_pack()) return update(c, {{key, std::nullopt}}, units);
  change_alone(c, {key, std::nullopt}, units);
}

void update(Case& c, const std::vector<Change>& changes, const Units& units) {
  if (c.is_pack()) return update_pack(c, changes, units);
  Case changed = c;
  if (apply(changes, changed, units) == Files::kMoved) read_files_again(changed, units);
  c = std::move(changed);
}

void check_case(const Case& c) {
  for (const Case& ring : c.rings) check_case(ring);
  if (c.is_pack()) return;
  StatedKeys stated;
  if (!c.files.empty()) stated.path = c.files.front().path;
  for (const std::string& key : c.stated) {
    stated.given[key] = {};
    if ((c.lubricant.file || c.lubricant.grade) && key.rfind(kOil, 0) == 0) stated.from_oil_file.insert(key);
  }
  std::vector<Fault> faults;
  for (KeyFault& one : case_faults(c, stated)) faults.push_back(std::move(one.fault));
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace ringfilm::io
