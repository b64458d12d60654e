#include "ringfilm/models/contact/summit_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

constexpr double kHardness = 2.5e9;
const GreenwoodTripp::Parameters kNewRing{.N = 0.097e12, .beta = 1.56e-6, .sigma = 0.48e-6, .E_prime = 134.8e9};

PressureAndArea law_at(double lambda, SummitContactChoice choice) {
  choice.hardness = kHardness;
  return summit_contact(kNewRing, choice)(lambda * kNewRing.sigma);
}

TEST(SingleAsperity, HasTheLoadsOfItsAuthors) {
  // R 1, E* 67.4, H 2.5, nu 0.3, w 0.1.
  const AsperityMaterial material{67.4, 2.5, 0.3};
  EXPECT_NEAR(SingleAsperity(AsperityLaw::kElastic, material, 1).load(0.1), 4.0 / 3 * 67.4 * std::pow(0.1, 1.5), 1e-12);
  EXPECT_NEAR(SingleAsperity(AsperityLaw::kKogutEtsion, material, 1).load(0.1), 1.3750662, 1e-6);
  EXPECT_NEAR(SingleAsperity(AsperityLaw::kZhaoMaiettaChang, material, 1).load(0.1), 1.5707963, 1e-7);
}

TEST(SingleAsperity, RisesWithTheApproachAndIsElasticAtFirst) {
  const AsperityMaterial material{67.4, 2.5, 0.3};
  for (const auto law : {AsperityLaw::kZhaoMaiettaChang, AsperityLaw::kKogutEtsion, AsperityLaw::kJacksonGreen}) {
    const SingleAsperity asperity(law, material, 1), elastic(AsperityLaw::kElastic, material, 1);
    const double first = asperity.limits()[0];
    EXPECT_GT(first, 0);
    EXPECT_NEAR(asperity.load(0.5 * first) / elastic.load(0.5 * first), 1, 0.01);
    double load = 0;
    for (double w = 0.3 * first; w < 1000 * first; w *= 1.05) {
      EXPECT_GT(asperity.load(w), load);
      load = asperity.load(w);
      EXPECT_LT(load / asperity.area(w), 1.13 * 2.5);  // of Kogut and Etsion at the end of its second range
    }
  }
}

TEST(SummitContact, AsFedIsTheClosedFormOfGreenwoodAndTripp) {
  const GreenwoodTripp closed(kNewRing);
  for (const double lambda : {0.2, 1.0, 1.286, 2.0, 3.0, 5.0}) {
    const auto at = closed.contact(lambda * kNewRing.sigma);
    const PressureAndArea of = law_at(lambda, {});
    EXPECT_NEAR(of.pressure / at.pressure, 1, 1e-9) << lambda;
    EXPECT_NEAR(of.area_share / at.area_share, 1, 1e-9) << lambda;
  }
  EXPECT_NEAR(law_at(1.286, {}).pressure, 37.424423e6, 10);
  EXPECT_NEAR(law_at(1.286, {}).area_share, 0.002025883, 1e-9);
}

TEST(SummitContact, GreenwoodAndWilliamsonFromThePlaneOfTheSummits) {
  const PressureAndArea of = law_at(1.286, {.model = ContactModel::kGreenwoodWilliamson, .plane = SummitPlane::kNayak});
  EXPECT_NEAR(of.pressure / 486.86444e6, 1, 1e-6);
  EXPECT_NEAR(of.area_share / 0.03263409, 1, 1e-6);
}

TEST(SummitContact, OfOneSurfaceFromThePlaneOfItsSummitsIsTenTimesAsStiff) {
  const double lambda[] = {1, 1.286, 2, 3}, expected[] = {729e6, 416e6, 81.3e6, 4.37e6};
  for (int k = 0; k < 4; ++k) {
    const PressureAndArea of =
        law_at(lambda[k], {.plane = SummitPlane::kNayak, .moments = ContactMoments::kOneSurface});
    EXPECT_NEAR(of.pressure / expected[k], 1, 5e-3) << lambda[k];
  }
}

TEST(SummitContact, PlasticAsperitiesAloneCarryAThird) {
  const double lambda[] = {1, 1.286, 2, 3};
  const double of_pairs[] = {0.26, 0.27, 0.29, 0.33}, of_summits[] = {3.4, 4.3, 7.5, 15};
  for (int k = 0; k < 4; ++k) {
    const double as_fed = law_at(lambda[k], {}).pressure;
    EXPECT_NEAR(law_at(lambda[k], {.asperity = AsperityLaw::kZhaoMaiettaChang}).pressure / as_fed, of_pairs[k], 0.01);
    EXPECT_NEAR(law_at(lambda[k], {.asperity = AsperityLaw::kKogutEtsion}).pressure / as_fed / of_pairs[k], 1, 0.05);
    EXPECT_NEAR(law_at(lambda[k], {.model = ContactModel::kGreenwoodWilliamson,
                                   .asperity = AsperityLaw::kZhaoMaiettaChang,
                                   .plane = SummitPlane::kNayak})
                        .pressure /
                    as_fed / of_summits[k],
                1, 0.03);
  }
}

TEST(SummitContact, BushGibsonAndThomasTouchesWithAHalfOfWhatIsAbove) {
  // At large separations A = half of the material ratio, and A E* h'/p = sqrt(2 pi).
  const SummitContactChoice choice{.model = ContactModel::kBushGibsonThomas};
  const double slope = summit_statistics(kNewRing)->rms_slope;
  double former = 1;
  for (const double lambda : {2.0, 4.0, 6.0}) {
    const PressureAndArea of = law_at(lambda, choice);
    const double kappa = of.area_share * 67.4e9 * slope / of.pressure / std::sqrt(2 * std::numbers::pi);
    EXPECT_LT(std::abs(kappa - 1), former);
    former = std::abs(kappa - 1);
    EXPECT_NEAR(of.area_share / (0.25 * std::erfc(lambda / std::numbers::sqrt2)), 1, 0.5);
  }
  EXPECT_LT(former, 0.1);
  // With curvatures of their mean alone the law of Greenwood and Williamson is close.
  const double summits =
      law_at(1.286, {.model = ContactModel::kGreenwoodWilliamson, .plane = SummitPlane::kNayak}).pressure;
  EXPECT_NEAR(law_at(1.286, choice).pressure / summits, 1, 0.2);
}

TEST(SummitContact, PlasticIsTheHardnessTimesTheMaterialRatio) {
  const PressureAndArea of = law_at(1.5, {.model = ContactModel::kPlastic});
  EXPECT_NEAR(of.area_share, 0.5 * std::erfc(1.5 / std::numbers::sqrt2), 1e-15);
  EXPECT_NEAR(of.pressure, kHardness * of.area_share, 1e-3);
}

TEST(SummitContact, RefusesAPlaneOfSummitsThatNoSurfaceHas) {
  GreenwoodTripp::Parameters none = kNewRing;
  none.sigma = 0.05e-6;  // bandwidth parameter below 1.5
  EXPECT_THROW(summit_contact(none, {.plane = SummitPlane::kNayak}), InputError);
  EXPECT_GT(summit_contact(none, {})(0.05e-6).pressure, 0);
}

TEST(TabulatedContact, KeepsToTheLawItWasMadeOf) {
  for (const auto model : {ContactModel::kGreenwoodTripp, ContactModel::kGreenwoodWilliamson,
                           ContactModel::kBushGibsonThomas, ContactModel::kPlastic}) {
    for (const auto asperity : {AsperityLaw::kElastic, AsperityLaw::kZhaoMaiettaChang, AsperityLaw::kJacksonGreen}) {
      SummitContactChoice choice{.model = model, .asperity = asperity, .plane = SummitPlane::kNayak};
      if (model == ContactModel::kPlastic) choice.plane = SummitPlane::kSurface;
      choice.hardness = kHardness;
      const auto law = summit_contact(kNewRing, choice);
      const TabulatedContact contact(tabulated(law, kNewRing.sigma), 1);
      EXPECT_LT(contact.row_error(), 1e-4);
      double former = INFINITY;
      for (double lambda = 0.013; lambda < 5; lambda += 0.05) {
        const double h = lambda * kNewRing.sigma;
        const PressureAndArea exact = law(h);
        const auto at = contact.contact(h);
        EXPECT_NEAR(at.pressure / exact.pressure, 1, 1e-4);
        EXPECT_NEAR(at.area_share / exact.area_share, 1, 1e-4);
        EXPECT_LT(at.pressure, former);
        former = at.pressure;
        constexpr double kStep = 1e-12;
        const double slope = (contact.contact(h + kStep).pressure - contact.contact(h - kStep).pressure) / (2 * kStep);
        EXPECT_NEAR(at.pressure_slope / slope, 1, 1e-3);
      }
    }
  }
}

TEST(TabulatedContact, ContinuesBeyondItsRowsAndEnds) {
  // ln p quadratic in h, as of a Gaussian surface.
  ContactTable table;
  for (int k = 0; k < 16; ++k) {
    const double h = 0.4e-6 + 0.08e-6 * k, x = h / 0.5e-6;
    table.h.push_back(h);
    table.pressure.push_back(3e8 * std::exp(-0.5 * x * x - 0.3 * x));
    table.area_share.push_back(0.2 * std::exp(-0.5 * x * x - 0.2 * x));
  }
  const TabulatedContact contact(table, table.h.back());
  EXPECT_EQ(contact.trusted_up_to(), table.h.back());
  const double x = 2e-6 / 0.5e-6;
  EXPECT_NEAR(contact.contact(2e-6).pressure / (3e8 * std::exp(-0.5 * x * x - 0.3 * x)), 1, 0.02);
  EXPECT_EQ(contact.contact(contact.reach()).pressure, 0);
  EXPECT_GT(contact.contact(0).pressure, contact.contact(0.4e-6).pressure);
  EXPECT_GT(contact.contact(-0.1e-6).pressure, contact.contact(0).pressure);
  EXPECT_TRUE(std::isnan(contact.contact(std::nan("")).pressure));
  table.pressure[5] = table.pressure[4];
  EXPECT_THROW(TabulatedContact(table, 1), InputError);
}

}  // namespace
}  // namespace ringfilm::models
