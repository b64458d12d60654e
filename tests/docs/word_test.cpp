#include <gtest/gtest.h>

#include <algorithm>

#include "document_tree.hpp"

namespace ringfilm::documents {
namespace {

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
