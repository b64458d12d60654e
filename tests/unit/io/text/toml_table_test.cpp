#include "ringfilm/io/text/toml_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ringfilm::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A table [wear] of a text, and what is wrong with it.
class TomlTableTest : public testing::Test {
 protected:
  void read(const std::string& keys) {
    source_.path = "life.toml";
    source_.text = "[wear]\n" + keys;
    root_ = parse_toml(source_);
  }
  TomlTable table(const std::vector<std::string>& known) { return {*root_.find("wear"), "[wear]", known, faults_}; }
  TomlTable table() { return {*root_.find("wear"), "[wear]", faults_}; }
  std::string faults() const { return describe(faults_); }

  Units units_;
  std::vector<Fault> faults_;

 private:
  SourceText source_;
  TomlValue root_;
};

TEST_F(TomlTableTest, HandsOutValuesByType) {
  read("text = \"fit\"\nnumber = 0.5\ncount = 1e6\nquantity = \"2 um\"\nlist = [\"a\", \"b\"]\n");
  TomlTable wear = table({"text", "number", "count", "quantity", "list", "absent"});
  EXPECT_EQ(wear.text("text"), "fit");
  EXPECT_EQ(wear.number("number"), 0.5);
  EXPECT_EQ(wear.count("count"), 1000000u);
  EXPECT_DOUBLE_EQ(wear.quantity("quantity", "m", "\"1 um\"", units_).value(), 2e-6);
  EXPECT_THAT(wear.texts("list"), ElementsAre("a", "b"));
  EXPECT_FALSE(wear.text("absent").has_value());
  EXPECT_TRUE(faults_.empty()) << faults();
}

TEST_F(TomlTableTest, ChoosesByName) {
  read("scheme = \"euler\"\n");
  int scheme = 1;
  EXPECT_TRUE(table().choose("scheme", {{"heun", 1}, {"euler", 2}}, scheme));
  EXPECT_EQ(scheme, 2);
  EXPECT_FALSE(table().choose("absent", {{"heun", 1}}, scheme));
  EXPECT_FALSE(table().choose("scheme", {{"heun", 1}, {"eulers", 3}}, scheme));
  EXPECT_EQ(scheme, 2);
  EXPECT_THAT(faults(), HasSubstr("life.toml:2:10: wear.scheme = \"euler\" is not known; did you mean eulers?"));
}

TEST_F(TomlTableTest, ReportsEveryFaultWithItsPlaceAndKey) {
  read("jump = 1\nnumber = \"1\"\ncount = 1.5\nquantity = 2\nlist = 3\nnot = \"2 N\"\ntruth = true\n");
  TomlTable wear = table({"jumps", "number", "count", "quantity", "list", "not", "truth"});
  wear.number("number");
  wear.count("count");
  wear.quantity("quantity", "m", "\"1 um\"", units_);
  wear.items("list");
  wear.quantity("not", "m", "\"1 um\"", units_);
  wear.quantity("truth", "m", "\"1 um\"", units_);
  wear.need("jumps", "4");
  wear.refuse_key("list", "means nothing here", "");
  wear.refuse_value("absent", "is refused", "");
  const std::string printed = faults();
  EXPECT_THAT(printed, HasSubstr("life.toml:2:1: unknown key jump in [wear]; did you mean jumps?"));
  EXPECT_THAT(printed, HasSubstr("life.toml:3:10: wear.number = \"1\" is not a number"));
  EXPECT_THAT(printed, HasSubstr("life.toml:4:9: wear.count = 1.5 is not a whole number"));
  EXPECT_THAT(printed, HasSubstr("life.toml:5:12: wear.quantity = 2 has no unit"));
  EXPECT_THAT(printed, HasSubstr("a length is required here, for example \"1 um\""));
  EXPECT_THAT(printed, HasSubstr("life.toml:6:8: wear.list = 3 is not a list"));
  EXPECT_THAT(printed, HasSubstr("life.toml:7:7: wear.not = \"2 N\" is not a length"));
  EXPECT_THAT(printed, HasSubstr("life.toml:8:9: wear.truth = (neither text nor number) is not a quantity"));
  EXPECT_THAT(printed, HasSubstr("[wear] has no jumps"));
  EXPECT_THAT(printed, HasSubstr("life.toml:6:1: wear.list means nothing here"));
  EXPECT_EQ(faults_.size(), 9u) << printed;
}

TEST_F(TomlTableTest, RefusesTheKeysThatNothingAskedFor) {
  read("asked = 1\naksed = 2\n");
  TomlTable wear = table();
  wear.find("asked");
  wear.refuse_the_rest();
  EXPECT_THAT(faults(), HasSubstr("life.toml:3:1: unknown key aksed in [wear]; did you mean asked?"));
  EXPECT_EQ(faults_.size(), 1u);
}

}  // namespace
}  // namespace ringfilm::io
