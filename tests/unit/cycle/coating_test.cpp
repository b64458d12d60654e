#include <gtest/gtest.h>

#include <algorithm>

#include "ringfilm/cycle/advice/validity.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "styles_case.hpp"

namespace ringfilm::cycle {
namespace {

Case coated_case() {
  Case c = testing::styles_new_ring();
  c.ring.coating.youngs_modulus = 280e9;
  c.ring.coating.poissons_ratio = 0.25;
  return c;
}

TEST(Coating, EntersTheCompositeModulusInPlaceOfTheRing) {
  Case c = coated_case();
  const double expected = 2 / ((1 - 0.25 * 0.25) / 280e9 + (1 - 0.211 * 0.211) / 92.3e9);
  EXPECT_NEAR(prepare(c).ring.E_prime / expected, 1, 1e-14);
  c.ring.coating.contact_modulus = ContactModulus::kBase;
  EXPECT_EQ(prepare(c).ring.E_prime, prepare(testing::styles_new_ring()).ring.E_prime);
  c.ring.coating.contact_modulus = ContactModulus::kCoating;
  c.contact.composite_modulus = 190e9;
  EXPECT_EQ(prepare(c).ring.E_prime, 190e9);
}

std::vector<Note> notes_of(const Case& c, double lambda_ratio) {
  Sample sample;
  sample.lambda_ratio = lambda_ratio;
  sample.min_film_thickness = 1e-6;
  const Setup setup = prepare(c);
  std::vector<Note> notes;
  append_validity_notes(setup, face_grid(setup), {sample}, {}, {}, notes);
  return notes;
}

bool reported(const Case& c) {
  const std::vector<Note> notes = notes_of(c, 1);
  return std::any_of(notes.begin(), notes.end(), [](const Note& note) { return note.topic == "coating-thin"; });
}

TEST(Coating, IsNotedWhereContactSpotsFeelWhatIsBelow) {
  // Spots of 0.41 um at lambda = 1: the share is 0.41 um x 0.68 over the thickness.
  Case c = coated_case();
  EXPECT_FALSE(reported(c));  // no thickness, nothing to state
  c.ring.coating.thickness = 100e-6;
  EXPECT_FALSE(reported(c));
  c.ring.coating.thickness = 3.5e-6;
  EXPECT_FALSE(reported(c));
  c.ring.coating.thickness = 2.3e-6;
  EXPECT_TRUE(reported(c));
  c.ring.coating.contact_modulus = ContactModulus::kBase;
  EXPECT_FALSE(reported(c));
}

}  // namespace
}  // namespace ringfilm::cycle
