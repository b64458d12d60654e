#include "ringfilm/study/ensemble/assumptions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "../study_case.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"

namespace {

using namespace ringfilm;
using cycle::Case;
using study::Alternative;
using study::Assumption;
using study::testing::coarse_case;

std::vector<Assumption> assumptions_of(const Case& c) { return study::assumptions_of(cycle::prepare(c)); }

std::vector<std::string> topics(const Case& c) {
  std::vector<std::string> out;
  for (const auto& entry : study::assumptions(c)) out.push_back(entry.topic);
  return out;
}

bool lists(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

std::vector<std::string> settings(const Case& c, const std::string& topic) {
  for (const Assumption& assumption : assumptions_of(c)) {
    if (assumption.entry.topic != topic) continue;
    std::vector<std::string> out;
    for (const Alternative& alternative : assumption.alternatives) out.push_back(alternative.setting);
    // The gap of the ring is lifted by a case of its own.
    EXPECT_EQ(assumption.entry.can_be_lifted, !out.empty() || topic == "ring-gap");
    return out;
  }
  ADD_FAILURE() << "no assumption " << topic;
  return {};
}

/// What a key holds, as one would write it in SI; nullopt for lists, names and files, which no alternative touches.
std::optional<std::string> held(const cycle::Field& field, Case& c) {
  const auto number = [](double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", value);  // three digits are left to conversions of units
    return std::string(text);
  };
  if (const auto* kind = std::get_if<cycle::NumberKind>(&field.kind)) return number(kind->ref(c));
  if (const auto* kind = std::get_if<cycle::OptionalNumberKind>(&field.kind)) {
    return kind->ref(c) ? number(*kind->ref(c)) : "absent";
  }
  if (const auto* kind = std::get_if<cycle::NumberOrFileKind>(&field.kind)) return number(kind->number(c));
  if (const auto* kind = std::get_if<cycle::CountKind>(&field.kind)) return std::to_string(kind->ref(c));
  if (const auto* kind = std::get_if<cycle::ChoiceKind>(&field.kind)) return kind->names.at(kind->index(c));
  return std::nullopt;
}

/// The right-hand side of a setting in the same form.
std::string printed(std::string value) {
  value.erase(std::remove(value.begin(), value.end(), '"'), value.end());
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  if (end == value.c_str()) return value;
  static const std::map<std::string, double> sizes = {{"", 1},       {" GPa", 1e9}, {" MPa", 1e6},
                                                      {" bar", 1e5}, {" N", 1},     {" mm", 1e-3}};
  char text[40];
  const double in_SI = std::string(end) == " degC" ? number + 273.15 : number * sizes.at(end);
  std::snprintf(text, sizeof text, "%.12g", in_SI);
  return text;
}

/// Every alternative changes the key that its setting names, to the value that it names, and nothing else; conditions
/// those that they are made of.
void expect_settings_match_effects(const Case& c) {
  for (const Assumption& assumption : assumptions_of(c)) {
    for (const Alternative& alternative : assumption.alternatives) {
      SCOPED_TRACE(alternative.setting);
      const auto equals = alternative.setting.find(" = ");
      ASSERT_NE(equals, std::string::npos);
      const std::string key = alternative.setting.substr(0, equals);
      Case before = c, after = c;
      alternative.apply(after);
      ASSERT_NE(cycle::find_field(key), nullptr);
      for (const cycle::Field& field : cycle::case_fields()) {
        if (field.key == key) {
          EXPECT_EQ(held(field, after), printed(alternative.setting.substr(equals + 3)));
          EXPECT_NE(held(field, after), held(field, before));
        } else if (key != "conditions" || !cycle::is_replaced_by(after.conditions, field.key)) {
          EXPECT_EQ(held(field, after), held(field, before)) << field.key;
        }
      }
      EXPECT_TRUE(cycle::broken_rules(after).empty());
    }
  }
}

TEST(Assumptions, SettingsStateExactlyWhatTheyApply) { expect_settings_match_effects(coarse_case()); }

TEST(Assumptions, SettingsStateWhatTheyApplyForEveryWayToStateTheTension) {
  Case by_force = coarse_case();
  by_force.ring.elastic_pressure.reset();
  by_force.ring.tangential_force = 10.6789;  // four digits are written, so 20 % of it must be rounded first
  expect_settings_match_effects(by_force);
  EXPECT_EQ(settings(by_force, "ring-tension"),
            (std::vector<std::string>{"ring.tangential_force = \"8.543 N\"", "ring.tangential_force = \"12.81 N\""}));

  Case by_gap = coarse_case();
  by_gap.ring.elastic_pressure.reset();
  by_gap.ring.free_gap = 10.5e-3;
  by_gap.ring.radial_thickness = 3.5e-3;
  expect_settings_match_effects(by_gap);
  EXPECT_EQ(settings(by_gap, "ring-tension"),
            (std::vector<std::string>{"ring.free_gap = \"8.4 mm\"", "ring.free_gap = \"12.6 mm\""}));
}

TEST(Assumptions, NoAlternativeIsTheCaseItself) {
  Case c = coarse_case();
  c.contact.composite_modulus = 190e9;
  c.film.cavitation_pressure = 0.2e5;
  c.gas.crankcase_pressure = 3e5;
  c.gas.pressure_behind_ring = 0.9;
  c.film.cavitation = cycle::Cavitation::kMassConserving;
  c.lubricant.viscosity_pressure = cycle::ViscosityPressure::kNone;
  expect_settings_match_effects(c);
  EXPECT_EQ(settings(c, "composite-modulus"), std::vector<std::string>{"contact.composite_modulus = \"135 GPa\""});
  EXPECT_EQ(settings(c, "cavitation-pressure"), std::vector<std::string>{"film.cavitation_pressure = \"1.013 bar\""});
  EXPECT_EQ(settings(c, "pressure-under-ring"), std::vector<std::string>{"gas.crankcase_pressure = \"1.013 bar\""});
  EXPECT_EQ(settings(c, "pressure-behind-ring"), std::vector<std::string>{"gas.pressure_behind_ring = 1"});
}

TEST(Assumptions, AStatedPressureBelowTheRingIsNotThatOfTheCrankcase) {
  Case c = coarse_case();
  c.ring.pressure_below.constant = 2.5e5;
  EXPECT_TRUE(settings(c, "pressure-under-ring").empty());
  for (const Assumption& assumption : assumptions_of(c)) {
    if (assumption.entry.topic != "pressure-under-ring") continue;
    EXPECT_EQ(assumption.entry.statement, "the pressure straight under the ring is that of ring.pressure_below");
  }
}

TEST(Assumptions, SetTheCoatingsModulusAgainstThatOfTheRingBelow) {
  cycle::Case c = coarse_case();
  c.ring.coating.youngs_modulus = 280e9;
  c.ring.coating.poissons_ratio = 0.25;
  EXPECT_EQ(settings(c, "composite-modulus"), std::vector<std::string>{"ring.coating.contact_modulus = \"base\""});
}

TEST(Assumptions, SetThePlateauAgainstAGaussianSurfaceAsRoughAsTheWholeLiner) {
  Case c = coarse_case();
  EXPECT_FALSE(lists(topics(c), "plateau"));
  c.contact.roughness = 0;
  c.contact.plateau.Rpq = 0.1e-6;
  c.contact.plateau.Rvq = 0.9e-6;
  c.contact.plateau.Rmq = 0.82;
  c.contact.plateau.ring_roughness = 0.3e-6;
  EXPECT_FALSE(lists(topics(c), "roughness-measure"));
  for (const Assumption& assumption : assumptions_of(c)) {
    if (assumption.entry.topic != "plateau") continue;
    ASSERT_EQ(assumption.alternatives.size(), 1u);
    Case other = c;
    assumption.alternatives.front().apply(other);
    EXPECT_FALSE(other.contact.plateau.is_stated());
    EXPECT_NEAR(other.contact.roughness / cycle::roughness(c), 1, 1e-3);  // four digits
    EXPECT_TRUE(cycle::broken_rules(other).empty());
    EXPECT_NE(assumption.alternatives.front().setting.find("without [contact.plateau]"), std::string::npos);
  }
  EXPECT_TRUE(lists(topics(c), "plateau"));
}

TEST(Assumptions, OfferAllOtherChoicesOfAKey) {
  EXPECT_EQ(settings(coarse_case(), "contact-integrals"),
            (std::vector<std::string>{"contact.integrals = \"polynomial-4-digit\"",
                                      "contact.integrals = \"polynomial-as-printed\""}));
}

TEST(Assumptions, ListNothingThatCannotAct) {
  Case barrel = coarse_case();
  barrel.ring.face.form = cycle::FaceForm::kParabola;
  barrel.ring.face.crown_height = 10e-6;
  EXPECT_FALSE(lists(topics(barrel), "face-orientation"));  // turned it is the same
  barrel.ring.face.apex = 0.49;
  EXPECT_TRUE(lists(topics(barrel), "face-orientation"));
  Case plastic = coarse_case();
  plastic.contact.model = cycle::ContactLaw::kPlastic;
  plastic.contact.hardness = 2e9;
  EXPECT_FALSE(lists(topics(plastic), "contact-integrals"));  // which are those of pairs of summits
}

TEST(Assumptions, OilLawsCanBeLiftedWhereLawsAreInUse) {
  // All other laws whose numbers have defaults, in the order of the table.
  std::vector<std::string> expected;
  for (const models::ViscosityLaw& law : models::viscosity_laws()) {
    const bool complete = std::all_of(law.parameters.begin(), law.parameters.end(), [](const auto& parameter) {
      return parameter.statement == models::Statement::kDefault;
    });
    if (law.name != "roelands" && complete) expected.push_back("lubricant.viscosity_pressure = \"" + law.name + "\"");
  }
  EXPECT_GE(expected.size(), 2u);
  expected.push_back("lubricant.compressibility = \"none\"");
  EXPECT_EQ(settings(coarse_case(), "oil-laws"), expected);
  Case no_thickening = coarse_case();
  no_thickening.lubricant.law_parameters["pressure_viscosity_coefficient"] = 0;
  EXPECT_EQ(settings(no_thickening, "oil-laws"), std::vector<std::string>{"lubricant.compressibility = \"none\""});
  Case table = coarse_case();
  table.lubricant.table_file = "oil.csv";
  table.lubricant.table = cycle::OilTable{{383.15, 403.15}, {1e5, 1e7}, {6e-3, 7e-3, 4e-3, 5e-3}, {790, 795, 780, 785}};
  EXPECT_TRUE(settings(table, "oil-laws").empty());
}

TEST(Assumptions, SettingsOutsideTheRangeOfAKeyAreNotOffered) {
  Case hot = coarse_case();
  hot.operating.oil_temperature = 590;  // a case may have 200 K to 600 K
  const std::vector<std::string> left{"operating.oil_temperature = \"296.9 degC\"",
                                      "thermal.viscous_heating = \"in-film\""};
  EXPECT_EQ(settings(hot, "oil-temperature"), left);
}

TEST(Assumptions, ASyntheticTraceComesFirstAndOnlyWhereOneIsUsed) {
  Case c = coarse_case();
  EXPECT_FALSE(lists(topics(c), "synthetic-trace"));
  c.gas.trace_origin = cycle::TraceOrigin::kSynthetic;
  EXPECT_EQ(topics(c).front(), "synthetic-trace");
  c.gas.model = cycle::GasModel::kWiebe;  // the trace is not read then
  EXPECT_FALSE(lists(topics(c), "synthetic-trace"));
}

std::string statement(const Case& c, const std::string& topic) {
  for (const auto& entry : study::assumptions(c)) {
    if (entry.topic == topic) return entry.statement;
  }
  return "not assumed";
}

TEST(Assumptions, TheEndGapIsOmittedClosedOrGiven) {
  Case c = coarse_case();
  EXPECT_EQ(statement(c, "ring-gap"), "the ends of the ring are omitted");
  EXPECT_TRUE(settings(c, "ring-gap").empty());
  c.film.dimension = cycle::FilmDimension::kUnrolled;
  EXPECT_NE(statement(c, "ring-gap").find("closed"), std::string::npos);
  c.ring.end_gap = 0.3e-3;
  EXPECT_NE(statement(c, "ring-gap").find("a gap of 0.3 mm"), std::string::npos);
  EXPECT_EQ(settings(c, "ring-gap"), std::vector<std::string>{"film.dimension = \"face\""});
  expect_settings_match_effects(c);
}

TEST(Assumptions, EachHasItsOwnPlaceInTheTheory) {
  Case c = coarse_case();
  c.gas.trace_origin = cycle::TraceOrigin::kSynthetic;
  std::ifstream page(RINGFILM_SOURCE_FOLDER "/docs/theory/assumptions.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  for (const auto& entry : study::assumptions(c)) {
    EXPECT_EQ(entry.source, "docs/theory/assumptions.md#" + entry.topic);
    EXPECT_NE(text.find("<a id=\"" + entry.topic + "\">"), std::string::npos) << entry.topic;
    EXPECT_FALSE(entry.statement.empty()) << entry.topic;
    EXPECT_TRUE(entry.variants.empty()) << entry.topic;
  }
}

}  // namespace
