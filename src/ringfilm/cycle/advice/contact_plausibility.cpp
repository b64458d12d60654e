#include "ringfilm/cycle/advice/contact_plausibility.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"

namespace ringfilm::cycle {
namespace {

/// N beta sigma is 0.03 to 0.05 in Greenwood and Tripp 1971, 0.064 to 0.073 in Styles et al. 2014. The real area is
/// pi^2 (N beta sigma)^2 F_2 of the nominal one: above 1 it exceeds it at a separation of 0.8 sigma.
constexpr double kMinRoughnessParameter = 0.005, kMaxRoughnessParameter = 1;
/// Dry metals in air reach a friction coefficient of about 1; a boundary film lowers it.
constexpr double kMaxShearStrength = 1;
/// From polymers to diamond [Pa].
constexpr double kSoftest = 1e9, kHardest = 1200e9;
/// Eyring stresses of oils are 2 to 10 MPa (Johnson and Tevaarwerk 1977); no oil shears at more than 100 MPa before it
/// yields as a solid [Pa].
constexpr double kMaxEyringStress = 100e6;

void append_roughness_note(const models::GreenwoodTripp::Parameters& pair, const std::string& sigma_keys,
                           std::vector<Note>& notes) {
  const double parameter = pair.N * pair.beta * pair.sigma;
  if (parameter >= kMinRoughnessParameter && parameter <= kMaxRoughnessParameter) return;
  notes.push_back({"roughness-parameter-unusual",
                   "the roughness parameter N beta sigma is " + number_text(parameter) +
                       ", where published surfaces have 0.03 to 0.073: are the units of contact.asperity_density, "
                       "contact.asperity_radius and " +
                       sigma_keys + " right?",
                   1});
}

/// Does a text hold one of these words?
bool names_any(const std::string& text, std::initializer_list<std::string_view> names) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i]));
  };
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    std::size_t at = text.find(name);
    while (at != std::string::npos && ((at > 0 && is_letter(at - 1)) || is_letter(at + name.size()))) {
      at = text.find(name, at + 1);
    }
    return at != std::string::npos;
  });
}

/// A root-sum-square of Ra lies 20 % below that of the rms heights of Gaussian surfaces.
void append_measure_note(const Contact& contact, std::vector<Note>& notes) {
  const std::optional<std::string>& rule = contact.measured.roughness_rule;
  const bool is_of_ra = rule && names_any(*rule, {"Ra", "Sa"}) && !names_any(*rule, {"Rq", "Sq", "rms"});
  const bool takes_rms = !is_closed_form(contact) && !contact.plateau.is_stated();
  if (!is_of_ra || !takes_rms || contact.roughness_measure != RoughnessMeasure::kAsGiven) return;
  notes.push_back({"roughness-from-ra",
                   "contact.roughness is of Ra (contact.measured.roughness_rule = \"" + *rule +
                       "\"), and this contact law takes the rms height, for a Gaussian surface 1.25 times as much: "
                       "measure the pair with --sigma Rq, or state contact.roughness_measure = \"ra-to-rq\"",
                   1});
}

void append_modulus_note(const char* key, double modulus, std::vector<Note>& notes) {
  if (modulus >= kSoftest && modulus <= kHardest) return;
  notes.push_back({"modulus-unusual",
                   std::string(key) + " = " + text_in(modulus, kGigapascal) + ": solids of rings and liners have " +
                       number_text(number_in(kSoftest, kGigapascal)) + " (polymers) to " +
                       text_in(kHardest, kGigapascal) + " (diamond); is its unit right?",
                   1});
}

void append_modulus_notes(const Case& c, std::vector<Note>& notes) {
  const Coating& coating = c.ring.coating;
  if (c.contact.composite_modulus) {
    append_modulus_note("contact.composite_modulus", *c.contact.composite_modulus, notes);
  } else {
    if (coating.youngs_modulus) append_modulus_note("ring.coating.youngs_modulus", *coating.youngs_modulus, notes);
    append_modulus_note("liner.youngs_modulus", c.liner.youngs_modulus, notes);
  }
  if (!c.contact.composite_modulus || c.ring.free_gap || c.ring.free_shape) {
    append_modulus_note("ring.youngs_modulus", c.ring.youngs_modulus, notes);
  }
}

}  // namespace

void append_contact_notes(const Case& c, std::vector<Note>& notes) {
  const Contact& contact = c.contact;
  if (const auto pair = asperities(c)) {
    append_roughness_note(*pair, roughness_keys(contact), notes);
    append_measure_note(contact, notes);
  }
  append_modulus_notes(c, notes);
  if (contact.boundary_shear_strength_coefficient > kMaxShearStrength) {
    notes.push_back(
        {"boundary-shear-strength-high",
         "contact.boundary_shear_strength_coefficient = " + number_text(contact.boundary_shear_strength_coefficient) +
             ": dry metals reach a friction coefficient of about 1, and a boundary film lowers it",
         1});
  }
  if (contact.friction_pair && contact.pair->state == models::FrictionState::kDry) {
    notes.push_back({"boundary-friction-dry",
                     "contact.friction_pair = \"" + *contact.friction_pair + "\": its coefficient of " +
                         number_text(contact.pair->friction) +
                         " is that of a probe without oil, not of asperities in engine oil, which have 0.08 to 0.15",
                     1});
  }
  if (contact.eyring_shear_stress > kMaxEyringStress) {
    notes.push_back({"eyring-stress-high",
                     "contact.eyring_shear_stress = " + text_in(contact.eyring_shear_stress, kMegapascal) +
                         ": oils have 2 to 10 MPa, and yield as solids below " +
                         text_in(kMaxEyringStress, kMegapascal) + "; is its unit right?",
                     1});
  }
}

}  // namespace ringfilm::cycle
