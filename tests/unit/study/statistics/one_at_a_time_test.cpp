#include "ringfilm/study/statistics/one_at_a_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ringfilm::study {
namespace {

const double kMissing = std::numeric_limits<double>::quiet_NaN();

TEST(OneAtATimeSensitivity, IsThatOfTheMediansOfTheOuterThirds) {
  std::vector<double> x, y;
  for (int i = 0; i < 301; ++i) {
    x.push_back(i / 300.0);
    y.push_back(10 * x.back() + ((i * 7) % 3 - 1) * 0.01);
  }
  const auto sensitivity = one_at_a_time_sensitivity(x, y, SensitivityEnds::kThirds);
  ASSERT_TRUE(sensitivity);
  // Thirds of an even factor have their medians at 1/6 and 5/6; the scatter laid on is 0.01.
  EXPECT_NEAR(sensitivity->low, 10.0 / 6, 0.05);
  EXPECT_NEAR(sensitivity->high, 50.0 / 6, 0.05);
}

TEST(OneAtATimeSensitivity, TakesFirstAndLastOfAChoiceHoweverManyThereAre) {
  for (const int n_choices : {2, 3, 4, 5, 7}) {
    std::vector<double> x, y;
    for (int i = 0; i < 20 * n_choices; ++i) {
      x.push_back(i % n_choices);
      y.push_back(10 * x.back() + (i / n_choices) % 2);  // 0 or 1 beside, so that the median is 0.5
    }
    const auto sensitivity = one_at_a_time_sensitivity(x, y, SensitivityEnds::kValues);
    ASSERT_TRUE(sensitivity) << n_choices;
    EXPECT_EQ(sensitivity->low, 0.5) << n_choices;
    EXPECT_EQ(sensitivity->high, 10 * (n_choices - 1) + 0.5) << n_choices;
  }
}

TEST(OneAtATimeSensitivity, PutsNoOtherValueInThePlaceOfOneThatWasNeverSolved) {
  std::vector<double> x, y;
  for (int i = 0; i < 40; ++i) {
    x.push_back(i % 4);
    y.push_back(i % 4 == 0 ? kMissing : 10 * x.back());
  }
  EXPECT_FALSE(one_at_a_time_sensitivity(x, y, SensitivityEnds::kValues));
}

TEST(OneAtATimeSensitivity, HasEndsByWhatIsListed) {
  EXPECT_EQ(sensitivity_ends(Levels{{1, 2}}), SensitivityEnds::kValues);
  EXPECT_EQ(sensitivity_ends(Choices{}), SensitivityEnds::kValues);
  EXPECT_EQ(sensitivity_ends(Span{}), SensitivityEnds::kThirds);
  EXPECT_EQ(sensitivity_ends(Distribution{}), SensitivityEnds::kThirds);
  EXPECT_EQ(sensitivity_ends(Listed{}), SensitivityEnds::kThirds);
}

TEST(OneAtATimeSensitivity, OmitsUnsolvedScenariosAndIsAbsentForTooFew) {
  std::vector<double> x = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, y = {1, 1, 1, 5, 5, 5, 5, 9, 9, 9};
  y[0] = kMissing;
  x.push_back(0);
  y.push_back(1);
  const auto sensitivity = one_at_a_time_sensitivity(x, y, SensitivityEnds::kThirds);
  ASSERT_TRUE(sensitivity);
  EXPECT_EQ(sensitivity->low, 1);
  EXPECT_EQ(sensitivity->high, 9);
  EXPECT_FALSE(
      one_at_a_time_sensitivity(std::vector<double>(5, 1.0), std::vector<double>(5, 1.0), SensitivityEnds::kThirds));
  EXPECT_FALSE(
      one_at_a_time_sensitivity(std::vector<double>(50, 1.0), std::vector<double>(50, 1.0), SensitivityEnds::kThirds));
  EXPECT_THROW(one_at_a_time_sensitivity(x, std::vector<double>{1}, SensitivityEnds::kThirds), std::invalid_argument);
}

}  // namespace
}  // namespace ringfilm::study
