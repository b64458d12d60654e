#include "ringfilm/study/inverse/variable.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

#include "ringfilm/base/number_text.hpp"
#include "ringfilm/study/design/plan.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

namespace ringfilm::study {
namespace {

/// Number at a place of a case; nullptr where the case has none there.
struct NumberPlace {
  cycle::Case& c;
  const Variable& variable;

  double* operator()(const cycle::NumberKind& kind) const { return &kind.ref(c); }
  double* operator()(const cycle::UnitNameKind& kind) const { return &kind.ref(c); }
  double* operator()(const cycle::NumberOrFileKind& kind) const { return kind.file(c) ? nullptr : &kind.number(c); }
  double* operator()(const cycle::OptionalNumberKind& kind) const { return at(kind.ref(c)); }
  double* operator()(const cycle::OptionalNumberOrFileKind& kind) const { return at(kind.ref(c).constant); }
  double* operator()(const cycle::ConstantOrTemperatureValuesKind& kind) const { return at(kind.constant(c)); }
  double* operator()(const cycle::NumberListKind& kind) const {
    std::vector<double>& list = kind.ref(c);
    return variable.item && *variable.item >= 1 && *variable.item <= list.size() ? &list[*variable.item - 1] : nullptr;
  }
  double* operator()(const cycle::StrokeValuesKind& kind) const {
    return kind.ref(c).size() == 1 ? &kind.ref(c).front().value : nullptr;
  }
  template <class Other>
  double* operator()(const Other&) const {
    return nullptr;
  }

 private:
  static double* at(std::optional<double>& number) { return number ? &*number : nullptr; }
};

/// Is it a number that factors of studies do not have: one of a list, or the size of a unit of a face?
bool is_own(const Variable& variable) {
  const cycle::Field* field = field_of_key(variable.key);
  if (field == nullptr) return false;
  const bool is_face_unit =
      std::holds_alternative<cycle::UnitNameKind>(field->kind) && field->key.find(".face.") != std::string::npos;
  return is_face_unit || (variable.item && std::holds_alternative<cycle::NumberListKind>(field->kind));
}

Factor factor_of(const Variable& variable) {
  Factor factor;
  factor.name = variable.name();
  factor.targets = {{std::nullopt, variable.key, 1.0}};
  factor.how = variable.how;
  factor.variation = Span{variable.lower, variable.upper, 2, variable.spacing};
  factor.unit = variable.unit;
  factor.display_unit = variable.display_unit;
  factor.mark = variable.mark;
  return factor;
}

void check_own(const Variable& variable, const cycle::Case& base, std::vector<Fault>& faults) {
  const auto refuse = [&](const std::string& predicate, const std::string& remedy) {
    faults.push_back({variable.mark, variable.name() + " " + predicate, remedy});
  };
  if (variable.how != FactorMode::kSet) refuse("is set, not scaled or added to", "remove how");
  cycle::Case own = base;
  for (const auto& [of, field] : places_of_key(own, variable.key)) {
    if (!cycle::belongs(*field, *of) || !cycle::is_active(*field, *of)) {
      return refuse("is not in use in the case",
                    field->active_when.empty() ? "name a key of the case" : "it is with " + field->active_when);
    }
    if (std::visit(NumberPlace{*of, variable}, field->kind) == nullptr) {
      return refuse("does not exist in the case", "items of a list count from 1");
    }
  }
}

}  // namespace

double value_at(const Variable& variable, double place) {
  if (place <= 0) return variable.lower;
  if (place >= 1) return variable.upper;
  if (variable.spacing == Spacing::kLinear) return variable.lower + (variable.upper - variable.lower) * place;
  return variable.lower * std::pow(variable.upper / variable.lower, place);
}

double place_of(const Variable& variable, double value) {
  if (variable.spacing == Spacing::kLinear) return (value - variable.lower) / (variable.upper - variable.lower);
  return value > 0 ? std::log(value / variable.lower) / std::log(variable.upper / variable.lower) : -1;
}

double slope_at(const Variable& variable, double place) {
  if (variable.spacing == Spacing::kLinear) return variable.upper - variable.lower;
  return value_at(variable, place) * std::log(variable.upper / variable.lower);
}

std::vector<double> values_at(const std::vector<Variable>& variables, const std::vector<double>& places) {
  std::vector<double> values;
  for (std::size_t i = 0; i < variables.size(); ++i) values.push_back(value_at(variables[i], places[i]));
  return values;
}

VariedCases::VariedCases(std::vector<cycle::Case> bases, std::vector<Variable> variables, Compute compute)
    : variables_(std::move(variables)) {
  study_.compute = compute;
  study_.accuracy.asked.reset();
  study_.sampling.method = Method::kGrid;
  for (cycle::Case& base : bases) study_.bases.push_back({std::to_string(study_.bases.size() + 1), std::move(base)});
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    if (is_own(variables_[i])) continue;
    study_.factors.push_back(factor_of(variables_[i]));
    factors_.push_back(i);
  }
}

std::vector<Fault> VariedCases::faults() const {
  std::vector<Fault> faults;
  std::set<std::string> names;
  for (const Variable& variable : variables_) {
    if (!names.insert(variable.name()).second) {
      faults.push_back({variable.mark, variable.name() + " is varied twice", "keep one of the two"});
    }
    if (!is_own(variable)) continue;
    check_own(variable, base(0), faults);
    if (variable.lower >= variable.upper) {
      faults.push_back(
          {variable.mark,
           variable.name() + " has bounds from " + number_text(variable.lower) + " to " + number_text(variable.upper),
           "lower must be below upper"});
    }
  }
  for (const Factor& factor : study_.factors) {
    const auto& span = std::get<Span>(factor.variation);
    if (span.low < span.high) continue;
    faults.push_back({factor.mark,
                      factor.name + " has bounds from " + number_text(span.low) + " to " + number_text(span.high) +
                          " " + factor.unit,
                      "lower must be below upper"});
  }
  if (!faults.empty() || study_.factors.empty()) return faults;
  for (Fault fault : faults_of(study_)) {
    if (fault.message.starts_with("factor ")) fault.message.erase(0, std::string("factor ").size());
    faults.push_back(std::move(fault));
  }
  return faults;
}

std::optional<double> VariedCases::value_of_base(std::size_t i, std::size_t j) const {
  const Variable& variable = variables_.at(j);
  if (variable.how == FactorMode::kScale) return 1.0;
  if (variable.how == FactorMode::kAdd) return 0.0;
  cycle::Case own = base(i);
  for (const auto& [of, field] : places_of_key(own, variable.key)) {
    const double* number = std::visit(NumberPlace{*of, variable}, field->kind);
    if (number != nullptr) return *number;
  }
  return std::nullopt;
}

std::vector<double> VariedCases::own_places() const {
  std::vector<double> places;
  for (std::size_t j = 0; j < variables_.size(); ++j) {
    const std::optional<double> value = value_of_base(0, j);
    const double place = value ? place_of(variables_[j], *value) : -1;
    places.push_back(place > 0 && place < 1 ? place : 0.5);
  }
  return places;
}

cycle::Case VariedCases::at(std::size_t base, const std::vector<double>& values) const {
  Point point{base, {}};
  for (const std::size_t i : factors_) point.values.push_back(values.at(i));
  cycle::Case c = scenario_case(study_, point);
  if (factors_.size() == variables_.size()) return c;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    if (!is_own(variables_[i])) continue;
    for (const auto& [of, field] : places_of_key(c, variables_[i].key)) {
      double* number = std::visit(NumberPlace{*of, variables_[i]}, field->kind);
      if (number == nullptr) throw InputError(variables_[i].name() + " does not exist in the case");
      *number = values[i];
      of->stated.insert(field->key);
    }
  }
  check_rules(c);
  return c;
}

}  // namespace ringfilm::study
