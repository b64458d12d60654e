#include "ringfilm/study/design/measured_factors.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "../study_example.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::study {
namespace {

using namespace testing;
using ::testing::HasSubstr;

cycle::Case measured_case(double zeta) {
  cycle::Case c = coarse_case();
  c.contact.boundary_shear_strength_coefficient = zeta;
  auto& m = c.contact.measured;
  m.asperity_density_deviation = 0.1 * c.contact.asperity_density;
  m.asperity_radius_deviation = 0.2 * c.contact.asperity_radius;
  m.roughness_deviation = 0.05 * c.contact.roughness;
  m.density_radius_correlation = -0.6;
  m.radius_roughness_correlation = 0.2;
  m.shear_strength.calibration = "May";
  m.shear_strength.slope_deviation = 0.02;
  m.shear_strength.calibration_deviation = 0.1 * zeta;
  m.shear_strength.reference_deviation = 0.53 * zeta;
  return c;
}

Study three_states() {
  Study study = study_of({}, Method::kSobol, 4096);
  study.bases = {{"new", measured_case(0.36)}, {"run-in", measured_case(0.3)}, {"embedded", measured_case(0.24)}};
  return study;
}

std::vector<std::string> names(const Study& study) {
  std::vector<std::string> all;
  for (const Factor& factor : study.factors) all.push_back(factor.name);
  return all;
}

TEST(MeasuredFactors, RingsOfAPackThatStateTheSameHaveOnePair) {
  cycle::Case pack = measured_case(0.3);
  pack.rings = {measured_case(0.3), measured_case(0.24), measured_case(0.3)};
  Study study = study_of({}, Method::kSobol, 16);
  study.bases = {{"car", pack}};
  add_measured_factors(study, {0});
  EXPECT_THAT(names(study), ::testing::ElementsAre(
                                "asperity_density of car ring 1+3", "asperity_radius of car ring 1+3",
                                "roughness of car ring 1+3", "slope of zeta of car ring 1+3", "calibration of May",
                                "reference of May", "asperity_density of car ring 2", "asperity_radius of car ring 2",
                                "roughness of car ring 2", "slope of zeta of car ring 2"));
  const auto keys = [&](std::size_t factor) {
    std::vector<std::string> all;
    for (const Target& target : study.factors[factor].targets) all.push_back(target.key);
    return all;
  };
  EXPECT_THAT(keys(2), ::testing::ElementsAre("ring.1.contact.roughness", "ring.3.contact.roughness"));
  EXPECT_EQ(keys(4).size(), 3u);
  const Point point = Plan(study).point(5);
  const cycle::Case drawn = scenario_case(study, point);
  EXPECT_EQ(drawn.rings[0].contact.roughness, drawn.rings[2].contact.roughness);
  EXPECT_NE(drawn.rings[0].contact.roughness, drawn.rings[1].contact.roughness);
  EXPECT_NE(drawn.rings[0].contact.roughness, pack.rings[0].contact.roughness);

  study = study_of({}, Method::kSobol, 16);
  pack.rings[1] = pack.rings[0];
  study.bases = {{"car", pack}};
  add_measured_factors(study, {0});
  EXPECT_EQ(names(study).front(), "asperity_density of car");
  EXPECT_EQ(study.factors.size(), 6u);
}

TEST(MeasuredFactors, SurfacesAreEachForThemselvesAndTheCalibrationIsOneForAll) {
  Study study = three_states();
  add_measured_factors(study, {0, 1, 2});
  EXPECT_THAT(names(study),
              ::testing::ElementsAre(
                  "asperity_density of new", "asperity_radius of new", "roughness of new", "slope of zeta of new",
                  "calibration of May", "reference of May", "asperity_density of run-in", "asperity_radius of run-in",
                  "roughness of run-in", "slope of zeta of run-in", "asperity_density of embedded",
                  "asperity_radius of embedded", "roughness of embedded", "slope of zeta of embedded"));
  EXPECT_EQ(study.correlations.size(), 6u);
  EXPECT_EQ(reported(study), "");
  // What is common moves all bases by the same share.
  const Plan plan(study);
  for (std::uint64_t p = 0; p < 20; ++p) {
    std::vector<double> rest;
    for (std::size_t b = 0; b < 3; ++b) {
      const Point point = plan.point(plan.scenario(b, p));
      const cycle::Case c = scenario_case(study, point);
      const double own = *point.values[b == 0 ? 3 : b == 1 ? 9 : 13];
      rest.push_back(c.contact.boundary_shear_strength_coefficient /
                     study.bases[b].input.contact.boundary_shear_strength_coefficient / own);
    }
    EXPECT_NEAR(rest[1], rest[0], 1e-12);
    EXPECT_NEAR(rest[2], rest[0], 1e-12);
  }
}

TEST(MeasuredFactors, ScatterIsThatOfTheMeasurement) {
  Study study = three_states();
  study.bases.resize(1);
  study.bases[0].input.contact.measured.shear_strength = {};
  add_measured_factors(study, {0});
  const Plan plan(study);
  const cycle::Contact& contact = study.bases[0].input.contact;
  double mean = 0, square = 0, product = 0;
  const double n = 4096;
  for (std::uint64_t i = 0; i < 4096; ++i) {
    const cycle::Contact c = scenario_case(study, plan.point(i)).contact;
    const double N = c.asperity_density / contact.asperity_density - 1,
                 beta = c.asperity_radius / contact.asperity_radius - 1;
    mean += beta / n;
    square += beta * beta / n;
    product += N * beta / n;
    EXPECT_GT(c.asperity_radius, 0);
  }
  // A deviation of 4096 independent draws is certain to 1.1 %, a correlation of -0.6 to 0.01; Sobol points are better.
  // Cut off at five deviations, nothing of that shows.
  EXPECT_NEAR(mean, 0, 0.2 * 0.016);
  EXPECT_NEAR(std::sqrt(square), 0.2, 0.2 * 0.011);
  EXPECT_NEAR(product / (0.1 * 0.2), -0.6, 0.02);
}

TEST(MeasuredFactors, OfAContactLawAreItsShiftAndItsFactor) {
  Study study = three_states();
  study.bases.resize(1);
  cycle::Contact& contact = study.bases[0].input.contact;
  contact.measured.shear_strength = {};
  contact.model = cycle::ContactLaw::kTable;
  cycle::ContactLawTable law;
  law.shift_deviation = 20e-9;
  law.factor_deviation = 0.1;
  law.shift_factor_correlation = -0.5;
  contact.law = base::Shared<cycle::ContactLawTable>(std::move(law));
  add_measured_factors(study, {0});
  EXPECT_THAT(names(study), ::testing::ElementsAre("law_shift of new", "law_factor of new"));
  const Plan plan(study);
  double square = 0, product = 0, squares = 0;
  constexpr double n = 4096;
  for (std::uint64_t i = 0; i < 4096; ++i) {
    const cycle::Contact c = scenario_case(study, plan.point(i)).contact;
    EXPECT_GT(c.law_factor, 0);
    square += c.law_shift * c.law_shift / n;
    squares += std::pow(std::log(c.law_factor), 2) / n;
    product += c.law_shift * std::log(c.law_factor) / n;
  }
  EXPECT_NEAR(std::sqrt(square) / 20e-9, 1, 0.02);
  EXPECT_NEAR(std::sqrt(squares) / 0.1, 1, 0.02);
  EXPECT_NEAR(product / (20e-9 * 0.1), -0.5, 0.03);
}

TEST(MeasuredFactors, ErrorsMayStandApart) {
  Study study = three_states();
  add_measured_factors(study, {0, 2}, {Shared::kApart, Shared::kCommon});
  EXPECT_THAT(names(study),
              ::testing::IsSupersetOf({"calibration of new", "calibration of embedded", "reference of May"}));
  study = three_states();
  study.bases[1].input.contact.measured.shear_strength.calibration = "April";
  add_measured_factors(study, {0, 1, 2});
  EXPECT_THAT(names(study), ::testing::IsSupersetOf({"calibration of May", "calibration of April"}));
}

TEST(MeasuredFactors, NoFactorWithoutScatter) {
  Study study = three_states();
  study.bases[0].input.contact.measured.asperity_radius_deviation = 0;
  study.bases[0].input.contact.measured.roughness_deviation.reset();
  add_measured_factors(study, {0});
  EXPECT_EQ(study.factors.size(), 4u);
  EXPECT_TRUE(study.correlations.empty());
  study = three_states();
  study.bases[1].input.contact.measured = {};
  try {
    add_measured_factors(study, {0, 1});
    FAIL() << "there is nothing to draw from";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("base \"run-in\" states no scatter in [contact.measured]"));
  }
}

TEST(MeasuredFactors, OneErrorHasOneSize) {
  Study study = three_states();
  study.bases[2].input.contact.measured.shear_strength.calibration_deviation = 0.12 * 0.24;
  try {
    add_measured_factors(study, {0, 1, 2});
    FAIL() << "one error cannot have two sizes";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the calibration of May has the relative deviation 0.1 in one base and 0.12 in "
                                        "base \"embedded\""));
  }
}

TEST(MeasuredFactors, BadScatterIsReportedByTheFactor) {
  Study study = three_states();
  study.bases[0].input.contact.measured.roughness_deviation = -1e-8;
  add_measured_factors(study, {0});
  EXPECT_THAT(reported(study), HasSubstr("factor \"roughness of new\" has the standard deviation -1e-08"));
  study = three_states();
  study.bases[0].input.contact.measured.density_roughness_correlation = 0.9;
  add_measured_factors(study, {0});
  EXPECT_THAT(reported(study),
              HasSubstr("their matrix is not positive definite, as factor \"roughness of new\" shows"));
}

}  // namespace
}  // namespace ringfilm::study
