#include "ringfilm/io/text/uncertain_quantity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ringfilm::io {
namespace {

using surface::Uncertain;
using ::testing::HasSubstr;

Uncertain length(const std::string& text) { return uncertain_quantity(text, "m", "\"1 um\"", Units()); }
Uncertain number(const std::string& text) { return uncertain_quantity(text, "1", "\"1 +- 0.1\"", Units()); }

std::string message_of_quantity(const std::string& text, const std::string& unit) {
  try {
    uncertain_quantity(text, unit, "\"2 um +- 1 um\"", Units());
  } catch (const UnitError& error) {
    return std::string(error.what()) + "; " + error.remedy;
  }
  return "";
}

TEST(UncertainQuantity, ReadsEveryWayToWriteIt) {
  for (const char* text : {"450 um +- 5 um", "450 +- 5 um", "(450 +- 5) um", "0.45 mm +- 5 um", "450 um +/- 5 um",
                           "450 um \u00B1 5 um", " 450um+-5um "}) {
    EXPECT_DOUBLE_EQ(length(text).value, 450e-6) << text;
    EXPECT_DOUBLE_EQ(length(text).deviation, 5e-6) << text;
  }
  EXPECT_DOUBLE_EQ(length("450 um +- 2 %").deviation, 9e-6);
  EXPECT_DOUBLE_EQ(length("-450 um +- 2 %").deviation, 9e-6);
  EXPECT_EQ(length("450 um").deviation, 0);
  EXPECT_DOUBLE_EQ(number("0.19 +- 0.1").value, 0.19);
  EXPECT_DOUBLE_EQ(number("0.19 +- 0.1").deviation, 0.1);
  EXPECT_DOUBLE_EQ(number("2e-1+-1e-2").deviation, 0.01);
}

TEST(UncertainQuantity, RefusesInvalidInput) {
  EXPECT_THAT(message_of_quantity("450", "m"), HasSubstr("has no unit"));
  EXPECT_THAT(message_of_quantity("450 +- 5", "m"), HasSubstr("has no unit"));
  EXPECT_THAT(message_of_quantity("450 um +- 5", "m"), HasSubstr("has no unit"));
  EXPECT_THAT(message_of_quantity("450 um +- 5 nN", "m"), HasSubstr("is not a length"));
  EXPECT_THAT(message_of_quantity("450 um +-", "m"), HasSubstr("nothing after +-"));
  EXPECT_THAT(message_of_quantity("450 um +- -5 um", "m"), HasSubstr("deviation below zero"));
  EXPECT_THAT(message_of_quantity("(450 +- 5 um", "m"), HasSubstr("not closed"));
  EXPECT_THAT(message_of_quantity("", "m"), HasSubstr("does not start with a number"));
  EXPECT_THAT(message_of_quantity("+- 5 um", "m"), HasSubstr("does not start with a number"));
  EXPECT_THAT(message_of_quantity("nan +- 0.1", "1"), HasSubstr("not a finite number"));
  EXPECT_THAT(message_of_quantity("1e999 +- 0.1", "1"), HasSubstr("out of the range"));
  EXPECT_THAT(message_of_quantity("0.19 um", "1"), HasSubstr("more than a number"));
  EXPECT_THAT(message_of_quantity("0.19 +- 0.1 um", "1"), HasSubstr("more than a number"));
}

}  // namespace
}  // namespace ringfilm::io
