#include <gtest/gtest.h>

#include "document_tree.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/pad/pad_result.hpp"

namespace ringfilm::documents {
namespace {

TEST(Docs, EveryQuantityOfAResultIsInTheGlossary) {
  const Mentions words = mentions({{"", text_of("docs/glossary.md")}}, "`([a-z_]+)`");
  for (const auto& quantity : cycle::curve_quantities()) EXPECT_TRUE(words.count(quantity.name)) << quantity.name;
  for (const auto& quantity : cycle::cycle_quantities()) EXPECT_TRUE(words.count(quantity.name)) << quantity.name;
  for (const auto& quantity : cycle::unrolled_quantities()) EXPECT_TRUE(words.count(quantity.name)) << quantity.name;
  for (const auto& quantity : cycle::unrolled_cycle_quantities())
    EXPECT_TRUE(words.count(quantity.name)) << quantity.name;
  for (const auto& quantity : cycle::derived_quantities()) EXPECT_TRUE(words.count(quantity.name)) << quantity.name;
  for (const auto& quantity : pad::pad_quantities()) EXPECT_TRUE(words.count(quantity.name)) << quantity.name;
  for (const auto& quantity : pad::front_quantities()) EXPECT_TRUE(words.count(quantity.name)) << quantity.name;
  for (const auto& quantity : pad::profile_quantities())
    EXPECT_TRUE(quantity.name == "x" || words.count(quantity.name)) << quantity.name;
}

}  // namespace
}  // namespace ringfilm::documents
