#include "ringfilm/models/oil/oil_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace {

using namespace ringfilm::models;
using Oil = std::shared_ptr<const OilAtTemperature>;

constexpr double kFreezing = 273.15;

/// The thickest oil of data/lubricants, SAE 15W-40.
OilLaws thick_oil() {
  OilLaws laws;
  laws.viscosity_temperature = {40 + kFreezing, 100 + kFreezing};
  laws.kinematic_viscosity = {110e-6, 14.6e-6};
  laws.density.temperature = {15 + kFreezing, 40 + kFreezing};
  laws.density.value = {880, 863.5};
  laws.parameters["pressure_viscosity_coefficient"] = 1e-8;
  laws.compression = DowsonHigginson{};
  return laws;
}

/// The thinnest one, SAE 0W-20.
OilLaws thin_oil() {
  OilLaws laws = thick_oil();
  laws.kinematic_viscosity = {45e-6, 8.6e-6};
  laws.density.value = {842, 826.2};
  return laws;
}

Oil barus_oil(double alpha, const DowsonHigginson& compression) {
  return closed_form_oil(viscosity_law(ViscosityPressureLaw::kBarus),
                         {0.01, 0.01, {{"pressure_viscosity_coefficient", alpha}}}, 850, compression);
}

OilFit::Values<double> values_of_law(const OilAtTemperature& oil, double p) {
  double rho, drho_dp, eta, deta_dp;
  oil.properties({&p, 1}, {{&rho, 1}, {&drho_dp, 1}, {&eta, 1}, {&deta_dp, 1}});
  return {rho / eta, drho_dp / eta - rho * deta_dp / (eta * eta), rho, drho_dp};
}

struct Differences {
  double value = 0, slope = 0;  // as OilFit::error and OilFit::slope_error
};

Differences differences_at(const OilFit& fit, const OilAtTemperature& oil, const std::vector<double>& pressures) {
  Differences found;
  double K_slope = 0, rho_slope = 0, K_slope_off = 0, rho_slope_off = 0;
  for (const double p : pressures) {
    const auto law = values_of_law(oil, p), fitted = fit.at(p);
    found.value = std::max({found.value, std::abs(fitted.K / law.K - 1), std::abs(fitted.rho / law.rho - 1)});
    K_slope = std::max(K_slope, std::abs(law.dK_dp));
    rho_slope = std::max(rho_slope, std::abs(law.drho_dp));
    K_slope_off = std::max(K_slope_off, std::abs(fitted.dK_dp - law.dK_dp));
    rho_slope_off = std::max(rho_slope_off, std::abs(fitted.drho_dp - law.drho_dp));
  }
  if (K_slope > 0) found.slope = K_slope_off / K_slope;
  if (rho_slope > 0) found.slope = std::max(found.slope, rho_slope_off / rho_slope);
  return found;
}

std::vector<double> random_pressures(double low, double high) {
  std::mt19937_64 bits(7);
  std::vector<double> p{low, high};
  for (int i = 0; i < 2000; ++i) p.push_back(low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53);
  return p;
}

TEST(OilFit, StandsForEngineOilsBetweenFreezingAndScorchingHeat) {
  for (const OilLaws& laws : {thin_oil(), thick_oil()}) {
    for (const double celsius : {-30.0, 20.0, 100.0, 180.0}) {
      for (const double high : {20e6, 60e6, 80e6}) {
        const Oil oil = closed_form_oil(laws, celsius + kFreezing);
        const auto fit = fit_oil(*oil, 0, high);
        ASSERT_TRUE(fit) << celsius << " degC, " << high << " Pa";
        EXPECT_EQ(fit->low, 0);
        EXPECT_EQ(fit->high, high);
        const auto seen = differences_at(*fit, *oil, random_pressures(0, high));
        // Between the check points the difference swells little: they lie four to each of its waves.
        EXPECT_LE(seen.value, 1.2 * fit->error + 1e-14) << celsius << " degC, " << high << " Pa";
        EXPECT_LE(seen.slope, 1.2 * fit->slope_error + 1e-14) << celsius << " degC, " << high << " Pa";
        EXPECT_GT(seen.slope, 0.2 * fit->slope_error);
        EXPECT_LE(fit->error, kFitError);
        EXPECT_LE(fit->slope_error, kFitSlopeError);
      }
    }
  }
}

TEST(OilFit, OfAUsualCycleLeavesRoundingOfTheValuesAndAMillionthOfTheSlopes) {
  const auto fit = fit_oil(*closed_form_oil(thick_oil(), 100 + kFreezing), 0, 25e6);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->error, 1e-13);
  EXPECT_LT(fit->slope_error, 1e-6);
}

TEST(OilFit, HasTheSlopesOfItsOwnValues) {
  const Oil oil = closed_form_oil(thick_oil(), 100 + kFreezing);
  const auto fit = fit_oil(*oil, 1e5, 30e6);
  ASSERT_TRUE(fit);
  constexpr double kStep = 1e5;  // [Pa]; a hundredth of the length over which the laws bend, squared: 1e-6
  for (const double p : {2e5, 1e6, 11e6, 29.8e6}) {
    const auto below = fit->at(p - kStep), above = fit->at(p + kStep), at = fit->at(p);
    EXPECT_NEAR((above.K - below.K) / (2 * kStep) / at.dK_dp, 1, 1e-5);
    EXPECT_NEAR((above.rho - below.rho) / (2 * kStep) / at.drho_dp, 1, 1e-5);
  }
}

TEST(OilFit, RepresentsAnOilThatNoPressureChanges) {
  const auto fit = fit_oil(*closed_form_oil(0.01, 850, 0.0, DowsonHigginson{.a = 0, .b = 0}), 0, 20e6);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->error, 1e-14);
  EXPECT_EQ(fit->slope_error, 0);
  for (const double p : {0.0, 1e5, 7e6, 20e6}) {
    EXPECT_NEAR(fit->at(p).K, 85000, 1e-9);
    EXPECT_NEAR(fit->at(p).rho, 850, 1e-11);
    EXPECT_EQ(fit->at(p).dK_dp, 0);
    EXPECT_EQ(fit->at(p).drho_dp, 0);
  }
}

TEST(OilFit, RepresentsBarusLawAndCompressionAlone) {
  const DowsonHigginson none{.a = 0, .b = 0};
  for (const Oil& oil : {barus_oil(2e-8, none), closed_form_oil(0.01, 850, 0.0, {}), barus_oil(1e-8, {})}) {
    const auto fit = fit_oil(*oil, 0, 40e6);
    ASSERT_TRUE(fit);
    EXPECT_LT(differences_at(*fit, *oil, random_pressures(0, 40e6)).value, 1e-11);
  }
}

TEST(OilFit, IsRefusedWhereItWouldDifferFromTheLaw) {
  const auto refused = [](const Oil& oil, double high) { return !fit_oil(*oil, 0, high); };
  const Oil table =
      tabulated_oil({1e5, 5e6, 1e7, 2e7, 4e7}, {0.01, 0.0107, 0.0113, 0.0128, 0.016}, {850, 852, 855, 860, 868});
  EXPECT_TRUE(refused(table, 20e6));
  // Viscosity over many decades, and one that overflows.
  EXPECT_TRUE(refused(barus_oil(1e-6, {}), 20e6));
  EXPECT_TRUE(refused(barus_oil(1e-6, {}), 1e9));
  // 2 GPa: ten half-lives of the fluidity.
  EXPECT_TRUE(refused(closed_form_oil(thick_oil(), 100 + kFreezing), 2e9));
}

TEST(FittedOil, CarriesTheFitAndAnswersByTheLaw) {
  const Oil oil = closed_form_oil(thin_oil(), 100 + kFreezing);
  const Oil fitted = fitted_oil(oil, 0, 60e6);
  EXPECT_EQ(oil->fit(), nullptr);
  ASSERT_NE(fitted->fit(), nullptr);
  EXPECT_EQ(fitted->fit()->high, 60e6);
  for (const double p : {0.0, 3e6, 59e6, 500e6}) {
    EXPECT_EQ(fitted->viscosity(p), oil->viscosity(p));
    EXPECT_EQ(fitted->density(p), oil->density(p));
  }
}

TEST(FittedOil, IsTheOilItselfWithoutAFit) {
  const Oil oil = barus_oil(1e-6, {});
  EXPECT_EQ(fitted_oil(oil, 0, 20e6), oil);
}

}  // namespace
