#include <gmock/gmock.h>

#include <limits>

#include "../study_example.hpp"
#include "ringfilm/study/design/plan.hpp"

namespace ringfilm::study {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Study with(Variation variation, std::string key = "operating.speed", FactorMode how = FactorMode::kSet,
           Method method = Method::kSobol) {
  return study_of({factor("x", std::move(variation), how, std::move(key))}, method);
}

Study of_three(double ab, double ac, double bc, Method method = Method::kSobol) {
  Study study = formula_study({normal(0, 1), normal(0, 1), normal(0, 1)}, 16, 1);
  study.sampling.method = method;
  study.correlations = {{0, 1, ab, {}}, {0, 2, ac, {}}, {1, 2, bc, {}}};
  return study;
}

TEST(PlanFaults, NoneInAGoodStudy) {
  EXPECT_THAT(reported(with(uniform(100, 300))), IsEmpty());
  EXPECT_THAT(reported(of_three(0.5, 0.2, -0.3)), IsEmpty());
}

TEST(PlanFaults, OfDistributionsNameTheFactor) {
  EXPECT_THAT(reported(with(normal(100, -1))),
              HasSubstr("factor \"x\" has the standard deviation -1 | it must be above 0"));
  Distribution nowhere = normal(100, 1);
  nowhere.lowest = 200;
  EXPECT_THAT(reported(with(nowhere)), HasSubstr("factor \"x\" has no support"));
}

TEST(PlanFaults, OfKeys) {
  EXPECT_THAT(reported(with(uniform(1, 2), "operating.sped")),
              HasSubstr("factor \"x\" names the key operating.sped, which does not exist"));
  EXPECT_THAT(reported(with(uniform(1, 2), "film.cavitation")),
              HasSubstr("factor \"x\" has numbers for film.cavitation, which is not a number"));
  EXPECT_THAT(reported(with(uniform(1, 2), "title")), HasSubstr("which is not a number"));
  EXPECT_THAT(reported(with(uniform(1, 2), "lubricant.file")), HasSubstr("which is not a number"));
  EXPECT_THAT(reported(with(uniform(1, 2), "output.crank_angles")), HasSubstr("which is not a number"));
  EXPECT_THAT(reported(with(uniform(1, 2), "solver.cells")), HasSubstr("draws solver.cells, which is a whole number"));
  EXPECT_THAT(reported(with(uniform(1, 2), "ring.face.coefficients", FactorMode::kAdd)), HasSubstr("it can be scaled"));
  EXPECT_THAT(reported(with(uniform(0.9, 1.1), "ring.face.coefficients", FactorMode::kScale)), IsEmpty());
  EXPECT_THAT(reported(with(uniform(1e-9, 2e-9), "lubricant.dh_a")), IsEmpty());
  Study unused = with(uniform(1e-9, 2e-9), "lubricant.dh_a");
  unused.bases[0].input.lubricant.compressibility = cycle::Compressibility::kNone;
  EXPECT_THAT(reported(unused), HasSubstr("not in use in base \"new\" | it is with lubricant.compressibility"));
  unused.factors.push_back(factor("lubricant.compressibility", Choices{{{"dowson-higginson", {}}, {"none", {}}}}));
  EXPECT_THAT(reported(unused), IsEmpty()) << "a choice may bring it into use";
  for (const char* key : {"title", "lubricant.name", "contact.measured.filter", "ring.face.measured.trace"})
    EXPECT_THAT(reported(with(Choices{{{"a", {}}, {"b", {}}}}, key)), HasSubstr("does not enter the computation"))
        << key;
  EXPECT_THAT(reported(with(Choices{{{"measured", {}}}}, "gas.trace_origin")),
              HasSubstr("does not enter the computation"));
  EXPECT_THAT(reported(with(uniform(1, 2), "ring.face.measured.residual_rms")),
              HasSubstr("does not enter the computation"));
  EXPECT_THAT(reported(with(uniform(1e-3, 2e-3), "pad.length")), HasSubstr("which base \"new\" does not have"));
  Study none = with(uniform(100, 300));
  none.factors[0].targets.clear();
  EXPECT_THAT(reported(none), HasSubstr("factor \"x\" moves no key"));
  Study beyond = with(uniform(100, 300));
  beyond.factors[0].targets[0].base = 1;
  EXPECT_THAT(reported(beyond), HasSubstr("moves a base that does not exist"));
}

TEST(PlanFaults, OfValuesOutOfTheRangeOfTheirKey) {
  EXPECT_THAT(reported(with(Levels{{100, -5}})),
              HasSubstr("factor \"x\" has the value -5 rad/s for operating.speed, which is out of range"));
  EXPECT_THAT(reported(with(Levels{{0, 100}})),
              HasSubstr("has the value 0 rad/s for operating.speed, which is out of range "
                        "| allowed is above 0 rad/s to 2094.4 rad/s"));
  EXPECT_THAT(reported(with(uniform(-1, 100))), HasSubstr("out of range"));
  EXPECT_THAT(reported(with(Span{100, 1e6, 3, Spacing::kLinear})), HasSubstr("out of range"));
  EXPECT_THAT(reported(with(normal(-3, 1))), HasSubstr("out of range")) << "at its median";
  EXPECT_THAT(reported(with(normal(100, 60))), IsEmpty()) << "a tail out of range refuses scenarios, not the study";
  Distribution cut = normal(100, 60);
  cut.lowest = 0;
  EXPECT_THAT(reported(with(cut)), IsEmpty()) << "an end that is excluded is never drawn";
}

TEST(PlanFaults, OfValues) {
  EXPECT_THAT(reported(with(Levels{})), HasSubstr("factor \"x\" has no values"));
  EXPECT_THAT(reported(with(Levels{{100, 200, 100}})), HasSubstr("has the value 100 twice"));
  EXPECT_THAT(reported(with(Levels{{100, std::numeric_limits<double>::quiet_NaN()}})), HasSubstr("not finite"));
  EXPECT_THAT(reported(with(Span{200, 100, 3, Spacing::kLinear})), HasSubstr("the first must be below the second"));
  EXPECT_THAT(reported(with(Span{100, 200, 1, Spacing::kLinear})), HasSubstr("a range of 1 points"));
  EXPECT_THAT(reported(with(Span{-1, 200, 5, Spacing::kLogarithmic}, "gas.crankcase_pressure", FactorMode::kAdd)),
              HasSubstr("both ends must be above 0"));
  EXPECT_THAT(reported(with(Listed{})), HasSubstr("only a list of scenarios brings its own"));
  EXPECT_THAT(reported(with(Choices{{{"mass-conserving", {}}, {"perfect", {}}}}, "film.cavitation")),
              HasSubstr("has \"perfect\", which film.cavitation does not accept | choose among reynolds-exit"));
  EXPECT_THAT(reported(with(Choices{{{"a", {}}}})), HasSubstr("has texts for operating.speed, which is a number"));
  EXPECT_THAT(reported(with(Choices{{{"oil.toml", {}}}}, "lubricant.file")), HasSubstr("no file was read for it"));
  EXPECT_THAT(reported(with(Choices{{{"none", {}}, {"none", {}}}}, "lubricant.compressibility")),
              HasSubstr("\"none\" twice"));
}

TEST(PlanFaults, OfNamesAndOfKeysThatAreSetTwice) {
  Study study = study_of({factor("x", uniform(100, 200), FactorMode::kSet, "operating.speed"),
                          factor("x", uniform(0.9, 1.1), FactorMode::kScale, "contact.roughness")});
  EXPECT_THAT(reported(study), HasSubstr("factor \"x\" is repeated"));
  study.factors[1] = factor("y", uniform(100, 200), FactorMode::kSet, "operating.speed");
  EXPECT_THAT(reported(study), HasSubstr("factor \"y\" sets operating.speed, as factor \"x\" does"));
  study.factors[1].how = FactorMode::kScale;
  EXPECT_THAT(reported(study), IsEmpty());
  study.bases.clear();
  study.factors.clear();
  EXPECT_THAT(reported(study), HasSubstr("the study has no base case"));
  EXPECT_THAT(reported(study), HasSubstr("the study has no factor"));
}

TEST(PlanFaults, OfCorrelations) {
  EXPECT_THAT(
      reported(of_three(0.9, 0.9, -0.9)),
      HasSubstr("the correlations of x1 and x2 and x3 cannot hold at once: their matrix is not positive definite, "
                "as factor \"x3\" shows"));
  EXPECT_THAT(reported(of_three(1, 0, 0)), HasSubstr("the correlation of factor \"x1\" and factor \"x2\" is 1"));
  EXPECT_THAT(reported(of_three(std::numeric_limits<double>::quiet_NaN(), 0, 0)), HasSubstr("is nan"));
  Study study = of_three(0.1, 0.1, 0.1);
  study.correlations[1] = {1, 0, 0.2, {}};
  EXPECT_THAT(reported(study), HasSubstr("is repeated"));
  study.correlations[1] = {1, 1, 0.2, {}};
  EXPECT_THAT(reported(study), HasSubstr("factor \"x2\" is correlated with itself"));
  study.correlations[1] = {1, 7, 0.2, {}};
  EXPECT_THAT(reported(study), HasSubstr("a factor that does not exist"));
  study = of_three(0.1, 0.1, 0.1);
  study.factors[2].variation = Levels{{1, 2}};
  EXPECT_THAT(reported(study), HasSubstr("factor \"x3\" is correlated, but has no distribution and no range"));
  EXPECT_THAT(reported(of_three(0.1, 0.1, 0.1, Method::kMorris)), HasSubstr("correlations have no place"));
  EXPECT_THAT(reported(of_three(0.1, 0.1, 0.1, Method::kLatinHypercube)), IsEmpty());
}

TEST(PlanFaults, OfPlans) {
  const auto of = [](const std::function<void(Study&)>& change) {
    Study study = with(uniform(100, 300));
    change(study);
    return reported(study);
  };
  EXPECT_THAT(of([](Study& s) { s.sampling.scenarios = 0; }), HasSubstr("plan.scenarios = 0"));
  EXPECT_THAT(of([](Study& s) { s.sampling.scenarios = (std::uint64_t{1} << 32) + 1; }), HasSubstr("at most 2^32"));
  EXPECT_THAT(of([](Study& s) { s.sampling.method = Method::kGrid; }),
              HasSubstr("factor \"x\" has a distribution, which a grid cannot lay out"));
  EXPECT_THAT(of([](Study& s) {
                s.sampling.method = Method::kLatinHypercube;
                s.sampling.indices = Indices::kFirstAndTotal;
              }),
              HasSubstr("plan.indices require Sobol points"));
  EXPECT_THAT(of([](Study& s) {
                s.sampling.method = Method::kMorris;
                s.sampling.levels = 5;
              }),
              HasSubstr("an even number"));
  EXPECT_THAT(of([](Study& s) {
                s.sampling.method = Method::kMorris;
                s.sampling.trajectories = 1;
              }),
              HasSubstr("plan.trajectories = 1"));
  EXPECT_THAT(of([](Study& s) { s.sampling.method = Method::kList; }), HasSubstr("the list of scenarios is empty"));
  EXPECT_THAT(of([](Study& s) {
                s.sampling.method = Method::kList;
                s.sampling.list = {{100}, {100, 200}};
              }),
              HasSubstr("scenario 2 of the list has 2 values"));
  EXPECT_THAT(of([](Study& s) {
                s.sampling.method = Method::kLatinHypercube;
                s.sampling.until = StoppingRule{"fmep", {}, 1, 10000};
              }),
              HasSubstr("this plan cannot be extended"));
  EXPECT_THAT(of([](Study& s) {
                s.sampling.until = StoppingRule{"fmeep", {}, 1, 10000};
              }),
              HasSubstr("no value fmeep"));
  EXPECT_THAT(of([](Study& s) {
                s.sampling.until = StoppingRule{"fmep", 1.5, 1, 10000};
              }),
              HasSubstr("the quantile is 1.5"));
  EXPECT_THAT(of([](Study& s) { s.sampling.until = StoppingRule{"fmep", {}, 0, 10000}; }), HasSubstr("the width is 0"));
  EXPECT_THAT(of([](Study& s) {
                s.sampling.until = StoppingRule{"fmep", {}, 1, 3};
              }),
              HasSubstr("below plan.scenarios"));
  EXPECT_THAT(of([](Study& s) {
                const Choices files{{{"a", {}}, {"b", {}}}};
                s.factors = {factor("lubricant.file", files), factor("lubricant.table", files)};
              }),
              HasSubstr("chooses files for lubricant.table, as factor \"lubricant.file\" does"));
  EXPECT_THAT(of([](Study& s) { s.kind = StudyKind::kMap; }), HasSubstr("kind = \"map\" without a grid"));
  EXPECT_THAT(of([](Study& s) { s.kind = StudyKind::kScreening; }), HasSubstr("without trajectories"));
  Study vast = study_of({}, Method::kGrid);
  for (const std::string& key : some_keys())
    vast.factors.push_back(factor(key, Span{1, 2, 1000, Spacing::kLinear}, FactorMode::kScale));
  EXPECT_THAT(reported(vast), HasSubstr("the grid has 1e+18 points"));
}

TEST(PlanFaults, AllAreReportedAtOnceWithTheirPlaces) {
  Study study = study_of({factor("a", normal(100, -1), FactorMode::kSet, "operating.speed"),
                          factor("b", uniform(1, 2), FactorMode::kSet, "no.such_key")});
  study.factors[0].mark = {"study.toml", 7, 1, "deviation = -1"};
  try {
    const Plan plan(study);
    FAIL() << "nothing may run";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().size(), 2u);
    EXPECT_THAT(error.what(), HasSubstr("study.toml:7:1: factor \"a\" has the standard deviation -1"));
    EXPECT_THAT(error.what(), HasSubstr("no.such_key"));
  }
}

}  // namespace
}  // namespace ringfilm::study
