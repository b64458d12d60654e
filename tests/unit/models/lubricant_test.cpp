#include "ringfilm/models/oil/lubricant.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "../../traps/floating_point_traps.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/models/oil/roelands.hpp"

namespace {

using namespace ringfilm::models;
using ringfilm::InputError;

constexpr double kZero = 273.15, kAtmospheric = 101325;

/// styles2014, Table 3.
OilLaws paper_oil() {
  OilLaws laws;
  laws.viscosity_temperature = {40 + kZero, 100 + kZero};
  laws.kinematic_viscosity = {59.99e-6, 9.590e-6};
  laws.density.temperature = {15 + kZero, 40 + kZero};
  laws.density.value = {849.7, 833.8};
  laws.parameters["pressure_viscosity_coefficient"] = 1e-8;
  laws.beta_0 = 4e-2;
  laws.theta_0 = 40 + kZero;
  laws.compression = DowsonHigginson{};
  return laws;
}

TEST(Walther, PassesThroughItsTwoPoints) {
  const auto laws = paper_oil();
  const auto walther = Walther::fit(laws.viscosity_temperature, laws.kinematic_viscosity);
  // Two nested powers of ten multiply rounding by the logarithms, about 10.
  EXPECT_NEAR(walther.kinematic_viscosity(40 + kZero) / 59.99e-6, 1, 1e-13);
  EXPECT_NEAR(walther.kinematic_viscosity(100 + kZero) / 9.590e-6, 1, 1e-13);
}

TEST(Walther, TakesTheMeanOfPointsBesideOneLine) {
  const Walther exact{.A = 9.0, .B = 3.5};
  std::vector<double> T, nu;
  for (const double at : {300.0, 320.0, 350.0, 390.0}) {
    T.push_back(at);
    nu.push_back(exact.kinematic_viscosity(at));
  }
  const auto through_all = Walther::fit(T, nu);
  EXPECT_NEAR(through_all.A, 9.0, 1e-12);  // ordinates of order 0.1, abscissae that differ by 0.1: two digits lost
  EXPECT_NEAR(through_all.B, 3.5, 1e-12);
}

TEST(Walther, RefusesPointsThatAreNoOil) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  const std::vector<double> T{313.15, 373.15};
  EXPECT_THROW(Walther::fit(T, std::vector<double>{9e-6, 60e-6}), InputError);
  EXPECT_THROW(Walther::fit(T, std::vector<double>{9e-6, 0.3e-6}), InputError);
  EXPECT_THROW(Walther::fit(T, std::vector<double>{9e-6, NAN}), InputError);
  EXPECT_THROW(Walther::fit(std::vector<double>{313.15}, std::vector<double>{60e-6}), InputError);
  EXPECT_THROW(Walther::fit(std::vector<double>{313.15, 313.15}, std::vector<double>{60e-6, 50e-6}), InputError);
  EXPECT_THROW(Walther::fit(std::vector<double>{300, 350, 400}, std::vector<double>{60e-6, 9e-6}), InputError);
  EXPECT_THROW(Walther::fit(T, std::vector<double>{60e-6, 20e-6, 9e-6}), InputError);
  EXPECT_THROW(Walther::fit(std::vector<double>{40, 100}, std::vector<double>{60e-6, 9e-6}), InputError);  // degC
  EXPECT_THROW(Walther::fit(std::vector<double>{313.15, NAN}, std::vector<double>{60e-6, 9e-6}), InputError);
}

TEST(Oil, OfThePaperAt120DegreesHasTheReferenceValues) {
  // Derived constants of the independent model (shared/reference/new_1500_reynolds.json).
  const auto [eta_T, rho_T, eta_0] = oil_state(paper_oil(), 120 + kZero);
  const double Z = roelands_index(1e-8, eta_0);
  EXPECT_NEAR(eta_T / 0.005063296356917147, 1, 1e-9);
  EXPECT_NEAR(rho_T, 782.92, 1e-9);
  EXPECT_NEAR(Z / 0.4472324222852102, 1, 1e-9);
  EXPECT_NEAR(eta_T / rho_T, 6.467e-6, 5e-10);  // PHYSICS section 1, four digits
}

TEST(Oil, AfterHoupertIsTwelvePercentAboveWaltherAt120Degrees) {
  auto laws = paper_oil();
  const double after_walther = oil_state(laws, 120 + kZero).eta_T;
  laws.viscosity_temperature_law = ViscosityTemperatureLaw::kHoupert;
  const auto state = oil_state(laws, 120 + kZero);
  EXPECT_NEAR(state.eta_T / after_walther, 1.12, 0.005);  // PHYSICS 2.10
  // Z belongs to the reference temperature: eq-roelands-index with 59.99e-6 m2/s times 833.8 kg/m3.
  EXPECT_NEAR(roelands_index(1e-8, state.eta_0), 1e-8 / (5.1e-9 * (std::log(59.99e-6 * 833.8) + 9.67)), 1e-12);
}

TEST(Oil, AfterHoupertNeedsOneViscosityOnlyIfItIsThatOfTheReferenceTemperature) {
  auto laws = paper_oil();
  laws.viscosity_temperature_law = ViscosityTemperatureLaw::kHoupert;
  const double with_two = oil_state(laws, 120 + kZero).eta_T;
  laws.viscosity_temperature = {40 + kZero};
  laws.kinematic_viscosity = {59.99e-6};
  EXPECT_NEAR(oil_state(laws, 120 + kZero).eta_T / with_two, 1, 1e-12);  // the fit passes through its points to 1e-13
  laws.theta_0 = 50 + kZero;
  EXPECT_THROW(oil_state(laws, 120 + kZero), InputError);
}

TEST(Oil, HoupertsTermFallsWithItsCoefficientAtTheReferenceTemperature) {
  // d ln eta/dT = -beta_0 at theta_0, by a central difference of 0.01 K: truncation 1e-4 of third derivatives, 1e-9.
  const double eta_0 = 0.05, theta_0 = 313.15, step = 0.01;
  const double slope = (std::log(houpert_viscosity(eta_0, theta_0, 0.04, theta_0 + step)) -
                        std::log(houpert_viscosity(eta_0, theta_0, 0.04, theta_0 - step))) /
                       (2 * step);
  EXPECT_NEAR(slope, -0.04, 1e-8);
  EXPECT_DOUBLE_EQ(houpert_viscosity(eta_0, theta_0, 0.04, theta_0), eta_0);
}

TEST(Oil, UnderPressureFollowsThePapersProductForm) {
  // styles2014, eqs 16 to 19, written with alpha* p instead of eta_T.
  auto laws = paper_oil();
  laws.viscosity_temperature_law = ViscosityTemperatureLaw::kHoupert;
  const double T = 393.15, theta_0 = 313.15, eta_0 = 59.99e-6 * 833.8, logarithm = std::log(eta_0) + 9.67;
  const double Z = 1e-8 / (5.1e-9 * logarithm), S_0 = 0.04 * (theta_0 - 138) / logarithm;
  const auto oil = closed_form_oil(laws, T);
  for (const double p : {1e5, 6.2e6, 5e7, 4e8}) {
    const double exponent = logarithm * (std::pow((T - 138) / (theta_0 - 138), -S_0) * std::pow(1 + p / 1.98e8, Z) - 1);
    EXPECT_NEAR(oil->viscosity(p) / (eta_0 * std::exp(exponent)), 1, 1e-13);  // exponents of order 5
  }
}

TEST(Oil, WithoutPressureLawsIsConstant) {
  auto laws = paper_oil();
  laws.viscosity_pressure_law = ViscosityPressureLaw::kNone;
  laws.compression.reset();
  const auto oil = closed_form_oil(laws, 393.15);
  EXPECT_EQ(oil->viscosity(1e9), oil->viscosity(0));
  EXPECT_EQ(oil->density(1e9), oil->density(0));
  EXPECT_NEAR(oil->density(0), 782.92, 1e-9);
}

TEST(Oil, DensityIsThatOfTheTableAtAtmosphericPressureAndLevelsOff) {
  const auto oil = closed_form_oil(paper_oil(), 313.15);
  EXPECT_DOUBLE_EQ(oil->density(kAtmospheric), 833.8);
  EXPECT_NEAR(oil->density(1e15) / 833.8, 1 + 6.0 / 17.0, 1e-6);  // a/b; the rest is 1/(b p)
}

TEST(Oil, ThinnerThanRoelandsLawAllowsIsRefused) {
  auto laws = paper_oil();
  laws.kinematic_viscosity = {0.075e-6 * 10, 0.060e-6 * 10};
  laws.density.value = {84.97, 83.38};
  try {
    closed_form_oil(laws, 393.15);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("mPa.s"), std::string::npos);
  }
}

TEST(DensityLaw, IsLinearBetweenAndBeyondItsPoints) {
  const DensityLaw law{.temperature = {288.15, 313.15}, .value = {849.7, 833.8}};
  EXPECT_NEAR(law.density(300.65), (849.7 + 833.8) / 2, 1e-12);
  EXPECT_NEAR(law.density(393.15), 782.92, 1e-9);
  EXPECT_FALSE(law.extrapolates(288.15));
  EXPECT_FALSE(law.extrapolates(313.15));
  EXPECT_TRUE(law.extrapolates(313.2));
  EXPECT_TRUE(law.extrapolates(288));
}

TEST(DensityLaw, ExpandsFromItsReferenceTemperature) {
  const DensityLaw law{.temperature = {288.15, 313.15},
                       .value = {849.7, 833.8},
                       .law = DensityTemperatureLaw::kThermalExpansivity,
                       .thermal_expansivity = 1e-3,
                       .reference_temperature = 313.15};
  EXPECT_NEAR(law.density(393.15), 833.8 * (1 - 0.08), 1e-9);
  EXPECT_FALSE(law.extrapolates(393.15));
}

TEST(DensityLaw, ThatRunsOutOfDensityIsRefused) {
  auto laws = paper_oil();
  EXPECT_THROW(oil_state(laws, 5000), InputError);
}

/// Table of the closed-form oil: what it is interpolated from is known everywhere.
OilTable table_of(const OilLaws& laws, std::vector<double> temperature, std::vector<double> pressure) {
  OilTable table{
      .temperature = std::move(temperature), .pressure = std::move(pressure), .viscosity = {}, .density = {}};
  for (const double T : table.temperature) {
    const auto oil = closed_form_oil(laws, T);
    for (const double p : table.pressure) {
      table.viscosity.push_back(oil->viscosity(p));
      table.density.push_back(oil->density(p));
    }
  }
  return table;
}

TEST(OilTable, GivesBackItsGridPoints) {
  const auto laws = paper_oil();
  const auto table = table_of(laws, {313.15, 353.15, 393.15}, {1e5, 1e7, 5e7, 1e8});
  for (const double T : table.temperature) {
    const auto tabulated = tabulated_oil(table, T), exact = closed_form_oil(laws, T);
    for (const double p : table.pressure) {
      EXPECT_NEAR(tabulated->viscosity(p) / exact->viscosity(p), 1, 1e-12);  // two logarithms and back
      EXPECT_NEAR(tabulated->density(p) / exact->density(p), 1, 1e-14);
    }
  }
}

TEST(OilTable, FollowsTheLawsBetweenItsGridPoints) {
  const auto laws = paper_oil();
  std::vector<double> pressure;
  for (int k = 0; k <= 20; ++k) pressure.push_back(1e5 + 5e6 * k);
  const auto table = table_of(laws, {373.15, 383.15, 393.15, 403.15}, pressure);
  const auto tabulated = tabulated_oil(table, 388.15), exact = closed_form_oil(laws, 388.15);
  for (double p = 1e5; p < 1e8; p += 1.3e6) {
    // Steps of 10 K and 5 MPa: Walther's line is straight at atmospheric pressure and bends by 3e-4 at 100 MPa.
    EXPECT_NEAR(tabulated->viscosity(p) / exact->viscosity(p), 1, 1e-6 + 4e-4 * p / 1e8);
    EXPECT_NEAR(tabulated->density(p) / exact->density(p), 1, 1e-5);
  }
}

TEST(OilTable, ContinuesStraightBeyondItsPressures) {
  const auto oil = tabulated_oil({1e5, 1e7, 2e7}, {0.005, 0.006, 0.007}, {800, 805, 809});
  const double p = 4e7;
  EXPECT_NEAR(oil->density(p) - oil->density(p - 1e7), oil->density(p - 1e7) - oil->density(p - 2e7), 1e-9);
  EXPECT_NEAR(oil->viscosity(p) / oil->viscosity(p - 1e7), oil->viscosity(p - 1e7) / oil->viscosity(p - 2e7), 1e-12);
}

TEST(OilTable, RefusesATemperatureOutsideWithItsRange) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  const auto table = table_of(paper_oil(), {313.15, 393.15}, {1e5, 1e7});
  for (const double T : {313.0, 393.3, std::nan("")}) {
    try {
      tabulated_oil(table, T);
      FAIL() << T;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("40 degC to 120 degC"), std::string::npos) << error.what();
    }
  }
  EXPECT_NO_THROW(tabulated_oil(table, 393.15 + 1e-10));  // rounding of a unit conversion
}

TEST(OilTable, RefusesWhatIsNotAGrid) {
  EXPECT_THROW(tabulated_oil({1e5}, {0.005}, {800}), InputError);
  EXPECT_THROW(tabulated_oil({1e5, 1e5}, {0.005, 0.006}, {800, 801}), InputError);
  EXPECT_THROW(tabulated_oil({1e5, 2e5}, {0.005, -0.006}, {800, 801}), InputError);
  EXPECT_THROW(tabulated_oil({1e5, 2e5}, {0.005}, {800, 801}), InputError);
  EXPECT_THROW(tabulated_oil(OilTable{{300, 290}, {1e5, 2e5}, {1, 1, 1, 1}, {1, 1, 1, 1}}, 295), InputError);
  EXPECT_THROW(tabulated_oil(OilTable{{290, 300}, {1e5, 2e5}, {1, 1, 1}, {1, 1, 1, 1}}, 295), InputError);
}

TEST(DowsonHigginson, HasItsDensityAtTheReferencePressure) {
  const auto of_pad = closed_form_oil(0.039, 850, 0.0, {6e-10, 1.7e-9, 0});
  EXPECT_EQ(of_pad->density(0), 850);
  EXPECT_NEAR(of_pad->density(1e9) / 850, 1 + 0.6 / 2.7, 1e-14);
  EXPECT_EQ(closed_form_oil(0.039, 850, 0.0, {6e-10, 1.7e-9})->density(kAtmospheric), 850);
}

}  // namespace
