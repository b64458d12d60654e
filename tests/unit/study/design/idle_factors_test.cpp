#include "ringfilm/study/design/idle_factors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "../study_example.hpp"

namespace ringfilm::study {
namespace {

using ::testing::ElementsAre;
using testing::factor;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::study_of;

Study three_factors(Method method) {
  return study_of({factor("operating.speed", uniform(100, 200)), factor("contact.roughness", uniform(1e-7, 2e-7)),
                   factor("ring.face_width", uniform(1e-3, 2e-3))},
                  method);
}

Study grid() {
  Study study = three_factors(Method::kGrid);
  study.factors[0].variation = Levels{{100, 150, 200}};
  study.factors[1].variation = Levels{{1e-7, 2e-7}};
  study.factors[2].variation = Levels{{1e-3, 2e-3}};
  return study;
}

std::vector<std::string> idle_notes_of(const Study& study, const std::function<double(const Point&)>& value) {
  const Plan plan(study);
  IdleFactors idle(plan);
  for (std::uint64_t i = 0; i < plan.size(); ++i) {
    const double x = value(plan.point(i));
    idle.add(i, std::vector<double>{x, 2 * x});
  }
  return idle.notes();
}

double of_all(const Point& p) { return *p.values[0] + 1e9 * *p.values[1] + 1e4 * *p.values[2]; }
double without_second(const Point& p) { return *p.values[0] + 1e4 * *p.values[2]; }
double of_none(const Point&) { return 7; }

TEST(IdleFactors, AreThoseThatChangeNoValueWhileTheOthersStay) {
  EXPECT_THAT(idle_notes_of(grid(), of_all), IsEmpty());
  EXPECT_THAT(idle_notes_of(grid(), without_second),
              ElementsAre(HasSubstr("factor \"contact.roughness\" changes no value of the cycle: 6 scenarios differ")));
  EXPECT_EQ(idle_notes_of(grid(), of_none).size(), 3u);
}

TEST(IdleFactors, AreFoundAlongTrajectoriesAndBesideABase) {
  for (const Method method : {Method::kMorris, Method::kOneAtATime}) {
    const auto value = [&](const Point& p) { return p.values[0].value_or(0) + 1e4 * p.values[2].value_or(0); };
    EXPECT_THAT(idle_notes_of(three_factors(method), value), ElementsAre(HasSubstr("\"contact.roughness\"")));
  }
  Study indices = three_factors(Method::kSobol);
  indices.sampling.indices = Indices::kFirstAndTotal;
  EXPECT_THAT(idle_notes_of(indices, without_second), ElementsAre(HasSubstr("\"contact.roughness\"")));
}

TEST(IdleFactors, AreAllOfASampleWhoseValuesAreTheSame) {
  for (const Method method : {Method::kSobol, Method::kLatinHypercube}) {
    EXPECT_THAT(idle_notes_of(three_factors(method), without_second), IsEmpty());
    EXPECT_THAT(idle_notes_of(three_factors(method), of_none),
                ElementsAre(HasSubstr("no factor changes a value of base \"new\": its 64 solved scenarios")));
  }
}

TEST(IdleFactors, OfAListAreFoundByPairsOrAllTogether) {
  Study study = three_factors(Method::kList);
  study.sampling.list = {{100, 1e-7, 1e-3}, {100, 2e-7, 1e-3}, {200, 2e-7, 2e-3}};
  EXPECT_THAT(idle_notes_of(study, of_all), IsEmpty());
  EXPECT_THAT(idle_notes_of(study, without_second), ElementsAre(HasSubstr("\"contact.roughness\"")));
  study.sampling.list = {{100, 1e-7, 1e-3}, {150, 2e-7, 2e-3}};  // no two differ in one factor alone
  EXPECT_THAT(idle_notes_of(study, of_all), IsEmpty());
  EXPECT_THAT(idle_notes_of(study, of_none),
              ElementsAre(HasSubstr("no factor changes a value of base \"new\": its 2")));
}

TEST(IdleFactors, ScenariosThatWereNotSolvedDoNotCount) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto solved_at_one_speed = [&](const Point& p) { return *p.values[0] == 100 ? of_all(p) : none; };
  EXPECT_THAT(idle_notes_of(grid(), solved_at_one_speed), IsEmpty());
  EXPECT_THAT(idle_notes_of(grid(), [&](const Point&) { return none; }), IsEmpty());
}

TEST(IdleFactors, ALastBitIsAnEffect) {
  const auto by_a_bit = [](const Point& p) { return *p.values[1] > 1.5e-7 ? std::nextafter(1.0, 2.0) : 1.0; };
  EXPECT_THAT(idle_notes_of(grid(), by_a_bit),
              ElementsAre(HasSubstr("\"operating.speed\""), HasSubstr("\"ring.face_width\"")));
}

// The plan is longer than what is remembered: whole sets of other numbers are omitted, never a part of one.
TEST(IdleFactors, AreFoundInALongPlan) {
  Study study = grid();
  study.factors[0].variation = Span{100, 200, 200, Spacing::kLinear};
  study.factors[1].variation = Span{1e-7, 2e-7, 200, Spacing::kLinear};
  study.factors[2].variation = Span{1e-3, 2e-3, 2, Spacing::kLinear};
  EXPECT_THAT(idle_notes_of(study, without_second), ElementsAre(HasSubstr("\"contact.roughness\"")));
  EXPECT_THAT(idle_notes_of(study, of_all), IsEmpty());
}

}  // namespace
}  // namespace ringfilm::study
