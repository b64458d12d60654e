#include "ringfilm/io/case/case_checks.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/case/conditions.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {
namespace {

using cycle::Field;

std::string section_of(const std::string& key) { return key.substr(0, key.find('.')); }

class Checks {
 public:
  Checks(const cycle::Case& c, const StatedKeys& stated) : case_(c), stated_(stated) {}

  std::vector<KeyFault> faults() {
    if (is_part_of_a_case()) {
      add("", {stated_.path, 0, 0, ""}, "this is a part of a case: it states no engine and no ring",
          "name it in a case, include = [\"" + stated_.path + "\"]; ringfilm new my_engine.toml writes one");
      return std::move(faults_);
    }
    check_missing();
    check_unused();
    check_rules();
    return std::move(faults_);
  }

 private:
  /// A fragment that a measurement wrote, an oil, a pair: tens of keys would be missing.
  bool is_part_of_a_case() const {
    const auto is_of_engine = [](const std::string& key) {
      const std::string section = key.substr(0, key.find('.'));
      return section == "engine" || section == "ring" || section == "gas" || section == "operating";
    };
    return case_.problem == cycle::Problem::kCycle && !stated_.given.empty() && stated_.faulty.empty() &&
           std::ranges::none_of(stated_.given, [&](const auto& one) { return is_of_engine(one.first); });
  }

  void add(const std::string& key, const SourceMark& mark, const std::string& message, const std::string& remedy) {
    faults_.push_back({key, {mark, message, remedy}});
  }

  bool is_for_gas_alone() const { return case_.purpose == cycle::CasePurpose::kGasPath; }

  /// Is the key of no concern to what the case is read for?
  bool is_out_of_scope(const Field& field) const { return is_for_gas_alone() && !field.uses.gas; }

  bool is_faulty(const std::string& key) const {
    return std::any_of(stated_.faulty.begin(), stated_.faulty.end(), [&key](const std::string& faulty) {
      return key == faulty || (faulty.back() == '.' && key.rfind(faulty, 0) == 0);
    });
  }

  /// May the key `other` decide whether `field` is in use? A trace does for the pressures that join a partial one.
  static bool decides(const Field& other, const Field& field) {
    // A key of another section decides where the words on its use name it.
    if (field.active_when.find(other.key) != std::string::npos) return true;
    if (section_of(other.key) != section_of(field.key)) return false;
    if (std::holds_alternative<cycle::FileKind>(other.kind)) {
      return std::holds_alternative<cycle::OptionalNumberKind>(field.kind);
    }
    return std::holds_alternative<cycle::ChoiceKind>(other.kind) ||
           std::holds_alternative<cycle::NumberOrFileKind>(other.kind) || other.need == cycle::Need::kOptional;
  }

  /// Is it known whether the key is in use? Not where a key that decides on it is wrong or missing.
  bool use_is_known(const Field& field) const {
    const bool all_is_well = stated_.faulty.empty() && missing_.empty();  // nearly always; quick, for batches
    if (field.active == nullptr || all_is_well) return true;
    const auto& fields = cycle::case_fields();
    return std::none_of(fields.begin(), fields.end(), [&](const Field& other) {
      return (is_faulty(other.key) || missing_.contains(other.key)) && decides(other, field);
    });
  }

  void check_missing() {
    // Keys that are always required come first: if a choice among them is missing, other keys cannot be checked.
    for (const Field& field : cycle::case_fields()) {
      if (field.active == nullptr && cycle::belongs(field, case_)) check_missing(field);
    }
    std::vector<const Field*> in_use;
    for (const Field& field : cycle::case_fields()) {
      if (field.active != nullptr && use_is_known(field) && cycle::is_active(field, case_)) in_use.push_back(&field);
    }
    for (const Field* field : in_use) check_missing(*field);
  }

  void check_missing(const Field& field) {
    // What the gas asks of a ring depends on its kind and motion: broken_gas_rules.
    if (is_out_of_scope(field) || (is_for_gas_alone() && cycle::is_of_ring(field.key))) return;
    if (!cycle::is_required(field, case_) || stated_.given.contains(field.key) || is_faulty(field.key)) return;
    missing_.insert(field.key);
    // Conditions that are not known might have set it.
    if (is_faulty("conditions") && cycle::is_replaced_by(cycle::Conditions::kEngine, field.key)) return;
    const std::size_t dot = field.key.rfind('.');
    const bool top_level = dot == std::string::npos;
    const std::string name = top_level ? field.key : field.key.substr(dot + 1);
    add(field.key, {stated_.path, 0, 0, ""}, "the key " + field.key + " is missing: " + field.help,
        "write, for example, " + name + " = " + field.example +
            (top_level ? " before the first section" : " in [" + field.key.substr(0, dot) + "]"));
  }

  /// Where the keys are stated that the words on the use of `field` name; nothing for a value of the command line.
  std::string places_of_conditions(const Field& field) const {
    std::string places;
    for (const auto& [key, entry] : stated_.given) {
      const std::size_t at = field.active_when.find(key + " ");
      if (at == std::string::npos || (at > 0 && field.active_when[at - 1] != ' ')) continue;
      const SourceMark& mark = entry.key_mark;
      if (mark.line > 0) places += ", and " + key + " is at " + mark.file + ":" + std::to_string(mark.line);
    }
    return places;
  }

  void check_unused() {
    check_mixed();
    for (const auto& [key, entry] : stated_.given) {
      const Field& field = *cycle::find_field(key);
      if (!cycle::belongs(field, case_) || is_out_of_scope(field)) continue;
      if (!use_is_known(field) || cycle::is_active(field, case_) || stated_.from_oil_file.contains(key)) continue;
      add(key, entry.key_mark, key + " is not used in this case",
          "it is used where " + field.active_when + places_of_conditions(field) + "; take it out (or add --set " + key +
              "= on the command line), or change that");
      faults_.back().used_where = field.active_when;
    }
  }

  /// Has either problem keys of its own there?
  static bool is_shared(const std::string& section) {
    return section == "lubricant" || section == "film" || section == "solver" || section == "contact" ||
           section == "thermal";
  }

  /// A case with keys of both problems: reported once a section that the case must not have at all, else for each key.
  void check_mixed() {
    using Given = std::pair<const std::string, KeyPlace>;
    std::map<std::string, const Given*> first;
    for (const Given& given : stated_.given) {
      if (cycle::belongs(*cycle::find_field(given.first), case_)) continue;
      const std::string section = section_of(given.first);
      const Given*& of_section = first[is_shared(section) ? given.first : section];
      const int line = given.second.key_mark.line;
      if (of_section == nullptr || line < of_section->second.key_mark.line) of_section = &given;
    }
    for (const auto& [what, given] : first) {
      add(given->first, given->second.key_mark, given->first + " is not used in this case",
          case_.problem == cycle::Problem::kPad
              ? "a case with [pad] is a film without engine, gas and ring: take " +
                    (what == given->first ? what : "[" + what + "]") + " out, or [pad]"
              : "it is used in a pad, a film without engine, gas and ring; take it out");
    }
  }

  void check_rules() {
    for (const cycle::RuleBreach& breach :
         is_for_gas_alone() ? cycle::broken_gas_rules(case_) : cycle::broken_rules(case_)) {
      if (!can_be_judged(breach)) continue;
      const auto found = stated_.given.find(breach.key);
      const SourceMark mark =
          found == stated_.given.end() ? SourceMark{stated_.path, 0, 0, ""} : found->second.value_mark;
      const std::string deletion = deletion_of(breach.ways);
      add(breach.key, mark, breach.message, breach.remedy + (deletion.empty() ? "" : "; " + deletion));
    }
  }

  /// Not where a key of the same section is wrong, or missing: what is there may be as it should be.
  bool can_be_judged(const cycle::RuleBreach& breach) const {
    const std::string section = section_of(breach.key);
    const auto of_section = [&section](const std::string& key) { return section_of(key) == section; };
    if (std::any_of(stated_.faulty.begin(), stated_.faulty.end(), of_section)) return false;
    if (breach.by == cycle::RuleBreach::By::kMissingKey) return true;
    return std::none_of(missing_.begin(), missing_.end(), of_section);
  }

  /// Which lines to delete so that one of several ways remains.
  std::string deletion_of(const std::vector<std::vector<std::string>>& ways) const {
    std::vector<std::vector<SourceMark>> places;
    for (const std::vector<std::string>& way : ways) {
      std::vector<SourceMark> of_way;
      for (const std::string& key : way) {
        const auto found = stated_.given.find(key);
        if (found == stated_.given.end()) return "";
        of_way.push_back(found->second.key_mark);
      }
      places.push_back(std::move(of_way));
    }
    return places.empty() ? "" : deletion_words(std::move(places));
  }

  const cycle::Case& case_;
  const StatedKeys& stated_;
  std::set<std::string> missing_;
  std::vector<KeyFault> faults_;
};

}  // namespace

std::vector<KeyFault> case_faults(const cycle::Case& c, const StatedKeys& stated) { return Checks(c, stated).faults(); }

}  // namespace ringfilm::io
