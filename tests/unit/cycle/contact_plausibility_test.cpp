#include "ringfilm/cycle/advice/contact_plausibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "styles_case.hpp"

namespace ringfilm::cycle::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

template <class Change>
std::vector<std::string> topics(const Change& change) {
  Case c = styles_new_ring();
  change(c);
  std::vector<Note> notes;
  append_contact_notes(c, notes);
  std::vector<std::string> all;
  for (const Note& note : notes) all.push_back(note.topic);
  return all;
}

TEST(ContactPlausibility, MeasuredPairsHaveNoNote) {
  EXPECT_THAT(topics([](Case&) {}), IsEmpty());
  EXPECT_THAT(topics([](Case& c) { c = styles_embedded_ring(); }), IsEmpty());
  EXPECT_THAT(topics([](Case& c) { c = styles_run_in_ring(); }), IsEmpty());
  EXPECT_THAT(topics([](Case& c) { c.ring.coating.youngs_modulus = 1000e9; }), IsEmpty()) << "diamond-like carbon";
}

TEST(ContactPlausibility, UnitsOfTheRoughnessAreNoted) {
  const auto unusual = ElementsAre("roughness-parameter-unusual");
  EXPECT_THAT(topics([](Case& c) { c.contact.asperity_radius = 1.56e-3; }), unusual);
  EXPECT_THAT(topics([](Case& c) { c.contact.roughness = 0.48e-9; }), unusual);
  EXPECT_THAT(topics([](Case& c) { c.contact.roughness = 50e-6; }), unusual);
  EXPECT_THAT(topics([](Case& c) { c.contact.asperity_density = 97000e12; }), unusual);
}

TEST(ContactPlausibility, RoughnessFromRaBesideALawOfTheRmsIsNoted) {
  const auto measured_by = [](const char* rule, SummitPlane plane, RoughnessMeasure measure) {
    return topics([&](Case& c) {
      c.contact.measured.roughness_rule = rule;
      c.contact.summit_plane = plane;
      c.contact.roughness_measure = measure;
    });
  };
  const char *const by_ra = "root of the sum of squares of Ra (Sa of a map)", *const by_rq = "Rq, root-sum-square";
  const auto nayak = SummitPlane::kNayak, surface = SummitPlane::kSurface;
  const auto as_given = RoughnessMeasure::kAsGiven, converted = RoughnessMeasure::kRaToRq;
  EXPECT_THAT(measured_by(by_ra, nayak, as_given), ElementsAre("roughness-from-ra"));
  EXPECT_THAT(measured_by(by_ra, nayak, converted), IsEmpty());
  EXPECT_THAT(measured_by(by_ra, surface, as_given), IsEmpty()) << "as in the paper";
  EXPECT_THAT(measured_by(by_rq, nayak, as_given), IsEmpty());
  EXPECT_THAT(measured_by("mean of Random Samples", nayak, as_given), IsEmpty()) << "names no Ra";
  const auto other_law = [&](ContactLaw model, AsperityLaw asperity, ContactMoments moments) {
    return topics([&](Case& c) {
      c.contact.measured.roughness_rule = by_ra;
      c.contact.model = model;
      c.contact.asperity = asperity;
      c.contact.moments = moments;
    });
  };
  using enum ContactLaw;
  const auto elastic = AsperityLaw::kElastic, flowing = AsperityLaw::kZhaoMaiettaChang;
  const auto pair = ContactMoments::kPair, one = ContactMoments::kOneSurface;
  EXPECT_THAT(other_law(kGreenwoodTripp, elastic, pair), IsEmpty());
  for (const auto& noted : {other_law(kGreenwoodTripp, flowing, pair), other_law(kGreenwoodTripp, elastic, one),
                            other_law(kGreenwoodWilliamson, elastic, pair), other_law(kPlastic, elastic, pair)}) {
    EXPECT_THAT(noted, ElementsAre("roughness-from-ra"));
  }
}

TEST(ContactPlausibility, ModuliOfNoSolidAreNoted) {
  const auto unusual = ElementsAre("modulus-unusual");
  EXPECT_THAT(topics([](Case& c) { c.ring.youngs_modulus = 203e6; }), unusual);
  EXPECT_THAT(topics([](Case& c) { c.liner.youngs_modulus = 9e12; }), unusual);
  EXPECT_THAT(topics([](Case& c) { c.ring.coating.youngs_modulus = 280e6; }), unusual);
  EXPECT_THAT(topics([](Case& c) { c.contact.composite_modulus = 134.8e6; }), unusual);
  const auto not_used = [](Case& c) {
    c.contact.composite_modulus = 134.8e9;
    c.ring.youngs_modulus = 203e6;
  };
  EXPECT_THAT(topics(not_used), IsEmpty());
}

TEST(ContactPlausibility, ShearStrengthsOfNoBoundaryFilmAreNoted) {
  EXPECT_THAT(topics([](Case& c) { c.contact.boundary_shear_strength_coefficient = 5; }),
              ElementsAre("boundary-shear-strength-high"));
  EXPECT_THAT(topics([](Case& c) { c.contact.eyring_shear_stress = 5e9; }), ElementsAre("eyring-stress-high"));
}

}  // namespace
}  // namespace ringfilm::cycle::testing
