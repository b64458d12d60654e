#include "ringfilm/study/inverse/optimisation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/base/error.hpp"
#include "ringfilm/study/inverse/constrained_search.hpp"

namespace {

using namespace ringfilm::study;

Variable variable(const std::string& key, double lower, double upper) {
  Variable one;
  one.key = key;
  one.lower = lower;
  one.upper = upper;
  one.unit = "1";
  return one;
}

Objective objective(const std::string& name, Goal goal = Goal::kMinimise) {
  Objective one;
  one.quantity.name = name;
  one.goal = goal;
  return one;
}

Optimisation one_objective() {
  Optimisation problem;
  problem.objectives = {objective("f")};
  problem.variables = {variable("x", -2, 2), variable("y", -2, 2)};
  problem.points = {{"", 1}};
  return problem;
}

/// Computes designs from functions of the values.
template <class Objectives, class Constraints>
DesignFunction designs(const Optimisation& problem, const Objectives& objectives, const Constraints& constraints) {
  return [=, &problem](std::size_t combination, const std::vector<double>& places) {
    Design design;
    design.combination = combination;
    design.places = places;
    design.values = values_at(problem.variables, places);
    design.objectives = objectives(design.values);
    design.constraints = constraints(design.values);
    return design;
  };
}

const auto kNoConstraint = [](const std::vector<double>&) { return std::vector<double>{}; };

TEST(Optimise, RayleighsStepIsFound) {
  // Load coefficient 3 (H - 1) a (1 - a)/(H^3 (1 - a) + a) of a step of H = h1/h0 over the part a of the length.
  Optimisation problem = one_objective();
  problem.objectives = {objective("load", Goal::kMaximise)};
  problem.variables = {variable("H", 1.1, 4), variable("a", 0.2, 0.95)};
  const auto load = [](const std::vector<double>& x) {
    return std::vector{3 * (x[0] - 1) * x[1] * (1 - x[1]) / (std::pow(x[0], 3) * (1 - x[1]) + x[1])};
  };
  const auto result = optimise(problem, {0.5, 0.5}, designs(problem, load, kNoConstraint), 1);
  ASSERT_TRUE(result.best);
  EXPECT_NEAR(result.best->values[0], 1.866, 5e-4);  // digits of the published values
  EXPECT_NEAR(result.best->values[1], 0.718, 5e-4);
  EXPECT_NEAR(result.best->objectives[0], 0.20627, 5e-6);
}

TEST(Optimise, ConstraintBindsWhereItKeepsTheObjectiveBack) {
  // x^2 + y^2 with x + y >= 1 is 0.5 at (0.5, 0.5).
  Optimisation problem = one_objective();
  Constraint sum;
  sum.quantity.name = "sum";
  sum.limit = 1;
  problem.constraints = {sum};
  const auto f = [](const std::vector<double>& x) { return std::vector{x[0] * x[0] + x[1] * x[1]}; };
  const auto c = [](const std::vector<double>& x) { return std::vector{x[0] + x[1]}; };
  const auto result = optimise(problem, {0.5, 0.5}, designs(problem, f, c), 2);
  ASSERT_TRUE(result.best);
  EXPECT_GE(result.best->constraints[0], 1);  // met exactly
  EXPECT_NEAR(result.best->objectives[0], 0.5, 1e-5);
  EXPECT_THAT(result.binding, testing::ElementsAre(0u));
}

TEST(Optimise, TargetsThatCannotBeMetHaveTheirDistance) {
  Optimisation problem = one_objective();
  Constraint sum;
  sum.limit = 5;  // 4 is the most
  problem.constraints = {sum};
  const auto f = [](const std::vector<double>& x) { return std::vector{x[0]}; };
  const auto c = [](const std::vector<double>& x) { return std::vector{x[0] + x[1]}; };
  const auto result = optimise(problem, {0.5, 0.5}, designs(problem, f, c), 1);
  EXPECT_FALSE(result.best);
  ASSERT_TRUE(result.nearest);
  EXPECT_NEAR(excess(problem.constraints[0], result.nearest->constraints[0]), 1, 1e-4);
}

TEST(Optimise, FrontOfTwoQuadraticsIsTheirs) {
  // x^2 and (x - 2)^2 have the front sqrt(f1) + sqrt(f2) = 2.
  Optimisation problem = one_objective();
  problem.objectives = {objective("f1"), objective("f2")};
  problem.variables = {variable("x", -1, 3)};
  const auto f = [](const std::vector<double>& x) { return std::vector{x[0] * x[0], (x[0] - 2) * (x[0] - 2)}; };
  const auto result = optimise(problem, {0.2}, designs(problem, f, kNoConstraint), 1);
  EXPECT_GE(result.front.size(), 10u);
  for (const Design& design : result.front) {
    EXPECT_NEAR(std::sqrt(design.objectives[0]) + std::sqrt(design.objectives[1]), 2, 1e-3);
  }
  EXPECT_NEAR(result.front.front().objectives[0], 0, 1e-4);
  EXPECT_NEAR(result.front.back().objectives[1], 0, 1e-4);
  EXPECT_NEAR(result.best->values[0], 1, 0.01);
}

TEST(Optimise, BestChoiceIsFoundAmongCombinations) {
  Optimisation problem = one_objective();
  problem.choices = {{"oil", {"\"a\"", "\"b\"", "\"c\""}, {}}, {"coating", {"1", "2"}, {}}};
  ASSERT_EQ(problem.n_combinations(), 6u);
  const DesignFunction design = [&](std::size_t combination, const std::vector<double>& places) {
    Design one;
    one.combination = combination;
    one.places = places;
    one.values = values_at(problem.variables, places);
    const auto chosen = problem.combination(combination);
    one.objectives = {std::pow(one.values[0] - 1, 2) + std::pow(one.values[1], 2) + (chosen[0] == 1 ? 0. : 1.) +
                      (chosen[1] == 1 ? 0. : 2.)};
    return one;
  };
  const auto result = optimise(problem, {0.5, 0.5}, design, 2);
  EXPECT_THAT(problem.combination(result.best->combination), testing::ElementsAre(1u, 1u));
  EXPECT_NEAR(result.best->values[0], 1, 1e-3);
}

TEST(Optimise, DesignsWithoutASolutionAreAvoided) {
  Optimisation problem = one_objective();
  const DesignFunction design = [&](std::size_t combination, const std::vector<double>& places) {
    Design one;
    one.combination = combination;
    one.places = places;
    one.values = values_at(problem.variables, places);
    if (one.values[0] < -0.5) {
      one.reason = "no film";
    } else {
      one.objectives = {std::pow(one.values[0], 2) + std::pow(one.values[1] - 1, 2)};
    }
    return one;
  };
  const auto result = optimise(problem, {0.9, 0.1}, design, 1);
  EXPECT_NEAR(result.best->objectives[0], 0, 1e-6);
}

TEST(Optimise, ThreadsDoNotChangeTheResult) {
  const Optimisation problem = one_objective();
  const auto f = [](const std::vector<double>& x) { return std::vector{std::sin(5 * x[0]) + std::pow(x[1] - 0.3, 2)}; };
  const auto one = optimise(problem, {0.5, 0.5}, designs(problem, f, kNoConstraint), 1);
  const auto four = optimise(problem, {0.5, 0.5}, designs(problem, f, kNoConstraint), 4);
  EXPECT_EQ(one.best->values, four.best->values);
  EXPECT_EQ(one.designs.size(), four.designs.size());
}

TEST(NonDominated, KeepsThoseThatNoOtherBeats) {
  EXPECT_THAT(non_dominated({{1, 4}, {2, 2}, {3, 3}, {4, 1}, {2, 2}}), testing::ElementsAre(0u, 1u, 3u));
}

TEST(SpreadWeights, AddUpToOne) {
  const auto weights = spread_weights(3, 6);
  EXPECT_EQ(weights.size(), 10u);  // 5 choose 2 ways to divide six steps into three parts above 0
  for (const auto& one : weights) EXPECT_NEAR(one[0] + one[1] + one[2], 1, 1e-15);
}

}  // namespace
