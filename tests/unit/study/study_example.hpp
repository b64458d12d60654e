#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/study/design/plan.hpp"
#include "study_case.hpp"

/// Studies of which no case is ever run.
namespace ringfilm::study::testing {

inline Factor factor(const std::string& name, Variation variation, FactorMode how = FactorMode::kSet,
                     const std::string& key = {}) {
  return {name, {{std::nullopt, key.empty() ? name : key, 1.0}}, how, std::move(variation), {}, {}, {}};
}

inline Study study_of(std::vector<Factor> factors, Method method = Method::kSobol, std::uint64_t scenarios = 64) {
  Study study;
  study.bases = {{"new", coarse_case()}};
  study.factors = std::move(factors);
  study.sampling.method = method;
  study.sampling.scenarios = scenarios;
  return study;
}

/// Keys that take any number that is added to them, for models that are only formulas.
inline const std::vector<std::string>& some_keys() {
  static const std::vector<std::string> keys = {"engine.bore",       "engine.stroke",   "operating.speed",
                                                "contact.roughness", "ring.face_width", "contact.asperity_radius"};
  return keys;
}

inline Study formula_study(const std::vector<Variation>& variations, std::uint64_t rows, std::uint64_t seed) {
  Study study = study_of({}, Method::kSobol, rows);
  for (std::size_t j = 0; j < variations.size(); ++j)
    study.factors.push_back(
        factor(std::string("x").append(std::to_string(j + 1)), variations[j], FactorMode::kAdd, some_keys().at(j)));
  study.seed = seed;
  return study;
}

using Formula = std::function<double(const std::vector<double>&)>;

/// The numbers of a point, every one of which is there.
inline std::vector<double> numbers(const Point& point) {
  std::vector<double> all;
  for (const auto& value : point.values) all.push_back(value.value());
  return all;
}

inline std::vector<double> values_of(const Plan& plan, const Formula& formula) {
  std::vector<double> values;
  for (std::uint64_t p = 0; p < plan.n_points(0); ++p)
    values.push_back(formula(numbers(plan.point(plan.scenario(0, p)))));
  return values;
}

/// The messages of all faults, line by line, and what to do.
inline std::string reported(const Study& study) {
  std::string text;
  for (const Fault& fault : faults_of(study)) text += fault.message + " | " + fault.remedy + "\n";
  return text;
}

}  // namespace ringfilm::study::testing
