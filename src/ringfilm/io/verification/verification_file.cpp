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
#include "ringfilm/io/table/csv_file.hpp"
#include "ringfilm/io/table/csv_quantity.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_table.hpp"
#include "ringfilm/study/verification/manufactured.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxCount = 100000;  // far more cells or steps than anyone waits for
constexpr int kMinCells = 2;                 // one inner node
constexpr int kMinLevels = 3;                // an order from two runs alone could not be seen to bend

std::vector<std::string> names_of(const std::vector<cycle::Quantity>& quantities) {
  std::vector<std::string> names;
  for (const cycle::Quantity& one : quantities) names.push_back(one.name);
  return names;
}

/// A table of the file. What is required of it and missing or wrong is reported, and read as 0.
class CheckTable : public TomlTable {
 public:
  CheckTable(const std::string& kind, const TomlValue& table, const Units& units, std::vector<Fault>& faults)
      : TomlTable(table, "[[" + kind + "]]", faults), units_(units) {}

  /// One of `names`.
  std::string needed_word(const std::string& key, const std::vector<std::string>& names) {
    const std::string word = needed_text(key);
    if (!word.empty() && std::ranges::find(names, word) == names.end()) refuse_word(key, word, names);
    return word;
  }

  std::vector<std::string> needed_texts(const std::string& key) {
    need(key);
    return texts(key);
  }

  double needed_number(const std::string& key, const std::string& si_unit) {
    const TomlValue* value = need(key);
    return value == nullptr ? 0 : number_of(key, *value, si_unit);
  }

  std::vector<double> needed_numbers(const std::string& key, const std::string& si_unit) {
    need(key);
    std::vector<double> list;
    for (const TomlValue& item : items(key)) list.push_back(number_of(key, item, si_unit));
    return list;
  }

  int needed_count(const std::string& key, int fewest) {
    const TomlValue* value = need(key);
    return value == nullptr ? fewest : count_of(key, *value, fewest);
  }

  std::vector<double> needed_counts(const std::string& key, int fewest) {
    need(key);
    std::vector<double> list;
    for (const TomlValue& item : items(key)) list.push_back(count_of(key, item, fewest));
    return list;
  }

  study::Tolerance tolerance(const std::string& si_unit) {
    const bool is_relative = find("relative_tolerance") != nullptr;
    if (is_relative == (find("absolute_tolerance") != nullptr)) {
      refuse(mark(), name() + " needs one of relative_tolerance and absolute_tolerance", "");
      return {};
    }
    if (is_relative) return {study::Tolerance::Kind::kRelative, needed_number("relative_tolerance", "1")};
    return {study::Tolerance::Kind::kAbsolute, needed_number("absolute_tolerance", si_unit)};
  }

  void read(study::Check& check) {
    check.label = needed_text("label");
    check.source = needed_text("source");
    check.because = needed_text("because");
  }

  /// The unit of the quantity that the table names; 1 where it names none that exists.
  std::string unit_of(const std::string& quantity) { return unit_of(quantity, study::find_measured(quantity)); }

  /// The unit of the curve over crank angle that the table names; 1 where it names none that exists.
  std::string unit_of_curve(const std::string& quantity) { return unit_of(quantity, study::find_curve(quantity)); }

  study::Probe probe() {
    study::Probe probe{needed_text("quantity"), std::nullopt};
    if (find("time") != nullptr) probe.time = needed_number("time", "s");
    return probe;
  }

 private:
  double number_of(const std::string& key, const TomlValue& value, const std::string& si_unit) {
    return quantity(key, value, si_unit, si_unit == "1" ? "1.5" : "\"1.5 " + si_unit + "\"", units_).value_or(0);
  }

  int count_of(const std::string& key, const TomlValue& value, int fewest) {
    const auto least = static_cast<std::uint64_t>(fewest);
    return static_cast<int>(count(key, value, least, kMaxCount).value_or(least));
  }

  std::string unit_of(const std::string& quantity, const std::optional<cycle::Quantity>& found) {
    if (found) return found->unit;
    if (!quantity.empty()) {
      refuse_value("quantity", "is not a quantity of a pad or a ring" +
                                   did_you_mean(quantity, names_of(study::measured_quantities())));
    }
    return "1";
  }

  const Units& units_;
};

class VerificationReader {
 public:
  VerificationReader(const fs::path& folder, const Units& units) : folder_(folder), units_(units) {
    verification_.name = folder.filename().string();
  }

  study::Verification read() {
    read_claim();
    const fs::path path = folder_ / "reference.toml";
    const TomlValue root = parse_toml(read_source_text(path.string(), path.string(), kMaxToml));
    for (const auto& [name, tables] : root.members) {
      const auto reader = readers().find(name);
      const bool is_list = tables.kind == TomlValue::Kind::kList;
      if (!is_list || reader == readers().end()) {
        faults_.push_back({tables.key_mark, is_list ? "unknown table [[" + name + "]]" : "unknown key " + name,
                           "tables are [[run]], [[value]], [[order]], [[bound]], [[optimum]], [[curve]], [[wear]], "
                           "[[contact]] and [[evaporation]]"});
        continue;
      }
      for (const TomlValue& value : tables.items) {
        CheckTable table(name, value, units_, faults_);
        (this->*reader->second)(table);
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
  using Read = void (VerificationReader::*)(CheckTable&);

  /// What reads the tables of each name.
  static const std::map<std::string, Read>& readers() {
    static const std::map<std::string, Read> all = {{"run", &VerificationReader::read_run},
                                                    {"value", &VerificationReader::read_value},
                                                    {"order", &VerificationReader::read_order},
                                                    {"bound", &VerificationReader::read_bound},
                                                    {"optimum", &VerificationReader::read_optimum},
                                                    {"curve", &VerificationReader::read_curve},
                                                    {"wear", &VerificationReader::read_wear},
                                                    {"contact", &VerificationReader::read_contact},
                                                    {"evaporation", &VerificationReader::read_evaporation}};
    return all;
  }

  /// Heading and first paragraph of the README.
  void read_claim() {
    const fs::path path = folder_ / "README.md";
    for (const std::string& line : read_source_text(path.string(), path.string(), kMaxToml).lines) {
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
  void read_run(CheckTable& table) {
    const std::string name = table.needed_text("name");
    NamedRun run{table.needed_text("case"), {}};
    for (const std::string& setting : table.needed_texts("set")) {
      const std::size_t equal_sign = setting.find('=');
      if (equal_sign == std::string::npos) {
        table.refuse_value("set", "holds no key=value", "for example \"solver.crank_step_control=fixed\"");
      } else {
        run.overrides.push_back({setting.substr(0, equal_sign), setting.substr(equal_sign + 1)});
      }
    }
    if (!fs::is_regular_file(folder_ / run.path)) table.refuse_value("case", "is not a file");
    named_[name] = std::move(run);
  }

  /// Notes that a check needs this run: the name of a [[run]] further up, or a case file of the folder.
  std::string run(CheckTable& table, const std::string& name, const std::string& key = "case") {
    if (name.empty()) return name;
    if (named_.count(name) == 0 && !fs::is_regular_file(folder_ / name)) {
      table.refuse_value(key, "names " + name + ", which is not a file of this folder and no [[run]] above");
    } else {
      verification_.runs[name];
    }
    return name;
  }

  void read_value(CheckTable& table) {
    study::ValueCheck check;
    table.read(check);
    read_probe(table, check);
    if (study::is_of_gas(check.probe.quantity)) of_gas_.insert(check.run);
    const std::string unit = table.unit_of(check.probe.quantity);
    check.expected = table.needed_number("expected", unit);
    check.tolerance = table.tolerance(unit);
    verification_.values.push_back(std::move(check));
  }

  void read_order(CheckTable& table) {
    study::OrderCheck check;
    table.read(check);
    if (table.find("manufactured") != nullptr) {
      check.manufactured = table.needed_word("manufactured", study::manufactured_films());
    } else {
      read_probe(table, check);
      check.exact = table.needed_number("expected", table.unit_of(check.probe.quantity));
    }
    read_levels(table, check);
    check.order = table.needed_number("order", "1");
    check.tolerance = table.needed_number("absolute_tolerance", "1");
    verification_.orders.push_back(std::move(check));
  }

  void read_levels(CheckTable& table, study::OrderCheck& check) {
    const bool is_run = check.manufactured.empty();
    const char* const steps = is_run ? "time_steps" : "steps";
    const bool is_in_time = table.find(steps) != nullptr;
    if (is_in_time) {
      check.refinement = study::Refinement::kTimeStep;
      check.levels = is_run ? table.needed_numbers(steps, "s") : table.needed_counts(steps, 1);
      // A run has cells of its own, a manufactured film has none.
      if (!is_run || table.find("cells") != nullptr) check.cells = table.needed_count("cells", kMinCells);
    } else {
      check.levels = table.needed_counts("cells", kMinCells);
    }
    const bool positive = std::all_of(check.levels.begin(), check.levels.end(), [](double level) { return level > 0; });
    if (static_cast<int>(check.levels.size()) < kMinLevels || !positive) {
      table.refuse_value(is_in_time ? steps : "cells", "is not a ladder",
                         "three positive numbers or more are required");
    }
  }

  void read_bound(CheckTable& table) {
    study::BoundCheck check;
    table.read(check);
    read_probe(table, check);
    if (table.unit_of(check.probe.quantity) != "m") {
      table.refuse_value("quantity", "is not a length, which could be counted in cells", "a front, or peak_position");
    }
    check.exact = table.needed_number("expected", "m");
    check.fewest_cells = table.needed_count("fewest_cells", kMinCells);
    check.most_cells = table.needed_count("most_cells", check.fewest_cells);
    check.most = table.needed_number("absolute_tolerance", "1");
    verification_.bounds.push_back(std::move(check));
  }

  void read_optimum(CheckTable& table) {
    study::OptimumCheck check;
    table.read(check);
    for (const std::string& name : table.needed_texts("cases")) check.runs.push_back(run(table, name, "cases"));
    check.parameters = table.needed_numbers("parameters", "1");
    if (check.runs.size() != 3 || check.parameters.size() != 3) {
      table.refuse_value("cases", "and the parameters must be three each");
    }
    check.probe = table.probe();
    table.unit_of(check.probe.quantity);
    check.expected = table.needed_number("expected", "1");
    check.tolerance = table.tolerance("1");
    verification_.optima.push_back(std::move(check));
  }

  void read_curve(CheckTable& table) {
    study::CurveCheck check;
    table.read(check);
    check.run = run(table, table.needed_text("case"));
    check.quantity = table.needed_text("quantity");
    const std::string unit = table.unit_of_curve(check.quantity);
    check.tolerance = table.tolerance(unit);
    if (table.find("dead_centre_zone") != nullptr) {
      const double reach_deg = table.needed_number("dead_centre_zone", "degree");
      const std::string kind_unit = check.tolerance.kind == study::Tolerance::Kind::kRelative ? "1" : unit;
      check.dead_centre_zone = {reach_deg, table.needed_number("dead_centre_tolerance", kind_unit)};
    }
    read_samples(table, unit, check);
    verification_.curves.push_back(std::move(check));
  }

  void read_wear(CheckTable& table) {
    study::WearCheck check;
    table.read(check);
    study::DryWear& dry = check.profile;
    dry.profile = table.needed_word("profile", study::dry_wear_profiles());
    if (dry.profile == "parabola") dry.shape = table.needed_number("radius", "m");
    if (dry.profile == "roof") dry.shape = table.needed_number("slope", "1");
    if (dry.profile == "wave") dry.shape = table.needed_number("amplitude", "m");
    dry.cells = table.needed_count("cells", kMinCells);
    dry.roughness = table.needed_number("roughness", "m");
    dry.width = table.needed_number("width", "m");
    dry.load = table.needed_number("load", "N/m");
    dry.coefficient = table.needed_number("coefficient", "m2/N");
    dry.sliding = table.needed_number("sliding", "m");
    dry.largest_depth = table.needed_number("largest_depth", "m");
    const std::vector<cycle::Quantity>& known = study::dry_wear_quantities();
    check.quantity = table.needed_word("quantity", names_of(known));
    const auto quantity = std::ranges::find(known, check.quantity, &cycle::Quantity::name);
    const std::string unit = quantity == known.end() ? "1" : quantity->unit;
    check.expected = table.needed_number("expected", unit);
    check.tolerance = table.tolerance(unit);
    verification_.wear.push_back(std::move(check));
  }

  void read_contact(CheckTable& table) {
    study::ContactCheck check;
    table.read(check);
    study::ContactForm& form = check.form;
    form.surface = table.needed_word("surface", study::contact_surfaces());
    const auto number = [&](const char* key) {
      return table.find(key) != nullptr ? table.needed_number(key, "1") : 0.0;
    };
    form.separation = number("separation");
    form.hardness = number("hardness");
    form.size = number("size");
    check.quantity = table.needed_word("quantity", names_of(study::contact_form_quantities()));
    check.expected = table.needed_number("expected", "1");
    if (table.find("levels") != nullptr) {
      check.levels = table.needed_counts("levels", kMinCells);
      check.order = table.needed_number("order", "1");
    } else if (form.surface != "persson") {
      form.points = table.needed_count("points", kMinCells);
    }
    check.tolerance = table.tolerance("1");
    verification_.contact.push_back(std::move(check));
  }

  void read_evaporation(CheckTable& table) {
    study::EvaporationCheck check;
    table.read(check);
    study::EvaporationForm& form = check.form;
    const std::vector<cycle::Quantity>& known = study::evaporation_quantities();
    check.quantity = table.needed_word("quantity", names_of(known));
    const auto number = [&](const char* key, const char* unit, double& value) {
      if (table.find(key) != nullptr) value = table.needed_number(key, unit);
    };
    number("temperature", "K", form.temperature);
    if (study::is_of_heat_transfer(check.quantity)) {
      form.bore = table.needed_number("bore", "m");
      form.pressure = table.needed_number("pressure", "Pa");
      form.velocity = table.needed_number("velocity", "m/s");
    } else {
      number("mass_transfer_coefficient", "m/s", form.mass_transfer_coefficient);
      number("mass", "kg/m2", form.mass);
      number("time", "s", form.time);
      read_fractions(table, form.fractions);
    }
    const auto quantity = std::ranges::find(known, check.quantity, &cycle::Quantity::name);
    const std::string unit = quantity == known.end() ? "1" : quantity->unit;
    check.expected = table.needed_number("expected", unit);
    check.tolerance = table.tolerance(unit);
    verification_.evaporation.push_back(std::move(check));
  }

  /// Boiling points, with shares of the mass (1 of one fraction) and molar masses where they are stated.
  static void read_fractions(CheckTable& table, std::vector<models::OilFraction>& fractions) {
    for (const double boiling_point : table.needed_numbers("boiling_points", "K")) {
      fractions.push_back({1, boiling_point, std::nullopt});
    }
    const auto put = [&](const char* key, const char* unit, auto member) {
      if (table.find(key) == nullptr) return;
      const std::vector<double> numbers = table.needed_numbers(key, unit);
      if (numbers.size() != fractions.size()) {
        table.refuse_value(key, "has another number of fractions than boiling_points");
        return;
      }
      for (std::size_t i = 0; i < numbers.size(); ++i) fractions[i].*member = numbers[i];
    };
    put("shares", "1", &models::OilFraction::share);
    put("molar_masses", "kg/mol", &models::OilFraction::molar_mass);
    if (fractions.empty()) fractions.push_back({1, 0, std::nullopt});
  }

  void read_samples(CheckTable& table, const std::string& unit, study::CurveCheck& check) {
    const std::string name = table.needed_text("file");
    const std::string angles = table.needed_text("angle_column"), values = table.needed_text("column");
    if (name.empty()) return;
    const std::string path = (folder_ / name).string();
    const CsvFile csv = read_csv({path, path}, Gaps::kNaN);
    const auto column = [&](const char* key, const std::string& requested, const std::string& si_unit) {
      const auto found = csv.find(requested);
      if (!found && !requested.empty())
        table.refuse_value(key, "is not a column of " + name, "there are " + csv.names());
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

  /// Reads run and probe of a check, and records that the run must reach the time of the probe, until its case is read.
  template <class Check>
  void read_probe(CheckTable& table, Check& check) {
    check.run = run(table, table.needed_text("case"));
    check.probe = table.probe();
    const TomlValue* time = table.find("time");
    if (time != nullptr && !check.run.empty()) times_.push_back({check.run, check.probe.time.value_or(0), *time});
  }

  void check_times() {
    for (const auto& [run, time, written] : times_) {
      const cycle::Case& c = verification_.runs.at(run);
      if (c.problem != cycle::Problem::kPad || !c.pad.is_transient()) {
        faults_.push_back(
            value_fault("time", written, "is asked of " + run + ", which has no history", "leave it out"));
      } else if (time < c.pad.first_time() || time > c.pad.last_time()) {
        faults_.push_back(value_fault("time", written, "is outside the history of " + run, "ask for a time within it"));
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
    if (!fs::is_directory(entry.path()) || fs::exists(entry.path() / "trends.toml")) continue;  // trends_file.hpp
    folders.push_back(entry.path().string());
  }
  if (folders.empty()) {
    throw InputError(all.string() + ": no verification is here", "the folder is shipped with cases/ and data/");
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::vector<study::NotCovered> read_not_covered(const std::string& path, const Units& units) {
  const TomlValue root = parse_toml(read_source_text(path, path, kMaxToml));
  std::vector<Fault> faults;
  std::vector<study::NotCovered> all;
  for (const auto& [name, tables] : root.members) {
    if (name != "not_covered" || tables.kind != TomlValue::Kind::kList) {
      faults.push_back({tables.key_mark, "unknown key " + name, "tables are [[not_covered]]"});
      continue;
    }
    for (const TomlValue& value : tables.items) {
      CheckTable table(name, value, units, faults);
      const std::string what = table.needed_text("what");
      all.push_back({what, table.needed_text("reason")});
      table.refuse_the_rest();
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return all;
}

}  // namespace ringfilm::io
