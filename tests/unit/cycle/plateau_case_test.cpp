#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/contact_curves.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "styles_case.hpp"

namespace ringfilm::cycle::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A honed liner under a ring of 0.1 um.
Case honed(double Rmq = 0.82) {
  Case c = styles_new_ring();
  c.contact.model = ContactLaw::kGreenwoodWilliamson;
  c.contact.summit_plane = SummitPlane::kNayak;
  c.contact.asperity_density = 0.05e12;
  c.contact.asperity_radius = 12e-6;
  c.contact.roughness = 0;
  c.contact.plateau.Rpq = 0.1e-6;
  c.contact.plateau.Rvq = 0.9e-6;
  c.contact.plateau.Rmq = Rmq;
  c.contact.plateau.ring_roughness = 0.1e-6;
  return c;
}

/// The same with the core of these lines, by core_roughness of them.
Case of_core() {
  Case c = honed();
  Plateau& plateau = c.contact.plateau;
  plateau.Rpq = plateau.Rvq = plateau.Rmq = std::nullopt;
  plateau.Rk = 0.257396e-6;
  plateau.Rpk = 0.094499e-6;
  plateau.Rvk = 0.427696e-6;
  plateau.Mr2 = 0.82970;
  return c;
}

std::vector<std::string> messages(const Case& c) {
  std::vector<std::string> all;
  for (const RuleBreach& breach : broken_rules(c)) all.push_back(breach.message + "; " + breach.remedy);
  return all;
}

double pressure(const Case& c, double h) { return asperity_contact(c)->contact(h).pressure; }

TEST(PlateauCase, FilmHasTheWholeSurfaceAndContactThePlateau) {
  const Case c = honed();
  const models::PlateauPlanes planes = models::plateau_planes({0.1e-6, 0.9e-6, 0.82});
  EXPECT_DOUBLE_EQ(roughness(c), std::hypot(0.1e-6, planes.rms));
  EXPECT_DOUBLE_EQ(asperities(c)->sigma, std::hypot(0.1e-6, 0.1e-6));
  EXPECT_DOUBLE_EQ(plateau_offset(c.contact), planes.plateau);
  EXPECT_DOUBLE_EQ(ring_roughness_share(c), std::pow(0.1e-6 / roughness(c), 2));
  Case measured = c;
  measured.contact.plateau.surface_roughness = 0.4e-6;
  EXPECT_DOUBLE_EQ(roughness(measured), std::hypot(0.1e-6, 0.4e-6));
  EXPECT_THAT(messages(c), IsEmpty());
  // A measured offset moves the law, and nothing else.
  measured.contact.plateau.offset = planes.plateau + 0.05e-6;
  EXPECT_DOUBLE_EQ(plateau_offset(measured.contact), planes.plateau + 0.05e-6);
  const double h = planes.plateau + 0.2e-6;
  EXPECT_NEAR(pressure(measured, h + 0.05e-6) / pressure(c, h), 1, 1e-3);
}

TEST(PlateauCase, ALinerThatIsAlmostAllPlateauIsTheGaussianOneOfItsRoughness) {
  const Case plateau = honed(1 - 1e-9), valleys = honed(1e-9);
  for (const auto& [c, rms] : {std::pair(plateau, 0.1e-6), std::pair(valleys, 0.9e-6)}) {
    Case gaussian = c;
    gaussian.contact.plateau = {};
    gaussian.contact.roughness = std::hypot(0.1e-6, rms);
    EXPECT_NEAR(roughness(c) / roughness(gaussian), 1, 1e-6);
    EXPECT_THAT(messages(c), IsEmpty());
    for (const double lambda : {0.5, 1.0, 2.0, 3.0}) {
      const double h = lambda * gaussian.contact.roughness;
      // Both are tables; the rows of that of the valleys are as far apart as those of a plateau that is not there.
      EXPECT_NEAR(pressure(c, h) / pressure(gaussian, h), 1, 1e-3) << lambda << " of " << rms;
    }
  }
}

TEST(PlateauCase, FarAboveTheValleysContactIsThatOfThePlateauFromItsOwnPlane) {
  const Case c = honed();
  Case alone = without_plateau(c);
  EXPECT_EQ(alone.contact.roughness, roughness(c));
  EXPECT_FALSE(alone.contact.plateau.is_stated());
  alone.contact.roughness = asperities(c)->sigma;
  for (const double lambda : {1.0, 2.0, 3.0}) {
    const double h = lambda * alone.contact.roughness;
    EXPECT_NEAR(pressure(c, h + plateau_offset(c.contact)) / pressure(alone, h), 1, 1e-3) << lambda;
  }
  // A Gaussian surface as rough as the whole liner would carry many times as much there.
  const double h = 2 * alone.contact.roughness + plateau_offset(c.contact);
  EXPECT_GT(pressure(without_plateau(c), h) / pressure(c, h), 3);
}

TEST(PlateauCase, FallsWithTheSeparationForEveryLaw) {
  for (const ContactLaw model : {ContactLaw::kGreenwoodTripp, ContactLaw::kGreenwoodWilliamson,
                                 ContactLaw::kBushGibsonThomas, ContactLaw::kPlastic}) {
    for (const double Rmq : {0.01, 0.3, 0.82, 0.99}) {
      Case c = honed(Rmq);
      c.contact.model = model;
      c.contact.hardness = 2.5e9;
      c.contact.plateau.ring_roughness = 0;
      c.contact.plateau.Rvq = 3e-6;  // a step that a table of a tenth of the plateau could not reach over
      const auto law = asperity_contact(c);
      const double end = plateau_offset(c.contact) + 4 * 0.1e-6;
      double before = INFINITY;
      for (int k = 0; k <= 200; ++k) {
        const auto at = law->contact(end * k / 200);
        EXPECT_LT(at.pressure, before);
        EXPECT_LT(at.pressure_slope, 0);
        before = at.pressure;
      }
      EXPECT_GT(before, 0);
    }
  }
}

TEST(PlateauCase, CoreValuesStateTheSamePlateau) {
  const auto lines = plateau_curve(of_core().contact);
  ASSERT_TRUE(lines);
  EXPECT_NEAR(lines->Rpq, 0.1e-6, 1e-10);
  EXPECT_NEAR(lines->Rvq, 0.4e-6, 1e-9);
  EXPECT_NEAR(lines->Rmq, 0.8, 1e-3);
  EXPECT_THAT(messages(of_core()), IsEmpty());
}

TEST(PlateauCase, ReplacesTheRoughnessAndItsChoices) {
  const Case c = honed();
  for (const char* key :
       {"contact.roughness", "contact.roughness_measure", "contact.integrals", "contact.ring_roughness_share"}) {
    EXPECT_FALSE(is_active(*find_field(key), c)) << key;
  }
  EXPECT_TRUE(is_required(*find_field("contact.plateau.ring_roughness"), c));
  EXPECT_FALSE(is_active(*find_field("contact.plateau.ring_roughness"), styles_new_ring()));
  EXPECT_FALSE(is_closed_form(c.contact));
}

TEST(PlateauCase, IsRefusedWithTheRemedy) {
  const auto refused = [](Case c, const auto& change) {
    change(c.contact.plateau);
    const std::vector<std::string> all = messages(c);
    return all.size() == 1 ? all.front() : std::to_string(all.size()) + " messages";
  };
  EXPECT_THAT(refused(honed(), [](Plateau& p) { p.Rmq = 0; }),
              AllOf(HasSubstr("contact.plateau.Rmq = 0 leaves no plateau"), HasSubstr("state contact.roughness")));
  EXPECT_THAT(refused(honed(), [](Plateau& p) { p.Rmq = 1; }), HasSubstr("contact.plateau.Rmq = 1 leaves no valleys"));
  EXPECT_THAT(
      refused(honed(), [](Plateau& p) { p.Rpq = 1e-6; }),
      AllOf(HasSubstr("contact.plateau.Rpq = 1 um is not below contact.plateau.Rvq = 0.9 um"), HasSubstr("exchanged")));
  EXPECT_THAT(
      refused(honed(), [](Plateau& p) { p.surface_roughness = 0.05e-6; }),
      AllOf(HasSubstr("surface_roughness = 0.05 um is below the Rpq of its plateau, 0.1 um"), HasSubstr("omit it")));
  EXPECT_THAT(refused(honed(), [](Plateau& p) { p.Rvq.reset(); }), HasSubstr("contact.plateau.Rvq is missing"));
  EXPECT_THAT(refused(honed(), [](Plateau& p) { p.Rk = 0.3e-6; }), HasSubstr("states both contact.plateau.Rpq and"));
  EXPECT_THAT(refused(of_core(), [](Plateau& p) { p.Mr2 = 0.95; }),
              AllOf(HasSubstr("contact.plateau.Mr2 = 0.95 is not between 0 and 0.901"), HasSubstr("Gaussian")));
  EXPECT_THAT(refused(of_core(), [](Plateau& p) { p.Rvk = 0.01e-6; }), HasSubstr("not deeper than a plateau of Rpq"));
  Case scattered = honed();
  scattered.contact.measured.roughness_deviation = 0.01e-6;
  EXPECT_THAT(refused(scattered, [](Plateau&) {}), HasSubstr("which [contact.plateau] replaces"));
  Case sparse = honed();
  sparse.contact.asperity_density = 0.005e12;
  EXPECT_THAT(refused(sparse, [](Plateau&) {}), HasSubstr("contact.asperity_radius and [contact.plateau] together"));
}

TEST(PlateauCase, ACycleRecordsTheResolvedValuesAndCarriesByThePlateau) {
  const CycleResult plateau = simulated(honed()), core = simulated(of_core()),
                    whole = simulated(without_plateau(honed()));
  ASSERT_TRUE(plateau.complete && core.complete && whole.complete);
  EXPECT_EQ(plateau.derived.at("Rpq"), 0.1e-6);
  EXPECT_EQ(plateau.derived.at("Rmq"), 0.82);
  EXPECT_NEAR(core.derived.at("Rvq"), 0.4e-6, 1e-9);
  EXPECT_EQ(plateau.derived.at("plateau_offset"), plateau_offset(honed().contact));
  EXPECT_EQ(plateau.derived.at("plateau_roughness"), asperities(honed())->sigma);
  EXPECT_EQ(plateau.derived.at("roughness"), roughness(honed()));
  EXPECT_EQ(whole.derived.count("Rpq"), 0u);
  // A plateau lets the film become thinner before it carries.
  EXPECT_LT(plateau.values.min_film_thickness, whole.values.min_film_thickness);
}

TEST(PlateauCase, ItsCurvesHaveTheWholeSurfaceNextToThem) {
  const ContactCurves curves = contact_curves(honed());
  EXPECT_EQ(curves.laws.back().name, "whole_surface");
  for (const OtherContactLaw& other : other_contact_laws(styles_new_ring())) EXPECT_NE(other.name, "whole_surface");
}

}  // namespace
}  // namespace ringfilm::cycle::testing
