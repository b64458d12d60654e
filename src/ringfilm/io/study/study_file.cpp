#include "ringfilm/io/study/study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/study/document_reader.hpp"
#include "ringfilm/io/study/study_factor.hpp"
#include "ringfilm/io/study/study_points.hpp"
#include "ringfilm/io/study/study_reading.hpp"
#include "ringfilm/io/table/csv_file.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/toml_table.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/study/design/measured_factors.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/design/study_values.hpp"
#include "ringfilm/study/study_words.hpp"

namespace ringfilm::io {
namespace {

using study::Compute;
using study::Method;

class StudyReader : DocumentReader {
 public:
  explicit StudyReader(const std::string& path) : DocumentReader(path) {}
  StudyReader(const std::string& path, const std::string& folder) : DocumentReader(path, folder) {}

  StudyFile read() {
    const TomlValue root = read_document(DocumentKind::kStudy, "study");
    TomlTable table(root, "a study",
                    {"title", "kind", "compute", "seed", "base", "factor", "measured", "correlation", "plan", "point",
                     "keep", "accuracy"},
                    faults_);
    study_.title = table.text("title").value_or(stem());
    table.choose("kind", study::kind_words(), study_.kind);
    table.choose("compute", {{"films", Compute::kFilms}, {"gas", Compute::kGas}}, study_.compute);
    study_.seed = table.count("seed").value_or(study_.seed);
    const std::vector<TomlValue> bases = table.items("base");
    for (const TomlValue& base : bases) read_base(base);
    if (bases.empty() && faults_.empty())
      faults_.push_back({{path_, 0, 0, ""}, "the study has no base case", "write [[base]] and case = \"...\" below"});
    // Factors are about bases: where one is missing, no interval can be given for them.
    if (!faults_.empty()) throw InputError(faults_);
    check_bases_alike(bases);
    if (!faults_.empty()) throw InputError(faults_);
    read_factors(table);
    if (faults_.empty()) read_measured(table);
    if (faults_.empty()) read_correlations(table);
    read_plan(table);
    read_points(table);
    read_keep(table);
    read_accuracy(table);
    if (faults_.empty()) read_files_of_factors();
    if (!faults_.empty()) throw InputError(faults_);
    return {std::move(study_), std::move(files_)};
  }

 private:
  void read_base(const TomlValue& value) {
    TomlTable table(value, "[[base]]", {"name", "case"}, faults_);
    const std::string name = table.needed_text("case", "\"my_engine.toml\"");
    if (name.empty()) return;
    const std::string path = locate(name, folder_).shown;
    try {
      const bool is_gas = study_.compute == Compute::kGas;
      cycle::Case input =
          read_case(path, {}, units_, is_gas ? cycle::CasePurpose::kGasPath : cycle::CasePurpose::kFilm);
      check_kind(input, path, table.find("case")->mark);
      record(input);
      study_.bases.push_back(
          {table.text("name").value_or(std::filesystem::path(path).stem().string()), std::move(input)});
    } catch (const InputError& error) {
      append_case_faults(error, table.find("case")->mark, faults_);
    }
  }

  void check_kind(const cycle::Case& input, const std::string& path, const SourceMark& mark) {
    if (input.problem == cycle::Problem::kPad) {
      faults_.push_back({mark, fmt::format("{} is a pad", path), "a study is about rings over engine cycles"});
    } else if (study_.compute == Compute::kGas && input.gas_path.model == cycle::GasPathModel::kGiven &&
               !input.stated.contains("gas_path.model")) {
      faults_.push_back({mark, fmt::format("{} has no gas path, and compute = \"gas\" is about it", path),
                         "state gas_path.model = \"orifice-volume\" and the volumes and gaps of its rings there, or "
                         "leave compute out"});
    }
  }

  /// All scenarios have the same values.
  void check_bases_alike(const std::vector<TomlValue>& tables) {
    const auto names = [&](const study::Base& base) {
      std::vector<std::string> all;
      for (const cycle::Quantity& value : study::study_values(study_, base.input).quantities) all.push_back(value.name);
      return all;
    };
    const std::vector<std::string> first = names(study_.bases.front());
    for (std::size_t b = 1; b < study_.bases.size(); ++b) {
      if (names(study_.bases[b]) == first) continue;
      faults_.push_back({tables[b].mark,
                         fmt::format("base {} has other values than {}: another number of rings, or another gas path",
                                     study_.bases[b].name, study_.bases.front().name),
                         "make it two studies"});
    }
  }

  void read_factors(TomlTable& root) {
    const FactorSources sources{study_, units_};
    std::vector<study::Factor> factors;
    for (const TomlValue& value : root.items("factor")) {
      if (auto factor = read_factor(value, sources, faults_)) factors.push_back(std::move(*factor));
    }
    study_.factors = std::move(factors);
  }

  /// What the factors read from files. After the plan, which decides which of their texts meet.
  void read_files_of_factors() {
    StudyReadings read = study_readings(study_, folder_, units_, faults_);
    for (const cycle::InputFile& file : read.files) record(file);
    study_.readings = std::move(read.readings);
    for (study::Factor& factor : study_.factors) record_contents(factor);
  }

  /// The digests of the files that a factor chooses.
  void record_contents(study::Factor& factor) {
    auto* choices = std::get_if<study::Choices>(&factor.variation);
    if (choices == nullptr || factor.targets.empty()) return;
    if (!study::is_file(*study::field_of_key(factor.targets.front().key))) return;
    for (study::Choice& choice : choices->values) choice.file_sha256 = file_sha256(locate(choice.text, folder_).path);
  }

  void read_measured(TomlTable& root) {
    for (const TomlValue& value : root.items("measured")) {
      if (study_.compute == study::Compute::kGas) {
        root.refuse(value.mark, "[[measured]] is about films, and the study computes the gas alone", "leave it out");
        return;
      }
      TomlTable table(value, "[[measured]]", {"bases", "shared"}, faults_);
      const std::vector<std::size_t> bases = read_base_names(table, study_);
      study::MeasuredSharing sharing;
      if (table.find("shared") != nullptr) {
        sharing = {study::Shared::kApart, study::Shared::kApart};
        for (const std::string& word : table.texts("shared")) {
          if (word == "calibration") {
            sharing.calibration = study::Shared::kCommon;
          } else if (word == "reference") {
            sharing.reference = study::Shared::kCommon;
          } else {
            table.refuse_word("shared", word, {"calibration", "reference"});
          }
        }
      }
      if (!faults_.empty()) return;
      try {
        study::add_measured_factors(study_, bases, sharing);
      } catch (const InputError& error) {
        for (const Fault& f : error.faults()) table.refuse(table.mark(), f.message, f.remedy);
      }
    }
  }

  void read_correlations(TomlTable& root) {
    std::vector<std::string> names;
    for (const study::Factor& factor : study_.factors) names.push_back(factor.name);
    for (const TomlValue& value : root.items("correlation")) {
      TomlTable table(value, "[[correlation]]", {"factors", "value"}, faults_);
      std::vector<std::size_t> both;
      for (const std::string& name : table.texts("factors")) {
        const auto at = std::find(names.begin(), names.end(), name);
        if (at == names.end()) {
          table.refuse_word("factors", name, names);
        } else {
          both.push_back(static_cast<std::size_t>(at - names.begin()));
        }
      }
      const auto number = table.number("value");
      if (!faults_.empty()) continue;
      if (both.size() != 2 || !number) {
        table.refuse(table.mark(), "a correlation requires two factors and a value",
                     "write factors = [\"a\", \"b\"] and value = 0.5");
      } else {
        study_.correlations.push_back({both[0], both[1], *number, table.mark()});
      }
    }
  }

  void read_plan(TomlTable& root) {
    study::Sampling& sampling = study_.sampling;
    const TomlValue* value = root.find("plan");
    if (value == nullptr) {
      faults_.push_back({{path_, 0, 0, ""}, "the study has no plan", "write [plan] and method = \"sobol\" below"});
      return;
    }
    TomlTable table(*value, "[plan]", {"method", "scenarios", "indices", "list", "trajectories", "levels", "until"},
                    faults_);
    table.needed_text("method", "\"sobol\"");
    const bool is_known = table.choose("method", study::method_words(), sampling.method);
    sampling.scenarios = table.count("scenarios").value_or(sampling.scenarios);
    sampling.trajectories = table.count("trajectories").value_or(sampling.trajectories);
    sampling.levels = table.count("levels").value_or(sampling.levels);
    table.choose("indices", {{"none", study::Indices::kNone}, {"first-and-total", study::Indices::kFirstAndTotal}},
                 sampling.indices);
    if (is_known) refuse_idle_keys(table, sampling.method);
    if (sampling.method == Method::kList && faults_.empty()) read_list(table);
    read_until(table);
  }

  /// Operating points bring their factors with them.
  void read_points(TomlTable& root) {
    const std::vector<TomlValue> tables = root.items("point");
    if (study_.sampling.method != Method::kOperatingPoints) {
      if (const TomlValue* value = root.find("point"))
        root.refuse(value->key_mark, "[[point]] means nothing with this method",
                    "leave the points out, or take method = \"operating-points\" in [plan]");
      return;
    }
    if (!study_.factors.empty()) {
      root.refuse(study_.factors.front().mark, "a study of operating points has no [[factor]]",
                  "state the values at each [[point]]");
      return;
    }
    if (!faults_.empty()) return;
    StudyPoints read = read_study_points(tables, root.find("plan")->key_mark, {study_, units_}, faults_);
    study_.factors = std::move(read.factors);
    study_.sampling.points = std::move(read.points);
    study_.sampling.list = std::move(read.list);
  }

  /// Keys that the method does not read; the plan itself reports this for until and indices.
  static void refuse_idle_keys(TomlTable& table, Method method) {
    const std::string predicate = fmt::format("means nothing with method = \"{}\"", study::word_of(method));
    const auto refuse = [&](const char* key, const char* remedy) { table.refuse_key(key, predicate, remedy); };
    if (method != Method::kSobol && method != Method::kLatinHypercube)
      refuse("scenarios", "leave it out, or sample: method = \"sobol\"");
    if (method != Method::kList) refuse("list", "leave it out, or take its points: method = \"list\"");
    if (method != Method::kMorris) {
      refuse("trajectories", "leave it out, or screen: method = \"morris\"");
      refuse("levels", "leave it out, or screen: method = \"morris\"");
    }
  }

  void read_until(TomlTable& plan) {
    const TomlValue* value = plan.find("until");
    if (value == nullptr) return;
    const std::size_t n_before = faults_.size();
    TomlTable table(*value, "plan.until", {"value", "quantile", "width", "most"}, faults_);
    study::StoppingRule until;
    until.value = table.needed_text("value", "\"fmep\"");
    until.quantile = table.number("quantile");
    table.need("most", "100000");
    until.most = table.count("most").value_or(0);
    if (faults_.size() > n_before) return;
    const study::StudyValues known = study::study_values(study_, study_.bases.front().input);
    const std::optional<std::size_t> quantity = known.index(until.value);
    until.mark = value->key_mark;
    if (!quantity) {
      std::vector<std::string> names;
      for (const auto& one : known.quantities) names.push_back(one.name);
      table.refuse_word("value", until.value, names);
      return;
    }
    if (const auto width = read_width(table, known.quantities[*quantity])) until.width = *width;
    if (faults_.size() == n_before) study_.sampling.until = until;
  }

  std::optional<double> read_width(TomlTable& table, const cycle::Quantity& quantity) {
    const std::string example = quantity.unit == "1" ? "0.01" : fmt::format("\"0.1 {}\"", quantity.display_unit);
    const TomlValue* value = table.need("width", example);
    const auto width = table.quantity("width", quantity.unit, example, units_);
    if (!width || *width > 0) return width;
    table.refuse(value->mark, fmt::format("the width of an interval is above 0, not {}", value->as_written()),
                 "state how narrow it shall become");
    return std::nullopt;
  }

  /// A column for each factor, in any order; of choices their place in the list of values, from 0.
  void read_list(TomlTable& table) {
    const std::string name = table.needed_text("list", "\"plan.csv\"");
    if (name.empty()) return;
    const CsvFile csv = read_csv(locate(name, folder_));
    record({"list", csv.source.path, csv.source.sha256});
    std::vector<std::vector<double>> columns;
    std::set<std::size_t> of_factors;
    for (const study::Factor& factor : study_.factors) {
      const auto found = csv.find(factor.name);
      if (found) of_factors.insert(*found);
      if (!found) {
        table.refuse(csv.source.mark(csv.header_line), fmt::format("there is no column {}", factor.name),
                     fmt::format("the columns are {}; one is required for each factor", csv.names()));
        continue;
      }
      std::vector<double> values = csv.columns[*found].values;
      const auto& unit = csv.columns[*found].unit;
      try {
        if (!factor.unit.empty() && (unit || factor.unit != "1")) {
          const Scale scale = units_.scale(unit.value_or(""), factor.unit);
          for (double& x : values) x = scale.to_si(x);
        }
      } catch (const UnitError& problem) {
        table.refuse(csv.unit_mark(*found), fmt::format("the column {} {}", factor.name, problem.what()),
                     fmt::format("write it as {} [{}]", factor.name, factor.display_unit));
      }
      columns.push_back(std::move(values));
    }
    for (std::size_t i = 0; i < csv.columns.size(); ++i) {
      if (!of_factors.contains(i))
        table.refuse(csv.header_mark(i), fmt::format("the column {} is of no factor", csv.columns[i].name),
                     "leave it out, or state a factor of this name");
    }
    if (!faults_.empty()) return;
    for (std::size_t i = 0; i < csv.row_lines.size(); ++i) {
      auto& row = study_.sampling.list.emplace_back();
      for (const auto& column : columns) row.push_back(column[i]);
    }
  }

  void read_keep(TomlTable& root) {
    const TomlValue* value = root.find("keep");
    if (value == nullptr) return;
    TomlTable table(*value, "[keep]", {"curves", "quantities", "crank_step"}, faults_);
    study::OutputSelection& keep = study_.keep;
    table.choose(
        "curves",
        {{"none", study::Curves::kNone}, {"all", study::Curves::kAll}, {"quantiles", study::Curves::kQuantiles}},
        keep.curves);
    keep.quantities_mark = keep.crank_step_mark = value->key_mark;
    if (const TomlValue* quantities = table.find("quantities")) read_kept_quantities(table, *quantities);
    if (const TomlValue* step = table.find("crank_step")) {
      keep.crank_step_mark = step->mark;
      keep.crank_step_deg =
          table.quantity("crank_step", "degree", "\"2 degree\"", units_).value_or(keep.crank_step_deg);
    }
  }

  void read_accuracy(TomlTable& root) {
    const TomlValue* value = root.find("accuracy");
    if (value == nullptr) return;
    TomlTable table(*value, "[accuracy]", {"sample"}, faults_);
    study_.accuracy.sample = table.count("sample");
    if (study_.compute == Compute::kGas) {
      table.refuse_key("sample", "is about films, and compute = \"gas\" has none", "leave it out");
    } else if (study_.accuracy.sample > study::Accuracy::kMaxSample) {
      table.refuse_value("sample", "is out of range",
                         fmt::format("allowed is 0 to {}; 16 are usual", study::Accuracy::kMaxSample));
    }
  }

  void read_kept_quantities(TomlTable& table, const TomlValue& quantities) {
    std::vector<std::string> known;
    for (const auto& curve : cycle::curve_quantities()) known.push_back(curve.name);
    known.erase(known.begin());  // the crank angle, which is the axis
    study_.keep.quantities = table.texts("quantities");
    study_.keep.quantities_mark = quantities.mark;
    for (const std::string& name : study_.keep.quantities) {
      if (std::find(known.begin(), known.end(), name) == known.end()) table.refuse_word("quantities", name, known);
    }
  }

  study::Study study_;
};

}  // namespace

StudyFile read_study(const std::string& path) { return StudyReader(path).read(); }

StudyFile read_study(const std::string& path, const std::string& folder) { return StudyReader(path, folder).read(); }

}  // namespace ringfilm::io
