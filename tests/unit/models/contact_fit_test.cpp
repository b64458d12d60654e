#include "ringfilm/models/contact/contact_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/models/contact/asperity_contact.hpp"

namespace {

using namespace ringfilm::models;

struct Law {
  double n;
  const ContactFit::Coefficients& P;
};

const Law kLaws[] = {{2.5, contact_fit().P52}, {2.0, contact_fit().P2}};
constexpr double kLambdaStep = 0.00317;  // hundreds of points to each of the 17 waves of the difference

TEST(ContactFit, KeepsToTheIntegralsWithinItsError) {
  EXPECT_LE(contact_fit().error, 1e-12);
  for (const auto& [n, P] : kLaws) {
    const double F_0 = gaussian_integral(n, 0);
    for (double lambda = 0; lambda <= ContactFit::kEnd; lambda += kLambdaStep) {
      EXPECT_NEAR(ContactFit::integral(P, lambda).value / F_0, gaussian_integral(n, lambda) / F_0, contact_fit().error)
          << lambda;
    }
    EXPECT_LT(gaussian_integral(n, ContactFit::kEnd) / F_0, contact_fit().error);  // taken as zero from there on
  }
}

TEST(ContactFit, KeepsTheSmallIntegralsOfFarSurfacesToSixDigits) {
  for (const auto& [n, P] : kLaws) {
    const double kept = n == 2.5 ? 1e-7 : 1e-6;  // the weights with which the polynomials were made
    for (double lambda = 0; lambda <= ContactFit::kEnd; lambda += kLambdaStep) {
      EXPECT_NEAR(ContactFit::integral(P, lambda).value / gaussian_integral(n, lambda), 1, kept) << lambda;
    }
  }
}

TEST(ContactFit, FallsStrictlyWithTheSlopeOfTheIntegrals) {
  for (const auto& [n, P] : kLaws) {
    double before = INFINITY;
    for (double lambda = 0; lambda <= ContactFit::kEnd; lambda += kLambdaStep) {
      const auto [F, slope] = ContactFit::integral(P, lambda);
      EXPECT_LT(F, before);
      before = F;
      // The slope of a difference with 17 waves is largest at the ends, 15^2/3.5 times the difference itself.
      EXPECT_NEAR(slope / (-n * gaussian_integral(n - 1, lambda)), 1, 1e-4) << lambda;
    }
    EXPECT_GT(before, 0);
  }
}

TEST(ContactFit, SteersByAShorterSlope) {
  for (double lambda = 0; lambda <= ContactFit::kEnd; lambda += kLambdaStep) {
    const double t = lambda * (2 / ContactFit::kEnd) - 1;
    const double slope = polynomial_and_slope(contact_fit().P52, t).slope;
    EXPECT_NEAR(polynomial(contact_fit().P52_slope, t) / slope, 1, 3e-5) << lambda;
  }
}

}  // namespace
