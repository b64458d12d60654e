#include "ringfilm/report/payload/even_pick.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ringfilm::report {
namespace {

TEST(EvenlyPicked, TakesAllOfFew) {
  EXPECT_EQ(evenly_picked(3, 5), (std::vector<std::uint64_t>{0, 1, 2}));
  EXPECT_TRUE(evenly_picked(0, 5).empty());
}

TEST(EvenlyPicked, TakesOneOfEachStretch) {
  const std::vector<std::uint64_t> picked = evenly_picked(100'003, 1000);
  ASSERT_EQ(picked.size(), 1000u);
  for (std::uint64_t k = 0; k < picked.size(); ++k) {
    EXPECT_GE(picked[k], k * 100'003 / 1000);
    EXPECT_LT(picked[k], (k + 1) * 100'003 / 1000);
  }
  EXPECT_EQ(picked, evenly_picked(100'003, 1000));
}

TEST(EvenlyPicked, HidesNothingThatComesPeriodically) {
  for (const std::uint64_t period : {2, 3, 5, 10}) {
    std::vector<int> counts(period);
    for (const std::uint64_t place : evenly_picked(20'000, 2000)) ++counts[place % period];
    // Each is expected 2000 / period times, with a deviation of less than the root of that; five of them are not met by
    // chance.
    const double expected = 2000.0 / static_cast<double>(period);
    for (const int n : counts) EXPECT_NEAR(n, expected, 5 * std::sqrt(expected)) << period;
  }
}

}  // namespace
}  // namespace ringfilm::report
