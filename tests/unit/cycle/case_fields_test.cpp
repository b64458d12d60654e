#include "ringfilm/case/keys/case_fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;

std::vector<std::string> keys_at_fault(const Case& c) {
  std::vector<std::string> keys;
  for (const RuleBreach& breach : broken_rules(c)) keys.push_back(breach.key);
  return keys;
}

/// A case that keeps all rules.
Case sound_case() {
  Case c;
  c.engine = {0.089, 0.0795, 0.1381, {}};
  c.gas.model = GasModel::kWiebe;
  c.ring.face_width = 1.2e-3;
  c.ring.elastic_pressure = 2e5;
  c.ring.face.form = FaceForm::kParabola;
  c.lubricant.kinematic_viscosity = {{313.15, 60e-6}, {373.15, 9.6e-6}};
  c.lubricant.density = {{288.15, 849.7}};
  return c;
}

bool active(const std::string& key, const Case& c) { return is_active(*find_field(key), c); }

TEST(CaseFields, NameEachKeyOnceWithHelpAndExample) {
  std::set<std::string> keys;
  for (const Field& field : case_fields()) {
    EXPECT_TRUE(keys.insert(field.key).second) << field.key;
    EXPECT_FALSE(field.help.empty()) << field.key;
    EXPECT_FALSE(field.example.empty()) << field.key;
    EXPECT_EQ(field.active == nullptr, field.active_when.empty()) << field.key;
    EXPECT_EQ(find_field(field.key), &field);
  }
  EXPECT_EQ(find_field("engine.boer"), nullptr);
}

TEST(CaseFields, HaveEveryKeyOfTheContract) {
  for (const char* key : {"title",
                          "engine.bore",
                          "engine.stroke",
                          "engine.connecting_rod_length",
                          "operating.speed",
                          "operating.oil_temperature",
                          "gas.model",
                          "gas.cylinder_pressure",
                          "gas.pressure_reference",
                          "gas.angle_zero",
                          "gas.pressure_column",
                          "gas.angle_column",
                          "gas.intake_pressure",
                          "gas.exhaust_pressure",
                          "gas.compression_ratio",
                          "gas.peak_pressure",
                          "gas.peak_angle",
                          "gas.burn_duration",
                          "gas.crankcase_pressure",
                          "gas.pressure_behind_ring",
                          "ring.face_width",
                          "ring.youngs_modulus",
                          "ring.poissons_ratio",
                          "ring.elastic_pressure",
                          "ring.tangential_force",
                          "ring.free_gap",
                          "ring.radial_thickness",
                          "ring.face.form",
                          "ring.face.height_zero",
                          "ring.face.orientation",
                          "ring.face.coefficients",
                          "ring.face.length_unit",
                          "ring.face.height_unit",
                          "ring.face.crown_height",
                          "ring.face.apex",
                          "ring.face.file",
                          "liner.youngs_modulus",
                          "liner.poissons_ratio",
                          "contact.model",
                          "contact.asperity_density",
                          "contact.asperity_radius",
                          "contact.roughness",
                          "contact.roughness_measure",
                          "contact.boundary_shear_strength_coefficient",
                          "contact.eyring_shear_stress",
                          "contact.composite_modulus",
                          "contact.integrals",
                          "contact.lambda_ratio",
                          "lubricant.file",
                          "lubricant.grade",
                          "lubricant.kinematic_viscosity",
                          "lubricant.density",
                          "lubricant.table",
                          "lubricant.pressure_viscosity_coefficient",
                          "lubricant.temperature_viscosity_coefficient",
                          "lubricant.reference_temperature",
                          "lubricant.thermal_expansivity",
                          "lubricant.viscosity_temperature",
                          "lubricant.viscosity_pressure",
                          "lubricant.density_temperature",
                          "lubricant.compressibility",
                          "film.cavitation",
                          "film.cavitation_pressure",
                          "solver.cells",
                          "solver.crank_step",
                          "solver.crank_step_control",
                          "solver.step_error",
                          "solver.tolerance",
                          "solver.method",
                          "solver.properties",
                          "output.crank_angles",
                          "output.fields"}) {
    EXPECT_NE(find_field(key), nullptr) << key;
  }
}

TEST(CaseFields, RequireOnlyWhatHasNoDefault) {
  std::set<std::string> required;
  for (const Field& field : case_fields()) {
    const bool is_of_contact = field.key.rfind("contact.", 0) == 0 && is_active(field, Case{});
    const bool is_always_in_use = field.active == nullptr || is_of_contact;
    if (is_required(field, Case{}) && belongs(field, Case{}) && is_always_in_use) required.insert(field.key);
  }
  const std::set<std::string> expected{"title",
                                       "engine.bore",
                                       "engine.stroke",
                                       "engine.connecting_rod_length",
                                       "operating.speed",
                                       "ring.face_width",
                                       "ring.face.form",
                                       "contact.asperity_density",
                                       "contact.asperity_radius",
                                       "contact.roughness",
                                       "contact.boundary_shear_strength_coefficient"};
  EXPECT_EQ(required, expected);
}

TEST(CaseFields, ChooseTheEnumeratorOfEachName) {
  for (const Field& field : case_fields()) {
    const auto* choice = std::get_if<ChoiceKind>(&field.kind);
    if (choice == nullptr) continue;
    for (int i = 0; i < static_cast<int>(choice->names.size()); ++i) {
      Case c;
      choice->choose(c, i);
      EXPECT_EQ(choice->index(c), i) << field.key;
    }
  }
  Case c;
  std::get<ChoiceKind>(find_field("ring.face.orientation")->kind).choose(c, 2);
  EXPECT_EQ(c.ring.face.orientation, Orientation::kLeadingEdge);
  std::get<ChoiceKind>(find_field("contact.integrals")->kind).choose(c, 1);
  EXPECT_EQ(c.contact.integrals, ContactIntegrals::kPolynomial4Digit);
}

TEST(CaseFields, AreInUseOnlyWithTheirModel) {
  Case c = sound_case();
  EXPECT_TRUE(active("gas.compression_ratio", c));
  EXPECT_TRUE(active("gas.intake_pressure", c));
  EXPECT_FALSE(active("gas.angle_zero", c));
  c.gas.crankcase_pressure_file = "crankcase.csv";
  EXPECT_TRUE(active("gas.angle_zero", c));
  c.gas.model = GasModel::kTrace;
  EXPECT_FALSE(active("gas.compression_ratio", c));
  c.stated.insert("gas.compression_ratio");  // for the index of compression
  EXPECT_TRUE(active("gas.compression_ratio", c));
  EXPECT_FALSE(active("gas.intake_pressure", c));
  c.gas.cylinder_pressure = SampledTrace{{-100, -95, -90}, {}};
  EXPECT_TRUE(active("gas.intake_pressure", c));

  EXPECT_TRUE(active("ring.youngs_modulus", c));
  c.contact.composite_modulus = 135e9;
  EXPECT_FALSE(active("ring.youngs_modulus", c));
  EXPECT_FALSE(active("liner.poissons_ratio", c));
  c.ring.free_gap = 0.01;
  EXPECT_TRUE(active("ring.youngs_modulus", c));
  EXPECT_FALSE(active("ring.poissons_ratio", c));

  EXPECT_FALSE(active("lubricant.reference_temperature", c));
  c.lubricant.density_temperature = DensityTemperature::kThermalExpansivity;
  EXPECT_TRUE(active("lubricant.reference_temperature", c));
  EXPECT_FALSE(active("lubricant.temperature_viscosity_coefficient", c));
  c.lubricant.table_file = "oil.csv";
  EXPECT_FALSE(active("lubricant.reference_temperature", c));
  EXPECT_FALSE(active("lubricant.compressibility", c));

  EXPECT_FALSE(active("gas_path.viscosity", c));
  c.film.crankcase_edge = EdgeFluid::kGas;  // which may blow through the film
  EXPECT_TRUE(active("gas_path.viscosity", c));
  EXPECT_TRUE(active("gas_path.crankcase_temperature", c));
  EXPECT_FALSE(active("gas_path.discharge_coefficient", c));
}

TEST(CaseRules, HoldForAValidCase) { EXPECT_THAT(broken_rules(sound_case()), IsEmpty()); }

TEST(CaseRules, AskForExactlyOneTension) {
  Case c = sound_case();
  c.ring.elastic_pressure.reset();
  EXPECT_THAT(keys_at_fault(c), Contains("ring.elastic_pressure"));
  c.ring.free_gap = 0.01;
  EXPECT_THAT(keys_at_fault(c), Contains("ring.radial_thickness"));
  c.ring.radial_thickness = 0.003;
  EXPECT_THAT(keys_at_fault(c), IsEmpty());
  c.ring.tangential_force = 10;
  EXPECT_THAT(keys_at_fault(c), Contains("ring.tangential_force"));
}

TEST(CaseRules, LetHoupertTakeOneValueAtItsReference) {
  Case c = sound_case();
  c.lubricant.viscosity_temperature = ViscosityTemperature::kHoupert;
  c.lubricant.kinematic_viscosity = {{313.15, 60e-6}};
  EXPECT_THAT(keys_at_fault(c), IsEmpty());
  c.lubricant.reference_temperature = 373.15;
  EXPECT_THAT(keys_at_fault(c), Contains("lubricant.kinematic_viscosity"));
}

TEST(CaseRules, LetAViscosityIndexReplaceTheSecondViscosity) {
  Case c = sound_case();
  c.lubricant.kinematic_viscosity = {{313.15, 73.30e-6}};
  EXPECT_THAT(keys_at_fault(c), Contains("lubricant.kinematic_viscosity"));
  c.lubricant.viscosity_index = 92;
  EXPECT_THAT(keys_at_fault(c), IsEmpty());
  ASSERT_EQ(c.lubricant.viscosities().size(), 2u);
  EXPECT_NEAR(c.lubricant.viscosities()[1].value, 8.86e-6, 0.05e-6);  // example of ASTM D2270; half a unit of the index
  c.lubricant.kinematic_viscosity = {{373.15, 8.86e-6}};
  ASSERT_EQ(c.lubricant.viscosities().size(), 2u);
  EXPECT_NEAR(c.lubricant.viscosities()[0].value, 73.30e-6, 0.3e-6);
  EXPECT_THAT(keys_at_fault(c), IsEmpty());
  c.lubricant.kinematic_viscosity = {{323.15, 50e-6}};
  EXPECT_THAT(keys_at_fault(c), Contains("lubricant.viscosity_index"));
  c.lubricant.kinematic_viscosity = {{313.15, 3e-6}};  // below 2 mm2/s at 100 degC
  EXPECT_THAT(keys_at_fault(c), Contains("lubricant.viscosity_index"));
  c.lubricant.kinematic_viscosity = {{313.15, 73.30e-6}, {373.15, 8.86e-6}};
  EXPECT_THAT(keys_at_fault(c), Contains("lubricant.viscosity_index"));
}

TEST(CaseRules, AskForStepsThatMakeACycle) {
  Case c = sound_case();
  for (const double step : {1.0, 0.5, 0.1, 0.3, 720.0 / 7919.0}) {
    c.solver.crank_step_deg = step;
    EXPECT_THAT(keys_at_fault(c), IsEmpty()) << step;
  }
  c.solver.crank_step_deg = 0.7;
  EXPECT_THAT(keys_at_fault(c), Contains("solver.crank_step"));
}

TEST(CaseRules, RefuseFieldsThatWouldFillTheMemory) {
  Case c = sound_case();
  c.output.fields = FieldOutput::kAll;
  EXPECT_THAT(keys_at_fault(c), IsEmpty());
  c.output.crank_angle_step_deg = 0.01;
  EXPECT_THAT(keys_at_fault(c), Contains("output.fields"));
}

TEST(CaseRules, AskForValvesThatOpenBeforeTheyClose) {
  Case c = sound_case();
  c.gas.exhaust_valve_closing_deg = 100;
  c.gas.intake_valve_closing_deg = 340;
  EXPECT_THAT(keys_at_fault(c), Contains("gas.exhaust_valve_closing"));
  EXPECT_THAT(keys_at_fault(c), Contains("gas.intake_valve_closing"));
}

}  // namespace
}  // namespace ringfilm::cycle
