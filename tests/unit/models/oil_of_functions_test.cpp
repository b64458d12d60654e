#include "ringfilm/models/oil/oil_of_functions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

constexpr double kAlpha = 1e-8;  // [1/Pa]

double barus(double p) { return 7e-3 * std::exp(kAlpha * p); }
double even_density(double) { return 800; }

struct Properties {
  double rho, drho_dp, eta, deta_dp;
};

Properties properties_at(const OilAtTemperature& oil, double p) {
  Properties out;
  oil.properties({&p, 1}, {{&out.rho, 1}, {&out.drho_dp, 1}, {&out.eta, 1}, {&out.deta_dp, 1}});
  return out;
}

/// An oil whose viscosity reports a slope of `factor` times its own.
class Misjudged final : public OilAtTemperature {
 public:
  explicit Misjudged(double factor) : factor_(factor) {}
  void properties(std::span<const double> p, OilProperties out) const override {
    for (std::size_t i = 0; i < p.size(); ++i) {
      out.rho[i] = 800;
      out.drho_dp[i] = 0;
      out.eta[i] = barus(p[i]);
      out.deta_dp[i] = factor_ * kAlpha * barus(p[i]);
    }
  }

 private:
  double factor_;
};

std::string reported(const OilAtTemperature& oil) {
  try {
    check_oil(oil, 0, 8e7);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(OilOfFunctions, GivesTheFunctionsAndTheirSlopes) {
  const auto oil = oil_of_functions(barus, [](double p) { return 800 * (1 + 5e-10 * p); });
  for (const double p : {0.0, 3e4, 1e5, 1e7, 8e7}) {
    const Properties at = properties_at(*oil, p);
    EXPECT_EQ(at.eta, barus(p));
    EXPECT_EQ(at.rho, 800 * (1 + 5e-10 * p));
    // (alpha times the half width of the difference)^2/6, and twice that where it leans to one side.
    EXPECT_NEAR(at.deta_dp / (kAlpha * barus(p)), 1, 4e-7) << p;
    EXPECT_NEAR(at.drho_dp / (800 * 5e-10), 1, 1e-7) << p;  // rounding of a difference of 0.1 kg/m3 in 800
  }
  EXPECT_EQ(reported(*oil), "");
}

TEST(OilOfFunctions, WhatDoesNotChangeHasNoSlope) {
  const auto oil = oil_of_functions(barus, [](double) { return 793.1; });
  for (const double p : {0.0, 5e4, 1e7}) EXPECT_EQ(properties_at(*oil, p).drho_dp, 0) << p;
}

TEST(OilOfFunctions, IsNeverAskedBelowTheZeroOfPressures) {
  const auto oil = oil_of_functions(
      [](double p) {
        EXPECT_GE(p, 0);
        return barus(p);
      },
      even_density);
  for (const double p : {0.0, 5e4, 1e5}) properties_at(*oil, p);
}

TEST(OilOfFunctions, NeedsBoth) {
  EXPECT_THROW(oil_of_functions(barus, {}), InputError);
  EXPECT_THROW(oil_of_functions({}, even_density), InputError);
}

TEST(OilOfFunctions, ALawWithoutAValueIsRefusedWhereItLacksOne) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(reported(*oil_of_functions([&](double p) { return p > 5e7 ? nan : barus(p); }, even_density)),
              ::testing::AllOf(::testing::HasSubstr("a viscosity of nan Pa.s"), ::testing::HasSubstr("MPa")));
  EXPECT_THAT(reported(*oil_of_functions(barus, [](double) { return 0.0; })),
              ::testing::HasSubstr("a density of 0 kg/m3 at 0 MPa"));
  EXPECT_THAT(reported(*oil_of_functions([](double) { return -1.0; }, even_density)),
              ::testing::HasSubstr("viscosity"));
}

TEST(OilOfFunctions, ASlopeThatIsNotThatOfItsValuesIsRefused) {
  EXPECT_EQ(reported(Misjudged(1)), "");
  EXPECT_THAT(reported(Misjudged(-1)), ::testing::HasSubstr("a slope of viscosity"));
  EXPECT_THAT(reported(Misjudged(1e6)), ::testing::HasSubstr("a slope of viscosity"));  // per MPa
  EXPECT_THAT(reported(Misjudged(std::numeric_limits<double>::quiet_NaN())),
              ::testing::HasSubstr("a slope of viscosity"));
}

}  // namespace
}  // namespace ringfilm::models
