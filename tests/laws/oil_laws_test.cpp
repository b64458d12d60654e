#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "ringfilm/models/oil/lubricant.hpp"

namespace {

using namespace ringfilm::models;

struct NamedOil {
  std::string name;
  std::shared_ptr<const OilAtTemperature> oil;
};

OilLaws laws_of_paper_oil() {
  OilLaws laws;
  laws.viscosity_temperature = {313.15, 373.15};
  laws.kinematic_viscosity = {59.99e-6, 9.590e-6};
  laws.density.temperature = {288.15, 313.15};
  laws.density.value = {849.7, 833.8};
  laws.parameters["pressure_viscosity_coefficient"] = 1e-8;
  laws.beta_0 = 4e-2;
  laws.theta_0 = 313.15;
  laws.compression = DowsonHigginson{};
  return laws;
}

/// Every oil model with every choice, at three temperatures of an engine.
std::vector<NamedOil> all_oils() {
  std::vector<NamedOil> oils;
  for (const double T : {313.15, 393.15, 423.15}) {
    const std::string at = " at " + std::to_string(T) + " K";
    for (const auto temperature_law : {ViscosityTemperatureLaw::kWalther, ViscosityTemperatureLaw::kHoupert}) {
      for (std::size_t k = 0; k < viscosity_laws().size(); ++k) {
        for (const bool compressible : {true, false}) {
          auto laws = laws_of_paper_oil();
          laws.viscosity_temperature_law = temperature_law;
          laws.viscosity_pressure_law = static_cast<ViscosityPressureLaw>(k);
          if (!compressible) laws.compression.reset();
          oils.push_back({(temperature_law == ViscosityTemperatureLaw::kWalther ? "walther " : "houpert ") +
                              viscosity_laws()[k].name + (compressible ? " dowson-higginson" : " incompressible") + at,
                          closed_form_oil(laws, T)});
        }
      }
    }
    oils.push_back({"table" + at, tabulated_oil({5e4, 4e6, 1e7, 5e7, 1e8}, {5e-3, 5.2e-3, 5.5e-3, 9e-3, 18e-3},
                                                {780, 782, 785.5, 802, 817})});
  }
  return oils;
}

/// From vacuum to a hundred times what a piston ring sees, none of them a node of the table.
const std::vector<double> kPressures{0, 0.9e5, 1.01325e5, 3e5, 2.1e6, 6.2e6, 2.5e7, 4.9e7, 5.1e7, 9e7, 3e8};

struct At {
  std::vector<double> rho, drho_dp, eta, deta_dp;
};
At properties(const OilAtTemperature& oil, const std::vector<double>& p) {
  At at{.rho = std::vector<double>(p.size()), .drho_dp = at.rho, .eta = at.rho, .deta_dp = at.rho};
  oil.properties(p, {at.rho, at.drho_dp, at.eta, at.deta_dp});
  return at;
}

TEST(OilLaws, ValuesArePositiveAndNeverFallWithPressure) {
  for (const auto& [name, oil] : all_oils()) {
    const auto at = properties(*oil, kPressures);
    for (std::size_t i = 0; i < kPressures.size(); ++i) {
      EXPECT_GT(at.rho[i], 0) << name;
      EXPECT_GT(at.eta[i], 0) << name;
      EXPECT_GE(at.drho_dp[i], 0) << name;
      EXPECT_GE(at.deta_dp[i], 0) << name;
      if (i == 0) continue;
      EXPECT_GE(at.rho[i], at.rho[i - 1]) << name;
      EXPECT_GE(at.eta[i], at.eta[i - 1]) << name;
    }
  }
}

TEST(OilLaws, SlopesAreTheDerivatives) {
  for (const auto& [name, oil] : all_oils()) {
    for (const double p : kPressures) {
      // Central difference over 1e-5 of the laws' pressure scale of 2e8 Pa: truncation 1e-10, rounding 1e-16/1e-5 of
      // the value over that scale. The table's scale is its spacing of 4 MPa: truncation (5e-4)^2 of the slope.
      const double step = 2e3;
      const auto at = properties(*oil, {p - step, p, p + step});
      const double table = name.starts_with("table") ? 1e-6 : 0;
      const double rho_scale = at.rho[1] / 2e8, eta_scale = at.eta[1] / 2e8;
      EXPECT_NEAR((at.rho[2] - at.rho[0]) / (2 * step), at.drho_dp[1], 1e-9 * rho_scale + table * at.drho_dp[1])
          << name << " " << p;
      EXPECT_NEAR((at.eta[2] - at.eta[0]) / (2 * step), at.deta_dp[1], 2e-9 * eta_scale + table * at.deta_dp[1])
          << name << " " << p;
    }
  }
}

TEST(OilLaws, APointDoesNotDependOnItsCompany) {
  for (const auto& [name, oil] : all_oils()) {
    const auto together = properties(*oil, kPressures);
    for (std::size_t i = 0; i < kPressures.size(); ++i) {
      const auto alone = properties(*oil, {kPressures[i]});
      EXPECT_EQ(alone.rho[0], together.rho[i]) << name;
      EXPECT_EQ(alone.drho_dp[0], together.drho_dp[i]) << name;
      EXPECT_EQ(alone.eta[0], together.eta[i]) << name;
      EXPECT_EQ(alone.deta_dp[0], together.deta_dp[i]) << name;
      EXPECT_EQ(oil->density(kPressures[i]), together.rho[i]) << name;
      EXPECT_EQ(oil->viscosity(kPressures[i]), together.eta[i]) << name;
    }
  }
}

TEST(OilLaws, ViscosityFallsWithTemperatureUnderEveryLaw) {
  for (const auto law : {ViscosityTemperatureLaw::kWalther, ViscosityTemperatureLaw::kHoupert}) {
    auto laws = laws_of_paper_oil();
    laws.viscosity_temperature_law = law;
    double last = INFINITY;
    for (double T = 273.15; T < 473.15; T += 5) {
      const double eta = oil_state(laws, T).eta_T;
      EXPECT_LT(eta, last) << T;
      last = eta;
    }
  }
}

TEST(OilLaws, PressureViscosityCoefficientIsTheSlopeOfLnEtaAtZeroPressure) {
  // Roelands' law is made so, up to its rounded constants: 5.1e-9 * 1.98e8 = 1.0098.
  const auto laws = laws_of_paper_oil();
  const auto at = properties(*closed_form_oil(laws, 393.15), {0});
  EXPECT_NEAR(at.deta_dp[0] / at.eta[0], 1e-8 / 1.0098, 1e-12 * 1e-8);
}

}  // namespace
