#include "ringfilm/io/case/case_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../case_example.hpp"
#include "ringfilm/case/keys/case_fields.hpp"

namespace ringfilm::io {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(CaseFile, GivesEveryValueInSi) {
  const cycle::Case c = CaseFolder().read();
  EXPECT_EQ(c.title, "test");
  EXPECT_EQ(c.engine.bore, 0.089);
  EXPECT_EQ(c.operating.oil_temperature, 393.15);
  EXPECT_DOUBLE_EQ(c.operating.speed, 157.07963267948966);
  EXPECT_EQ(c.ring.elastic_pressure, 0.2e6);
  EXPECT_EQ(c.ring.face.crown_height, 15e-6);
  EXPECT_EQ(c.contact.asperity_density, 0.097e12);
  EXPECT_EQ(c.lubricant.kinematic_viscosity.at(1).value, 9.59e-6);
  EXPECT_EQ(c.lubricant.density.at(0).temperature, 288.15);
  ASSERT_EQ(c.gas.cylinder_pressure->value.size(), 144u);
  EXPECT_EQ(c.gas.cylinder_pressure->value.front(), 6.1e6);
  EXPECT_THAT(c.stated, Contains("engine.bore"));
  EXPECT_THAT(c.stated, Not(Contains("liner.youngs_modulus")));
}

TEST(CaseFile, KeepsTheDigestOfEveryFileItRead) {
  const CaseFolder folder;
  std::string trace = "crank_angle [degree],p [bar]\n";
  for (int angle = -90; angle <= 90; angle += 10) trace += std::to_string(angle) + (angle == 0 ? ",2\n" : ",1\n");
  folder.write("p.csv", trace);
  const cycle::Case c = folder.read({{"gas.intake_pressure", "0.9 bar"}, {"gas.exhaust_pressure", "1.1 bar"}});
  ASSERT_EQ(c.files.size(), 2u);
  EXPECT_EQ(c.files[0].role, "case");
  EXPECT_EQ(c.files[1].role, "gas.cylinder_pressure");
  // sha256sum of the text above.
  EXPECT_EQ(c.files[1].sha256, "a0ecc53b6e48ed8f3fd2d488182c73fe5f6c010d9a142fbaa2ac4e063fb5913a");
}

TEST(CaseFile, TitleIsNotTooLong) {
  EXPECT_THAT(CaseFolder().read({{"title", std::string(1000, 'a')}}).title, testing::SizeIs(1000));
  EXPECT_THAT(CaseFolder().faults({{"title", std::string(1001, 'a')}}), HasSubstr("has 1001 characters"));
}

struct Mistake {
  const char* name;
  std::string (*faults)();
  std::vector<std::string> parts;
};

/// The complete case with one piece of its text replaced.
std::string with(std::string CaseText::*part, const std::string& text) {
  CaseText c;
  c.*part = text;
  return faults_of(c);
}
std::string with_more(std::string CaseText::*part, const std::string& text) {
  CaseText c;
  c.*part += text;
  return faults_of(c);
}

class Mistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreReportedWithPlaceValueAndRemedy) {
  const std::string reported = GetParam().faults();
  for (const std::string& part : GetParam().parts) EXPECT_THAT(reported, HasSubstr(part));
}

INSTANTIATE_TEST_SUITE_P(
    Keys, Mistakes,
    ::testing::Values(
        Mistake{"UnknownKey",
                [] { return with_more(&CaseText::ring, "face_widht = \"1 mm\"\n"); },
                {"case.toml:16:1: unknown key ring.face_widht; did you mean ring.face_width?", "16 | face_widht"}},
        Mistake{"KeyInTheWrongSection",
                [] { return with_more(&CaseText::engine, "oil_temperature = \"1 degC\"\n"); },
                {"unknown key engine.oil_temperature; did you mean operating.oil_temperature?"}},
        Mistake{"UnknownSection",
                [] { return with_more(&CaseText::lubricant, "[solvers]\ncells = 100\n"); },
                {"unknown section [solvers]; did you mean solver?"}},
        Mistake{"SectionAsKey",
                [] { return with(&CaseText::engine, "engine = 5\n"); },
                {"case.toml:2:1: engine is a section, not a key"}},
        Mistake{"KeyAsSection",
                [] { return with(&CaseText::top, "title.text = \"a\"\n"); },
                {"title is a section here", "it requires one value"}},
        Mistake{"MissingKey",
                [] { return with(&CaseText::operating, "[operating]\nspeed = \"1500 rpm\"\n"); },
                {"case.toml: the key operating.oil_temperature is missing",
                 "oil_temperature = \"120 degC\" in [operating]"}},
        Mistake{"MissingTitle",
                [] { return with(&CaseText::top, ""); },
                {"the key title is missing", "before the first section"}},
        Mistake{"Duplicate",
                [] { return with_more(&CaseText::engine, "bore = \"89 mm\"\n"); },
                {"case.toml:6:", "bore is given twice", "delete line 3 or line 6 of case.toml"}},
        Mistake{"UnusedKey",
                [] { return with_more(&CaseText::gas, "peak_angle = \"12 degree\"\n"); },
                {"case.toml:13:1: gas.peak_angle is not used in this case", "gas.model = \"wiebe\""}},
        Mistake{"OtherFaceForm",
                [] { return with_more(&CaseText::face, "length_unit = \"mm\"\n"); },
                {"ring.face.length_unit is not used in this case", "ring.face.form = \"polynomial\""}},
        Mistake{"PolynomialWithoutUnits",
                [] { return with(&CaseText::face, "[ring.face]\nform = \"polynomial\"\n"); },
                {"ring.face.coefficients is missing", "ring.face.length_unit is missing",
                 "ring.face.height_unit is missing"}},
        Mistake{"ParabolaWithoutHeight",
                [] { return with(&CaseText::face, "[ring.face]\nform = \"parabola\"\n"); },
                {"ring.face.crown_height is missing"}},
        Mistake{
            "ReferenceNotStated",
            [] { return with(&CaseText::gas, "[gas]\ncylinder_pressure = \"p.csv\"\n"); },
            {"gas.pressure_reference is missing", "gas.angle_zero is missing", "pressure_reference = \"absolute\""}},
        Mistake{"ModuliBesideCompositeModulus",
                [] {
                  return with_more(&CaseText::contact,
                                   "composite_modulus = \"135 GPa\"\n[liner]\npoissons_ratio = 0.2\n");
                },
                {"liner.poissons_ratio is not used in this case", "contact.composite_modulus is not stated"}},
        Mistake{"HoupertKeyWithWalther",
                [] { return with_more(&CaseText::lubricant, "temperature_viscosity_coefficient = \"0.04 1/K\"\n"); },
                {"lubricant.temperature_viscosity_coefficient is not used", "\"houpert\""}}),
    [](const auto& mistake) { return mistake.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Values, Mistakes,
    ::testing::Values(
        Mistake{"NoUnit",
                [] { return with(&CaseText::ring, "[ring]\nface_width = \"1.2 mm\"\ntangential_force = 12.5\n"); },
                {"case.toml:15:20: ring.tangential_force = 12.5 has no unit", "15 | tangential_force = 12.5",
                 "^ a force is required here, for example \"10.7 N\""}},
        Mistake{"NoUnitInText",
                [] { return with(&CaseText::ring, "[ring]\nface_width = \"1.2\"\n"); },
                {"case.toml:14:14: ring.face_width = \"1.2\" has no unit", "a length is required here"}},
        Mistake{"WrongUnit",
                [] { return with(&CaseText::ring, "[ring]\nface_width = \"1.2 bar\"\n"); },
                {"ring.face_width = \"1.2 bar\" is not a length", "for example \"1.2 mm\""}},
        Mistake{"Negative",
                [] { return with(&CaseText::ring, "[ring]\nface_width = \"-1.2 mm\"\n"); },
                {"ring.face_width = \"-1.2 mm\" is out of range", "allowed is above 0 to 50 mm"}},
        Mistake{"NotANumber",
                [] { return with(&CaseText::ring, "[ring]\nface_width = nan\n"); },
                {"ring.face_width = nan is not a finite number"}},
        Mistake{"NotANumberInText",
                [] { return with(&CaseText::ring, "[ring]\nface_width = \"nan mm\"\n"); },
                {"ring.face_width = \"nan mm\" is not a finite number"}},
        Mistake{"InfiniteBareNumber",
                [] { return with_more(&CaseText::contact, "[liner]\npoissons_ratio = inf\n"); },
                {"liner.poissons_ratio = inf is not a finite number"}},
        Mistake{"DecimalComma",
                [] { return with(&CaseText::ring, "[ring]\nface_width = \"1,2 mm\"\n"); },
                {"ring.face_width = \"1,2 mm\" has a decimal comma", "write a decimal point"}},
        Mistake{"TextForBareNumber",
                [] { return with_more(&CaseText::contact, "[liner]\npoissons_ratio = \"0.2\"\n"); },
                {"liner.poissons_ratio = \"0.2\" is text", "a number without unit is required"}},
        Mistake{"ShareInPercent",
                [] { return with_more(&CaseText::gas, "pressure_behind_ring = 90\n"); },
                {"gas.pressure_behind_ring = 90 is out of range", "it is a share: write 0.9 for 90 %"}},
        Mistake{
            "ShareAsTextInPercent",
            [] { return with_more(&CaseText::gas, "pressure_behind_ring = \"90 %\"\n"); },
            {"gas.pressure_behind_ring = \"90 %\" is text", "a number without unit is required here, for example 0.9"}},
        Mistake{"Gauge",
                [] { return with_more(&CaseText::gas, "crankcase_pressure = \"0.1 barg\"\n"); },
                {"\"0.1 barg\" is a gauge pressure", "add the atmosphere"}},
        Mistake{"SpeedInHertz",
                [] { return with(&CaseText::operating, "[operating]\nspeed = \"25 Hz\"\n"); },
                {"operating.speed = \"25 Hz\" could mean turns or radians", "rpm or rad/s"}},
        Mistake{"UnknownChoice",
                [] { return with_more(&CaseText::contact, "integrals = \"exakt\"\n"); },
                {"contact.integrals = \"exakt\" is not known; did you mean \"exact\"?", "\"polynomial-4-digit\""}},
        Mistake{"UnknownOutlet",
                [] { return with_more(&CaseText::more, "[film]\noutlet = \"capilary\"\n"); },
                {"film.outlet = \"capilary\" is not known; did you mean \"capillary\"?"}},
        Mistake{"NoSurfaceTension",
                [] { return with_more(&CaseText::lubricant, "surface_tension = \"0 N/m\"\n"); },
                {"lubricant.surface_tension = \"0 N/m\" is out of range", "0.001 to 1 N/m"}},
        Mistake{"FractionOfACell",
                [] { return with_more(&CaseText::more, "[solver]\ncells = 100.5\n"); },
                {"solver.cells = 100.5 is not a whole number"}},
        Mistake{"TooFewCells",
                [] { return with_more(&CaseText::more, "[solver]\ncells = 7\n"); },
                {"solver.cells = 7 is out of range", "8 to 100000"}},
        Mistake{"StepThatMissesTheCycle",
                [] { return with_more(&CaseText::more, "[solver]\ncrank_step = \"0.7 degree\"\n"); },
                {"solver.crank_step = 0.7 degree does not divide the cycle"}},
        Mistake{"AngleWithoutUnit",
                [] { return with_more(&CaseText::more, "[output]\ncrank_angles = 1\n"); },
                {"case.toml:28:16: output.crank_angles = 1 has no unit", "an angle is required"}},
        Mistake{"AngleTwice",
                [] { return with_more(&CaseText::more, "[output]\nfields = [\"-20 degree\", \"700 degree\"]\n"); },
                {"has the angle 700 degree twice"}},
        Mistake{"Date",
                [] { return with_more(&CaseText::more, "[film]\ncavitation_pressure = 2024-01-01\n"); },
                {"film.cavitation_pressure = (neither text nor number) is not a quantity"}},
        Mistake{"OilWithoutValue",
                [] {
                  return with(&CaseText::lubricant,
                              "[lubricant]\nkinematic_viscosity = [{temperature = \"40 degC\"}]\n");
                },
                {"lubricant.kinematic_viscosity = {...} requires a temperature and a value",
                 "lubricant.density is missing"}}),
    [](const auto& mistake) { return mistake.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Rules, Mistakes,
    ::testing::Values(
        Mistake{"TwoTensions",
                [] { return with_more(&CaseText::ring, "tangential_force = \"10 N\"\n"); },
                {"case.toml:16:20: the tension of the ring is stated twice: ring.elastic_pressure and "
                 "ring.tangential_force",
                 "state one of", "delete line 15 or line 16 of case.toml"}},
        Mistake{"ThreeTensions",
                [] {
                  return with_more(&CaseText::ring,
                                   "tangential_force = \"10 N\"\nfree_gap = \"10 mm\"\nradial_thickness = \"3 mm\"\n");
                },
                {"ring.elastic_pressure and ring.tangential_force and ring.free_gap",
                 "delete all but one of these: line 15; line 16; line 17 and line 18 of case.toml"}},
        Mistake{"NoTension",
                [] { return with(&CaseText::ring, "[ring]\nface_width = \"1.2 mm\"\n"); },
                {"the tension of the ring is missing", "ring.free_gap with ring.radial_thickness"}},
        Mistake{"GapWithoutThickness",
                [] { return with(&CaseText::ring, "[ring]\nface_width = \"1.2 mm\"\nfree_gap = \"10 mm\"\n"); },
                {"ring.free_gap is stated without ring.radial_thickness"}},
        Mistake{"ShortRod",
                [] {
                  return with(&CaseText::engine,
                              "[engine]\nbore = \"89 mm\"\nstroke = \"80 mm\"\nconnecting_rod_length = \"40 mm\"\n");
                },
                {"40 mm is not longer than the crank radius, 40 mm"}},
        Mistake{"OneViscosity",
                [] {
                  return with(&CaseText::lubricant,
                              "[lubricant]\nkinematic_viscosity = [{temperature = \"40 degC\", value = \"60 mm2/s\"}]\n"
                              "density = [{temperature = \"40 degC\", value = \"830 kg/m3\"}]\n");
                },
                {"has one value; the Walther line needs two or more"}},
        Mistake{"RisingViscosity",
                [] {
                  return with(&CaseText::lubricant,
                              "[lubricant]\nkinematic_viscosity = [{temperature = \"40 degC\", value = \"6 mm2/s\"},"
                              "{temperature = \"100 degC\", value = \"60 mm2/s\"}]\n"
                              "density = [{temperature = \"40 degC\", value = \"830 kg/m3\"}]\n");
                },
                {"lubricant.kinematic_viscosity does not fall from 40 to 100 degC"}},
        Mistake{"LawBesideTable",
                [] {
                  CaseText c;
                  c.lubricant = "[lubricant]\ntable = \"oil.csv\"\nviscosity_pressure = \"none\"\n";
                  const CaseFolder folder(c);
                  folder.write("oil.csv",
                               "temperature [degC],pressure [bar],viscosity [cP],density [kg/m3]\n"
                               "40,1,50,830\n40,1000,200,870\n");
                  return folder.faults();
                },
                {"lubricant.viscosity_pressure is not used in this case", "no lubricant.table"}}),
    [](const auto& mistake) { return mistake.param.name; });

TEST(CaseFile, ReportsAllFaultsOfAllFilesAtOnce) {
  CaseText text;
  text.top += "include = [\"fragment.toml\"]\n";
  text.ring = "[ring]\nface_width = 1.2\nelastic_pressure = \"2 N\"\n";
  const CaseFolder folder(text);
  folder.write("fragment.toml", "[film]\ncavitaton = \"none\"\n");
  folder.write("p.csv", "crank_angle [degree],p [bar]\n0,1\n1,x\n");
  const std::string reported = folder.faults();
  EXPECT_THAT(reported, HasSubstr("ring.face_width = 1.2 has no unit"));
  EXPECT_THAT(reported, HasSubstr("ring.elastic_pressure = \"2 N\" is not a pressure"));
  EXPECT_THAT(reported, HasSubstr("fragment.toml:2:1: unknown key film.cavitaton; did you mean film.cavitation?"));
  EXPECT_THAT(reported, HasSubstr("p.csv:3:3: \"x\" is not a number"));
}

TEST(CaseFile, ReportsAMisspeltKeyOnceAndNotAsMissing) {
  CaseText text;
  text.ring = "[ring]\nface_widht = \"1.2 mm\"\nelastic_pressure = \"0.2 MPa\"\n";
  EXPECT_THAT(faults_of(text), Not(HasSubstr("missing")));
}

TEST(CaseFile, KeepsValuesOfAnOilFileThatTheCaseHasNoUseFor) {
  CaseText text;
  text.lubricant = "[lubricant]\nfile = \"oil.toml\"\n";
  const CaseFolder folder(text);
  folder.write("oil.toml",
               "name = \"x\"\nthermal_expansivity = \"1e-3 1/K\"\n"
               "kinematic_viscosity = [{temperature = \"40 degC\", value = \"60 mm2/s\"},"
               "{temperature = \"100 degC\", value = \"9 mm2/s\"}]\n"
               "density = [{temperature = \"40 degC\", value = \"830 kg/m3\"}]\n");
  const cycle::Case c = folder.read();
  EXPECT_EQ(c.lubricant.thermal_expansivity, 1e-3);
  EXPECT_EQ(c.lubricant.name, "x");
  EXPECT_EQ(c.files.at(1).role, "lubricant.file");
}

TEST(CaseFile, RefusesAKeyInBothCaseAndOilFile) {
  CaseText text;
  text.lubricant += "file = \"oil.toml\"\n";
  const CaseFolder folder(text);
  folder.write("oil.toml", "density = [{temperature = \"40 degC\", value = \"830 kg/m3\"}]\n");
  EXPECT_THAT(folder.faults(), HasSubstr(":1: lubricant.density is given twice"));
  EXPECT_THAT(folder.faults(), HasSubstr("of case.toml, or lubricant.file: the oil file has it at oil.toml:1:1"));
}

TEST(CaseFile, OverridesDropKeysThatTheyMakeUnusedAndNoOthers) {
  const CaseFolder folder;
  std::vector<DroppedKey> dropped;
  const auto read = [&](const std::vector<Override>& overrides) {
    dropped.clear();
    return read_case_dropping(folder / "case.toml", overrides, Units(), dropped);
  };
  EXPECT_EQ(read({{"ring.tangential_force", "12 N"}}).ring.elastic_pressure, std::nullopt);
  ASSERT_EQ(dropped.size(), 1u);
  EXPECT_EQ(dropped.front().key, "ring.elastic_pressure");
  EXPECT_GT(dropped.front().mark.line, 0);
  EXPECT_TRUE(read({{"gas.model", "wiebe"}}).gas.cylinder_pressure_file.empty());
  EXPECT_EQ(dropped.size(), 3u);
  EXPECT_THROW(read({{"gas.peak_pressure", "80 bar"}}), InputError);
  EXPECT_THROW(folder.read({{"gas.model", "wiebe"}}), InputError) << "who does not ask for it is refused";
  read({{"solver.cells", "70"}});
  EXPECT_TRUE(dropped.empty());
}

TEST(CaseFile, ReadsMeasuredFacesAndOilTables) {
  CaseText text;
  text.face = "[ring.face]\nform = \"points\"\nfile = \"face.csv\"\n";
  text.lubricant = "[lubricant]\ntable = \"oil.csv\"\n";
  const CaseFolder folder(text);
  folder.write("face.csv", "x [um],height [um]\n0,10\n600,0\n1200,12\n");
  folder.write("oil.csv",
               "temperature [degC],pressure [bar],viscosity [cP],density [g/cm3]\n"
               "100,1,5,0.79\n40,1,50,0.83\n100,1000,12,0.83\n40,1000,200,0.87\n");
  const cycle::Case c = folder.read();
  EXPECT_EQ(c.ring.face.x.back(), c.ring.face_width);
  EXPECT_DOUBLE_EQ(c.ring.face.height.at(2), 12e-6);
  EXPECT_THAT(c.lubricant.table->temperature, ::testing::ElementsAre(313.15, 373.15));
  EXPECT_THAT(c.lubricant.table->viscosity, ::testing::ElementsAre(0.05, 0.2, 0.005, 0.012));
  EXPECT_THAT(c.lubricant.table->density, ::testing::ElementsAre(830, 870, 790, 830));
}

TEST(CaseFile, RefusesAFaceThatDoesNotCoverTheWidth) {
  CaseText text;
  text.face = "[ring.face]\nform = \"points\"\nfile = \"face.csv\"\n";
  const CaseFolder folder(text);
  folder.write("face.csv", "x [mm],height [um]\n0,10\n1.1,12\n");
  EXPECT_THAT(folder.faults(), HasSubstr("run from x = 0 to 1.1 mm and do not cover the face width of 1.2 mm"));
  folder.write("face.csv", "x [mm],height [um]\n0,10\n1.3,12\n0.6,12\n");
  EXPECT_THAT(folder.faults(), HasSubstr("face.csv:4:1: x falls"));
}

TEST(CaseFile, RefusesAnOilTableWithHoles) {
  CaseText text;
  text.lubricant = "[lubricant]\ntable = \"oil.csv\"\n";
  const CaseFolder folder(text);
  folder.write(
      "oil.csv",
      "temperature [degC],pressure [bar],viscosity [cP],density [kg/m3]\n100,1,5,790\n40,1,50,830\n40,9,51,831\n");
  EXPECT_THAT(folder.faults(), HasSubstr("the table has 3 rows for 2 temperatures and 2 pressures"));
}

TEST(CaseFile, WrapsAnglesIntoTheCycleAndTakesBareOnesInListsAsDegrees) {
  CaseText text;
  text.more = "[output]\ncrank_angles = [\"20 degree\", -20, \"720 degree\"]\nfields = [\"-90 degree\"]\n";
  const cycle::Case c = CaseFolder(text).read();
  EXPECT_THAT(c.output.crank_angles_deg, ::testing::ElementsAre(0, 20, 700));
  EXPECT_THAT(c.output.field_angles_deg, ::testing::ElementsAre(630));
  EXPECT_EQ(c.output.fields, cycle::FieldOutput::kListed);
}

}  // namespace
}  // namespace ringfilm::io
