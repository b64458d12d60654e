#include "ringfilm/io/inverse/fit_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/io/table/csv_file.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::io {
namespace {

using study::Discrepancy;
using study::Measured;

constexpr std::size_t kMaxFitStarts = 1000;
constexpr std::size_t kMaxValues = 5000;  // values of a series: the discrepancy takes a matrix of as many rows
constexpr const char* kAngleColumn = "crank_angle";

const std::vector<std::string> kMeasuredKeys = {
    "file",  "quantity",    "column", "value",       "standard_deviation", "relative_error",    "offset",
    "scale", "angle_shift", "at",     "crank_range", "discrepancy",        "discrepancy_length"};

class FitReader : VariedDocumentReader {
 public:
  FitReader(const std::string& path, const CaseQuantities& quantities)
      : VariedDocumentReader(path), quantities_(quantities) {}

  FitFile read() {
    const TomlValue root = read_document(DocumentKind::kFit, "fit");
    TomlTable table(root, "a fit", {"title", "case", "compute", "measured", "parameter", "fit"}, faults_);
    fit_.title = table.text("title").value_or(stem());
    if (!read_case_of(table)) throw InputError(faults_);
    known_values_ = quantities_.values(first_base());
    known_curves_ = quantities_.curves(first_base());
    for (const TomlValue& value : table.items("measured")) read_measured(value);
    for (const TomlValue& value : table.items("parameter")) read_parameter(value);
    read_options(table);
    need(table, "measured", "write [[measured]] with file, quantity and standard_deviation");
    need(table, "parameter", "write [[parameter]] with key, lower and upper");
    if (!faults_.empty()) throw InputError(faults_);
    std::vector<study::Variable> variables(fit_.parameters.begin(), fit_.parameters.end());
    for (Fault& fault : study::VariedCases(bases_, variables, compute_).faults()) faults_.push_back(std::move(fault));
    if (!faults_.empty()) throw InputError(faults_);
    return {std::move(fit_), compute_, std::move(bases_), std::move(files_)};
  }

 private:
  void need(TomlTable& root, const std::string& table, const std::string& remedy) {
    if (root.find(table) == nullptr) {
      faults_.push_back({{path_, 0, 0, ""}, fmt::format("the fit has no [[{}]]", table), remedy});
    }
  }

  void read_measured(const TomlValue& value) {
    TomlTable table(value, "[[measured]]", kMeasuredKeys, faults_);
    const std::size_t n_before = faults_.size();
    std::vector<cycle::Quantity> known = known_values_;
    known.insert(known.end(), known_curves_.begin(), known_curves_.end());
    const auto quantity = read_quantity(table, known);
    if (!quantity) return;
    Measured measured;
    measured.quantity = *quantity;
    read_numbers(table, measured);
    if (faults_.size() > n_before || measured.values.empty()) return;
    read_deviations(table, measured);
    read_errors(table, measured);
    if (faults_.size() == n_before) fit_.measured.push_back(std::move(measured));
  }

  void read_numbers(TomlTable& table, Measured& measured) {
    if (table.find("file") != nullptr && table.find("value") != nullptr) {
      return table.refuse_key("value", "is stated next to file", "keep one of the two");
    }
    if (table.find("value") != nullptr) return read_single(table, measured);
    const std::string name = table.needed_text("file", "\"friction.csv\"");
    if (name.empty()) return;
    try {
      const CsvFile csv = read_csv(locate(name, folder_), Gaps::kKept);
      record({"measured", csv.source.path, csv.source.sha256});
      read_columns(table, csv, measured);
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults()) {
        faults_.push_back(fault.mark.line > 0 ? fault : Fault{table.find("file")->mark, fault.message, fault.remedy});
      }
    }
  }

  /// One value, stated in the file of the fit.
  void read_single(TomlTable& table, Measured& measured) {
    if (find_by_name(known_values_, measured.quantity.name) == nullptr) {
      return table.refuse_key("value", fmt::format("is one number, and {} is a curve", measured.quantity.name),
                              "name the file of the curve");
    }
    const std::string& unit = measured.quantity.display_unit;
    const std::string example = measured.quantity.unit == "1" ? "0.1" : fmt::format("\"1 {}\"", unit);
    const auto number = table.quantity("value", measured.quantity.unit, example, units_);
    const auto base = base_at(table);
    if (!number || !base) return;
    measured.values = {*number};
    measured.bases = {*base};
  }

  /// The case at the keys that `at` states.
  std::optional<std::size_t> base_at(TomlTable& table) {
    const TomlValue* at = table.find("at");
    if (at == nullptr) return 0;
    if (at->kind != TomlValue::Kind::kTable) {
      table.refuse_value("at", "is not a table", "for example at = { \"operating.speed\" = \"1000 rpm\" }");
      return std::nullopt;
    }
    return add_base(overrides_of(*at), at->mark);
  }

  void read_columns(TomlTable& table, const CsvFile& csv, Measured& measured) {
    const std::string column = table.text("column").value_or(measured.quantity.name);
    const auto found = csv.find(column);
    if (!found) {
      table.refuse(csv.source.mark(csv.header_line), fmt::format("there is no column {}", column),
                   fmt::format("the columns are {}; column = \"...\" names another", csv.names()));
      return;
    }
    const std::vector<double> values = in_si(table, csv, *found, measured.quantity.unit);
    if (values.empty()) return;
    const auto angle = csv.find(kAngleColumn);
    const bool is_curve = find_by_name(known_curves_, measured.quantity.name) != nullptr;
    const bool is_value = find_by_name(known_values_, measured.quantity.name) != nullptr;
    if (angle && is_curve) return read_curve(table, csv, *angle, values, measured);
    if (is_value) return read_values(table, csv, *found, values, measured);
    table.refuse(csv.source.mark(csv.header_line),
                 fmt::format("{} is a curve, and there is no column {}", measured.quantity.name, kAngleColumn),
                 fmt::format("the columns are {}", csv.names()));
  }

  std::vector<double> in_si(TomlTable& table, const CsvFile& csv, std::size_t column, const std::string& si_unit) {
    std::vector<double> values = csv.columns[column].values;
    const auto& unit = csv.columns[column].unit;
    if (si_unit == "1" && !unit) return values;
    try {
      const Scale scale = units_.scale(unit.value_or(""), si_unit);
      for (double& value : values) value = scale.to_si(value);
      return values;
    } catch (const UnitError& problem) {
      table.refuse(csv.unit_mark(column), fmt::format("the column {} {}", csv.columns[column].name, problem.what()),
                   problem.remedy);
      return {};
    }
  }

  void read_curve(TomlTable& table, const CsvFile& csv, std::size_t angle_column, const std::vector<double>& values,
                  Measured& measured) {
    const std::vector<double> angles = in_si(table, csv, angle_column, "degree");
    const auto base = base_at(table);
    if (angles.empty() || !base) return;
    measured.bases = {*base};
    const auto [from, to] = crank_range(table);
    std::size_t n_finite = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i]) || !std::isfinite(angles[i])) continue;  // a gap of the trace
      ++n_finite;
      const double angle = std::remainder(angles[i], cycle::kCycleDeg);
      if (angle < from || angle > to) continue;
      measured.crank_angle_deg.push_back(angle);
      measured.values.push_back(values[i]);
    }
    if (measured.values.empty()) {
      const SourceMark mark = csv.source.mark(csv.header_line);
      table.refuse(mark,
                   n_finite == 0 ? fmt::format("the column {} has no number", csv.columns[angle_column].name)
                                 : fmt::format("not one of {} measured crank angles lies within crank_range", n_finite),
                   "measurement and model must overlap");
    } else if (measured.values.size() > kMaxValues) {
      table.refuse(csv.source.mark(csv.header_line),
                   fmt::format("the curve has {} values, more than {}", measured.values.size(), kMaxValues),
                   "average it over steps of crank angle, for example of 1 degree");
    }
  }

  /// The part of the cycle that counts [degree].
  std::pair<double, double> crank_range(TomlTable& table) {
    std::pair<double, double> range{-cycle::kCycleDeg / 2, cycle::kCycleDeg / 2};
    const std::vector<TomlValue> ends = table.items("crank_range");
    if (table.find("crank_range") == nullptr) return range;
    if (ends.size() != 2) {
      table.refuse_value("crank_range", "does not have two ends", "for example [\"-30 degree\", \"60 degree\"]");
      return range;
    }
    const auto from = table.quantity("crank_range", ends[0], "degree", "\"-30 degree\"", units_);
    const auto to = table.quantity("crank_range", ends[1], "degree", "\"60 degree\"", units_);
    if (!from || !to) return range;
    if (*from >= *to || *from < range.first || *to > range.second) {
      table.refuse_value("crank_range", "is not a range from -360 to 360 degree", "its first end is below its second");
      return range;
    }
    return {*from, *to};
  }

  /// Values of cycles; columns that are keys of the case state the operating point of each.
  void read_values(TomlTable& table, const CsvFile& csv, std::size_t value_column, const std::vector<double>& values,
                   Measured& measured) {
    std::vector<std::size_t> keys;
    for (std::size_t i = 0; i < csv.columns.size(); ++i) {
      if (i != value_column && study::field_of_key(csv.columns[i].name) != nullptr) keys.push_back(i);
    }
    if (keys.empty() && values.size() > 1) {
      table.refuse(csv.source.mark(csv.header_line),
                   fmt::format("{} has {} values, and no column is a key of the case that distinguishes them",
                               measured.quantity.name, values.size()),
                   "name columns as keys, for example operating.speed [rpm]");
      return;
    }
    std::map<std::vector<double>, std::size_t> known;
    for (std::size_t row = 0; row < values.size(); ++row) {
      if (!std::isfinite(values[row])) continue;
      std::vector<double> numbers;
      std::vector<Override> overrides;
      const TomlValue* at = table.find("at");
      if (at != nullptr && at->kind == TomlValue::Kind::kTable) overrides = overrides_of(*at);
      for (const std::size_t i : keys) {
        const double number = csv.columns[i].values[row];
        numbers.push_back(number);
        const auto& unit = csv.columns[i].unit;
        const std::string text = exact_text(number);
        overrides.push_back({csv.columns[i].name, unit && *unit != "1" ? quoted(text + " " + *unit) : text});
      }
      auto base = known.find(numbers);
      if (base == known.end()) {
        const auto added = overrides.empty() ? std::optional<std::size_t>(0)
                                             : add_base(overrides, csv.source.mark(csv.row_lines[row]));
        if (!added) return;
        base = known.emplace(std::move(numbers), *added).first;
      }
      measured.bases.push_back(base->second);
      measured.values.push_back(values[row]);
    }
    if (measured.values.empty()) {
      table.refuse(csv.source.mark(csv.header_line), "there is no measured value", "write one in a row");
    }
  }

  void read_deviations(TomlTable& table, Measured& measured) {
    const auto absolute = read_deviation(table, "standard_deviation", measured.quantity);
    const auto relative = positive(table, "relative_error");
    if (table.find("standard_deviation") == nullptr && table.find("relative_error") == nullptr) {
      table.refuse(table.mark(), fmt::format("the measured {} has no error", measured.quantity.name),
                   "state standard_deviation, relative_error or both: intervals follow from them");
      return;
    }
    if (!absolute && !relative) return;
    for (const double value : measured.values) {
      measured.deviations.push_back(std::hypot(absolute.value_or(0), relative.value_or(0) * value));
      if (measured.deviations.back() > 0) continue;
      table.refuse_value("relative_error", "gives no error where the measured value is 0",
                         "state standard_deviation, too");
      return;
    }
  }

  std::optional<double> positive(TomlTable& table, const std::string& key) {
    const auto number = table.number(key);
    if (number && !(*number > 0)) table.refuse_value(key, "is not above 0", "omit the key where there is none");
    return number;
  }

  std::optional<double> angle(TomlTable& table, const std::string& key) {
    const auto degrees = table.quantity(key, "degree", "\"1 degree\"", units_);
    if (degrees && !(*degrees > 0)) table.refuse_value(key, "is not above 0", "omit the key where there is none");
    return degrees;
  }

  void read_errors(TomlTable& table, Measured& measured) {
    measured.offset = read_deviation(table, "offset", measured.quantity);
    measured.scale = positive(table, "scale");
    measured.angle_shift_deg = angle(table, "angle_shift");
    if (!measured.is_curve()) {
      for (const char* key : {"angle_shift", "crank_range", "discrepancy_length"}) {
        table.refuse_key(key, "is about curves over crank angle", "remove it");
      }
    }
    if (const auto length = angle(table, "discrepancy_length")) measured.discrepancy_length_deg = *length;
    const TomlValue* discrepancy = table.find("discrepancy");
    if (discrepancy == nullptr) return;
    if (discrepancy->kind == TomlValue::Kind::kText && discrepancy->text == "estimated") {
      measured.discrepancy = Discrepancy::kEstimated;
    } else if (const auto deviation = read_deviation(table, "discrepancy", measured.quantity)) {
      measured.discrepancy = Discrepancy::kStated;
      measured.discrepancy_deviation = *deviation;
    }
  }

  void read_parameter(const TomlValue& value) {
    TomlTable table(value, "[[parameter]]",
                    {"key", "lower", "upper", "how", "item", "spacing", "prior_mean", "prior_deviation"}, faults_);
    const auto variable = read_variable(table);
    if (!variable) return;
    study::FitParameter parameter;
    static_cast<study::Variable&>(parameter) = *variable;
    const bool has_mean = table.find("prior_mean") != nullptr;
    const bool has_deviation = table.find("prior_deviation") != nullptr;
    if (has_mean != has_deviation) {
      table.refuse_key(has_mean ? "prior_mean" : "prior_deviation", "is stated alone",
                       "a prior has prior_mean and prior_deviation");
    }
    const std::string example = variable->unit == "1" ? "0.1" : fmt::format("\"1 {}\"", variable->display_unit);
    parameter.prior_mean = table.quantity("prior_mean", variable->unit, example, units_);
    cycle::Quantity as_quantity;
    as_quantity.unit = variable->unit;
    as_quantity.display_unit = variable->display_unit;
    parameter.prior_deviation = read_deviation(table, "prior_deviation", as_quantity);
    fit_.parameters.push_back(std::move(parameter));
  }

  void read_options(TomlTable& root) {
    const TomlValue* value = root.find("fit");
    if (value == nullptr) return;
    TomlTable table(*value, "[fit]", {"starts", "seed", "intervals"}, faults_);
    if (const TomlValue* starts = table.find("starts")) {
      if (const auto n = table.count("starts", *starts, 1, kMaxFitStarts)) fit_.starts = static_cast<std::size_t>(*n);
    }
    fit_.seed = table.count("seed").value_or(fit_.seed);
    table.choose("intervals", {{"profile", study::Intervals::kProfile}, {"linear", study::Intervals::kLinear}},
                 fit_.intervals);
  }

  const CaseQuantities& quantities_;
  study::Fit fit_;
  std::vector<cycle::Quantity> known_values_, known_curves_;
};

}  // namespace

FitFile read_fit(const std::string& path, const CaseQuantities& quantities) {
  return FitReader(path, quantities).read();
}

}  // namespace ringfilm::io
