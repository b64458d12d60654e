#include "ringfilm/study/statistics/swing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ringfilm::study {
namespace {

const double kMissing = std::numeric_limits<double>::quiet_NaN();

TEST(Swing, IsThatOfTheMediansOfTheOuterThirds) {
  std::vector<double> x, y;
  for (int i = 0; i < 301; ++i) {
    x.push_back(i / 300.0);
    y.push_back(10 * x.back() + ((i * 7) % 3 - 1) * 0.01);
  }
  const auto swing = swing_of(x, y, SwingEnds::kThirds);
  ASSERT_TRUE(swing);
  // Thirds of an even factor have their medians at 1/6 and 5/6; the scatter laid on is 0.01.
  EXPECT_NEAR(swing->low, 10.0 / 6, 0.05);
  EXPECT_NEAR(swing->high, 50.0 / 6, 0.05);
}

TEST(Swing, TakesFirstAndLastOfAChoiceHoweverManyThereAre) {
  for (const int n_choices : {2, 3, 4, 5, 7}) {
    std::vector<double> x, y;
    for (int i = 0; i < 20 * n_choices; ++i) {
      x.push_back(i % n_choices);
      y.push_back(10 * x.back() + (i / n_choices) % 2);  // 0 or 1 beside, so that the median is 0.5
    }
    const auto swing = swing_of(x, y, SwingEnds::kValues);
    ASSERT_TRUE(swing) << n_choices;
    EXPECT_EQ(swing->low, 0.5) << n_choices;
    EXPECT_EQ(swing->high, 10 * (n_choices - 1) + 0.5) << n_choices;
  }
}

TEST(Swing, PutsNoOtherValueInThePlaceOfOneThatWasNeverSolved) {
  std::vector<double> x, y;
  for (int i = 0; i < 40; ++i) {
    x.push_back(i % 4);
    y.push_back(i % 4 == 0 ? kMissing : 10 * x.back());
  }
  EXPECT_FALSE(swing_of(x, y, SwingEnds::kValues));
}

TEST(Swing, HasEndsByWhatIsListed) {
  EXPECT_EQ(swing_ends(Levels{{1, 2}}), SwingEnds::kValues);
  EXPECT_EQ(swing_ends(Choices{}), SwingEnds::kValues);
  EXPECT_EQ(swing_ends(Span{}), SwingEnds::kThirds);
  EXPECT_EQ(swing_ends(Distribution{}), SwingEnds::kThirds);
  EXPECT_EQ(swing_ends(Listed{}), SwingEnds::kThirds);
}

TEST(Swing, LeavesOutWhatWasNotSolvedAndTellsNothingOfTooFew) {
  std::vector<double> x = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, y = {1, 1, 1, 5, 5, 5, 5, 9, 9, 9};
  y[0] = kMissing;
  x.push_back(0);
  y.push_back(1);
  const auto swing = swing_of(x, y, SwingEnds::kThirds);
  ASSERT_TRUE(swing);
  EXPECT_EQ(swing->low, 1);
  EXPECT_EQ(swing->high, 9);
  EXPECT_FALSE(swing_of(std::vector<double>(5, 1.0), std::vector<double>(5, 1.0), SwingEnds::kThirds));
  EXPECT_FALSE(swing_of(std::vector<double>(50, 1.0), std::vector<double>(50, 1.0), SwingEnds::kThirds));
  EXPECT_THROW(swing_of(x, std::vector<double>{1}, SwingEnds::kThirds), std::invalid_argument);
}

}  // namespace
}  // namespace ringfilm::study
