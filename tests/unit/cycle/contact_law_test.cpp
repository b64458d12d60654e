#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "batch_cases.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/contact_curves.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/models/patir_cheng.hpp"
#include "tabulated_case.hpp"

namespace ringfilm::cycle::testing {
namespace {

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
    EXPECT_DOUBLE_EQ(one.derived.at("roughness_parameter"),
                     c.contact.asperity_density * c.contact.asperity_radius * one.derived.at("roughness"));
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

/// The same with the flow of Patir and Cheng as if it had been measured, from `first` to `last` in lambda.
/// @param across phi_y over phi_x
Case with_flow(Case c, double first = 0.5, double last = 8, double across = 1) {
  ContactLawTable law = *c.contact.law;
  const double sigma = law.composite_roughness;
  const models::PatirCheng factors(1);
  models::FlowTable flow;
  flow.sigma = sigma;
  flow.gap = {1e-9, 1e-3};
  for (double lambda = first; lambda < last + 1e-9; lambda += 0.05) {
    const double h = lambda * sigma;
    flow.h.push_back(h);
    flow.pressure_flow_x.push_back(factors.pressure_flow(lambda));
    flow.pressure_flow_y.push_back(across * factors.pressure_flow(lambda));
    flow.shear_flow.push_back(0.4 * factors.shear_flow(lambda));
    flow.pressure_stress.push_back(1);
    flow.mean_gap.push_back(h + sigma * models::average_gap_excess(lambda));
    flow.gap_share.push_back({(1e-3 - h) / (1e-3 - 1e-9), (h - 1e-9) / (1e-3 - 1e-9)});
  }
  law.flow = std::make_shared<const models::MeasuredFlow>(std::move(flow));
  c.contact.law = base::Shared<ContactLawTable>(std::move(law));
  c.film.flow_factors = c.film.shear_flow = Roughness::kMeasured;
  c.film.average_gap = AverageGap::kMeasured;
  return c;
}

TEST(MeasuredFlow, OfPatirAndChengsNumbersGivesTheirCycle) {
  const Case table = with_table(styles_new_ring());
  Case published = table;
  published.film.flow_factors = published.film.shear_flow = Roughness::kPatirCheng;
  published.film.average_gap = AverageGap::kTruncated;
  published.contact.ring_roughness_share = 0.7;  // V_r = -0.4: the ring at rest is the rougher one
  const CycleResult one = simulate(prepare(published)), other = simulate(prepare(with_flow(table)));
  const CycleResult smooth = simulate(prepare(table));
  ASSERT_TRUE(one.complete && other.complete);
  EXPECT_NEAR(other.values.mean_power_loss / one.values.mean_power_loss, 1, 1e-3);
  EXPECT_NEAR(other.values.min_film_thickness / one.values.min_film_thickness, 1, 1e-3);
  EXPECT_GT(std::abs(smooth.values.mean_power_loss / one.values.mean_power_loss - 1), 0.01);
  EXPECT_THAT(topics(other), ::testing::Not(::testing::Contains("flow-factors-left")));
}

// A film of four times the flow around the ring is that of half the length (Film2dFactors): twice as much leaves
// through its ends, and up to four times on a mesh whose cells are longer than the layer there.
TEST(MeasuredFlow, AcrossTheMotionLetsOilOutOfTheEnds) {
  const auto leaked = [](double across) {
    Case c = with_flow(with_table(styles_new_ring()), 0.5, 80, across);  // up to the edges of the face
    c.film.dimension = FilmDimension::kUnrolled;
    c.ring.end_gap = 0.3e-3;
    c.solver.cells = 40;
    c.solver.cells_y = 40;
    c.solver.crank_step_deg = c.output.crank_angle_step_deg = 8;
    double sum = 0;
    const CycleResult result = simulated(c);
    for (const UnrolledSample& sample : result.unrolled_samples) sum += std::abs(sample.gap_leakage);
    EXPECT_LT(result.effort.max_mass_residual, 1e-4);
    return sum;
  };
  const double ratio = leaked(4) / leaked(1);
  EXPECT_GT(ratio, 2);
  EXPECT_LT(ratio, 4);
}

TEST(MeasuredFlow, NotesWhereTheFactorsEnd) {
  const Case table = with_table(styles_new_ring());
  const auto few = topics(simulate(prepare(with_flow(table, 2, 3))));
  EXPECT_THAT(few, ::testing::Contains("flow-factors-left"));
  EXPECT_THAT(few, ::testing::Contains("flow-factors-extrapolated"));
  EXPECT_THAT(few, ::testing::Not(::testing::Contains("lambda-ratio-low")));
}

TEST(MeasuredFlow, BelongsToTheContactLaw) {
  const auto keys = [](const Case& c) {
    std::vector<std::string> found;
    for (const RuleBreach& breach : broken_rules(c)) found.push_back(breach.key);
    return found;
  };
  const Case table = with_table(styles_new_ring()), whole = with_flow(table);
  EXPECT_THAT(keys(whole), ::testing::IsEmpty());
  Case without = table;
  without.film.flow_factors = Roughness::kMeasured;
  EXPECT_THAT(keys(without), ::testing::ElementsAre("film.flow_factors"));
  Case closed = styles_new_ring();
  closed.film.average_gap = AverageGap::kMeasured;
  EXPECT_THAT(keys(closed), ::testing::ElementsAre("film.average_gap"));
  Case unlimited = whole;
  unlimited.film.stress_factors = Roughness::kMeasured;
  EXPECT_THAT(keys(unlimited), ::testing::IsEmpty());
  unlimited.contact.eyring_shear_stress = 0;
  EXPECT_THAT(keys(unlimited), ::testing::ElementsAre("film.stress_factors"));
}

TEST(ContactLaw, MovesAndScalesAsTheCaseStates) {
  Case c = with_table(styles_new_ring(), 0.5);
  const auto law = asperity_contact(c);
  c.contact.law_shift = 50e-9;
  c.contact.law_factor = 1.3;
  const auto moved = asperity_contact(c);
  for (const double h : {0.4e-6, 0.7e-6, 1.2e-6}) {
    const auto one = law->contact(h - 50e-9), other = moved->contact(h);
    EXPECT_NEAR(other.pressure / one.pressure, 1.3, 1e-3) << h;
    EXPECT_NEAR(other.area_share / one.area_share, 1.3, 1e-3) << h;
  }
}

// Greenwood and Tripp: p goes with N^2 beta^1.5 at a given sigma.
TEST(ContactCurves, HaveTheBandOfWhatWasMeasured) {
  Case c = styles_new_ring();
  const ContactCurves without = contact_curves(c);
  ASSERT_EQ(without.laws.front().name, "of_the_case");
  EXPECT_TRUE(std::isnan(without.log_deviation[10]));
  EXPECT_EQ(without.pressure[20], asperity_contact(c)->contact(without.separation[20]).pressure);
  EXPECT_TRUE(without.phi_x.empty() && without.phi_y.empty() && without.phi_s.empty());
  MeasuredContact& measured = c.contact.measured;
  measured.asperity_density_deviation = 0.1 * c.contact.asperity_density;
  measured.asperity_radius_deviation = 0.05 * c.contact.asperity_radius;
  measured.roughness_deviation = 0;
  const double of_density = 2 * std::log(1.1), of_radius = 1.5 * std::log(1.05);
  for (const double correlation : {0.0, -0.8}) {
    measured.density_radius_correlation = correlation;
    const double expected =
        std::sqrt(of_density * of_density + of_radius * of_radius + 2 * correlation * of_density * of_radius);
    for (const std::size_t k : {0, 20, 60}) {
      EXPECT_NEAR(contact_curves(c).log_deviation[k], expected, 1e-9) << k;
    }
  }
}

// ln p falls evenly, by 1 over the length: a shift of the separation is a factor of the pressure.
TEST(ContactCurves, HaveTheBandOfAMeasuredPair) {
  constexpr double kLength = 0.2e-6, kShift = 30e-9, kScale = 0.1, kCorrelation = 0.4;
  Case c = with_table(styles_new_ring());
  ContactLawTable law = *c.contact.law;
  for (std::size_t k = 0; k < law.rows.h.size(); ++k) {
    law.rows.pressure[k] = 1e9 * std::exp(-law.rows.h[k] / kLength);
    law.rows.area_share[k] = law.rows.pressure[k] / 2.5e9;
  }
  law.shift_deviation = kShift;
  law.factor_deviation = kScale;
  law.shift_factor_correlation = kCorrelation;
  c.contact.law = base::Shared<ContactLawTable>(std::move(law));
  const ContactCurves curves = contact_curves(c);
  const double by_shift = kShift / kLength;
  const double expected = std::sqrt(by_shift * by_shift + kScale * kScale + 2 * kCorrelation * by_shift * kScale);
  ASSERT_EQ(curves.laws.size(), 1u);  // its maps are not part of the case
  for (const std::size_t k : {5, 20, 40}) EXPECT_NEAR(curves.log_deviation[k] / expected, 1, 0.01) << k;
}

TEST(ContactCurves, HaveTheFlowOfTheGap) {
  const Case c = with_flow(with_table(styles_new_ring()));
  const ContactCurves curves = contact_curves(c);
  ASSERT_EQ(curves.phi_x.size(), curves.separation.size());
  const std::size_t k = 30;  // lambda 1.5
  EXPECT_NEAR(curves.phi_x[k], models::PatirCheng(1).pressure_flow(1.5), 1e-6);
  EXPECT_NEAR(curves.phi_s[k], 0.4 * models::PatirCheng(1).shear_flow(1.5), 1e-6);
  Case published = with_table(styles_new_ring());
  published.film.flow_factors = Roughness::kPatirCheng;
  published.film.orientation = 1.0 / 3;
  const ContactCurves of_literature = contact_curves(published);
  EXPECT_EQ(of_literature.phi_x[k], models::PatirCheng(1.0 / 3).pressure_flow(1.5));
  EXPECT_EQ(of_literature.phi_y[k], models::PatirCheng(3).pressure_flow(1.5));
}

}  // namespace
}  // namespace ringfilm::cycle::testing
