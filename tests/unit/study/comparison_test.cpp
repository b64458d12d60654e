#include "ringfilm/study/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ringfilm/base/error.hpp"

namespace {

using namespace ringfilm;
using study::compare;
using study::LedgerEntry;
using study::PublishedValue;

cycle::CycleResult with_power(double power) {
  cycle::CycleResult result;
  result.values.mean_power_loss = power;
  return result;
}

PublishedValue published_power(double power) {
  return {.source = "a paper", .quantity = "mean_power_loss", .statement = "", .value = power, .decided_by = ""};
}

study::LedgerVariant variant(const std::string& setting, double power) {
  study::LedgerVariant out;
  out.setting = setting;
  out.values.mean_power_loss = power;
  return out;
}

/// Variants of a result of 110 W, beside a published value of 100 W.
std::vector<LedgerEntry> ledger_around_100_watt() {
  LedgerEntry one, two;
  one.variants = {variant("farther", 130), variant("closer", 104)};
  two.variants = {variant("closest", 98), variant("unsolved", 100)};
  two.variants.back().solved = false;
  return {one, two};
}

TEST(Comparison, DeviationIsRelativeToThePublishedValue) {
  const auto rows = compare(with_power(110), {published_power(100)}, {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].computed, 110);
  EXPECT_NEAR(rows[0].deviation, 0.1, 1e-15);  // one division
  EXPECT_EQ(rows[0].strongest_setting, "");
  EXPECT_FALSE(rows[0].with_strongest_setting);
}

TEST(Comparison, StrongestSettingComesClosestAndWasSolved) {
  const auto row = compare(with_power(110), {published_power(100)}, ledger_around_100_watt()).front();
  EXPECT_EQ(row.strongest_setting, "closest");
  EXPECT_EQ(row.with_strongest_setting, 98);
}

TEST(Comparison, NamesNoSettingWhereTheResultAgreesWithinOnePercent) {
  for (const double agreeing : {99.1, 100.0, 100.9}) {
    const std::vector<LedgerEntry> ledger{{.topic = "",
                                           .statement = "",
                                           .consequence = "",
                                           .source = "",
                                           .can_be_lifted = true,
                                           .variants = {variant("exact", 100)}}};
    const auto row = compare(with_power(agreeing), {published_power(100)}, ledger).front();
    EXPECT_EQ(row.strongest_setting, "") << agreeing;
    EXPECT_FALSE(row.with_strongest_setting) << agreeing;
  }
}

TEST(Comparison, NamesNoSettingThatLeadsAwayOrIsNotANumber) {
  LedgerEntry entry;
  entry.variants = {variant("away", 120), variant("no number", std::numeric_limits<double>::quiet_NaN())};
  EXPECT_EQ(compare(with_power(110), {published_power(100)}, {entry}).front().strongest_setting, "");
}

TEST(Comparison, RefusesAQuantityThatNoCycleHas) {
  auto value = published_power(100);
  value.quantity = "mean_pwer_loss";
  try {
    compare(with_power(110), {value}, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"mean_pwer_loss\""), std::string::npos) << error.what();
  }
}

}  // namespace
