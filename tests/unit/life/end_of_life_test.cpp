#include "ringfilm/life/end_of_life.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/life/wear/face_distance.hpp"

namespace ringfilm::life {
namespace {

TEST(EndOfLife, ALimitIsReachedFromWhicheverSide) {
  EXPECT_DOUBLE_EQ(reaching_time({0, 10, 20}, {1, 2, 6}, 4).value(), 15);
  EXPECT_DOUBLE_EQ(reaching_time({0, 10, 20}, {6, 5, 1}, 3).value(), 15);
  EXPECT_EQ(reaching_time({0, 10, 20}, {1, 2, 6}, 7), std::nullopt);
  EXPECT_EQ(reaching_time({0, 10}, {std::nan(""), 1}, 1), std::nullopt);
}

WornProfile profile(double depth, double coating) { return worn_profile({depth}, depth * 1e-3, coating); }

/// A scenario that wears 1 um per hour through a coating of 6 um, reported after 0 and 5 h, and limits of its depth.
struct Through {
  Life life;
  LifeResult result;

  Through() {
    constexpr double kCoating = 6e-6;
    life.mode = Mode::kArchard;
    life.wear.coating_thickness = kCoating;
    life.end_rules = {{"largest_worn_depth", 5.5e-6}, {"coating_left", 0}};
    for (const double hours : {0.0, 5.0}) {
      LifeState& state = result.states.emplace_back();
      state.time = hours * kHour;
      state.values.assign(life_quantities().size(), 1);
      state.worn = profile(hours * 1e-6, kCoating);
    }
    result.wear.emplace();
    result.wear->worn_through = {6 * kHour, profile(kCoating, kCoating)};
  }
};

TEST(EndOfLife, ALimitOfDepthIsMetBeforeTheCoatingEndsBetweenTwoHours) {
  const Through one;
  const std::vector<EndOfLife> ends = ends_of_life(one.life, one.result);
  EXPECT_DOUBLE_EQ(ends[0].time.value(), 5.5 * kHour);
  EXPECT_DOUBLE_EQ(ends[1].time.value(), 6 * kHour);
  EXPECT_EQ(ends[0].turned, std::nullopt);
}

TEST(EndOfLife, ALimitOfDepthIsKnownWhereNoReportedHourIsReached) {
  Through one;
  one.result.states.clear();
  EXPECT_DOUBLE_EQ(ends_of_life(one.life, one.result)[0].time.value(), 5.5 * kHour);
  append_notes_of_ends(one.life, one.result);
  EXPECT_TRUE(one.result.notes.empty());
}

TEST(EndOfLife, AnotherScenarioOfABandHasItsOwnEnd) {
  Through one;
  one.result.other_paths = {{"highest fitted coefficient", {}}};
  LifeState& first = one.result.states.front();
  first.other_paths = {first.values};
  first.other_worn = {first.worn};
  one.result.states.back().other_paths = {{}};
  one.result.states.back().other_worn = {std::nullopt};
  one.result.wear->other_worn_through = {WearThrough{3 * kHour, profile(6e-6, 6e-6)}};
  EXPECT_DOUBLE_EQ(ends_of_life(one.life, one.result)[0].other_paths[0].value(), 2.75 * kHour);
}

TEST(FaceDistance, OffsetAndTiltAreFree) {
  const std::vector<double> x = {0, 1, 2, 3, 4}, flat(5, 0.0), line = {1, 3, 5, 7, 9}, wave = {0, 1, 0, -1, 0};
  EXPECT_NEAR(rms_distance(x, line, flat, 2), 0, 1e-12);
  std::vector<double> both;
  for (std::size_t i = 0; i < x.size(); ++i) both.push_back(line[i] + wave[i]);
  // Of (0, 1, 0, -1, 0) about its line of slope -0.2: 2 - 0.4 over five places.
  EXPECT_NEAR(rms_distance(x, both, flat, 2), std::sqrt(1.6 / 5), 1e-12);
}

}  // namespace
}  // namespace ringfilm::life
