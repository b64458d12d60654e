#include "ringfilm/models/contact/plateau.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>

namespace ringfilm::models {
namespace {

double quantile(double share) { return -std::sqrt(2.0) * boost::math::erfc_inv(2 * share); }

/// Height of the two lines at a material ratio, from the mean plane of the plateau.
double height(const PlateauCurve& of, double share) {
  const double s = quantile(share), meet = quantile(of.Rmq);
  return share < of.Rmq ? -of.Rpq * s : -of.Rpq * meet - of.Rvq * (s - meet);
}

TEST(Plateau, PlanesAndRmsAreThoseOfTheCurve) {
  for (const PlateauCurve& curve :
       {PlateauCurve{0.1e-6, 1e-6, 0.83}, PlateauCurve{0.05e-6, 2e-6, 0.4}, PlateauCurve{0.2e-6, 0.3e-6, 0.95}}) {
    constexpr int kPoints = 1000000;
    double sum = 0, squares = 0;
    for (int i = 0; i < kPoints; ++i) {
      const double z = height(curve, (i + 0.5) / kPoints);
      sum += z;
      squares += z * z;
    }
    const double mean = sum / kPoints, rms = std::sqrt(squares / kPoints - mean * mean);
    const PlateauPlanes planes = plateau_planes(curve);
    // A sum over a million places lacks the heights beyond 4.9 standard deviations.
    EXPECT_NEAR(planes.plateau, -mean, 1e-5 * rms);
    EXPECT_NEAR(planes.rms, rms, 1e-4 * rms);
    // The line of the valleys has its middle at the material ratio of one half.
    const double meet = quantile(curve.Rmq), valleys = (curve.Rvq - curve.Rpq) * meet;
    EXPECT_NEAR(planes.valleys, valleys - mean, 1e-5 * rms);
  }
}

TEST(Plateau, AlmostNoValleysAreTheGaussianSurfaceOfThePlateauAndAlmostNoPlateauThatOfTheValleys) {
  const double Rpq = 0.1e-6, Rvq = 0.9e-6, rare = 1e-12;
  const PlateauPlanes plateau = plateau_planes({Rpq, Rvq, 1 - rare}), valleys = plateau_planes({Rpq, Rvq, rare});
  EXPECT_NEAR(plateau.rms / Rpq, 1, 1e-9);
  EXPECT_NEAR(plateau.plateau / Rpq, 0, 1e-9);
  EXPECT_NEAR(valleys.rms / Rvq, 1, 1e-9);
  EXPECT_NEAR(valleys.valleys / Rvq, 0, 1e-9);
  for (const ContactModel model : {ContactModel::kGreenwoodTripp, ContactModel::kGreenwoodWilliamson,
                                   ContactModel::kBushGibsonThomas, ContactModel::kPlastic}) {
    const SummitContactChoice choice{
        .model = model, .plane = SummitPlane::kNayak, .moments = ContactMoments::kPair, .hardness = 2.5e9};
    const auto law = [&](double sigma) {
      return summit_contact({.N = 0.05e12, .beta = 12e-6, .sigma = sigma, .E_prime = 134.8e9}, choice);
    };
    for (const double lambda : {0.0, 0.5, 1.0, 2.0, 3.0}) {
      const auto expect_law_of = [&](double sigma, const PlateauPlanes& planes) {
        const PressureAndArea both = plateau_contact(law(Rpq), law(Rvq), planes)(lambda * sigma),
                              alone = law(sigma)(lambda * sigma);
        EXPECT_NEAR(both.pressure / alone.pressure, 1, 1e-6) << lambda << " of " << sigma;
        EXPECT_NEAR(both.area_share / alone.area_share, 1, 1e-6) << lambda << " of " << sigma;
      };
      expect_law_of(Rpq, plateau);
      expect_law_of(Rvq, valleys);
    }
  }
}

TEST(Plateau, PlasticContactWithASmoothRingIsHardnessTimesTheMaterialRatio) {
  const PlateauCurve curve{0.1e-6, 1e-6, 0.7};
  const double hardness = 2.5e9;
  const auto law = [&](double sigma) {
    return summit_contact({.N = 1, .beta = 1, .sigma = sigma, .E_prime = 1},
                          {.model = ContactModel::kPlastic, .hardness = hardness});
  };
  const PlateauPlanes planes = plateau_planes(curve);
  const ContactFunction contact = plateau_contact(law(curve.Rpq), law(curve.Rvq), planes);
  for (const double share : {1e-4, 0.01, 0.3, 0.65, 0.75, 0.95}) {
    EXPECT_NEAR(contact(height(curve, share) + planes.plateau).pressure / (hardness * share), 1, 1e-9) << share;
  }
}

TEST(Plateau, CoreValuesGiveBackTheLinesThatHaveThem) {
  // By core_roughness of the two lines at 40001 material ratios: Rk, Rpk, Rvk, Mr2 of each. Where both meet at 0.6 the
  // flattest 40 % reach into the valleys, and the plateau is known to 3 %.
  struct Known {
    PlateauCurve lines;
    CoreValues core;
    double tolerance;
  };
  for (const Known& known : {Known{{1, 4, 0.8}, {2.57396, 0.94499, 4.27696, 0.82970}, 1e-3},
                             Known{{1, 10, 0.7}, {2.57396, 0.94499, 12.29705, 0.72597}, 1e-3},
                             Known{{1, 2, 0.85}, {2.57396, 0.94499, 1.97760, 0.87732}, 1e-3},
                             Known{{1, 4, 0.6}, {2.67429, 0.92880, 5.07599, 0.70009}, 0.03}}) {
    const PlateauCurve of = plateau_curve(known.core);
    EXPECT_NEAR(of.Rpq, known.lines.Rpq, known.tolerance);
    EXPECT_NEAR(of.Rvq / known.lines.Rvq, 1, known.tolerance);
    EXPECT_NEAR(of.Rmq, known.lines.Rmq, known.tolerance);
  }
}

TEST(Plateau, MeetsTheGaussianSurfaceAtItsMr2) {
  // With Rvk of a Gaussian surface of rms 1 there is nothing deeper.
  const PlateauCurve of = plateau_curve({2.57396, 0.94503, 0.94503, kMr2OfGaussian});
  EXPECT_NEAR(of.Rpq, 1, 1e-5);
  EXPECT_NEAR(of.Rvq, 1, 1e-3);
}

}  // namespace
}  // namespace ringfilm::models
