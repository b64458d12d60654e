#include "ringfilm/models/contact/asperity_contact.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>

#include "../../traps/floating_point_traps.hpp"
#include "ringfilm/base/error.hpp"

namespace {

using ringfilm::models::composite_modulus;
using ringfilm::models::contact_spot_radius;
using ringfilm::models::ContactIntegralForm;
using ringfilm::models::gaussian_integral;
using ringfilm::models::GreenwoodTripp;
using ringfilm::models::share_below_coating;

/// F_n straight from its definition, cut where the Gaussian has fallen below 1e-40 of its start.
double definition_by_gauss_kronrod(double n, double lambda) {
  const auto integrand = [=](double s) { return std::pow(s - lambda, n) * std::exp(-s * s / 2); };
  const double end = std::sqrt(lambda * lambda + 185);
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, lambda, end, 15, 1e-14) *
         boost::math::double_constants::one_div_root_two_pi;
}

double definition_by_tanh_sinh(double n, double lambda) {
  boost::math::quadrature::tanh_sinh<double> rule;
  const auto integrand = [=](double u) { return std::pow(u, n) * std::exp(-u * (u / 2 + lambda)); };
  return rule.integrate(integrand, 0.0, 14.0, 1e-14) * std::exp(-lambda * lambda / 2) *
         boost::math::double_constants::one_div_root_two_pi;
}

/// Surfaces of the new ring of styles2014, Table 1.
GreenwoodTripp new_ring(ContactIntegralForm form) {
  return GreenwoodTripp({.N = 0.097e12, .beta = 1.56e-6, .sigma = 0.48e-6, .E_prime = 134.8e9, .form = form});
}

double F_52(const GreenwoodTripp& contact, double lambda) {
  const auto& [N, beta, sigma, E_prime, form] = contact.parameters();
  const double scale =
      8 * std::sqrt(2.0) / 15 * M_PI * std::pow(N * beta * sigma, 2) * std::sqrt(sigma / beta) * E_prime;
  return contact.contact(lambda * sigma).pressure / scale;
}

double F_2(const GreenwoodTripp& contact, double lambda) {
  const auto& [N, beta, sigma, E_prime, form] = contact.parameters();
  return contact.contact(lambda * sigma).area_share / std::pow(M_PI * N * beta * sigma, 2);
}

TEST(GaussianIntegral, HasTheTabulatedValues) {
  // docs/theory/contact.md, eq-gaussian-integral: as many digits as are printed there.
  EXPECT_NEAR(gaussian_integral(2, 0), 0.5, 1e-15);
  EXPECT_NEAR(gaussian_integral(2.5, 0), 0.616634219, 5e-10);
  EXPECT_NEAR(gaussian_integral(2.5, 1), 0.0805623, 5e-8);
  EXPECT_NEAR(gaussian_integral(2.5, 2), 0.00542371, 5e-9);
  EXPECT_NEAR(gaussian_integral(2.5, 3), 1.70873e-4, 5e-10);
}

TEST(GaussianIntegral, IsAGammaFunctionAtZero) {
  for (const double n : {1.0, 1.5, 2.0, 2.5}) {
    const double closed = std::pow(2, (n - 1) / 2) * std::tgamma((n + 1) / 2) / std::sqrt(2 * M_PI);
    EXPECT_NEAR(gaussian_integral(n, 0) / closed, 1, 4e-15);  // a sum of 200 terms, rounded
  }
}

TEST(GaussianIntegral, AgreesWithTwoQuadraturesOfItsDefinition) {
  for (const double n : {1.5, 2.0, 2.5}) {
    for (double lambda = 0; lambda <= 8; lambda += 0.25) {
      // tanh-sinh integrates the endpoint power to rounding; Gauss-Kronrod meets its own tolerance on it.
      EXPECT_NEAR(gaussian_integral(n, lambda) / definition_by_tanh_sinh(n, lambda), 1, 1e-13) << n << " " << lambda;
      EXPECT_NEAR(gaussian_integral(n, lambda) / definition_by_gauss_kronrod(n, lambda), 1, 1e-12)
          << n << " " << lambda;
    }
  }
}

TEST(GaussianIntegral, HasTheClosedFormForTwo) {
  for (const double lambda : {0.3, 1.0, 2.0}) {
    const double closed = (1 + lambda * lambda) / 2 * std::erfc(lambda / std::sqrt(2.0)) -
                          lambda * std::exp(-lambda * lambda / 2) / std::sqrt(2 * M_PI);
    EXPECT_NEAR(gaussian_integral(2, lambda) / closed, 1, 1e-13);  // the closed form cancels two digits at 2
  }
}

TEST(GreenwoodTripp, ExactFormAgreesWithQuadratureUpToItsReach) {
  const auto contact = new_ring(ContactIntegralForm::kExact);
  for (double lambda = 0.003; lambda < 8; lambda += 0.0173) {
    const auto at = contact.contact(lambda * 0.48e-6);
    const double F = definition_by_tanh_sinh(2.5, lambda);
    // Series of degree 11 over pieces of 1/16: 6e-14 at the far end; the rest is the oracle's rounding.
    EXPECT_NEAR(F_52(contact, lambda) / F, 1, 2e-13) << lambda;
    EXPECT_NEAR(F_2(contact, lambda) / definition_by_tanh_sinh(2, lambda), 1, 2e-13) << lambda;
    const double slope = -2.5 * definition_by_tanh_sinh(1.5, lambda) / F / 0.48e-6;  // F_n' = -n F_(n-1)
    EXPECT_NEAR(at.pressure_slope / at.pressure / slope, 1, 4e-13) << lambda;
  }
}

TEST(GreenwoodTripp, ReachesEightSigmaWhereTheRestIsRounding) {
  const auto contact = new_ring(ContactIntegralForm::kExact);
  EXPECT_DOUBLE_EQ(contact.reach(), 8 * 0.48e-6);
  EXPECT_EQ(contact.contact(contact.reach()).pressure, 0);
  EXPECT_EQ(contact.contact(1).pressure, 0);
  EXPECT_LT(F_52(contact, 7.999) / F_52(contact, 0), std::numeric_limits<double>::epsilon());
}

TEST(GreenwoodTripp, FourDigitPolynomialsEndAtTheirFirstZero) {
  const auto contact = new_ring(ContactIntegralForm::kPolynomial4Digit);
  EXPECT_NEAR(contact.reach() / 0.48e-6, 2.2239, 5e-5);  // PHYSICS 2.1, four decimals
  EXPECT_GT(F_52(contact, 2.2238), 0);
  EXPECT_GT(F_2(contact, 2.2945), 0);
  for (double lambda = 2.2947; lambda < 8; lambda += 0.01) {
    EXPECT_EQ(F_52(contact, lambda), 0) << lambda;
    EXPECT_EQ(F_2(contact, lambda), 0) << lambda;
  }
}

TEST(GreenwoodTripp, FourDigitPolynomialsFollowTheExactIntegrals) {
  const auto fit = new_ring(ContactIntegralForm::kPolynomial4Digit), exact = new_ring(ContactIntegralForm::kExact);
  for (double lambda = 0; lambda < 3; lambda += 0.1) {
    EXPECT_NEAR(F_52(fit, lambda), F_52(exact, lambda), 0.004) << lambda;  // what the zero from 2.22 on cuts off
    EXPECT_NEAR(F_2(fit, lambda), F_2(exact, lambda), 0.004) << lambda;
  }
}

TEST(GreenwoodTripp, PrintedPolynomialRisesAgainAndActsUpToItsLastZero) {
  const auto printed = new_ring(ContactIntegralForm::kPolynomialAsPrinted);
  EXPECT_NEAR(printed.reach() / 0.48e-6, 6.87, 0.005);  // PHYSICS 2.1: two decimals given
  EXPECT_NEAR(F_52(printed, 5.8), 1.23, 0.005);         // the same
  EXPECT_LT(printed.contact(1.90 * 0.48e-6).pressure_slope, 0);
  EXPECT_GT(printed.contact(1.92 * 0.48e-6).pressure_slope, 0);
  // styles2014, eqs 6 and 7, at 1: the sums of the printed coefficients.
  EXPECT_NEAR(F_52(printed, 1), -0.004 + 0.057 - 0.296 + 0.784 - 1.078 + 0.617, 1e-14);
  EXPECT_NEAR(F_2(printed, 1), -0.002 + 0.028 - 0.173 + 0.526 - 0.804 + 0.500, 1e-14);
  for (double lambda = 0; lambda < 12; lambda += 0.01) {
    EXPECT_GE(F_52(printed, lambda), 0);
    EXPECT_GE(F_2(printed, lambda), 0);
  }
}

TEST(GreenwoodTripp, InnerLoopGivesTheSameAsTheWholeContact) {
  for (const auto form : {ContactIntegralForm::kExact, ContactIntegralForm::kPolynomial4Digit,
                          ContactIntegralForm::kPolynomialAsPrinted}) {
    const auto contact = new_ring(form);
    for (const double h : {-1e-8, 0.0, 1e-7, 9e-7, 3e-6, 5e-6}) {
      double p_a, dp_a_dh;
      contact.pressure(h, p_a, dp_a_dh);
      EXPECT_EQ(p_a, contact.contact(h).pressure);
      EXPECT_EQ(dp_a_dh, contact.contact(h).pressure_slope);
    }
  }
}

TEST(GreenwoodTripp, ContinuesAlongTheTangentBelowZero) {
  const auto contact = new_ring(ContactIntegralForm::kExact);
  const auto zero = contact.contact(0), below = contact.contact(-1e-7);
  EXPECT_NEAR(below.pressure, zero.pressure - 1e-7 * zero.pressure_slope, 1e-12 * zero.pressure);  // rounding
  EXPECT_EQ(below.pressure_slope, zero.pressure_slope);
}

TEST(GreenwoodTripp, StartsItsSeriesFromTheIntegralsAtItsReach) {
  // They are written down as numbers: what is there is the quadrature, to its rounding.
  const auto contact = new_ring(ContactIntegralForm::kExact);
  const double last = std::nextafter(8.0, 0.0);
  EXPECT_NEAR(F_52(contact, last) / gaussian_integral(2.5, 8), 1, 1e-13);
  EXPECT_NEAR(F_2(contact, last) / gaussian_integral(2, 8), 1, 1e-13);
}

TEST(GreenwoodTripp, OffersTheFitOfItsIntegralsAndItsScales) {
  const auto exact = new_ring(ContactIntegralForm::kExact);
  EXPECT_EQ(exact.quintic_52(), nullptr);
  ASSERT_NE(exact.fit(), nullptr);
  for (const auto form : {ContactIntegralForm::kPolynomial4Digit, ContactIntegralForm::kPolynomialAsPrinted}) {
    const auto contact = new_ring(form);
    EXPECT_EQ(contact.fit(), nullptr);
    ASSERT_NE(contact.quintic_52(), nullptr);
    const auto& [c, end] = *contact.quintic_52();
    EXPECT_EQ(end * 0.48e-6, contact.reach());
    EXPECT_NEAR(F_52(contact, 1), c[0] + c[1] + c[2] + c[3] + c[4] + c[5], 1e-15);
    EXPECT_NEAR(F_52(contact, 0), c[5], 1e-15);
  }
  EXPECT_NEAR(exact.contact(0).pressure / exact.pressure_scale() / gaussian_integral(2.5, 0), 1, 1e-13);
  EXPECT_NEAR(exact.contact(0).area_share / exact.area_scale() / gaussian_integral(2, 0), 1, 1e-13);
}

TEST(CompositeModulus, IsThatOfThePaperConvention) {
  // PHYSICS section 1: 203 GPa, 0.3 on 92.3 GPa, 0.211 give 134.8 GPa.
  EXPECT_NEAR(composite_modulus(203e9, 0.3, 92.3e9, 0.211), 134.8e9, 0.05e9);
  // Two equal bodies: 2/E' = 2 (1 - nu^2)/E.
  EXPECT_NEAR(composite_modulus(200e9, 0.3, 200e9, 0.3), 200e9 / 0.91, 1);
}

TEST(CompositeModulus, OfWhatIsNotABodyIsRefused) {
  const ringfilm::traps::NoTraps no_traps;  // NaNs on purpose
  for (const double E : {-2e11, 0.0, double(NAN)}) {
    EXPECT_THROW(composite_modulus(E, 0.3, 2e11, 0.3), ringfilm::InputError) << E;
    EXPECT_THROW(composite_modulus(2e11, 0.3, E, 0.3), ringfilm::InputError) << E;
  }
  for (const double nu : {-1.0, 0.51, 5.0, double(NAN)}) {
    EXPECT_THROW(composite_modulus(2e11, nu, 2e11, 0.3), ringfilm::InputError) << nu;
    EXPECT_THROW(composite_modulus(2e11, 0.3, 2e11, nu), ringfilm::InputError) << nu;
  }
  // A rigid body takes no part: 2/E' = (1 - nu^2)/E of the other.
  EXPECT_NEAR(composite_modulus(2e11, 0.3, INFINITY, 0.3), 4e11 / 0.91, 1);
}

TEST(GreenwoodTripp, HasNoContactAtAnInfiniteSeparation) {
  const ringfilm::traps::NoTraps no_traps;  // an infinity on purpose
  for (const auto form : {ContactIntegralForm::kExact, ContactIntegralForm::kPolynomial4Digit,
                          ContactIntegralForm::kPolynomialAsPrinted}) {
    const auto contact = GreenwoodTripp({0.1e12, 1.5e-6, 0.5e-6, 1.4e11, form}).contact(INFINITY);
    EXPECT_EQ(contact.pressure, 0);
    EXPECT_EQ(contact.pressure_slope, 0);
    EXPECT_EQ(contact.area_share, 0);
  }
}

TEST(ContactSpot, HasTheRealAreaOverTheNumberOfSpots) {
  // F_1 and F_2 at 0 and 1 from the normal density and distribution: phi(1) = 0.24197072, Q(1) = 0.15865525.
  EXPECT_NEAR(contact_spot_radius(1.56e-6, 0.48e-6, 0), std::sqrt(1.56 * 0.48 * 0.5 / (4 * 0.39894228)) * 1e-6, 1e-14);
  const double F_1 = 0.24197072 - 0.15865525, F_2 = 2 * 0.15865525 - 0.24197072;
  EXPECT_NEAR(contact_spot_radius(1.56e-6, 0.48e-6, 1), std::sqrt(1.56 * 0.48 * F_2 / (4 * F_1)) * 1e-6, 1e-13);
}

TEST(Coating, LetsTheShareOfTheApproachThroughThatBoussinesqGives) {
  // Depth below the middle of a Hertz pressure, radius 1: displacement by point loads of Boussinesq,
  // u = (1 + nu) P/(2 pi E) [z^2/rho^3 + 2 (1 - nu)/rho], summed over rings of sqrt(1 - r^2).
  for (const double nu : {0.2, 0.3}) {
    const auto displacement = [nu](double z) {
      double sum = 0;
      const int n = 20000;
      for (int i = 0; i < n; ++i) {
        const double r = (i + 0.5) / n, rho = std::hypot(r, z);
        sum += std::sqrt(1 - r * r) * r * (z * z / (rho * rho * rho) + 2 * (1 - nu) / rho) / n;
      }
      return sum;
    };
    for (const double thickness : {10.0, 30.0}) {
      // A point load is left at depth, up to the square of radius over thickness.
      EXPECT_NEAR(share_below_coating(1, thickness, nu) / (displacement(thickness) / displacement(0)), 1,
                  2 / (thickness * thickness));
    }
  }
  EXPECT_EQ(share_below_coating(1, 0.01, 0.3), 1);
}

/// Surfaces of styles2014, Table 1, with values of an independent implementation, to four digits.
struct PairOfThePaper {
  double N, beta, sigma, bandwidth, slope, offset_over_sigma, spread_over_sigma, plasticity_index;
};

TEST(SummitStatistics, AreThoseOfAnIndependentImplementation) {
  for (const PairOfThePaper& of : {PairOfThePaper{0.097e12, 1.56e-6, 0.48e-6, 12.73, 0.3386, 0.6325, 0.9641, 14.68},
                                   PairOfThePaper{0.100e12, 1.34e-6, 0.50e-6, 10.83, 0.3882, 0.6857, 0.9577, 16.12},
                                   PairOfThePaper{0.101e12, 1.82e-6, 0.35e-6, 9.99, 0.2844, 0.7141, 0.9540, 11.55}}) {
    const GreenwoodTripp::Parameters pair{.N = of.N, .beta = of.beta, .sigma = of.sigma, .E_prime = 134.8e9};
    const auto summits = ringfilm::models::summit_statistics(pair);
    ASSERT_TRUE(summits);
    EXPECT_NEAR(summits->bandwidth, of.bandwidth, 6e-3);
    EXPECT_NEAR(summits->rms_slope, of.slope, 6e-5);
    EXPECT_NEAR(summits->summit_offset / of.sigma, of.offset_over_sigma, 6e-5);
    EXPECT_NEAR(summits->summit_spread / of.sigma, of.spread_over_sigma, 6e-5);
    EXPECT_NEAR(ringfilm::models::plasticity_index(pair, summits->summit_spread, 2.5e9), of.plasticity_index, 6e-3);
  }
}

TEST(SummitStatistics, DoNotExistBelowTheSmallestBandwidth) {
  // alpha goes with sigma^2: 12.73 at 0.48 um is 1.5 at 0.1648 um.
  const auto of = [](double sigma) {
    return ringfilm::models::summit_statistics({.N = 0.097e12, .beta = 1.56e-6, .sigma = sigma, .E_prime = 134.8e9});
  };
  EXPECT_TRUE(of(0.166e-6));
  EXPECT_FALSE(of(0.163e-6));
}

TEST(GreenwoodTripp, GivesNaNForASeparationThatIsNotANumber) {
  for (const auto form : {ContactIntegralForm::kExact, ContactIntegralForm::kPolynomial4Digit,
                          ContactIntegralForm::kPolynomialAsPrinted}) {
    const auto c = new_ring(form).contact(std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(std::isnan(c.pressure));
    EXPECT_TRUE(std::isnan(c.pressure_slope));
    EXPECT_TRUE(std::isnan(c.area_share));
  }
}

}  // namespace
