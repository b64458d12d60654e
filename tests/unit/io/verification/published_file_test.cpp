#include "ringfilm/io/verification/published_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "../scratch_folder.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::io {
namespace {

using testing::HasSubstr;

const std::string kGood = R"([[published]]
case = "new"
source = "paper"
quantity = "fmep"
statement = "friction mean effective pressure"
value = "19 kPa"
decided_by = ""

[[published]]
case = "worn"
source = "paper"
quantity = "lambda_ratio_at_peak_pressure"
statement = "lambda ratio"
value = 1.18
decided_by = "E'"
)";

std::string replaced(const std::string& old_text, const std::string& new_text) {
  std::string text = kGood;
  return text.replace(text.find(old_text), old_text.size(), new_text);
}

std::string refusal_of_published(const std::string& text) {
  const ScratchFolder folder;
  std::ofstream(folder / "published.toml") << text;
  try {
    read_published(folder / "published.toml", "new", Units());
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(PublishedFile, GivesTheValuesOfOneCaseInSi) {
  const ScratchFolder folder;
  std::ofstream(folder / "published.toml") << kGood;
  const auto values = read_published(folder / "published.toml", "new", Units());
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(values[0].source, "paper");
  EXPECT_EQ(values[0].quantity, "fmep");
  EXPECT_EQ(values[0].value, 19e3);
  const auto worn = read_published(folder / "published.toml", "worn", Units());
  ASSERT_EQ(worn.size(), 1u);
  EXPECT_EQ(worn[0].value, 1.18);
  EXPECT_EQ(worn[0].decided_by, "E'");
}

TEST(PublishedFile, RefusesWhatCannotBeCompared) {
  EXPECT_THAT(refusal_of_published(replaced("\"fmep\"", "\"fmeep\"")), HasSubstr("not a cycle value"));
  EXPECT_THAT(refusal_of_published(replaced("\"19 kPa\"", "19")), HasSubstr("unit"));
  EXPECT_THAT(refusal_of_published(replaced("\"19 kPa\"", "\"19 kg\"")), HasSubstr("19 kg"));
  EXPECT_THAT(refusal_of_published(replaced("\"19 kPa\"", "\"0 kPa\"")), HasSubstr("not 0"));
  EXPECT_THAT(refusal_of_published(replaced("value = 1.18\n", "")), HasSubstr("[[published]] has no value"));
  EXPECT_THAT(refusal_of_published(replaced("source =", "sauce =")), HasSubstr("unknown key sauce in [[published]]"));
  EXPECT_THAT(refusal_of_published("title = \"nothing\"\n"), HasSubstr("[[published]]"));
}

TEST(PublishedFile, ShippedOneHoldsWhatThePaperReportsOfEachRing) {
  const std::string path = std::string(RINGFILM_SOURCE_FOLDER) + "/cases/styles2014/published.toml";
  for (const char* ring : {"new", "run-in", "embedded"})
    EXPECT_FALSE(read_published(path, ring, Units()).empty()) << ring;
}

}  // namespace
}  // namespace ringfilm::io
