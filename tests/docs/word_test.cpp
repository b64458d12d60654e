#include <gtest/gtest.h>

#include <algorithm>

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

// \f, \r or \b of a formula that a program took for a code.
TEST(Docs, HaveNoControlCharacters) {
  const auto is_control = [](unsigned char c) { return c < ' ' && c != '\n'; };
  for (const auto& [path, text] : texts_below("docs", {".md", ".py", ".csv", ".txt"})) {
    const auto found = std::find_if(text.begin(), text.end(), is_control);
    EXPECT_EQ(found, text.end()) << path << ": line " << 1 + std::count(text.begin(), found, '\n');
  }
}

}  // namespace
}  // namespace ringfilm::documents
