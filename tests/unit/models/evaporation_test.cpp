#include "ringfilm/models/oil/evaporation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "ringfilm/models/gas/heat_transfer.hpp"

namespace {

using namespace ringfilm::models;

TEST(VapourPressure, IsTheAtmosphereAtTheBoilingPointAndFallsByClausiusClapeyron) {
  constexpr double kBoiling = 700;
  EXPECT_DOUBLE_EQ(vapour_pressure(kBoiling, kBoiling), 101325);
  // d ln p/d(1/T) = -dH/R with dH = (4.4 + ln T_b) R T_b.
  const double T = 450, dT = 1e-3;
  const double slope = (std::log(vapour_pressure(kBoiling, T + dT)) - std::log(vapour_pressure(kBoiling, T - dT))) /
                       (1 / (T + dT) - 1 / (T - dT));
  EXPECT_NEAR(slope / (-(4.4 + std::log(kBoiling)) * kBoiling), 1, 1e-6);  // difference quotient
}

TEST(MolarMass, OfNormalAlkanesIsWithinTwoPercent) {
  // n-C25: 352.7 g/mol, 401.9 degC; n-C40: 563.1 g/mol, 522 degC: within 3 % there.
  EXPECT_NEAR(molar_mass_of_boiling_point(675.05), 0.3527, 0.02 * 0.3527);
  EXPECT_NEAR(molar_mass_of_boiling_point(795.15), 0.5631, 0.03 * 0.5631);
  EXPECT_EQ((OilFraction{1, 675.05, 0.4}.molar_mass_or_correlated()), 0.4);
}

TEST(Evaporation, AFilmOfOneFractionDriesOutAfterItsMassOverTheFlux) {
  constexpr double kMolarMass = 0.4, kFilm = 800 * 1e-6, kBeta = 0.05, kBoiling = 720, T = 450;
  const double flux = kBeta * kMolarMass * vapour_pressure(kBoiling, T) / (8.314462618 * T);  // [kg/(m2 s)]
  const double dries_out = kFilm / flux;
  const std::array concentration{vapour_concentration(kBoiling, T)};
  for (const double share : {0.1, 0.5, 0.999}) {
    std::array moles{kFilm / kMolarMass};
    evaporate(moles, concentration, kBeta * share * dries_out);
    EXPECT_NEAR(moles[0] * kMolarMass / kFilm, 1 - share, 1e-12);  // rounding
  }
  std::array moles{kFilm / kMolarMass};
  evaporate(moles, concentration, kBeta * 1.0001 * dries_out);
  EXPECT_EQ(moles[0], 0);
}

TEST(Evaporation, OfTwoFractionsFollowsTheirDifferentialEquations) {
  const std::vector<double> concentration{0.2, 0.03};
  std::array<double, 2> stepped{4e-4, 1.2e-3};
  std::vector<double> closed(stepped.begin(), stepped.end());
  constexpr double kExposure = 8e-3;
  constexpr int kSteps = 4000;
  // dn_i/dtau = -c_i n_i/(n_1 + n_2), Runge-Kutta of order 4.
  const auto slope = [&](const std::array<double, 2>& n) {
    const double all = n[0] + n[1];
    return std::array{-concentration[0] * n[0] / all, -concentration[1] * n[1] / all};
  };
  const auto moved = [](const std::array<double, 2>& n, const std::array<double, 2>& by, double h) {
    return std::array{n[0] + h * by[0], n[1] + h * by[1]};
  };
  const double h = kExposure / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const auto a = slope(stepped), b = slope(moved(stepped, a, h / 2)), c = slope(moved(stepped, b, h / 2)),
               d = slope(moved(stepped, c, h));
    for (std::size_t i = 0; i < 2; ++i) stepped[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  evaporate(closed, concentration, kExposure);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(closed[i] / stepped[i], 1, 1e-9);  // what the steps leave
  EXPECT_LT(closed[0] / closed[1], 4e-4 / 1.2e-3 / 2);                               // the light one goes first
}

TEST(Evaporation, InTwoPartsIsThatOfTheWhole) {
  const std::vector<double> concentration{0.2, 0.03, 0.004};
  std::vector<double> once{4e-4, 1e-3, 5e-4}, twice = once;
  evaporate(once, concentration, 0.02);
  evaporate(twice, concentration, 0.013);
  evaporate(twice, concentration, 0.007);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(twice[i], once[i], 1e-12 * once[i] + 1e-18);  // rounding
}

TEST(HeatTransfer, ScalesAsWoschniAndByTheAnalogy) {
  const double alpha = woschni_coefficient(0.09, 20e5, 900, 10);
  EXPECT_NEAR(woschni_coefficient(0.09, 40e5, 900, 10) / alpha, std::pow(2, 0.8), 1e-12);
  EXPECT_NEAR(woschni_coefficient(0.18, 20e5, 900, 10) / alpha, std::pow(2, -0.2), 1e-12);
  EXPECT_NEAR(alpha, 3.26 * std::pow(0.09, -0.2) * std::pow(2000, 0.8) * std::pow(900, -0.55) * std::pow(10, 0.8),
              1e-9 * alpha);
  EXPECT_NEAR(mass_transfer_coefficient(200, 1.2, 1000, 8), 200 / (1.2 * 1000 * 4), 1e-12);
}

TEST(NoackLoss, OfOneFractionIsTheMassOfTheSaturatedAir) {
  constexpr double kBoiling = 800, kMolarMass = 0.4, kTest = 523.15, kAir = 0.253, kSample = 0.065;
  const std::vector<OilFraction> oil{{1, kBoiling, kMolarMass}};
  const double expected = kAir * kMolarMass * vapour_concentration(kBoiling, kTest) / kSample;
  EXPECT_NEAR(noack_loss(oil) / expected, 1, 1e-10);  // the difference of nearly equal masses
}

TEST(NoackLoss, OfTheFractionsThatBelongToItIsTheSame) {
  double before = 2000;
  for (const double loss : {kMinNoackLoss, 0.05, 0.12, 0.2, kMaxNoackLoss}) {
    const std::vector<OilFraction> oil = distillation_of_noack(loss);
    EXPECT_NEAR(noack_loss(oil) / loss, 1, 1e-8) << loss;  // boiling points to 1e-9 K
    double shares = 0;
    for (const OilFraction& fraction : oil) shares += fraction.share;
    EXPECT_NEAR(shares, 1, 1e-15);
    EXPECT_LT(oil.front().boiling_point, before) << "a lighter oil loses more";
    before = oil.front().boiling_point;
    EXPECT_LT(oil.back().boiling_point, kMaxBoilingPoint);
  }
}

TEST(NoackLoss, OfTheShippedFractionsIsWhatTheyState) {
  // data/lubricants/sae-5w-30.toml: about 12 %.
  const std::vector<OilFraction> oil{
      {0.1, 732.15, 0.33}, {0.25, 777.15, 0.38}, {0.3, 812.15, 0.43}, {0.2, 857.15, 0.49}, {0.15, 932.15, 0.6}};
  EXPECT_NEAR(noack_loss(oil), 0.12, 0.002);
}

}  // namespace
