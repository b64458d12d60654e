#include "ringfilm/io/verification/verification_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/csv_file.hpp"
#include "ringfilm/io/text/csv_quantity.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/study/verification/manufactured.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

constexpr int kMostCount = 100000;  // far more cells or steps than anyone waits for
constexpr int kFewestCells = 2;     // one inner node
constexpr int kFewestLevels = 3;    // an order from two runs alone could not be seen to bend

/// One table of the file: hands out its keys, and refuses what nobody asked for.
class Table {
 public:
  Table(std::string kind, const TomlValue& value, const Units& units, std::vector<Fault>& faults)
      : kind_(std::move(kind)), value_(value), units_(units), faults_(faults) {}

  const TomlValue* find(const std::string& key) {
    asked_.insert(key);
    for (const auto& [name, value] : value_.members) {
      if (name == key) return &value;
    }
    return nullptr;
  }

  const TomlValue* need(const std::string& key) {
    const TomlValue* found = find(key);
    if (found == nullptr) faults_.push_back({value_.mark, kind_ + "." + key + " is missing", ""});
    return found;
  }

  std::string text(const std::string& key) {
    const TomlValue* found = need(key);
    return found == nullptr ? "" : text_of(key, *found);
  }

  std::string text_of(const std::string& key, const TomlValue& value) {
    if (value.kind == TomlValue::Kind::kText && !value.text.empty()) return value.text;
    refuse(key, value, "is not a text");
    return "";
  }

  std::vector<std::string> texts(const std::string& key) {
    std::vector<std::string> list;
    const TomlValue* found = need(key);
    if (found == nullptr) return list;
    if (found->kind != TomlValue::Kind::kList) refuse(key, *found, "is not a list");
    for (const TomlValue& item : found->items) list.push_back(text_of(key, item));
    return list;
  }

  /// In SI: a bare number where `si_unit` is 1, else a text with its unit.
  double number_of(const std::string& key, const TomlValue& value, const std::string& si_unit) {
    const bool is_number = value.kind == TomlValue::Kind::kNumber || value.kind == TomlValue::Kind::kInteger;
    if (is_number && si_unit == "1" && std::isfinite(value.number)) return value.number;
    try {
      if (value.kind == TomlValue::Kind::kText && si_unit != "1") {
        return units_.quantity(value.text, si_unit, "1.5 " + si_unit);
      }
    } catch (const UnitError& problem) {
      refuse(key, value, problem.what(), problem.remedy);
      return 0;
    }
    refuse(key, value, si_unit == "1" ? "is not a number" : "has no unit",
           si_unit == "1" ? "" : "a text such as \"1.5 " + si_unit + "\" is required here");
    return 0;
  }

  double number(const std::string& key, const std::string& si_unit) {
    const TomlValue* found = need(key);
    return found == nullptr ? 0 : number_of(key, *found, si_unit);
  }

  std::vector<double> numbers(const std::string& key, const std::string& si_unit) {
    std::vector<double> list;
    const TomlValue* found = need(key);
    if (found == nullptr) return list;
    if (found->kind != TomlValue::Kind::kList) refuse(key, *found, "is not a list");
    for (const TomlValue& item : found->items) list.push_back(number_of(key, item, si_unit));
    return list;
  }

  /// A whole number from `fewest` on.
  int count_of(const std::string& key, const TomlValue& value, int fewest) {
    const double number = value.kind == TomlValue::Kind::kInteger ? value.number : 0;
    if (number >= fewest && number <= kMostCount) return static_cast<int>(number);
    refuse(key, value, "is not a count", "a whole number from " + std::to_string(fewest) + " on is required here");
    return fewest;
  }

  int count(const std::string& key, int fewest) {
    const TomlValue* found = need(key);
    return found == nullptr ? fewest : count_of(key, *found, fewest);
  }

  std::vector<double> counts(const std::string& key, int fewest) {
    std::vector<double> list;
    const TomlValue* found = need(key);
    if (found == nullptr) return list;
    if (found->kind != TomlValue::Kind::kList) refuse(key, *found, "is not a list");
    for (const TomlValue& item : found->items) list.push_back(count_of(key, item, fewest));
    return list;
  }

  study::Tolerance tolerance(const std::string& si_unit) {
    const TomlValue* relative = find("relative_tolerance");
    const TomlValue* absolute = find("absolute_tolerance");
    if ((relative == nullptr) == (absolute == nullptr)) {
      faults_.push_back({value_.mark, kind_ + " needs one of relative_tolerance and absolute_tolerance", ""});
      return {};
    }
    if (relative != nullptr) {
      return {study::Tolerance::Kind::kRelative, number_of("relative_tolerance", *relative, "1")};
    }
    return {study::Tolerance::Kind::kAbsolute, number_of("absolute_tolerance", *absolute, si_unit)};
  }

  void read(study::Check& check) {
    check.label = text("label");
    check.source = text("source");
    check.because = text("because");
  }

  /// The unit of the quantity that the table names; 1 where it names none that exists.
  std::string unit_of(const std::string& quantity) { return unit_of(quantity, study::find_measured(quantity)); }

  /// The same of a curve over crank angle.
  std::string unit_of_curve(const std::string& quantity) { return unit_of(quantity, study::find_curve(quantity)); }

  std::string unit_of(const std::string& quantity, const std::optional<cycle::Quantity>& found) {
    if (found) return found->unit;
    if (quantity.empty()) return "1";
    std::vector<std::string> names;
    for (const auto& known : study::measured_quantities()) names.push_back(known.name);
    const std::string nearest = nearest_word(quantity, names);
    refuse("quantity", "is not a quantity of a pad or a ring", nearest.empty() ? "" : "did you mean " + nearest + "?");
    return "1";
  }

  study::Probe probe() {
    study::Probe probe{text("quantity"), std::nullopt};
    if (const TomlValue* time = find("time")) probe.time = number_of("time", *time, "s");
    return probe;
  }

  void refuse(const std::string& key, const TomlValue& value, const std::string& predicate,
              const std::string& remedy = "") {
    faults_.push_back({value.mark, kind_ + "." + key + " = " + value.as_written() + " " + predicate, remedy});
  }

  /// The same for the value of a key; where that is missing, this has been reported.
  void refuse(const std::string& key, const std::string& predicate, const std::string& remedy = "") {
    if (const TomlValue* value = find(key)) refuse(key, *value, predicate, remedy);
  }

  void refuse_the_rest() {
    const std::vector<std::string> known(asked_.begin(), asked_.end());
    for (const auto& [name, value] : value_.members) {
      if (asked_.count(name) != 0) continue;
      const std::string nearest = nearest_word(name, known);
      faults_.push_back({value.key_mark, "unknown key " + kind_ + "." + name,
                         nearest.empty() ? "" : "did you mean " + kind_ + "." + nearest + "?"});
    }
  }

 private:
  std::string kind_;
  const TomlValue& value_;
  const Units& units_;
  std::vector<Fault>& faults_;
  std::set<std::string> asked_;
};

class VerificationReader {
 public:
  VerificationReader(const fs::path& folder, const Units& units) : folder_(folder), units_(units) {
    verification_.name = folder.filename().string();
  }

  study::Verification read() {
    read_claim();
    const fs::path path = folder_ / "reference.toml";
    const TomlValue root = parse_toml(read_source_text(path.string(), path.string(), kLargestToml));
    for (const auto& [name, tables] : root.members) {
      if (tables.kind != TomlValue::Kind::kList) {
        faults_.push_back({tables.key_mark, "unknown key " + name, kTables});
        continue;
      }
      for (const TomlValue& value : tables.items) {
        Table table(name, value, units_, faults_);
        if (name == "run") {
          read_run(table);
        } else if (name == "value") {
          read_value(table);
        } else if (name == "order") {
          read_order(table);
        } else if (name == "bound") {
          read_bound(table);
        } else if (name == "optimum") {
          read_optimum(table);
        } else if (name == "curve") {
          read_curve(table);
        } else if (name == "wear") {
          read_wear(table);
        } else if (name == "contact") {
          read_contact(table);
        } else {
          faults_.push_back({tables.key_mark, "unknown table [[" + name + "]]", kTables});
          break;
        }
        table.refuse_the_rest();
      }
    }
    if (!faults_.empty()) throw InputError(std::move(faults_));
    for (auto& [name, c] : verification_.runs) {
      const auto named = named_.find(name);
      const CasePurpose purpose = of_gas_.contains(name) ? CasePurpose::kGasPath : CasePurpose::kFilm;
      const bool is_file = named == named_.end();
      c = read_case((folder_ / (is_file ? name : named->second.path)).string(),
                    is_file ? std::vector<Override>{} : named->second.overrides, units_, purpose);
      if (purpose == CasePurpose::kFilm && c.is_pack()) refuse_pack(name, c.rings.size());
    }
    check_times();
    if (!faults_.empty()) throw InputError(std::move(faults_));
    return std::move(verification_);
  }

 private:
  static constexpr const char* kTables =
      "tables are [[run]], [[value]], [[order]], [[bound]], [[optimum]], [[curve]], [[wear]] and [[contact]]";

  /// Heading and first paragraph of the README.
  void read_claim() {
    const fs::path path = folder_ / "README.md";
    for (const std::string& line : read_source_text(path.string(), path.string(), kLargestToml).lines) {
      if (verification_.title.empty()) {
        const std::size_t start = line.find_first_not_of("# ");
        if (start != std::string::npos) verification_.title = line.substr(start);
      } else if (!line.empty()) {
        verification_.claim += (verification_.claim.empty() ? "" : " ") + line;
      } else if (!verification_.claim.empty()) {
        return;
      }
    }
  }

  /// A case under a name of its own, with some of its keys replaced.
  void read_run(Table& table) {
    const std::string name = table.text("name");
    NamedRun run{table.text("case"), {}};
    for (const std::string& setting : table.texts("set")) {
      const std::size_t equal_sign = setting.find('=');
      if (equal_sign == std::string::npos) {
        table.refuse("set", "holds no key=value", "for example \"solver.crank_step_control=fixed\"");
      } else {
        run.overrides.push_back({setting.substr(0, equal_sign), setting.substr(equal_sign + 1)});
      }
    }
    if (!fs::is_regular_file(folder_ / run.path)) table.refuse("case", "is not a file");
    named_[name] = std::move(run);
  }

  /// Notes that a check needs this run: the name of a [[run]] further up, or a case file of the folder.
  std::string run(Table& table, const std::string& name, const std::string& key = "case") {
    if (name.empty()) return name;
    if (named_.count(name) == 0 && !fs::is_regular_file(folder_ / name)) {
      table.refuse(key, "names " + name + ", which is not a file of this folder and no [[run]] above");
    } else {
      verification_.runs[name];
    }
    return name;
  }

  void read_value(Table& table) {
    study::ValueCheck check;
    table.read(check);
    check.run = run(table, table.text("case"));
    check.probe = table.probe();
    if (study::is_of_gas(check.probe.quantity)) of_gas_.insert(check.run);
    note_time(table, check.run, check.probe);
    const std::string unit = table.unit_of(check.probe.quantity);
    check.expected = table.number("expected", unit);
    check.tolerance = table.tolerance(unit);
    verification_.values.push_back(std::move(check));
  }

  void read_order(Table& table) {
    study::OrderCheck check;
    table.read(check);
    if (const TomlValue* film = table.find("manufactured")) {
      check.manufactured = table.text_of("manufactured", *film);
      const auto& known = study::manufactured_films();
      if (std::find(known.begin(), known.end(), check.manufactured) == known.end()) {
        table.refuse("manufactured", *film, "is not a manufactured film",
                     fmt::format("one of: {}", fmt::join(known, ", ")));
      }
    } else {
      check.run = run(table, table.text("case"));
      check.probe = table.probe();
      note_time(table, check.run, check.probe);
      check.exact = table.number("expected", table.unit_of(check.probe.quantity));
    }
    read_levels(table, check);
    check.order = table.number("order", "1");
    check.tolerance = table.number("absolute_tolerance", "1");
    verification_.orders.push_back(std::move(check));
  }

  void read_levels(Table& table, study::OrderCheck& check) {
    const bool is_run = check.manufactured.empty();
    const char* const steps = is_run ? "time_steps" : "steps";
    const TomlValue* in_time = table.find(steps);
    if (in_time != nullptr) {
      check.refinement = study::Refinement::kTimeStep;
      check.levels = is_run ? table.numbers(steps, "s") : table.counts(steps, 1);
      // A run has cells of its own, a manufactured film has none.
      const TomlValue* cells = is_run ? table.find("cells") : table.need("cells");
      if (cells != nullptr) check.cells = table.count_of("cells", *cells, kFewestCells);
    } else {
      check.levels = table.counts("cells", kFewestCells);
    }
    const bool positive = std::all_of(check.levels.begin(), check.levels.end(), [](double level) { return level > 0; });
    if (static_cast<int>(check.levels.size()) < kFewestLevels || !positive) {
      table.refuse(in_time == nullptr ? "cells" : steps, "is not a ladder",
                   "three positive numbers or more are required");
    }
  }

  void read_bound(Table& table) {
    study::BoundCheck check;
    table.read(check);
    check.run = run(table, table.text("case"));
    check.probe = table.probe();
    note_time(table, check.run, check.probe);
    if (table.unit_of(check.probe.quantity) != "m") {
      table.refuse("quantity", "is not a length, which could be counted in cells", "a front, or peak_position");
    }
    check.exact = table.number("expected", "m");
    check.fewest_cells = table.count("fewest_cells", kFewestCells);
    check.most_cells = table.count("most_cells", check.fewest_cells);
    check.most = table.number("absolute_tolerance", "1");
    verification_.bounds.push_back(std::move(check));
  }

  void read_optimum(Table& table) {
    study::OptimumCheck check;
    table.read(check);
    for (const std::string& name : table.texts("cases")) check.runs.push_back(run(table, name, "cases"));
    check.parameters = table.numbers("parameters", "1");
    if (check.runs.size() != 3 || check.parameters.size() != 3) {
      table.refuse("cases", "and the parameters must be three each");
    }
    check.probe = table.probe();
    table.unit_of(check.probe.quantity);
    check.expected = table.number("expected", "1");
    check.tolerance = table.tolerance("1");
    verification_.optima.push_back(std::move(check));
  }

  void read_curve(Table& table) {
    study::CurveCheck check;
    table.read(check);
    check.run = run(table, table.text("case"));
    check.quantity = table.text("quantity");
    const std::string unit = table.unit_of_curve(check.quantity);
    check.tolerance = table.tolerance(unit);
    if (const TomlValue* zone = table.find("dead_centre_zone")) {
      const double reach_deg = table.number_of("dead_centre_zone", *zone, "degree");
      const std::string kind_unit = check.tolerance.kind == study::Tolerance::Kind::kRelative ? "1" : unit;
      check.dead_centre_zone = {reach_deg, table.number("dead_centre_tolerance", kind_unit)};
    }
    read_samples(table, unit, check);
    verification_.curves.push_back(std::move(check));
  }

  void read_wear(Table& table) {
    study::WearCheck check;
    table.read(check);
    study::DryWear& dry = check.profile;
    const auto& profiles = study::dry_wear_profiles();
    dry.profile = table.text("profile");
    if (std::find(profiles.begin(), profiles.end(), dry.profile) == profiles.end()) {
      table.refuse("profile", "is not a profile", fmt::format("one of: {}", fmt::join(profiles, ", ")));
    }
    if (dry.profile == "parabola") dry.shape = table.number("radius", "m");
    if (dry.profile == "roof") dry.shape = table.number("slope", "1");
    if (dry.profile == "wave") dry.shape = table.number("amplitude", "m");
    dry.cells = table.count("cells", kFewestCells);
    dry.roughness = table.number("roughness", "m");
    dry.width = table.number("width", "m");
    dry.load = table.number("load", "N/m");
    dry.coefficient = table.number("coefficient", "m2/N");
    dry.sliding = table.number("sliding", "m");
    dry.largest_depth = table.number("largest_depth", "m");
    check.quantity = table.text("quantity");
    std::string unit = "1";
    std::vector<std::string> names;
    for (const cycle::Quantity& known : study::dry_wear_quantities()) {
      names.push_back(known.name);
      if (known.name == check.quantity) unit = known.unit;
    }
    if (std::find(names.begin(), names.end(), check.quantity) == names.end()) {
      table.refuse("quantity", "is not a quantity of wear", fmt::format("one of: {}", fmt::join(names, ", ")));
    }
    check.expected = table.number("expected", unit);
    check.tolerance = table.tolerance(unit);
    verification_.wear.push_back(std::move(check));
  }

  void read_contact(Table& table) {
    study::ContactCheck check;
    table.read(check);
    study::ContactForm& form = check.form;
    const auto& surfaces = study::contact_surfaces();
    form.surface = table.text("surface");
    if (std::find(surfaces.begin(), surfaces.end(), form.surface) == surfaces.end()) {
      table.refuse("surface", "is not a surface", fmt::format("one of: {}", fmt::join(surfaces, ", ")));
    }
    const auto number = [&](const char* key) { return table.find(key) != nullptr ? table.number(key, "1") : 0.0; };
    form.separation = number("separation");
    form.hardness = number("hardness");
    form.size = number("size");
    check.quantity = table.text("quantity");
    const auto& known = study::contact_form_quantities();
    if (std::none_of(known.begin(), known.end(), [&](const auto& one) { return one.name == check.quantity; })) {
      table.refuse("quantity", "is not a quantity of such a surface");
    }
    check.expected = table.number("expected", "1");
    if (table.find("levels") != nullptr) {
      check.levels = table.counts("levels", kFewestCells);
      check.order = table.number("order", "1");
    } else if (form.surface != "persson") {
      form.points = table.count("points", kFewestCells);
    }
    check.tolerance = table.tolerance("1");
    verification_.contact.push_back(std::move(check));
  }

  void read_samples(Table& table, const std::string& unit, study::CurveCheck& check) {
    const std::string name = table.text("file");
    const std::string angles = table.text("angle_column"), values = table.text("column");
    if (name.empty()) return;
    const std::string path = (folder_ / name).string();
    const CsvFile csv = read_csv({path, path}, NaN::kKept);
    const auto column = [&](const char* key, const std::string& requested, const std::string& si_unit) {
      const auto found = csv.find(requested);
      if (!found && !requested.empty()) table.refuse(key, "is not a column of " + name, "there are " + csv.names());
      return found ? samples(csv, *found, si_unit) : std::vector<double>{};
    };
    check.crank_angle_deg = column("angle_column", angles, "degree");
    check.expected = column("column", values, unit);
  }

  /// A column in the unit of its header, in SI or degrees where it has none. Other columns may hold what is not a
  /// number.
  std::vector<double> samples(const CsvFile& csv, std::size_t i_column, const std::string& si_unit) {
    const CsvColumn& column = csv.columns[i_column];
    for (std::size_t i = 0; i < column.values.size(); ++i) {
      if (!std::isnan(column.values[i])) continue;
      faults_.push_back({csv.cell_mark(i, i_column), "nan is not a finite number", "a check needs a number here"});
      return {};
    }
    return column.unit ? quantity_column(csv, column.name, si_unit, column.name + " [" + si_unit + "]", units_, faults_)
                       : column.values;
  }

  void refuse_pack(const std::string& run, std::size_t rings) {
    faults_.push_back({{(folder_ / "reference.toml").string(), 0, 0, ""},
                       fmt::format("{} is a pack of {} rings, of which a check has no single value", run, rings),
                       "name a case of one ring, or ask for a quantity of the gas, such as blow_by_per_cycle"});
  }

  /// Records that the run must reach the time of a probe, until its case is read.
  void note_time(Table& table, const std::string& run, const study::Probe& probe) {
    const TomlValue* time = table.find("time");
    if (time != nullptr && !run.empty()) times_.push_back({run, probe.time.value_or(0), *time});
  }

  void check_times() {
    for (const auto& [run, time, written] : times_) {
      const cycle::Case& c = verification_.runs.at(run);
      const std::string stated = "time = " + written.as_written() + " ";
      if (c.problem != cycle::Problem::kPad || !c.pad.is_transient()) {
        faults_.push_back({written.mark, stated + "is asked of " + run + ", which has no history", "leave it out"});
      } else if (time < c.pad.first_time() || time > c.pad.last_time()) {
        faults_.push_back({written.mark, stated + "is outside the history of " + run, "ask for a time within it"});
      }
    }
  }

  struct NamedRun {
    std::string path;
    std::vector<Override> overrides;
  };

  struct AskedTime {
    std::string run;
    double time;  ///< [s]
    TomlValue written;
  };

  fs::path folder_;
  std::map<std::string, NamedRun> named_;
  std::set<std::string> of_gas_;  ///< runs of which the gas alone is computed
  std::vector<AskedTime> times_;
  const Units& units_;
  std::vector<Fault> faults_;
  study::Verification verification_;
};

}  // namespace

study::Verification read_verification(const std::string& folder, const Units& units) {
  return VerificationReader(folder, units).read();
}

std::vector<std::string> verification_folders() {
  const fs::path all = fs::path(shipped_folder()) / "verification";
  std::vector<std::string> folders;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(all, error)) {
    if (fs::is_directory(entry.path())) folders.push_back(entry.path().string());
  }
  if (folders.empty()) {
    throw InputError(all.string() + ": no verification is here", "the folder is shipped with cases/ and data/");
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::vector<study::NotCovered> read_not_covered(const std::string& path, const Units& units) {
  const TomlValue root = parse_toml(read_source_text(path, path, kLargestToml));
  std::vector<Fault> faults;
  std::vector<study::NotCovered> all;
  for (const auto& [name, tables] : root.members) {
    if (name != "not_covered" || tables.kind != TomlValue::Kind::kList) {
      faults.push_back({tables.key_mark, "unknown key " + name, "tables are [[not_covered]]"});
      continue;
    }
    for (const TomlValue& value : tables.items) {
      Table table(name, value, units, faults);
      const std::string what = table.text("what");
      all.push_back({what, table.text("reason")});
      table.refuse_the_rest();
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return all;
}

}  // namespace ringfilm::io
