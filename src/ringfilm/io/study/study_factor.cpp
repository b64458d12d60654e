#include "ringfilm/io/study/study_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_values.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::io {
namespace {

using study::Factor;
using study::FactorMode;

const std::vector<std::string> kFactorKeys = {
    "name",  "source", "key",     "keys",         "bases",         "how",       "values",
    "range", "points", "spacing", "distribution", "mean",          "deviation", "relative_deviation",
    "lower", "upper",  "mode",    "median",       "log_deviation", "truncate"};

/// A value or a difference of two: "5 degC" warmer is 5 K, not 278.15 K.
enum class Meaning { kValue, kDifference };

class FactorReader {
 public:
  FactorReader(const TomlValue& table, const FactorSources& sources, std::vector<Fault>& faults)
      : faults_(faults),
        n_before_(faults.size()),
        table_(table, "[[factor]]", kFactorKeys, faults),
        sources_(sources) {}

  std::optional<Factor> read() {
    factor_.mark = table_.mark();
    read_targets();
    table_.choose("how", {{"set", FactorMode::kSet}, {"scale", FactorMode::kScale}, {"add", FactorMode::kAdd}},
                  factor_.how);
    if (field_ == nullptr || faults_.size() > n_before_) return std::nullopt;
    factor_.name = table_.text("name").value_or(factor_.targets.front().key);
    factor_.source = table_.text("source").value_or("");
    const bool is_text = study::entry_of(*field_) == study::Entry::kText || lists_values_along_stroke();
    factor_.unit = is_text ? "" : factor_.how == FactorMode::kScale ? "1" : field_->unit;
    factor_.display_unit = is_text ? "" : factor_.how == FactorMode::kScale ? "1" : field_->display_unit;
    // A difference of temperatures is read in kelvin.
    if (factor_.how == FactorMode::kAdd && factor_.unit == "K") factor_.display_unit = factor_.unit;
    read_variation(is_text);
    if (faults_.size() > n_before_) return std::nullopt;
    return std::move(factor_);
  }

 private:
  void refuse(const TomlValue* at, const std::string& message, const std::string& remedy) {
    table_.refuse(at == nullptr ? table_.mark() : at->mark, message, remedy);
  }

  void read_targets() {
    std::vector<std::string> keys = table_.texts("keys");
    if (const auto key = table_.text("key")) keys.push_back(*key);
    if (keys.empty() && faults_.size() == n_before_)
      refuse(nullptr, "[[factor]] names no key", "write, for example, key = \"operating.speed\"");
    const TomlValue* at = table_.find("key") != nullptr ? table_.find("key") : table_.find("keys");
    for (const std::string& key : keys) {
      const cycle::Field* field = study::field_of_key(key);
      if (field == nullptr) {
        std::vector<std::string> known;
        for (const cycle::Field& one : cycle::case_fields()) known.push_back(one.key);
        refuse(at, fmt::format("a case has no key {}{}", key, did_you_mean(key, known)),
               "`ringfilm fields` lists all keys");
        continue;
      }
      if (field_ != nullptr && field->unit != field_->unit) {
        refuse(at, fmt::format("{} and {} have different units", field_->key, key),
               "one number cannot be both; write two factors");
      }
      if (field_ == nullptr) field_ = field;
      add_targets(key);
    }
  }

  void add_targets(const std::string& key) {
    if (table_.find("bases") == nullptr) {
      factor_.targets.push_back({std::nullopt, key, 1.0});
      return;
    }
    for (const std::size_t base : read_base_names(table_, sources_.study)) factor_.targets.push_back({base, key, 1.0});
  }

  void read_variation(bool is_text) {
    const std::vector<std::string> ways = {"values", "range", "distribution"};
    std::vector<std::string> stated;
    std::copy_if(ways.begin(), ways.end(), std::back_inserter(stated),
                 [this](const std::string& way) { return table_.find(way) != nullptr; });
    if (stated.size() > 1) {
      refuse(table_.find(stated[1]), fmt::format("a factor has both {} and {}", stated[0], stated[1]), "keep one");
    } else if (stated.empty()) {
      factor_.variation = study::Listed{};
    } else if (stated[0] == "values") {
      is_text ? read_choices() : read_levels();
    } else if (is_text) {
      refuse(table_.find(stated[0]), fmt::format("{} is not a number and has no {}", field_->key, stated[0]),
             "list its values: values = [..., ...]");
    } else if (stated[0] == "range") {
      read_span();
    } else {
      read_distribution();
    }
    check_belonging(stated.empty() ? "" : stated[0]);
  }

  /// Keys that only mean something with one way to vary.
  void check_belonging(const std::string& way) {
    const std::map<std::string, std::vector<std::string>> parts = {
        {"range", {"points", "spacing"}},
        {"distribution",
         {"mean", "deviation", "relative_deviation", "lower", "upper", "mode", "median", "log_deviation", "truncate"}}};
    for (const auto& [owner, keys] : parts) {
      for (const std::string& key : keys) {
        if (owner != way) table_.refuse_key(key, "means nothing without " + owner, "take it out");
      }
    }
  }

  std::optional<double> quantity(const TomlValue& value, const std::string& key, Meaning meaning) {
    const std::string example = factor_.unit == "1" ? "1" : fmt::format("\"1 {}\"", factor_.display_unit);
    const auto x = table_.quantity(key, value, factor_.unit, example, sources_.units);
    if (!x || meaning == Meaning::kValue || factor_.unit != "K") return x;
    const std::size_t unit = value.text.find_first_not_of("+-.0123456789eE ");
    return *x - sources_.units.quantity(fmt::format("0 {}", value.text.substr(unit)), factor_.unit, example);
  }

  Meaning meaning() const { return factor_.how == FactorMode::kAdd ? Meaning::kDifference : Meaning::kValue; }

  std::vector<double> quantities(const std::string& key) {
    std::vector<double> all;
    for (const TomlValue& item : table_.items(key)) {
      if (const auto x = quantity(item, key, meaning())) all.push_back(*x);
    }
    return all;
  }

  void read_levels() { factor_.variation = study::Levels{quantities("values")}; }

  /// Both ends of the value of the key.
  std::optional<std::pair<double, double>> ends(const std::string& key) {
    if (table_.find(key) == nullptr) return std::nullopt;
    const std::vector<double> both = quantities(key);
    if (both.size() == 2) return std::pair{both[0], both[1]};
    if (faults_.size() == n_before_)
      refuse(table_.find(key), fmt::format("{} has {} values", key, both.size()), "two are required: [lower, upper]");
    return std::nullopt;
  }

  void read_span() {
    study::Span span;
    if (const auto both = ends("range")) std::tie(span.low, span.high) = *both;
    span.points = table_.count("points").value_or(span.points);
    table_.choose("spacing", {{"linear", study::Spacing::kLinear}, {"log", study::Spacing::kLogarithmic}},
                  span.spacing);
    factor_.variation = span;
  }

  double needed(const std::string& key, Meaning meaning) {
    const TomlValue* value = table_.find(key);
    if (value != nullptr) return quantity(*value, key, meaning).value_or(0);
    refuse(table_.find("distribution"), fmt::format("this distribution requires {}", key), "state it");
    return 0;
  }
  double needed(const std::string& key) { return needed(key, meaning()); }

  /// Standard deviation, as such or relative to the mean.
  double deviation(double mean) {
    if (const auto relative = table_.number("relative_deviation")) return *relative * std::abs(mean);
    return needed("deviation", Meaning::kDifference);
  }

  void read_distribution() {
    using study::Shape;
    Shape shape{};
    const bool is_known = table_.choose("distribution",
                                        {{"normal", Shape::kNormal},
                                         {"lognormal", Shape::kLognormal},
                                         {"uniform", Shape::kUniform},
                                         {"triangular", Shape::kTriangular}},
                                        shape);
    if (!is_known) return;
    study::Distribution d;
    std::vector<std::string> used = {"truncate"};
    if (shape == Shape::kNormal) {
      used.insert(used.end(), {"mean", "deviation", "relative_deviation"});
      const double mean = needed("mean");
      d = study::normal(mean, deviation(mean));
    } else if (shape == Shape::kLognormal && table_.find("median") != nullptr) {
      used.insert(used.end(), {"median", "log_deviation"});
      d = study::lognormal(needed("median"), table_.number("log_deviation").value_or(0));
    } else if (shape == Shape::kLognormal) {
      used.insert(used.end(), {"mean", "deviation", "relative_deviation"});
      const double mean = needed("mean");
      d = study::lognormal_of_moments(mean, deviation(mean));
    } else {
      used.insert(used.end(), {"lower", "upper"});
      const double lower = needed("lower"), upper = needed("upper");
      d = study::uniform(lower, upper);
      if (shape == Shape::kTriangular) {
        used.push_back("mode");
        d = study::triangular(lower, needed("mode"), upper);
      }
    }
    for (const std::string key :
         {"mean", "deviation", "relative_deviation", "lower", "upper", "mode", "median", "log_deviation"}) {
      if (std::find(used.begin(), used.end(), key) != used.end()) continue;
      table_.refuse_key(
          key, "means nothing here",
          fmt::format("a {} distribution is stated otherwise; take it out", *table_.text("distribution")));
    }
    if (const auto cut = ends("truncate")) std::tie(d.lowest, d.highest) = *cut;
    factor_.variation = d;
  }

  /// Does one of the values differ along the stroke?
  bool lists_values_along_stroke() {
    const TomlValue* values = table_.find("values");
    return std::holds_alternative<cycle::StrokeValuesKind>(field_->kind) && values != nullptr &&
           std::ranges::any_of(values->items, [](const auto& item) { return item.kind == TomlValue::Kind::kList; });
  }

  void read_choices() {
    study::Choices choices;
    if (const auto* along_stroke = std::get_if<cycle::StrokeValuesKind>(&field_->kind)) {
      for (const TomlValue& item : table_.items("values")) {
        cycle::Case read;
        set_value(read, *field_, {field_->key, item, ""}, sources_.units, faults_);
        choices.values.push_back({item.as_written(), item.mark, "", along_stroke->ref(read)});
      }
      factor_.variation = std::move(choices);
      return;
    }
    table_.texts("values");  // refuses what is not a text
    for (const TomlValue& item : table_.items("values")) choices.values.push_back({item.text, item.mark});
    factor_.variation = std::move(choices);
  }

  std::vector<Fault>& faults_;
  std::size_t n_before_;
  TomlTable table_;
  const FactorSources& sources_;
  const cycle::Field* field_ = nullptr;
  Factor factor_;
};

}  // namespace

std::optional<Factor> read_factor(const TomlValue& table, const FactorSources& sources, std::vector<Fault>& faults) {
  return FactorReader(table, sources, faults).read();
}

std::vector<std::size_t> read_base_names(TomlTable& table, const study::Study& study) {
  std::vector<std::size_t> found;
  std::vector<std::string> names;
  for (const study::Base& base : study.bases) names.push_back(base.name);
  if (table.find("bases") == nullptr) {
    for (std::size_t b = 0; b < names.size(); ++b) found.push_back(b);
  }
  for (const std::string& name : table.texts("bases")) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) {
      table.refuse_word("bases", name, names);
    } else {
      found.push_back(static_cast<std::size_t>(at - names.begin()));
    }
  }
  return found;
}

}  // namespace ringfilm::io
