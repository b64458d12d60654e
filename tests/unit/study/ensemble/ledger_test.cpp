#include "ringfilm/study/ensemble/ledger.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../study_case.hpp"

namespace {

using namespace ringfilm;
using cycle::Case;
using study::LedgerEntry;
using study::LedgerVariant;
using study::testing::coarse_case;

const LedgerVariant& variant(const std::vector<LedgerEntry>& ledger, const std::string& setting) {
  for (const LedgerEntry& entry : ledger) {
    for (const LedgerVariant& candidate : entry.variants) {
      if (candidate.setting == setting) return candidate;
    }
  }
  throw std::out_of_range("the ledger has no variant " + setting);
}

/// The same bits: the same solver ran the same case.
void expect_same_values(const cycle::CycleValues& variant, const Case& changed) {
  const auto direct = study::endings({changed}).front().result.values;
  for (const auto& quantity : cycle::cycle_quantities()) {
    EXPECT_EQ(variant.*quantity.value, direct.*quantity.value) << quantity.name;
  }
}

TEST(Ledger, VariantsEqualADirectRunOfTheChangedCase) {
  const Case c = coarse_case();
  int reported = 0, last_done = 0, last_total = 0;
  const auto ledger = study::ledger(c, [&](int done, int total) {
    ++reported;
    last_done = done;
    last_total = total;
  });

  Case mass_conserving = c;
  mass_conserving.film.cavitation = cycle::Cavitation::kMassConserving;
  expect_same_values(variant(ledger, "film.cavitation = \"mass-conserving\"").values, mass_conserving);
  Case stiffer = c;
  stiffer.contact.composite_modulus = 190e9;
  expect_same_values(variant(ledger, "contact.composite_modulus = \"190 GPa\"").values, stiffer);
  Case tenser = c;
  tenser.ring.elastic_pressure = 0.24e6;
  expect_same_values(variant(ledger, "ring.elastic_pressure = \"0.24 MPa\"").values, tenser);

  int variants = 0;
  for (const LedgerEntry& entry : ledger) {
    variants += static_cast<int>(entry.variants.size());
    const bool by_a_case_of_its_own = entry.topic == "ring-gap" || entry.topic == "bore-shape";
    EXPECT_EQ(entry.can_be_lifted, !entry.variants.empty() || by_a_case_of_its_own) << entry.topic;
  }
  EXPECT_EQ(reported, variants + 1);  // and the case itself
  EXPECT_EQ(last_done, reported);
  EXPECT_EQ(last_total, reported);
}

TEST(Ledger, AValueThatASettingDoesNotMoveIsThatOfTheResult) {
  Case c = coarse_case();
  c.solver.cells = 20;
  study::LedgerPlan plan = study::ledger_plan(c);
  const auto ended = study::endings(plan.cases);
  cycle::CycleValues own = ended.back().result.values;
  own.peak_gas_pressure *= 1.001;  // the result may have been found in another way
  own.min_film_thickness *= 1.001;
  const auto ledger = study::ledger(std::move(plan), ended, own);
  const cycle::CycleValues stiffer = variant(ledger, "contact.composite_modulus = \"190 GPa\"").values;
  EXPECT_EQ(stiffer.peak_gas_pressure, own.peak_gas_pressure);
  Case direct = c;
  direct.contact.composite_modulus = 190e9;
  EXPECT_EQ(stiffer.min_film_thickness, study::endings({direct}).front().result.values.min_film_thickness);
}

TEST(Ledger, WithoutTheCaseItselfNoValueCountsAsUnmoved) {
  study::LedgerPlan plan = study::ledger_plan(coarse_case());
  std::vector<study::Ending> ended(plan.cases.size());
  for (study::Ending& ending : ended) ending.result.values.peak_gas_pressure = 2;
  cycle::CycleValues own;
  own.peak_gas_pressure = 3;
  const char* setting = "contact.composite_modulus = \"190 GPa\"";
  EXPECT_EQ(variant(study::ledger(plan, ended, own), setting).values.peak_gas_pressure, 3);
  ended.back().refusal = InputError("refused");
  EXPECT_EQ(variant(study::ledger(plan, ended, own), setting).values.peak_gas_pressure, 2);
}

TEST(Ledger, NeedsAnEndingOfEachCase) {
  study::LedgerPlan plan = study::ledger_plan(coarse_case());
  const std::vector<study::Ending> ended(plan.cases.size());
  EXPECT_THROW(study::ledger(plan, std::span(ended).first(ended.size() - 1), {}), std::logic_error);
  EXPECT_THROW(study::ledger(study::LedgerPlan(), {}, {}), std::logic_error);
}

TEST(Ledger, AVariantThatCannotBeSolvedIsKeptWithItsReason) {
  Case c = coarse_case();
  c.solver.cells = 20;
  c.lubricant.table_file = "oil.csv";  // 20 K to either side of 120 degC lie outside
  c.lubricant.table = cycle::OilTable{{383.15, 403.15}, {1e5, 1e7}, {6e-3, 7e-3, 4e-3, 5e-3}, {790, 795, 780, 785}};
  const auto ledger = study::ledger(c);
  for (const char* setting : {"operating.oil_temperature = \"100 degC\"", "operating.oil_temperature = \"140 degC\""}) {
    const LedgerVariant& outside = variant(ledger, setting);
    EXPECT_FALSE(outside.solved);
    EXPECT_NE(outside.reason.find("outside the oil table"), std::string::npos) << outside.reason;
    EXPECT_TRUE(std::isnan(outside.values.mean_power_loss));
  }
  const LedgerVariant& inside = variant(ledger, "contact.composite_modulus = \"190 GPa\"");
  EXPECT_TRUE(inside.solved);
  EXPECT_EQ(inside.reason, "");
  EXPECT_GT(inside.values.mean_power_loss, 0);
}

TEST(Ledger, OutputThatTheCaseAsksForDoesNotMoveAVariant) {
  Case c = coarse_case();
  c.solver.cells = 20;
  c.output.fields = cycle::FieldOutput::kAll;
  c.output.crank_angles_deg = {10};
  Case plain = coarse_case();
  plain.solver.cells = 20;
  const auto with_fields = study::ledger(c), without = study::ledger(plain);
  ASSERT_EQ(with_fields.size(), without.size());
  const char* setting = "ring.face.orientation = \"x0-crankcase\"";
  EXPECT_EQ(variant(with_fields, setting).values.mean_power_loss, variant(without, setting).values.mean_power_loss);
}

}  // namespace
