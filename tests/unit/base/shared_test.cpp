#include "ringfilm/base/shared.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace ringfilm::base {
namespace {

using Numbers = Shared<std::vector<double>>;

TEST(Shared, CopiesShareTheirValue) {
  const Numbers a = std::vector<double>{1, 2};
  const Numbers b = a;
  EXPECT_EQ(a->data(), b->data());
}

TEST(Shared, AssigningLeavesOtherCopiesAsTheyAre) {
  Numbers a = std::vector<double>{1, 2};
  const Numbers b = a;
  a = std::vector<double>{3};
  EXPECT_EQ(*a, std::vector<double>{3});
  EXPECT_EQ(*b, (std::vector<double>{1, 2}));
}

TEST(Shared, IsNeverEmpty) {
  Numbers a;
  EXPECT_TRUE(a->empty());
  a = std::vector<double>{4};
  const Numbers b = std::move(a);
  EXPECT_EQ(*a, *b);  // NOLINT(bugprone-use-after-move): this is what it is about
}

}  // namespace
}  // namespace ringfilm::base
