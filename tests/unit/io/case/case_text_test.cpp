#include "ringfilm/io/case/case_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../case_example.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_value_text.hpp"

namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;

const std::string kCases = std::string(RINGFILM_SOURCE_FOLDER) + "/cases/styles2014/";

/// The case read again from its resolved text.
cycle::Case read_again(const cycle::Case& c) {
  const ScratchFolder folder;
  // File names in the text are as seen from the folder of the run; here they are absolute.
  write_text(folder / "again.toml", resolved_case(c));
  return read_case(folder / "again.toml");
}

void expect_same_values(const cycle::Case& a, const cycle::Case& b) {
  for (const cycle::Field& field : cycle::case_fields()) {
    if (field.key == "lubricant.file") continue;  // written out key by key
    if (!cycle::is_active(field, a)) continue;    // an oil file may state keys that the case does not use
    EXPECT_EQ(exact_value(field, a), exact_value(field, b)) << field.key;
  }
  EXPECT_EQ(a.engine.bore, b.engine.bore);
  EXPECT_EQ(a.operating.speed, b.operating.speed);
  EXPECT_EQ(a.operating.oil_temperature, b.operating.oil_temperature);
  EXPECT_EQ(a.gas.cylinder_pressure->value, b.gas.cylinder_pressure->value);
  EXPECT_EQ(a.gas.cylinder_pressure->crank_angle_deg, b.gas.cylinder_pressure->crank_angle_deg);
  EXPECT_EQ(a.contact.asperity_density, b.contact.asperity_density);
  EXPECT_EQ(a.contact.composite_modulus, b.contact.composite_modulus);
  EXPECT_EQ(a.ring.face.coefficients, b.ring.face.coefficients);
  EXPECT_EQ(a.ring.face.length_unit, b.ring.face.length_unit);
  EXPECT_EQ(a.ring.face.x, b.ring.face.x);
  EXPECT_EQ(a.lubricant.table->viscosity, b.lubricant.table->viscosity);
  EXPECT_EQ(a.solver.crank_step_deg, b.solver.crank_step_deg);
  EXPECT_EQ(a.output.crank_angles_deg, b.output.crank_angles_deg);
  EXPECT_EQ(a.output.field_angles_deg, b.output.field_angles_deg);
}

TEST(ResolvedCase, GivesTheSameBitsAgain) {
  const CaseFolder folder;
  const cycle::Case awkward = folder.read({{"operating.speed", "1777.7 rpm"},
                                           {"operating.oil_temperature", "211.3 degF"},
                                           {"engine.bore", "3.504 inch"},
                                           {"contact.composite_modulus", "19.5e6 psi"},
                                           {"ring.elastic_pressure", ""},
                                           {"ring.free_gap", "10.1 mm"},
                                           {"ring.radial_thickness", "3.3 mm"},
                                           {"lubricant.viscosity_temperature", "houpert"},
                                           {"output.crank_angles", "[\"0.1 rad\", \"-17.3 degree\"]"},
                                           {"title", "a \"quoted\" \\ title, \u00B5m"}});
  expect_same_values(awkward, read_again(awkward));
}

TEST(ResolvedCase, GivesTheSameBitsForWiebePolynomialAndTables) {
  CaseText text;
  text.gas = "[gas]\nmodel = \"wiebe\"\npeak_pressure = \"913.7 psi\"\nintake_pressure = \"0.93 bar\"\n";
  text.face =
      "[ring.face]\nform = \"polynomial\"\ncoefficients = [0.1, -3, 1e-7]\nlength_unit = \"inch\"\nheight_unit = "
      "\"um\"\n";
  text.lubricant = "[lubricant]\ntable = \"oil.csv\"\n";
  const CaseFolder folder(text);
  folder.write("oil.csv",
               "temperature [degC],pressure [bar],viscosity [cP],density [kg/m3]\n40,1,50,830\n40,1e3,200,870\n");
  const cycle::Case c = folder.read();
  expect_same_values(c, [&] {
    cycle::Case again = read_again(c);
    again.gas.exhaust_pressure.reset();  // the model's own value, written out
    return again;
  }());
}

TEST(CaseEntries, ReportWhatIsAssumed) {
  const std::vector<CaseEntry> entries = case_entries(CaseFolder().read());
  const auto entry = [&entries](const std::string& key) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&key](const CaseEntry& e) { return e.key == key; });
    return found == entries.end() ? CaseEntry{} : *found;
  };
  EXPECT_EQ(entry("engine.bore").value, "\"0.089 m\"");
  EXPECT_EQ(entry("engine.bore").shown, "89 mm");
  EXPECT_EQ(entry("engine.bore").value_si, 0.089);
  EXPECT_EQ(entry("engine.bore").unit, "m");
  EXPECT_TRUE(std::isnan(entry("gas.model").value_si));
  EXPECT_FALSE(entry("engine.bore").assumed);
  EXPECT_TRUE(entry("liner.youngs_modulus").assumed);
  EXPECT_EQ(entry("liner.youngs_modulus").shown, "92.3 GPa");
  EXPECT_EQ(entry("gas.model").value, "\"trace\"");
  EXPECT_EQ(entry("gas.compression_ratio").key, "");
  EXPECT_EQ(entry("lubricant.density").shown, "849.7 kg/m3 at 15 degC");
}

TEST(CaseEntries, ListTheDefaultsOfTheWiebeModel) {
  CaseText text;
  text.gas = "[gas]\nmodel = \"wiebe\"\n";
  for (const CaseEntry& entry : case_entries(CaseFolder(text).read())) {
    if (entry.key == "gas.intake_pressure") {
      EXPECT_EQ(entry.shown, "0.95 bar");
      EXPECT_TRUE(entry.assumed);
      return;
    }
  }
  ADD_FAILURE() << "gas.intake_pressure is in use and not listed";
}

TEST(FieldsTable, HasEveryKeyWithItsMeaning) {
  const std::string table = fields_table(), markdown = fields_markdown();
  for (const cycle::Field& field : cycle::case_fields()) {
    EXPECT_THAT(table, HasSubstr(field.help));
    EXPECT_THAT(markdown, HasSubstr(field.help));
  }
  EXPECT_THAT(table, HasSubstr("above 0 to 2000 mm"));
  EXPECT_THAT(markdown, HasSubstr("trace \\| wiebe"));
}

TEST(FieldsTable, OfASectionAKeyOrAWordHasThoseKeysAlone) {
  const auto has = [](const std::string& table, const char* key) {
    return table.find(cycle::find_field(key)->help) != std::string::npos;
  };
  const std::string ring = fields_table({"ring"});
  EXPECT_TRUE(has(ring, "ring.face_width") && has(ring, "ring.face.form"));
  EXPECT_FALSE(has(ring, "engine.bore"));
  EXPECT_EQ(ring, fields_table({"[ring]"}));
  const std::string some = fields_table({"engine.bore", "clearance"});
  EXPECT_TRUE(has(some, "engine.bore") && has(some, "ring.side_clearance") && has(some, "ring.land_clearance"));
  EXPECT_FALSE(has(some, "engine.stroke") || has(some, "ring.face_width"));
}

TEST(FieldsTable, RefusesAWordThatIsInNoKey) {
  try {
    fields_table({"ring.face_widht"});
    ADD_FAILURE() << "taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean ring.face_width?"));
  }
}

class ShippedCase : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedCase, StatesEveryKeyThatIsInUse) {
  const cycle::Case c = read_case(kCases + GetParam());
  for (const CaseEntry& entry : case_entries(c)) EXPECT_FALSE(entry.assumed) << entry.key;
  EXPECT_EQ(c.gas.trace_origin, cycle::TraceOrigin::kSynthetic);
}

TEST_P(ShippedCase, ResolvesToTheSameBits) {
  const cycle::Case c = read_case(kCases + GetParam());
  expect_same_values(c, [&] {
    cycle::Case again = read_again(c);
    // Values of the oil file that this case has no use for are not written.
    again.lubricant.thermal_expansivity = c.lubricant.thermal_expansivity;
    again.lubricant.temperature_viscosity_coefficient = c.lubricant.temperature_viscosity_coefficient;
    return again;
  }());
}

INSTANTIATE_TEST_SUITE_P(Styles2014, ShippedCase, ::testing::Values("new.toml", "run-in.toml", "embedded.toml"));

TEST(ShippedCases, HaveTheMeasuredSurfacesOfThePaper) {
  const cycle::Case fresh = read_case(kCases + "new.toml"), run_in = read_case(kCases + "run-in.toml"),
                    embedded = read_case(kCases + "embedded.toml");
  // styles2014, Tables 1, 2 and 4.
  EXPECT_DOUBLE_EQ(fresh.contact.asperity_density, 0.097e12);
  EXPECT_DOUBLE_EQ(run_in.contact.asperity_density, 0.100e12);
  EXPECT_DOUBLE_EQ(embedded.contact.asperity_density, 0.101e12);
  EXPECT_DOUBLE_EQ(fresh.contact.asperity_radius, 1.56e-6);
  EXPECT_DOUBLE_EQ(run_in.contact.asperity_radius, 1.34e-6);
  EXPECT_DOUBLE_EQ(embedded.contact.asperity_radius, 1.82e-6);
  EXPECT_DOUBLE_EQ(fresh.contact.roughness, 0.48e-6);
  EXPECT_DOUBLE_EQ(run_in.contact.roughness, 0.50e-6);
  EXPECT_DOUBLE_EQ(embedded.contact.roughness, 0.35e-6);
  EXPECT_DOUBLE_EQ(fresh.contact.boundary_shear_strength_coefficient, 0.3581);
  EXPECT_DOUBLE_EQ(run_in.contact.boundary_shear_strength_coefficient, 0.2565);
  EXPECT_DOUBLE_EQ(embedded.contact.boundary_shear_strength_coefficient, 0.1423);
  EXPECT_DOUBLE_EQ(fresh.ring.face.coefficients.front(), 427.9);
  EXPECT_DOUBLE_EQ(run_in.ring.face.coefficients.back(), 13.857);
  EXPECT_DOUBLE_EQ(embedded.ring.face.coefficients.at(5), -17.338);
}

}  // namespace
}  // namespace ringfilm::io
