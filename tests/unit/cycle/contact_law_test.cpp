#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "batch_cases.hpp"
#include "ringfilm/cycle/case/case_fields.hpp"
#include "ringfilm/cycle/integration/contact_setup.hpp"

namespace ringfilm::cycle::testing {
namespace {

/// Greenwood and Tripp as a table, so that the cycle is known.
Case with_table(Case c, double first = 0, double last = 5) {
  const auto law = asperity_contact(c);
  ContactLawTable table;
  table.composite_roughness = roughness(c);
  table.composite_modulus = composite_modulus(c);
  for (double lambda = first; lambda < last + 1e-9; lambda += 0.1) {
    const auto at = law->contact(lambda * table.composite_roughness);
    table.rows.h.push_back(lambda * table.composite_roughness);
    table.rows.pressure.push_back(at.pressure);
    table.rows.area_share.push_back(at.area_share);
    table.mean_gap.push_back(lambda * table.composite_roughness);
  }
  table.last_supported_separation = table.rows.h.back();
  c.contact.model = ContactLaw::kTable;
  c.contact.law_file = "law.nc";
  c.contact.law = base::Shared<ContactLawTable>(std::move(table));
  return c;
}

std::vector<std::string> topics(const CycleResult& result) {
  std::vector<std::string> found;
  for (const Note& note : result.notes) found.push_back(note.topic);
  return found;
}

TEST(ContactLaw, ATableOfGreenwoodAndTrippGivesTheirCycle) {
  const Case c = styles_new_ring();
  for (const auto properties : {Properties::kFitted, Properties::kExact}) {
    Case closed = c, table = with_table(c);
    closed.solver.properties = table.solver.properties = properties;
    const CycleResult one = simulate(prepare(closed)), other = simulate(prepare(table));
    ASSERT_TRUE(one.complete && other.complete);
    // The spline errs by 1e-4 of the pressure between its rows, and the film balances it with a hundredth of that.
    EXPECT_NEAR(other.values.mean_power_loss / one.values.mean_power_loss, 1, 2e-5);
    EXPECT_NEAR(other.values.min_film_thickness / one.values.min_film_thickness, 1, 2e-5);
    EXPECT_NEAR(other.values.peak_mean_real_pressure / one.values.peak_mean_real_pressure, 1, 1e-3);
    EXPECT_THAT(topics(other), ::testing::Not(::testing::Contains("contact-law-extrapolated")));
    EXPECT_THAT(topics(other), ::testing::Not(::testing::Contains("contact-law-left")));
    EXPECT_EQ(other.derived.count("roughness_parameter"), 0u);
    EXPECT_EQ(other.derived.at("roughness"), 0.48e-6);
  }
}

TEST(ContactLaw, NotesWhereTheTableEnds) {
  const Case c = styles_new_ring();
  EXPECT_THAT(topics(simulate(prepare(with_table(c, 1.5)))), ::testing::Contains("contact-law-left"));
  EXPECT_THAT(topics(simulate(prepare(with_table(c, 0, 1.5)))), ::testing::Contains("contact-law-extrapolated"));
}

TEST(ContactLaw, FilmsWithTablesAndWithFormulasDoNotDisturbEachOther) {
  std::vector<Case> cases;
  for (int k = 0; k < 6; ++k) {
    Case c = styles_new_ring();
    c.operating.speed *= 1 + 0.1 * k;
    c.solver.cells = 60;
    cases.push_back(k % 2 == 0 ? with_table(c) : c);
  }
  const Batch all = batch_of(cases, {0, 1, 2, 3, 4, 5}, film::kernels().name);
  const Batch turned = batch_of(cases, {5, 3, 4, 1, 0, 2}, film::kernels().name);
  for (const auto& [i, outcome] : all.outcomes) {
    const Batch alone = batch_of(cases, {i}, film::kernels().name);
    for (const Batch* other : {&turned, &alone}) {
      EXPECT_EQ(std::memcmp(&outcome.result.values, &other->outcomes.at(i).result.values, sizeof(CycleValues)), 0) << i;
    }
    EXPECT_GT(outcome.result.values.mean_power_loss, 0);
  }
}

TEST(ContactLaw, FromThePlaneOfTheSummitsTheFilmIsThicker) {
  Case c = styles_new_ring();
  const double as_fed = simulate(prepare(c)).values.lambda_ratio_at_peak_pressure;
  c.contact.model = ContactLaw::kGreenwoodWilliamson;
  c.contact.summit_plane = SummitPlane::kNayak;
  const CycleResult elastic = simulate(prepare(c));
  c.contact.hardness = 2.5e9;
  c.contact.asperity = AsperityLaw::kZhaoMaiettaChang;
  const CycleResult flowing = simulate(prepare(c));
  EXPECT_GT(flowing.values.lambda_ratio_at_peak_pressure, as_fed + 0.5);
  EXPECT_GT(elastic.values.lambda_ratio_at_peak_pressure, flowing.values.lambda_ratio_at_peak_pressure + 0.2);
  EXPECT_THAT(topics(elastic), ::testing::Contains("contact-beyond-hardness"));
  EXPECT_THAT(topics(flowing), ::testing::Not(::testing::Contains("contact-beyond-hardness")));
}

TEST(ContactLaw, LawsThatCannotBeAreRefused) {
  const auto keys = [](const Case& c) {
    std::vector<std::string> found;
    for (const RuleBreach& breach : broken_rules(c)) found.push_back(breach.key);
    return found;
  };
  Case c = styles_new_ring();
  EXPECT_THAT(keys(c), ::testing::IsEmpty());
  c.contact.model = ContactLaw::kPlastic;
  EXPECT_THAT(keys(c), ::testing::ElementsAre("contact.hardness"));
  c.contact.model = ContactLaw::kBushGibsonThomas;
  EXPECT_THAT(keys(c), ::testing::IsEmpty());
  c.contact.roughness = 0.05e-6;  // bandwidth parameter below 1.5
  EXPECT_THAT(keys(c), ::testing::ElementsAre("contact.summit_plane"));
}

}  // namespace
}  // namespace ringfilm::cycle::testing
