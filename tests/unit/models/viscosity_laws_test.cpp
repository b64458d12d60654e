#include "ringfilm/models/oil/viscosity_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "ringfilm/base/error.hpp"

namespace {

using namespace ringfilm::models;

/// The viscosity of an oil of 39 mPa s under a law [Pa s].
double viscosity(ViscosityPressureLaw law, const LawParameters& parameters, double p) {
  double eta = 0, slope = 0;
  viscosity_law(law).curve({0.039, 0.039, parameters})->viscosity({&p, 1}, {&eta, 1}, {&slope, 1});
  return eta;
}

TEST(ViscosityLaws, AreNamedOnceAndDescribed) {
  std::set<std::string> names, equations;
  for (const ViscosityLaw& law : viscosity_laws()) {
    EXPECT_TRUE(names.insert(law.name).second) << law.name;
    EXPECT_TRUE(equations.insert(law.equation).second) << law.name << ": " << law.equation;
    EXPECT_FALSE(law.meaning.empty()) << law.name;
    EXPECT_EQ(law.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos) << law.name;
    EXPECT_EQ(law.equation.rfind("eq-", 0), 0u) << law.name;
    ASSERT_NE(law.curve, nullptr) << law.name;
  }
}

TEST(ViscosityLaws, AreWhereTheProgramLooksForThem) {
  EXPECT_EQ(viscosity_law(ViscosityPressureLaw::kRoelands).name, "roelands");
  EXPECT_EQ(viscosity_law(ViscosityPressureLaw::kNone).name, "none");
  EXPECT_EQ(viscosity_law(ViscosityPressureLaw::kBarus).name, "barus");
}

TEST(ViscosityLaws, HaveParametersWithUnitMeaningAndAValueInTheirRange) {
  for (const LawParameter& parameter : law_parameters()) {
    EXPECT_LT(parameter.low, parameter.high) << parameter.key;
    EXPECT_GE(parameter.usual, parameter.low) << parameter.key;
    EXPECT_LE(parameter.usual, parameter.high) << parameter.key;
    EXPECT_FALSE(parameter.unit.empty() || parameter.display_unit.empty()) << parameter.key;
    EXPECT_FALSE(parameter.meaning.empty() || parameter.example.empty()) << parameter.key;
    EXPECT_EQ(parameter.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos)
        << parameter.key;
  }
}

TEST(ViscosityLaws, AgreeOnAParameterThatTheyShare) {
  for (const LawParameter& shared : law_parameters()) {
    for (const ViscosityLaw& law : viscosity_laws()) {
      for (const LawParameter& parameter : law.parameters) {
        if (parameter.key != shared.key) continue;
        EXPECT_EQ(parameter.unit, shared.unit) << law.name << " " << shared.key;
        EXPECT_EQ(parameter.display_unit, shared.display_unit) << law.name << " " << shared.key;
        EXPECT_EQ(parameter.low, shared.low) << law.name << " " << shared.key;
        EXPECT_EQ(parameter.high, shared.high) << law.name << " " << shared.key;
        EXPECT_EQ(parameter.usual, shared.usual) << law.name << " " << shared.key;
        EXPECT_EQ(parameter.statement, shared.statement) << law.name << " " << shared.key;
        EXPECT_EQ(parameter.meaning, shared.meaning) << law.name << " " << shared.key;
        EXPECT_EQ(parameter.example, shared.example) << law.name << " " << shared.key;
      }
    }
  }
}

TEST(ViscosityLaws, AskOnlyForTheParametersThatTheyList) {
  for (const ViscosityLaw& law : viscosity_laws()) {
    LawParameters listed;
    for (const LawParameter& parameter : law.parameters) listed[parameter.key] = parameter.usual;
    EXPECT_NO_THROW(law.curve({0.01, 0.02, listed})) << law.name;
    for (const LawParameter& parameter : law.parameters) {
      EXPECT_TRUE(takes(law, parameter.key)) << law.name;
      LawParameters too_few = listed;
      too_few.erase(parameter.key);
      EXPECT_THROW(law.curve({0.01, 0.02, too_few}), std::out_of_range)
          << law.name << " lists " << parameter.key << " and does not use it";
    }
    EXPECT_FALSE(takes(law, "no_such_parameter"));
  }
}

TEST(Barus, GrowsByAFactorOfEInOneReciprocalOfItsCoefficient) {
  const LawParameters alpha{{"pressure_viscosity_coefficient", 2e-8}};
  EXPECT_DOUBLE_EQ(viscosity(ViscosityPressureLaw::kBarus, alpha, 0), 0.039);
  EXPECT_NEAR(viscosity(ViscosityPressureLaw::kBarus, alpha, 5e7) / 0.039, std::exp(1.0), 1e-14);
}

TEST(Roelands, WithoutACoefficientIsConstant) {
  const LawParameters alpha{{"pressure_viscosity_coefficient", 0.0}};
  for (const double p : {0.0, 1e7, 1e9}) EXPECT_EQ(viscosity(ViscosityPressureLaw::kRoelands, alpha, p), 0.039);
}

}  // namespace
