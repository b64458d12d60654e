#include "ringfilm/io/text/base64.hpp"

#include <gtest/gtest.h>

namespace {

using ringfilm::io::base64;

TEST(Base64, GivesTheExamplesOfItsStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, JoinsLongBlocksWithoutASeam) {
  const std::string text = base64(std::string((3u << 20) + 4, '\0'));
  ASSERT_EQ(text.size(), (4u << 20) + 8);
  EXPECT_EQ(text.find_first_not_of('A'), text.size() - 2);
  EXPECT_EQ(text.substr(text.size() - 2), "==");
}

}  // namespace
