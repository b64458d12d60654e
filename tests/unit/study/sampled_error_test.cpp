#include "ringfilm/study/sampled_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ringfilm/case/accuracy.hpp"
#include "ringfilm/study/design/kept_curves.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/ensemble/error_estimate.hpp"
#include "ringfilm/study/study_run.hpp"
#include "study_example.hpp"

namespace ringfilm::study {
namespace {

using testing::factor;
using testing::study_of;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Study speeds(std::vector<double> values) {
  return study_of({factor("operating.speed", Levels{std::move(values)}, FactorMode::kScale)}, Method::kGrid);
}

Study many_speeds() { return speeds({1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2, 2.1, 2.2, 2.3, 2.4, 2.5}); }

/// A force, a crank angle, both flows, and an input.
StudyValues some_values() {
  StudyValues values;
  for (const auto& [name, unit] :
       {std::pair{"force", "N"}, std::pair{"angle", "degree"}, std::pair{"net_oil_flow", "kg/s"},
        std::pair{"mean_absolute_oil_flow", "kg/s"}, std::pair{"input", "Pa"}}) {
    values.quantities.push_back({name, unit, unit, "", "", ""});
  }
  return values;
}

TEST(SampledError, IsTwiceTheChangeOnTheFinerGridRelativeToIt) {
  const SampledError error = compared(some_values(), {3, 7}, {{10.1, 5, 0.2, 4, 1}, {20, 5, 0.3, 4, 2}},
                                      {{10, 9, 0.1, 4, 1}, {20, 9, 0.3, 4, 2}}, {2.5, 0.5});
  EXPECT_EQ(error.scenarios, (std::vector<std::uint64_t>{3, 7}));
  EXPECT_EQ(error.n_unsolved, 0u);
  // With two values the quantile is the larger.
  EXPECT_NEAR(error.quantiles[0].value(), 0.02, 1e-12);
  EXPECT_FALSE(error.quantiles[1]) << "a crank angle has no relative error";
  EXPECT_NEAR(error.quantiles[2].value(), 2 * 0.1 / 4, 1e-12) << "relative to the flow of both directions";
  EXPECT_FALSE(error.quantiles[3]) << "the finer grid changes it in no scenario";
  EXPECT_FALSE(error.quantiles[4]);
  // Force and net flow of both scenarios, of which the net flow of the first is 5 % off.
  EXPECT_EQ(error.n_values, 4u);
  EXPECT_EQ(error.n_within, 3u);
  EXPECT_EQ(error.coverage(), 0.75);
  EXPECT_EQ(error.asked, (std::vector<double>{0.5, 2.5}));
}

TEST(SampledError, OfAShareOfARegimeIsRelativeToTheWhole) {
  StudyValues values;
  values.quantities.push_back({"full_film_cycle_share", "1", "%", "", "", "eq-regime-shares"});
  const SampledError error = compared(values, {0, 1}, {{0.02}, {0.5}}, {{0.01}, {0.5}}, {1.0, 1.0});
  EXPECT_NEAR(error.quantiles[0].value(), 2 * 0.01, 1e-12);
}

TEST(SampledError, OmitsScenariosWithoutOneOfBothResults) {
  const std::vector<double> none(5, kNone);
  const SampledError error = compared(some_values(), {0, 1, 2}, {{1, 0, 1, 1, 1}, none, {2, 0, 1, 1, 1}},
                                      {none, {2, 0, 1, 1, 1}, {2.5, 0, 1, 1, 1}}, {1.0, 1.0, std::nullopt});
  EXPECT_EQ(error.scenarios, std::vector<std::uint64_t>{2});
  EXPECT_EQ(error.n_unsolved, 2u);
  EXPECT_NEAR(error.quantiles[0].value(), 2 * 0.5 / 2.5, 1e-12);
  EXPECT_FALSE(error.coverage()) << "no accuracy is asked for where it was solved";
}

TEST(SampledError, TakesOneScenarioOfEachPartOfThePlan) {
  Study study = many_speeds();
  study.accuracy.sample = 5;
  const Plan plan(study);
  const std::vector<std::uint64_t> scenarios = sampled_scenarios(plan);
  ASSERT_EQ(scenarios.size(), 5u);
  for (std::uint64_t k = 0; k < 5; ++k) {
    const ScenarioRange part = shard_range(plan.size(), k + 1, 5);
    EXPECT_GE(scenarios[k], part.first);
    EXPECT_LT(scenarios[k], part.end);
  }
  EXPECT_EQ(sampled_scenarios(Plan(study)), scenarios);
}

TEST(SampledError, SampleIsWhatTheStudyStatesOrSixteenWhereAnAccuracyIsAskedFor) {
  Study study = many_speeds();
  study.bases.push_back(study.bases.front());
  study.bases.back().name = "again";
  EXPECT_EQ(sample_size(Plan(study)), 0u) << "the cells of coarse_case are stated";
  study.bases.back().input.solver.accuracy = 5;
  EXPECT_EQ(sample_size(Plan(study)), 16u);
  study.accuracy.sample = 0;
  EXPECT_EQ(sample_size(Plan(study)), 0u);
  study.accuracy.sample = 1000;
  EXPECT_EQ(sample_size(Plan(study)), 32u);
}

/// Six times the cells and steps, far finer than what the estimate takes.
cycle::Case far_finer(const cycle::Case& c) {
  cycle::Case fine = finer_grid(c);
  fine.solver.cells *= 3;
  fine.solver.crank_step_deg /= 4;
  fine.solver.step_error /= 64;
  return fine;
}

TEST(SampledError, EstimateIsNotBelowTheErrorAgainstAFarFinerGrid) {
  Study study = speeds({0.5, 1, 2, 3});
  study.bases[0].input.film.cavitation = cycle::Cavitation::kMassConserving;
  study.bases[0].input.solver = {};
  study.bases[0].input.solver.accuracy = 5;
  study.accuracy.sample = 4;
  const Plan plan(study);
  const auto same = [](const cycle::Case& c) { return c; };
  const std::vector<std::uint64_t> all = {0, 1, 2, 3};
  const auto own = values_of_changed(plan, all, same), truth = values_of_changed(plan, all, far_finer);
  const auto error = sampled_error(plan, [&](std::uint64_t i) { return own[i]; });
  ASSERT_TRUE(error);
  EXPECT_EQ(error->scenarios, all);
  std::size_t n = 0, n_above = 0;
  for (std::size_t i = 0; i < plan.values().quantities.size(); ++i) {
    if (!error->quantiles[i] || plan.values().quantities[i].name == "net_oil_flow") continue;
    double largest = 0;
    // Errors of the shares of regimes are those of the whole.
    const bool is_share = cycle::is_regime_share(plan.values().quantities[i]);
    for (const std::uint64_t k : all) {
      largest = std::fmax(largest, std::abs(own[k][i] - truth[k][i]) / (is_share ? 1 : std::abs(truth[k][i])));
    }
    ++n;
    n_above += largest <= *error->quantiles[i] ? 1 : 0;
  }
  EXPECT_GT(n, 30u);
  // The full estimate, of four grids, covers 99 % (docs/theory/error-estimate.md); one grid cannot know the order.
  EXPECT_GE(static_cast<double>(n_above), 0.9 * static_cast<double>(n)) << n_above << " of " << n;
  EXPECT_GT(error->coverage().value(), 0.9);
}

TEST(SampledError, ThreadsChangeNoBit) {
  Study study = speeds({1, 1.5, 2});
  study.accuracy.sample = 3;
  const Plan plan(study);
  const std::vector<std::uint64_t> all = {0, 1, 2};
  BatchOptions one, two;
  one.threads = 1;
  two.threads = 2;
  EXPECT_EQ(values_of_changed(plan, all, finer_grid, {}, one), values_of_changed(plan, all, finer_grid, {}, two));
}

TEST(AccuracyOfStudy, IsThatOfFilmsWhoseCellsAndStepsAreNotStated) {
  Study study = speeds({1});
  cycle::Case c = study.bases[0].input;
  c.solver = {};
  EXPECT_EQ(with_accuracy_of_study(c, study).solver.accuracy, study.accuracy.asked);
  cycle::Case stated = c;
  stated.stated.insert("solver.cells");
  EXPECT_FALSE(with_accuracy_of_study(stated, study).solver.accuracy) << "200 cells, as stated";
  EXPECT_FALSE(with_accuracy_of_study(study.bases[0].input, study).solver.accuracy);
  stated.solver.accuracy = 1;
  EXPECT_EQ(with_accuracy_of_study(stated, study).solver.accuracy, 1);
  cycle::Case with_oil = c;
  with_oil.film.chamber_edge = cycle::EdgeFluid::kGas;
  EXPECT_EQ(with_accuracy_of_study(with_oil, study).solver.accuracy, study.accuracy.asked);
  with_oil.film.supply = cycle::OilSupply::kGiven;
  EXPECT_FALSE(with_accuracy_of_study(with_oil, study).solver.accuracy) << "no figures are known";
  study.accuracy.asked.reset();
  EXPECT_FALSE(with_accuracy_of_study(c, study).solver.accuracy);
}

TEST(AccuracyOfStudy, IsNotAskedOfScenariosWhoseCellsAreAFactor) {
  Study study = study_of({factor("solver.cells", Levels{{60, 200}})}, Method::kGrid);
  study.bases[0].input.solver = {};
  const Plan plan(study);
  for (const std::uint64_t i : {0, 1}) {
    const cycle::Case c = scenario_case(plan.study(), plan.point(i));
    EXPECT_FALSE(c.solver.accuracy);
    EXPECT_EQ(c.solver.cells, i == 0 ? 60 : 200);
  }
  EXPECT_EQ(sample_size(plan), 0u);
}

TEST(AccuracyOfStudy, IsSampledWhereAFactorAsksForIt) {
  Study study = study_of({factor("solver.accuracy", Levels{{1, 5}})}, Method::kGrid);
  EXPECT_EQ(sample_size(Plan(study)), 2u);
  study.factors = {factor("operating.speed", Levels{{1, 2}}, FactorMode::kScale)};
  EXPECT_EQ(sample_size(Plan(study)), 0u) << "its base states cells";
}

TEST(AccuracyOfStudy, TakesStepsThatEndWhereCurvesAreKept) {
  Study study = speeds({1});
  study.keep.curves = Curves::kAll;
  study.keep.quantities = {"min_film_thickness"};
  study.keep.crank_step_deg = 0.75;
  EXPECT_EQ(faults_of_keep(study).size(), 1u) << "its base has steps of 1 degree";
  study.bases[0].input.solver = {};
  EXPECT_TRUE(faults_of_keep(study).empty());
  cycle::Case c = with_accuracy_of_study(study.bases[0].input, study);
  ask_for_kept(study.keep, c);
  EXPECT_EQ(cycle::with_accuracy(c).solver.crank_step_deg, 0.75);
}

}  // namespace
}  // namespace ringfilm::study
