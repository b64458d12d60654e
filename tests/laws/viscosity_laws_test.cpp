#include "ringfilm/models/oil/viscosity_laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ringfilm/models/oil/oil_fit.hpp"

// What every law of the table of viscosity laws must keep: a new one is tested by standing there.
namespace {

using namespace ringfilm::models;

struct NamedCurve {
  std::string name;
  double eta_T;
  std::shared_ptr<const ViscosityCurve> curve;
};

/// Every law with a hot, a warm and a cold oil, its parameters as usual and each of them halved and doubled.
std::vector<NamedCurve> all_curves() {
  std::vector<NamedCurve> curves;
  for (const ViscosityLaw& law : viscosity_laws()) {
    std::vector<LawParameters> sets{usual_law_parameters()};
    for (const LawParameter& parameter : law.parameters) {
      for (const double factor : {0.5, 2.0}) {
        LawParameters changed = usual_law_parameters();
        changed[parameter.key] = std::clamp(factor * parameter.usual, parameter.low, parameter.high);
        sets.push_back(changed);
      }
    }
    for (const double eta_T : {3e-3, 5.06e-3, 0.1}) {
      for (std::size_t k = 0; k < sets.size(); ++k) {
        curves.push_back({law.name + " of " + std::to_string(1e3 * eta_T) + " mPa s, parameters " + std::to_string(k),
                          eta_T, law.curve({eta_T, 0.05, sets[k]})});
      }
    }
  }
  return curves;
}

struct ViscosityAt {
  std::vector<double> eta, deta_dp;
};

ViscosityAt values(const ViscosityCurve& curve, std::span<const double> p) {
  ViscosityAt at{std::vector<double>(p.size()), std::vector<double>(p.size())};
  curve.viscosity(p, at.eta, at.deta_dp);
  return at;
}

/// From vacuum to a hundred times what a piston ring sees.
const std::vector<double> kViscosityPressures{0,     1,     0.9e5, 1.01325e5, 3e5, 2.1e6, 6.2e6,
                                              1.5e7, 2.5e7, 3.1e7, 5.1e7,     9e7, 3e8};

TEST(ViscosityLaws, HaveTheOilsOwnViscosityAtNoPressure) {
  for (const auto& [name, eta_T, curve] : all_curves()) {
    EXPECT_NEAR(values(*curve, std::vector<double>{0}).eta[0] / eta_T, 1, 1e-14) << name;  // a few roundings
  }
}

TEST(ViscosityLaws, AreFiniteAndNeverFallWithPressure) {
  for (const auto& [name, eta_T, curve] : all_curves()) {
    const ViscosityAt at = values(*curve, kViscosityPressures);
    for (std::size_t i = 0; i < kViscosityPressures.size(); ++i) {
      EXPECT_TRUE(std::isfinite(at.eta[i]) && std::isfinite(at.deta_dp[i]))
          << name << " at " << kViscosityPressures[i] << " Pa";
      EXPECT_GT(at.eta[i], 0) << name << " at " << kViscosityPressures[i] << " Pa";
      EXPECT_GE(at.deta_dp[i], 0) << name << " at " << kViscosityPressures[i] << " Pa";
      if (i == 0) continue;
      // Two series or powers of the same law differ by roundings where it is all but flat.
      EXPECT_GE(at.eta[i], at.eta[i - 1] * (1 - 1e-14)) << name << " at " << kViscosityPressures[i] << " Pa";
    }
  }
}

TEST(ViscosityLaws, HaveTheSlopeOfTheirValues) {
  for (const auto& [name, eta_T, curve] : all_curves()) {
    for (const double p : kViscosityPressures) {
      // Central difference over 2e3 Pa, 1e-4 or less of the pressure over which a law grows by e (2e7 Pa or more):
      // truncation 1e-8/6 of the slope, and rounding 2e-16/1e-4 of the value over that pressure.
      const double step = 2e3;
      const ViscosityAt at = values(*curve, std::vector<double>{p - step, p, p + step});
      EXPECT_NEAR((at.eta[2] - at.eta[0]) / (2 * step), at.deta_dp[1], 1e-8 * at.deta_dp[1] + 1e-11 * at.eta[1] / 2e7)
          << name << " at " << p << " Pa";
    }
  }
}

TEST(ViscosityLaws, GiveTheSameBitsInLanesOfAnyNumber) {
  for (const auto& [name, eta_T, curve] : all_curves()) {
    std::vector<double> p;
    for (int k = 0; k < 37; ++k) p.push_back(1.3e6 * k);
    const ViscosityAt together = values(*curve, p);
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (const std::size_t lanes : {1u, 2u, 3u, 4u, 7u, 8u, 16u}) {
        if (i + lanes > p.size()) continue;
        const ViscosityAt few = values(*curve, std::span(p).subspan(i, lanes));
        for (std::size_t l = 0; l < lanes; ++l) {
          EXPECT_EQ(few.eta[l], together.eta[i + l]) << name << " at " << p[i + l] << " Pa";
          EXPECT_EQ(few.deta_dp[l], together.deta_dp[i + l]) << name << " at " << p[i + l] << " Pa";
        }
      }
    }
  }
}

TEST(ViscosityLaws, AreFollowedByCertifiedPolynomials) {
  // The usual parameters over the pressures of a cycle: else solver.properties = "fitted" would fall back to the laws.
  for (const ViscosityLaw& law : viscosity_laws()) {
    const LawParameters usual = usual_law_parameters();
    for (const double eta_T : {3e-3, 5.06e-3, 0.1}) {
      const auto oil = closed_form_oil(law, {eta_T, 0.05, usual}, 800, DowsonHigginson{});
      EXPECT_TRUE(fit_oil(*oil, 0, 20e6)) << law.name << " of " << eta_T << " Pa s";
    }
  }
}

}  // namespace
