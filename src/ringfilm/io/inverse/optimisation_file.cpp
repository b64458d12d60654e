#include "ringfilm/io/inverse/optimisation_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace ringfilm::io {
namespace {

using study::Goal;
using study::OverPoints;

/// Combinations of choices, each of which is searched by itself.
constexpr std::size_t kMaxCombinations = 200;
constexpr std::size_t kMaxStarts = 1000, kMaxFrontPoints = 1000, kMaxEvaluations = 1'000'000;

class OptimisationReader : VariedDocumentReader {
 public:
  OptimisationReader(const std::string& path, const CaseQuantities& quantities)
      : VariedDocumentReader(path), quantities_(quantities) {}

  OptimisationFile read() {
    const TomlValue root = read_document(DocumentKind::kOptimisation, "optimisation");
    TomlTable table(root, "an optimisation",
                    {"title", "case", "compute", "objective", "constraint", "variable", "point", "optimise"}, faults_);
    problem_.title = table.text("title").value_or(stem());
    if (!read_case_of(table)) throw InputError(faults_);
    known_ = quantities_.values(first_base());
    read_points(table);
    for (const TomlValue& value : table.items("variable")) read_variable_or_choice(value);
    for (const TomlValue& value : table.items("objective")) read_objective(value);
    for (const TomlValue& value : table.items("constraint")) read_constraint(value);
    read_options(table);
    need(table, "variable", problem_.variables.size() + problem_.choices.size(),
         "write [[variable]] with key, lower and upper");
    need(table, "objective", problem_.objectives.size(), "write [[objective]] with quantity and goal");
    if (!faults_.empty()) throw InputError(faults_);
    read_bases();
    if (faults_.empty()) check_variables();
    if (!faults_.empty()) throw InputError(faults_);
    return {std::move(problem_), compute_, std::move(bases_), std::move(files_)};
  }

 private:
  void need(TomlTable& root, const std::string& table, std::size_t n, const std::string& remedy) {
    if (n > 0 || root.find(table) != nullptr) return;
    faults_.push_back({{path_, 0, 0, ""}, fmt::format("the optimisation has no [[{}]]", table), remedy});
  }

  void read_points(TomlTable& root) {
    const std::vector<TomlValue> tables = root.items("point");
    std::set<std::string> names;
    for (const TomlValue& value : tables) {
      TomlTable table(value, "[[point]]", {"name", "weight", "values"}, faults_);
      study::WeightedPoint point;
      point.name = table.needed_text("name", "\"idle\"");
      if (!point.name.empty() && !names.insert(point.name).second) {
        table.refuse_value("name", "is the name of another point, too", "give each a name of its own");
      }
      point.weight = table.number("weight").value_or(1);
      if (!(point.weight > 0)) table.refuse_value("weight", "is not above 0", "for example weight = 0.3");
      const TomlValue* values = table.need("values", "{ \"operating.speed\" = \"1000 rpm\" }");
      if (values != nullptr && values->kind != TomlValue::Kind::kTable) {
        table.refuse_value("values", "is not a table", "for example { \"operating.speed\" = \"1000 rpm\" }");
      } else if (values != nullptr) {
        overrides_of_points_.push_back(overrides_of(*values));
        marks_of_points_.push_back(values->mark);
        problem_.points.push_back(point);
      }
    }
    if (!tables.empty()) return;
    problem_.points.push_back({"", 1});
    overrides_of_points_.emplace_back();
    marks_of_points_.push_back({path_, 0, 0, ""});
  }

  void read_variable_or_choice(const TomlValue& value) {
    TomlTable table(value, "[[variable]]", {"key", "lower", "upper", "how", "item", "spacing", "choices"}, faults_);
    const TomlValue* choices = table.find("choices");
    if (choices == nullptr) {
      if (auto variable = read_variable(table)) problem_.variables.push_back(std::move(*variable));
      return;
    }
    study::ChoiceVariable choice{table.needed_text("key", "\"lubricant.file\""), {}, table.mark()};
    for (const char* key : {"lower", "upper", "how", "item", "spacing"}) {
      table.refuse_key(key, "means nothing with choices", "keep one of the two");
    }
    for (const TomlValue& item : table.items("choices")) {
      choice.texts.push_back(override_of(choice.key, item).value);
    }
    if (choice.texts.empty()) table.refuse_value("choices", "has no values", "list at least one");
    problem_.choices.push_back(std::move(choice));
  }

  void read_objective(const TomlValue& value) {
    TomlTable table(value, "[[objective]]", {"quantity", "goal", "over"}, faults_);
    study::Objective objective;
    table.need("goal", "\"minimise\"");
    table.choose("goal", {{"minimise", Goal::kMinimise}, {"maximise", Goal::kMaximise}}, objective.goal);
    table.choose("over", over_words(), objective.over);
    if (auto quantity = read_quantity(table, known_)) {
      objective.quantity = std::move(*quantity);
      problem_.objectives.push_back(std::move(objective));
    }
  }

  void read_constraint(const TomlValue& value) {
    TomlTable table(value, "[[constraint]]", {"quantity", "at_least", "at_most", "over"}, faults_);
    const auto quantity = read_quantity(table, known_);
    if (!quantity) return;
    const bool has_lower = table.find("at_least") != nullptr, has_upper = table.find("at_most") != nullptr;
    if (!has_lower && !has_upper) {
      table.refuse(table.mark(), fmt::format("the constraint on {} has no limit", quantity->name),
                   "state at_least or at_most");
    }
    for (const bool is_lower : {true, false}) {
      const std::string key = is_lower ? "at_least" : "at_most";
      const std::string example = quantity->unit == "1" ? "0.1" : fmt::format("\"1 {}\"", quantity->display_unit);
      const auto limit = table.quantity(key, quantity->unit, example, units_);
      if (!limit) continue;
      study::Constraint constraint{*quantity, is_lower, *limit, is_lower ? OverPoints::kMin : OverPoints::kMax};
      table.choose("over", over_words(), constraint.over);
      problem_.constraints.push_back(std::move(constraint));
    }
    const std::size_t n = problem_.constraints.size();
    if (has_lower && has_upper && n >= 2 && problem_.constraints[n - 2].limit > problem_.constraints[n - 1].limit) {
      table.refuse_value("at_least", "is above at_most", "are they exchanged?");
    }
  }

  static std::vector<std::pair<std::string, OverPoints>> over_words() {
    return {{"mean", OverPoints::kMean}, {"lowest", OverPoints::kMin}, {"highest", OverPoints::kMax}};
  }

  void read_options(TomlTable& root) {
    const TomlValue* value = root.find("optimise");
    if (value == nullptr) return;
    TomlTable table(*value, "[optimise]", {"starts", "seed", "front_points", "evaluations"}, faults_);
    const auto read = [&](const std::string& key, std::size_t most, std::size_t& target) {
      const TomlValue* stated = table.find(key);
      const auto count = stated != nullptr ? table.count(key, *stated, 1, most) : std::nullopt;
      if (count) target = static_cast<std::size_t>(*count);
    };
    read("starts", kMaxStarts, problem_.starts);
    read("front_points", kMaxFrontPoints, problem_.front_points);
    read("evaluations", kMaxEvaluations, problem_.max_evaluations);
    problem_.seed = table.count("seed").value_or(problem_.seed);
  }

  void read_bases() {
    if (problem_.n_combinations() > kMaxCombinations) {
      faults_.push_back({problem_.choices.front().mark,
                         fmt::format("the choices have {} combinations, each of which is searched by itself",
                                     problem_.n_combinations()),
                         fmt::format("at most {} are allowed; list fewer choices", kMaxCombinations)});
      return;
    }
    bases_.clear();
    for (std::size_t c = 0; c < problem_.n_combinations(); ++c) {
      const std::vector<std::size_t> chosen = problem_.combination(c);
      for (std::size_t p = 0; p < problem_.points.size(); ++p) {
        std::vector<Override> overrides = overrides_of_points_[p];
        for (std::size_t k = 0; k < chosen.size(); ++k) {
          overrides.push_back({problem_.choices[k].key, problem_.choices[k].texts[chosen[k]]});
        }
        add_base(overrides, problem_.choices.empty() ? marks_of_points_[p] : problem_.choices.front().mark);
        if (!faults_.empty()) return;
      }
    }
  }

  void check_variables() {
    for (Fault& fault : study::VariedCases(bases_, problem_.variables, compute_).faults()) {
      faults_.push_back(std::move(fault));
    }
  }

  const CaseQuantities& quantities_;
  study::Optimisation problem_;
  std::vector<cycle::Quantity> known_;
  std::vector<std::vector<Override>> overrides_of_points_;
  std::vector<SourceMark> marks_of_points_;
};

}  // namespace

OptimisationFile read_optimisation(const std::string& path, const CaseQuantities& quantities) {
  return OptimisationReader(path, quantities).read();
}

}  // namespace ringfilm::io
