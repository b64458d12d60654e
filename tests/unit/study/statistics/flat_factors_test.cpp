#include "ringfilm/study/statistics/flat_factors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "../study_example.hpp"

namespace ringfilm::study {
namespace {

using testing::factor;
using testing::study_of;

constexpr double kTolerance = 0.005;

/// Oil film of five thicknesses at two speeds.
Study grid() {
  Study study = study_of({factor("film", {}, FactorMode::kSet, "contact.roughness"),
                          factor("speed", {}, FactorMode::kSet, "operating.speed")},
                         Method::kGrid);
  study.factors[0].variation = Levels{{1e-7, 2e-7, 3e-7, 5e-7, 9e-7}};
  study.factors[1].variation = Levels{{100, 200}};
  return study;
}

/// Ranges where friction has a value of a scenario, and film and blow-by none that is flat.
std::vector<FlatRange> ranges_of(const Study& study, const std::function<double(double, double)>& friction) {
  const Plan plan(study);
  FlatFactors flat(plan, kTolerance);
  for (std::uint64_t i = 0; i < plan.size(); ++i) {
    const Point point = plan.point(i);
    if (!point.values[0] || !point.values[1]) continue;
    std::vector<double> values;
    for (const std::size_t value : flat.watched()) {
      const double f = friction(*point.values[0], *point.values[1]);
      values.push_back(plan.values().quantities[value].name == "fmep" ? f : std::exp(5e6 * *point.values[0]) * f);
    }
    flat.add(i, values);
  }
  return flat.ranges(IdleFactors(plan));
}

/// Falls with the film up to 0.25 um, and stays from there on but for a part in 10,000.
double saturated(double film, double speed) { return speed * (1 + std::max(0.0, 2.5e-7 - film) * 1e7 - 100 * film); }

TEST(FlatFactors, FindThePartOfAFactorToWhichTheFrictionIsFlat) {
  const std::vector<FlatRange> ranges = ranges_of(grid(), saturated);
  ASSERT_EQ(ranges.size(), 1u);
  EXPECT_EQ(ranges[0].factor, 0u);
  EXPECT_FALSE(ranges[0].is_whole);
  EXPECT_DOUBLE_EQ(ranges[0].low, 3e-7);
  EXPECT_DOUBLE_EQ(ranges[0].high, 9e-7);
}

TEST(FlatFactors, FindAFactorThatHardlyCountsAtAllAndLeaveThoseThatCount) {
  const auto ranges = ranges_of(grid(), [](double film, double speed) { return film * (1 + 1e-6 * speed); });
  ASSERT_EQ(ranges.size(), 2u);  // of friction and film
  for (const FlatRange& range : ranges) EXPECT_TRUE(range.factor == 1 && range.is_whole);
  EXPECT_TRUE(ranges_of(grid(), [](double film, double speed) { return film * speed; }).empty());
}

TEST(FlatFactors, AreNotThoseThatAreFlatAtSomeOfTheOtherNumbersAlone) {
  EXPECT_TRUE(ranges_of(grid(), [](double film, double speed) {
                return speed < 150 ? saturated(film, 1) : 1e7 * film;
              }).empty());
}

TEST(FlatFactors, AreNotReportedWhereNoValueChangesOrNothingIsSolved) {
  EXPECT_TRUE(ranges_of(grid(), [](double, double) { return std::numeric_limits<double>::quiet_NaN(); }).empty());
  const Plan plan(grid());
  FlatFactors flat(plan, kTolerance);
  for (std::uint64_t i = 0; i < plan.size(); ++i) flat.add(i, std::vector<double>(flat.watched().size(), 7.0));
  EXPECT_EQ(flat.ranges(IdleFactors(plan)).size(), 2 * flat.watched().size());  // other values may change
  IdleFactors idle(plan);
  for (std::uint64_t i = 0; i < plan.size(); ++i) idle.add(i, std::vector<double>{7.0});
  EXPECT_TRUE(flat.ranges(idle).empty());  // reported by `idle`
}

TEST(FlatFactors, CannotBeFoundAmongScenariosThatDifferInAllFactors) {
  const Plan sampled(study_of({factor("operating.speed", Span{100, 200})}, Method::kLatinHypercube));
  EXPECT_TRUE(FlatFactors(sampled, kTolerance).watched().empty());
}

TEST(FlatFactors, AreFoundAlongTrajectories) {
  Study study = grid();
  study.factors[0].variation = Span{1e-7, 9e-7};
  study.factors[1].variation = Span{100, 200};
  study.sampling.method = Method::kMorris;
  const auto ranges = ranges_of(study, [](double film, double speed) { return film + 1e-13 * speed; });
  ASSERT_FALSE(ranges.empty());
  for (const FlatRange& range : ranges) EXPECT_TRUE(range.factor == 1 && range.is_whole);
}

}  // namespace
}  // namespace ringfilm::study
