#include "ringfilm/report/payload/unsolved_reasons.hpp"

#include <gtest/gtest.h>

namespace ringfilm::report {
namespace {

TEST(UnsolvedReasons, CountTheSameWordsTogetherWhateverTheirNumbers) {
  UnsolvedReasons reasons;
  reasons.add(3, "no film at 12.5 degree, residual 1e-05");
  reasons.add(4, "the ring lifts off");
  reasons.add(7, "no film at -340 degree, residual 3.25e+02");
  reasons.add(9, "no film at 0.5 degree, residual 7");
  const auto found = reasons.most_frequent_first();
  EXPECT_EQ(reasons.count(), 4u);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].text, "no film at 12.5 degree, residual 1e-05");
  EXPECT_EQ(found[0].count, 3u);
  EXPECT_EQ(found[0].first, 3u);
  EXPECT_TRUE(found[0].numbers_differ);
  EXPECT_EQ(found[1].count, 1u);
  EXPECT_FALSE(found[1].numbers_differ);
}

TEST(UnsolvedReasons, SeparateWordsThatContainNumbers) {
  UnsolvedReasons reasons;
  reasons.add(0, "1 step");
  reasons.add(1, "1. step");
  reasons.add(2, "1e step");
  reasons.add(3, "1-2 steps");
  reasons.add(4, "5");
  reasons.add(5, "");
  EXPECT_EQ(reasons.most_frequent_first().size(), 6u);
}

TEST(UnsolvedReasons, AreBoundedHoweverManyThereAre) {
  UnsolvedReasons reasons;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    std::string text;
    for (std::uint64_t rest = i; rest > 0; rest /= 20) text.push_back(static_cast<char>('a' + rest % 20));
    reasons.add(i, "because of " + text);
  }
  const auto found = reasons.most_frequent_first();
  EXPECT_EQ(found.size(), 1001u);
  EXPECT_EQ(found.front().text, "other reasons");
  EXPECT_EQ(found.front().count, 4000u);
  EXPECT_EQ(reasons.count(), 5000u);
}

}  // namespace
}  // namespace ringfilm::report
