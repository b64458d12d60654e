#include "ringfilm/base/printable_text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "ringfilm/base/error.hpp"

namespace ringfilm {
namespace {

TEST(PrintableText, ShowsControlCharactersByTheirCode) {
  EXPECT_EQ(printable("\x1b[31mred\x7f\r"), "\\x1B[31mred\\x7F\\x0D");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xC2\x9B\x33\x31m"), "\\x9B31m");  // CSI of C1, which some terminals obey
}

TEST(PrintableText, ShowsWhatChangesTheDirectionOrEndsALineByItsCode) {
  const std::string hidden =
      "cost \xE2\x80\xAE"
      "001\xE2\x81\xA9\xE2\x80\xA8\xD8\x9C";  // U+202E, 2069, 2028, 061C
  EXPECT_EQ(printable(hidden), "cost \\u202E001\\u2069\\u2028\\u061C");
  EXPECT_EQ(code_point_at(hidden, find_control_character(hidden)), 0x202Eu);
  EXPECT_EQ(printable("\xE2\x80"), "\xE2\x80");  // cut off: not a character
}

TEST(PrintableText, LeavesLinesTabsAndLettersOfAnyLanguage) {
  const std::string text = "a\tb\n\xC2\xB5m \xC3\xA4 \xE2\x82\xAC \xD7\x90 \xC2";  // the last one is cut off
  EXPECT_EQ(printable(text), text);
  EXPECT_EQ(find_control_character(text), std::string::npos);
}

TEST(PrintableText, CaretStaysUnderItsPlaceBehindACharacterThatChangesTheDirection) {
  const InputError error(std::vector<Fault>{{{"a", 1, 5,
                                              "\xE2\x80\xAE"
                                              "bc"},
                                             "wrong",
                                             "right"}});
  EXPECT_EQ(std::string(error.what()), "a:1:5: wrong\n    1 |    bc\n      |     ^ right\n");
}

TEST(PrintableText, FaultsHoldNoControlCharacter) {
  const std::string name("a\0b\x1b[2J", 7);
  const InputError error(std::vector<Fault>{{{name, 1, 1, name}, "of " + name, "not " + name}});
  EXPECT_EQ(std::string(error.what()),
            "a\\x00b\\x1B[2J:1:1: of a\\x00b\\x1B[2J\n    1 | a b [2J\n      | ^ not a\\x00b\\x1B[2J\n");
}

}  // namespace
}  // namespace ringfilm
