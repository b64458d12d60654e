#include "ringfilm/cycle/case/contact_plausibility.hpp"

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
  append_contact_notes(c, c.contact.roughness, notes);
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
