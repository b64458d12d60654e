#include "ringfilm/models/oil/roelands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "ringfilm/base/error.hpp"

namespace {

using namespace ringfilm::models;

TEST(Roelands, KeepsToTheLawWhereItsSeriesEndsAndBeyond) {
  // From mild to far stiffer than any engine oil; inside, at the ends of and outside 0 to 30 MPa.
  for (const double Z : {0.1, 0.45, 0.9, 2.0}) {
    for (const double eta_T : {1e-3, 5e-3, 1.0}) {
      const auto curve = roelands_curve(eta_T, Z);
      for (const double p : {-1e5, -1e-3, 0.0, 1e-3, 1e5, 4e6, 1.5e7, 2.6e7, 3e7 - 1, 3e7, 3e7 + 1, 1e8, 1e9}) {
        const double exponent = (std::log(eta_T) + 9.67) * (std::pow(1 + p / 1.98e8, Z) - 1);
        // Rounding of exponents of up to 400, and of the series' 13 terms.
        double eta, slope;
        curve->viscosity({&p, 1}, {&eta, 1}, {&slope, 1});
        EXPECT_NEAR(eta / (eta_T * std::exp(exponent)), 1, 1e-14 * (2 + std::abs(exponent))) << Z << " " << p;
      }
    }
  }
}

TEST(Roelands, HasTheIndexOfThePaper) {
  // styles2014, eq. 18, at the viscosity of the paper's oil at 120 degC.
  EXPECT_NEAR(roelands_index(1e-8, 0.005063296356917147) / 0.4472324222852102, 1, 1e-12);
  EXPECT_EQ(roelands_index(0, 0.005), 0);
}

TEST(Roelands, RefusesAnOilThinnerThanItsLaw) {
  try {
    roelands_logarithm(6.3e-5);
    FAIL();
  } catch (const ringfilm::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("below the 0.0632 mPa.s"), std::string::npos) << error.what();
  }
  EXPECT_EQ(roelands_logarithm(1), 9.67);
}

}  // namespace
