#include "ringfilm/io/case_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "ringfilm/cycle/case_fields.hpp"
#include "ringfilm/io/case_tree.hpp"
#include "ringfilm/io/case_values.hpp"
#include "ringfilm/io/face_file.hpp"
#include "ringfilm/io/oil_file.hpp"
#include "ringfilm/io/pad_file.hpp"
#include "ringfilm/io/trace_file.hpp"

namespace ringfilm::io {
namespace {

using cycle::Case;
using cycle::Field;

std::string section_of(const std::string& key) { return key.substr(0, key.find('.')); }

class Reader {
 public:
  Reader(CaseTree tree, const Units& units) : tree_(std::move(tree)), units_(units) {}

  Case read() {
    case_ = cycle::blank_case(problem());
    case_.files = tree_.files;
    case_.notes = tree_.notes;
    for (const TomlEntry& entry : tree_.entries) read_value(entry);
    read_data_files();
    if (tree_.complete) {
      check_missing();
      check_unused();
      check_rules();
    }
    if (!tree_.faults.empty()) {
      sort_faults();
      throw InputError(tree_.faults);
    }
    return std::move(case_);
  }

 private:
  /// A pad where any of its keys is stated, be it with a slip.
  cycle::Problem problem() const {
    const auto of_pad = [](const std::string& key) { return key.rfind("pad.", 0) == 0; };
    const bool stated = std::any_of(tree_.entries.begin(), tree_.entries.end(),
                                    [&](const TomlEntry& entry) { return of_pad(entry.key); });
    return stated || std::any_of(tree_.faulty.begin(), tree_.faulty.end(), of_pad) ? cycle::Problem::kPad
                                                                                   : cycle::Problem::kCycle;
  }

  void read_value(const TomlEntry& entry) {
    given_[entry.key] = &entry;
    case_.stated.insert(entry.key);
    if (!set_value(case_, *cycle::find_field(entry.key), entry, units_, tree_.faults)) tree_.faulty.insert(entry.key);
  }

  bool is_good(const std::string& key) const { return given_.contains(key) && !is_faulty(key); }

  bool is_faulty(const std::string& key) const {
    return std::any_of(tree_.faulty.begin(), tree_.faulty.end(), [&key](const std::string& faulty) {
      return key == faulty || (faulty.back() == '.' && key.rfind(faulty, 0) == 0);
    });
  }

  void read_data_files() {
    if (case_.problem == cycle::Problem::kPad) return read_pad_files();
    cycle::Gas& gas = case_.gas;
    const TraceColumns cylinder{gas.pressure_column,    gas.angle_column, gas.pressure_unit,    gas.angle_unit,
                                gas.pressure_reference, gas.angle_zero,   TracePlace::kCylinder};
    const TraceColumns crankcase{std::nullopt,           std::nullopt,   gas.pressure_unit,     gas.angle_unit,
                                 gas.pressure_reference, gas.angle_zero, TracePlace::kCrankcase};
    if (gas.model == cycle::GasModel::kTrace && is_good("gas.cylinder_pressure")) {
      read_data("gas.cylinder_pressure", gas.cylinder_pressure_file, [&](const NamedFile& file) {
        TraceFile trace = read_trace(file, cylinder, units_);
        gas.cylinder_pressure = std::move(trace.samples);
        return std::pair{trace.sha256, trace.notes};
      });
    }
    if (gas.crankcase_pressure_file && is_good("gas.crankcase_pressure")) {
      read_data("gas.crankcase_pressure", *gas.crankcase_pressure_file, [&](const NamedFile& file) {
        TraceFile trace = read_trace(file, crankcase, units_);
        gas.crankcase_trace = std::move(trace.samples);
        return std::pair{trace.sha256, trace.notes};
      });
    }
    cycle::RingFace& face = case_.ring.face;
    if (face.form == cycle::FaceForm::kPoints && is_good("ring.face.file")) {
      read_data("ring.face.file", face.points_file, [&](const NamedFile& file) {
        FaceFile points = read_face(file, units_);
        face.x = std::move(points.x);
        face.height = std::move(points.height);
        fit_to_width(face.x, case_.ring.face_width);
        return std::pair{points.sha256, points.notes};
      });
    }
    if (case_.lubricant.table_file && is_good("lubricant.table")) {
      read_data("lubricant.table", *case_.lubricant.table_file, [&](const NamedFile& file) {
        OilFile oil = read_oil_table(file, units_);
        case_.lubricant.table = std::move(oil.table);
        return std::pair{oil.sha256, oil.notes};
      });
    }
  }

  void read_pad_files() {
    cycle::Pad& pad = case_.pad;
    if (is_good("pad.gap")) {
      read_data("pad.gap", pad.gap_file, [&](const NamedFile& file) {
        GapFile gap = read_gap(file, units_);
        pad.gap_x = std::move(gap.x);
        pad.gap_y = std::move(gap.y);
        pad.gap_height = std::move(gap.height);
        fit_to_width(pad.gap_x, pad.length);
        if (pad.width) fit_to_width(pad.gap_y, *pad.width);
        return std::pair{gap.sha256, gap.notes};
      });
    }
    if (pad.separation_history_file && is_good("pad.separation_history")) {
      read_data("pad.separation_history", *pad.separation_history_file, [&](const NamedFile& file) {
        SeparationHistory history = read_separation_history(file, units_);
        pad.history_time = std::move(history.time);
        pad.history_separation = std::move(history.separation);
        return std::pair{history.sha256, history.notes};
      });
    }
  }

  /// `use` reads the file and returns its digest and notes.
  template <typename Use>
  void read_data(const std::string& key, const std::string& name, const Use& use) {
    try {
      const auto [sha256, notes] = use(locate(name, ""));
      case_.files.push_back({key, name, sha256});
      case_.notes.insert(case_.notes.end(), notes.begin(), notes.end());
    } catch (const InputError& error) {
      tree_.faulty.insert(key);
      for (const Fault& f : error.faults()) {
        const bool in_file = f.mark.line > 0;
        const SourceMark& named = given_.at(key)->value.mark;
        tree_.faults.push_back(in_file ? f : Fault{named, key + ": " + f.mark.file + ": " + f.message, f.remedy});
      }
    }
  }

  /// "1.2 mm" in one file and "1200 um" in another differ in the last bit: the last point is the edge.
  static void fit_to_width(std::vector<double>& x, double width) {
    if (!x.empty() && std::abs(x.back() - width) <= 1e-9 * width) x.back() = width;
    if (!x.empty() && std::abs(x.front()) <= 1e-9 * width) x.front() = 0;
  }

  /// Sections whose keys decide on each other's use.
  static std::string group_of(const std::string& key) {
    const std::string section = section_of(key);
    return section == "liner" || section == "contact" ? "ring" : section;
  }

  /// May the key `other` decide whether `field` is in use? A trace does for the pressures that join a partial one.
  static bool decides(const Field& other, const Field& field) {
    if (group_of(other.key) != group_of(field.key)) return false;
    if (std::holds_alternative<cycle::FileKind>(other.kind)) {
      return std::holds_alternative<cycle::OptionalNumberKind>(field.kind);
    }
    return std::holds_alternative<cycle::ChoiceKind>(other.kind) ||
           std::holds_alternative<cycle::NumberOrFileKind>(other.kind) || other.need == cycle::Need::kOptional;
  }

  /// Can it be told whether the key is in use? Not where a key that decides on it is wrong or missing.
  bool use_is_known(const Field& field) const {
    const auto& fields = cycle::case_fields();
    return field.active == nullptr || std::none_of(fields.begin(), fields.end(), [&](const Field& other) {
             return decides(other, field) && (is_faulty(other.key) || missing_.contains(other.key));
           });
  }

  void check_missing() {
    // Keys that are always wanted come first: where a choice among them is missing, no more can be said.
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
    if (!cycle::is_required(field, case_) || given_.contains(field.key) || is_faulty(field.key)) return;
    missing_.insert(field.key);
    const std::size_t dot = field.key.rfind('.');
    const bool top_level = dot == std::string::npos;
    const std::string name = top_level ? field.key : field.key.substr(dot + 1);
    tree_.faults.push_back({{tree_.path, 0, 0, ""},
                            "the key " + field.key + " is missing: " + field.help,
                            "write, for example, " + name + " = " + field.example +
                                (top_level ? " before the first section" : " in [" + field.key.substr(0, dot) + "]")});
  }

  void check_unused() {
    check_mixed();
    for (const auto& [key, entry] : given_) {
      const Field& field = *cycle::find_field(key);
      if (!cycle::belongs(field, case_)) continue;
      if (!use_is_known(field) || cycle::is_active(field, case_) || tree_.from_oil_file.contains(key)) continue;
      tree_.faults.push_back({entry->value.key_mark, key + " is not used in this case",
                              "it is used where " + field.active_when + "; take it out (or add --set " + key +
                                  "= on the command line), or change that"});
    }
  }

  /// A case with keys of both problems: told once a section.
  void check_mixed() {
    std::map<std::string, const TomlEntry*> first;
    for (const auto& [key, entry] : given_) {
      if (cycle::belongs(*cycle::find_field(key), case_)) continue;
      const TomlEntry*& of_section = first[section_of(key)];
      if (of_section == nullptr || entry->value.key_mark.line < of_section->value.key_mark.line) of_section = entry;
    }
    for (const auto& [section, entry] : first) {
      const bool whole_section = section != "lubricant" && section != "solver";
      tree_.faults.push_back({entry->value.key_mark, entry->key + " is not used in this case",
                              case_.problem == cycle::Problem::kPad
                                  ? "a case with [pad] is a film without engine, gas and ring: take " +
                                        (whole_section ? "[" + section + "]" : entry->key) + " out, or [pad]"
                                  : "it is used in a pad, a film without engine, gas and ring; take it out"});
    }
  }

  void check_rules() {
    for (const cycle::RuleBreach& breach : cycle::broken_rules(case_)) {
      const std::string section = section_of(breach.key);
      const auto of_section = [&section](const std::string& key) { return section_of(key) == section; };
      if (std::any_of(tree_.faulty.begin(), tree_.faulty.end(), of_section) ||
          std::any_of(missing_.begin(), missing_.end(), of_section)) {
        continue;
      }
      const auto found = given_.find(breach.key);
      const SourceMark mark = found == given_.end() ? SourceMark{tree_.path, 0, 0, ""} : found->second->value.mark;
      tree_.faults.push_back({mark, breach.message, breach.remedy});
    }
  }

  /// In the order in which a person meets them: file by file, from top to bottom, then what is missing.
  void sort_faults() {
    std::vector<std::string> order;
    for (const cycle::InputFile& file : case_.files) order.push_back(file.path);
    const auto rank = [&](const Fault& f) {
      const auto found = std::find(order.begin(), order.end(), f.mark.file);
      return std::tuple(f.mark.line == 0, found - order.begin(), f.mark.line, f.mark.column);
    };
    std::stable_sort(tree_.faults.begin(), tree_.faults.end(),
                     [&](const Fault& a, const Fault& b) { return rank(a) < rank(b); });
  }

  CaseTree tree_;
  const Units& units_;
  Case case_;
  std::map<std::string, const TomlEntry*> given_;
  std::set<std::string> missing_;
};

}  // namespace

cycle::Case read_case(const std::string& path, const std::vector<Override>& overrides) {
  return read_case(path, overrides, Units());
}

cycle::Case read_case(const std::string& path, const std::vector<Override>& overrides, const Units& units) {
  return Reader(read_case_tree(path, overrides), units).read();
}

}  // namespace ringfilm::io
