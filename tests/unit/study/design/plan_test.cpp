#include "ringfilm/study/design/plan.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "../study_example.hpp"

namespace ringfilm::study {
namespace {

using namespace testing;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Values = std::vector<std::optional<double>>;

Study sampled(Method method, std::uint64_t scenarios, std::uint64_t seed = 1) {
  Study study = study_of({factor("operating.speed", uniform(100, 400)), factor("contact.roughness", normal(5e-7, 1e-8)),
                          factor("film.cavitation", Choices{{{"mass-conserving", {}}, {"reynolds-exit", {}}}}),
                          factor("engine.bore", Span{0.08, 0.09, 3, Spacing::kLogarithmic})},
                         method, scenarios);
  study.seed = seed;
  return study;
}

TEST(Plan, ScenariosDoNotDependOnTheOrderInWhichTheyAreAskedFor) {
  for (const Method method : {Method::kSobol, Method::kLatinHypercube}) {
    const Plan forwards(sampled(method, 100)), backwards(sampled(method, 100));
    std::vector<Values> there(100), back(100);
    for (std::size_t i = 0; i < 100; ++i) there[i] = forwards.point(i).values;
    for (std::size_t i = 100; i-- > 0;) back[i] = backwards.point(i).values;
    EXPECT_EQ(there, back);
    EXPECT_THROW(forwards.point(100), std::out_of_range);
  }
}

TEST(Plan, SobolPointsAndTrajectoriesAreExtendedWhereMoreAreRequested) {
  const Plan few(sampled(Method::kSobol, 16)), many(sampled(Method::kSobol, 1000));
  for (std::uint64_t i = 0; i < few.size(); ++i) EXPECT_EQ(few.point(i).values, many.point(i).values);
  EXPECT_EQ(few.digest_text(), many.digest_text());

  Study study = sampled(Method::kSobol, 16);
  study.sampling.indices = Indices::kFirstAndTotal;
  const Plan few_rows(study);
  study.sampling.scenarios = 40;
  const Plan many_rows(study);
  EXPECT_EQ(few_rows.size(), 16u * 6);
  for (std::uint64_t i = 0; i < few_rows.size(); ++i) EXPECT_EQ(few_rows.point(i).values, many_rows.point(i).values);

  study = sampled(Method::kMorris, 0);
  study.sampling.trajectories = 3;
  const Plan few_walks(study);
  study.sampling.trajectories = 30;
  const Plan many_walks(study);
  EXPECT_EQ(few_walks.size(), 15u);
  for (std::uint64_t i = 0; i < 15; ++i) EXPECT_EQ(few_walks.point(i).values, many_walks.point(i).values);
  EXPECT_EQ(few_walks.digest_text(), many_walks.digest_text());
}

TEST(Plan, ALatinHypercubeOfAnotherCountIsAnotherAndReportsIt) {
  const Plan few(sampled(Method::kLatinHypercube, 16)), many(sampled(Method::kLatinHypercube, 32));
  EXPECT_NE(few.point(0).values, many.point(0).values);
  EXPECT_NE(few.digest_text(), many.digest_text());
  EXPECT_THAT(few.notes(), Contains(HasSubstr("cannot be extended")));
  EXPECT_THAT(Plan(sampled(Method::kSobol, 16)).notes(),
              ElementsAre(HasSubstr("wider than need be"), HasSubstr("cylinder pressure stays the same")));
  EXPECT_THAT(Plan(sampled(Method::kSobol, 17)).notes(), Contains(HasSubstr("not a power of two")));
}

TEST(Plan, SamplesAreSpreadOverEachFactor) {
  for (const Method method : {Method::kSobol, Method::kLatinHypercube}) {
    const Plan plan(sampled(method, 64));
    std::set<int> parts;
    int n_exit = 0;
    double below = 0;
    for (std::uint64_t i = 0; i < 64; ++i) {
      const auto x = numbers(plan.point(i));
      parts.insert(static_cast<int>((x[0] - 100) / 300 * 64));
      n_exit += x[2] == 1;
      below += x[1] < 5e-7;
      EXPECT_TRUE(x[2] == 0 || x[2] == 1);
      EXPECT_TRUE(x[3] > 0.08 && x[3] < 0.09);
      EXPECT_TRUE(plan.is_sample(i));
    }
    EXPECT_EQ(parts.size(), 64u) << "one in each of 64 equal parts";
    EXPECT_EQ(n_exit, 32);
    EXPECT_EQ(below, 32);
  }
}

TEST(Plan, SeedsGiveOtherPoints) {
  EXPECT_NE(Plan(sampled(Method::kSobol, 16, 1)).point(0).values, Plan(sampled(Method::kSobol, 16, 2)).point(0).values);
  EXPECT_NE(Plan(sampled(Method::kSobol, 16, 1)).digest_text(), Plan(sampled(Method::kSobol, 16, 2)).digest_text());
}

TEST(Plan, AMillionScenariosNeedNoTable) {
  // No time is asserted: a plan that laid out its points would need some 100 GB here.
  const std::uint64_t n = std::uint64_t{1} << 31;
  for (const Method method : {Method::kSobol, Method::kLatinHypercube}) {
    const Plan plan(sampled(method, n));
    EXPECT_EQ(plan.size(), n);
    EXPECT_NE(plan.point(n - 1).values, plan.point(n / 2).values);
  }
}

TEST(Plan, BasesAreSideBySideAtTheSamePoint) {
  Study study = sampled(Method::kSobol, 8);
  study.bases.push_back({"run-in", coarse_case()});
  study.factors[1].targets[0].base = 1;
  const Plan plan(study);
  EXPECT_EQ(plan.size(), 16u);
  for (std::uint64_t p = 0; p < 8; ++p) {
    EXPECT_EQ(plan.scenario(0, p), 2 * p);
    EXPECT_EQ(plan.scenario(1, p), 2 * p + 1);
    EXPECT_EQ(plan.base_of(2 * p + 1), 1u);
    EXPECT_EQ(plan.point_of(2 * p + 1), p);
    const auto a = plan.point(2 * p).values, b = plan.point(2 * p + 1).values;
    EXPECT_EQ(a[0], b[0]) << "what is common to both bases is the same number in both";
    EXPECT_FALSE(a[1]) << "a factor of the other base";
    EXPECT_TRUE(b[1]);
  }
  EXPECT_THROW(plan.scenario(2, 0), std::out_of_range);
  EXPECT_THROW(plan.scenario(0, 8), std::out_of_range);
}

TEST(Plan, AGridRunsLikeNestedLoops) {
  Study study = study_of({factor("operating.speed", Levels{{100, 200}}),
                          factor("contact.roughness", Span{1e-7, 1e-5, 3, Spacing::kLogarithmic})},
                         Method::kGrid);
  const Plan plan(study);
  ASSERT_EQ(plan.size(), 6u);
  EXPECT_EQ(plan.point(0).values, (Values{100, 1e-7}));
  EXPECT_NEAR(*plan.point(1).values[1], 1e-6, 1e-18);
  EXPECT_EQ(plan.point(2).values, (Values{100, 1e-5})) << "both ends to the last digit";
  EXPECT_EQ(plan.point(5).values, (Values{200, 1e-5}));
  EXPECT_FALSE(plan.is_sample(0));
}

TEST(Plan, AFactorOfOneBaseDoesNotMultiplyTheGridOfAnother) {
  Study study =
      study_of({factor("operating.speed", Levels{{100, 200}}), factor("contact.roughness", Levels{{1e-7, 2e-7, 3e-7}})},
               Method::kGrid);
  study.bases.push_back({"run-in", coarse_case()});
  study.factors[1].targets[0].base = 1;
  const Plan plan(study);
  EXPECT_EQ(plan.size(), 2u + 6u);
  EXPECT_EQ(plan.n_points(0), 2u);
  EXPECT_EQ(plan.point(1).values, (Values{200, std::nullopt}));
  EXPECT_EQ(plan.point(2).base, 1u);
  EXPECT_EQ(plan.point(2).values, (Values{100, 1e-7}));
  EXPECT_EQ(plan.scenario(1, 5), 7u);
  EXPECT_THROW(plan.scenario(0, 2), std::out_of_range) << "that is a point of the other base";
}

TEST(Plan, OneAtATimeBeginsAtTheBase) {
  Study study =
      study_of({factor("operating.speed", Levels{{100, 200}}), factor("contact.roughness", normal(5e-7, 1e-7))},
               Method::kOneAtATime);
  const Plan plan(study);
  ASSERT_EQ(plan.size(), 5u);
  EXPECT_EQ(plan.point(0).values, (Values{std::nullopt, 5e-7}));
  EXPECT_EQ(plan.point(1).values, (Values{100, 5e-7}));
  EXPECT_EQ(plan.point(2).values, (Values{200, 5e-7}));
  EXPECT_FALSE(plan.point(3).values[0]);
  EXPECT_NEAR(*plan.point(3).values[1], 5e-7 - 1.6448536e-7, 1e-13);
  EXPECT_NEAR(*plan.point(4).values[1], 5e-7 + 1.6448536e-7, 1e-13);
  EXPECT_THAT(plan.notes(), Contains(HasSubstr("from their 5 % to their 95 % quantile")));
}

TEST(Plan, AListIsRunUnchanged) {
  Study study = study_of({factor("operating.speed", Listed{}), factor("contact.roughness", Listed{})}, Method::kList);
  study.sampling.list = {{100, 1e-7}, {200, 2e-7}};
  study.bases.push_back({"run-in", coarse_case()});
  const Plan plan(study);
  ASSERT_EQ(plan.size(), 4u);
  EXPECT_EQ(plan.point(1).values, (Values{100, 1e-7}));
  EXPECT_EQ(plan.point(1).base, 1u);
  EXPECT_EQ(plan.point(2).values, (Values{200, 2e-7}));
  EXPECT_TRUE(plan.is_sample(1));
  EXPECT_THAT(plan.notes(), ElementsAre(HasSubstr("presume that the points of the list were drawn at random"),
                                        HasSubstr("base \"new\", \"run-in\": operating.speed goes from 954.93 to")));
}

TEST(Plan, RowsForIndicesShareTheirNumbers) {
  Study study = sampled(Method::kSobol, 8);
  study.sampling.indices = Indices::kFirstAndTotal;
  const Plan plan(study);
  ASSERT_EQ(plan.points_per_row(), 6u);
  const Plan plain(sampled(Method::kSobol, 8));
  for (std::uint64_t row = 0; row < 8; ++row) {
    const auto a = plan.point(6 * row).values, b = plan.point(6 * row + 1).values;
    EXPECT_EQ(a, plain.point(row).values) << "the first is the point that the study would have without indices";
    EXPECT_NE(a[0], b[0]);
    EXPECT_TRUE(plan.is_sample(6 * row) && plan.is_sample(6 * row + 1));
    for (std::size_t g = 0; g < 4; ++g) {
      Values expected = a;
      expected[g] = b[g];
      EXPECT_EQ(plan.point(6 * row + 2 + g).values, expected);
      EXPECT_FALSE(plan.is_sample(6 * row + 2 + g));
    }
  }
}

TEST(Plan, CorrelatedFactorsChangeMatrixTogether) {
  Study study = formula_study({normal(0, 1), normal(0, 1), normal(0, 1)}, 8, 1);
  study.sampling.indices = Indices::kFirstAndTotal;
  study.correlations = {{0, 2, 0.5, {}}};
  const Plan plan(study);
  ASSERT_EQ(plan.points_per_row(), 4u);
  const auto a = numbers(plan.point(0)), b = numbers(plan.point(1)), both = numbers(plan.point(2));
  EXPECT_EQ(both, (std::vector<double>{b[0], a[1], b[2]}));
  EXPECT_THAT(plan.notes(), Contains(HasSubstr("correlated factors share one index")));
}

TEST(Plan, IsExtendedNoFurtherThanAllowed) {
  Study study = sampled(Method::kSobol, 16);
  study.bases.push_back({"run-in", coarse_case()});
  study.sampling.until = StoppingRule{"fmep", 0.95, 100, 64};
  const Plan plan(study);
  EXPECT_EQ(plan.size(), 32u);
  EXPECT_EQ(plan.most(), 128u);
  EXPECT_NO_THROW(plan.point(127));
  EXPECT_THROW(plan.point(128), std::out_of_range);
  EXPECT_EQ(plan.scenario(1, 63), 127u);
}

TEST(Plan, DigestTextContainsEverythingThatMovesANumber) {
  const Study study = sampled(Method::kSobol, 16);
  std::set<std::string> texts = {Plan(study).digest_text()};
  const auto expect_other = [&](const char* what, const std::function<void(Study&)>& change) {
    Study other = study;
    change(other);
    EXPECT_TRUE(texts.insert(Plan(other).digest_text()).second) << what;
  };
  expect_other("seed", [](Study& s) { s.seed = 2; });
  expect_other("method", [](Study& s) { s.sampling.method = Method::kLatinHypercube; });
  expect_other("indices", [](Study& s) { s.sampling.indices = Indices::kFirstAndTotal; });
  expect_other("base", [](Study& s) { s.bases[0].input.engine.bore *= 1.01; });
  expect_other("how", [](Study& s) { s.factors[1].how = FactorMode::kAdd; });
  expect_other("gain", [](Study& s) { s.factors[1].targets[0].gain = 1.5; });
  expect_other("key", [](Study& s) { s.factors[1].targets[0].key = "contact.asperity_radius"; });
  expect_other("bases of factor", [](Study& s) { s.factors[1].targets[0].base = 0; });
  expect_other("distribution", [](Study& s) { std::get<Distribution>(s.factors[1].variation).deviation *= 1.01; });
  expect_other("truncation", [](Study& s) { std::get<Distribution>(s.factors[1].variation).lowest = 1e-7; });
  expect_other("range", [](Study& s) { std::get<Span>(s.factors[3].variation).high = 0.095; });
  expect_other("choice", [](Study& s) { std::get<Choices>(s.factors[2].variation).values.pop_back(); });
  expect_other("contents of a choice",
               [](Study& s) { std::get<Choices>(s.factors[2].variation).values[0].file_sha256 = "abc"; });
  expect_other("correlation", [](Study& s) { s.correlations = {{0, 1, 0.5, {}}}; });
  Study titled = study;
  titled.title = "another title";
  titled.bases[0].name = "old";  // by default that of its file
  titled.keep.curves = Curves::kAll;
  titled.keep.crank_step_deg = 4;
  EXPECT_EQ(Plan(titled).digest_text(), Plan(study).digest_text()) << "words move no number";
}

// As first computed: the same study must give the same numbers in every later version, or a study that was begun cannot
// continue.
TEST(Plan, NumbersAreFrozen) {
  const Plan sobol(study_of({factor("operating.speed", uniform(0x1p-10, 1024 + 0x1p-10))}, Method::kSobol, 4));
  const Plan hypercube(
      study_of({factor("operating.speed", uniform(0x1p-10, 1024 + 0x1p-10))}, Method::kLatinHypercube, 4));
  const std::vector<double> of_sobol = {160.14510906534508, 677.28218710268641, 975.95942785433238, 461.68156994998901},
                            of_hypercube = {494.51686200846177, 521.13679387325135, 232.40011061545758,
                                            949.06182948164735};
  for (std::uint64_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(*sobol.point(i).values[0], of_sobol[i], 1e-9) << i;
    EXPECT_NEAR(*hypercube.point(i).values[0], of_hypercube[i], 1e-9) << i;
  }
}

}  // namespace
}  // namespace ringfilm::study
