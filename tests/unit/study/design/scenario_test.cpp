#include "ringfilm/study/design/scenario.hpp"

#include "../study_example.hpp"

namespace ringfilm::study {
namespace {

using namespace testing;

/// What all factors make of the base; the message if it is refused.
struct Outcome {
  std::optional<cycle::Case> c;
  std::string refusal;
};

Outcome outcome(const Study& study, const std::vector<std::optional<double>>& values, std::size_t base = 0) {
  try {
    return {scenario_case(study, {base, values}), ""};
  } catch (const InputError& error) {
    return {std::nullopt, error.what()};
  }
}

TEST(Scenario, NumbersAreSetScaledAndAdded) {
  const Study study =
      study_of({factor("operating.speed", Levels{{100}}), factor("contact.roughness", Levels{{1}}, FactorMode::kScale),
                factor("operating.oil_temperature", Levels{{1}}, FactorMode::kAdd)});
  const cycle::Case& base = study.bases[0].input;
  const auto made = outcome(study, {200, 1.5, -10}).c;
  ASSERT_TRUE(made);
  EXPECT_EQ(made->operating.speed, 200);
  EXPECT_EQ(made->contact.roughness, 1.5 * base.contact.roughness);
  EXPECT_EQ(made->operating.oil_temperature, base.operating.oil_temperature - 10);
  EXPECT_EQ(made->stated.count("operating.speed"), 1u);
  const auto alone = outcome(study, {std::nullopt, 1, std::nullopt}).c;
  EXPECT_EQ(digest_text(*alone), digest_text(base)) << "what is left alone or scaled by 1 is the base";
}

TEST(Scenario, OneNumberMovesSeveralKeysEachByItsGain) {
  Study study = study_of({factor("calibration", normal(0, 1), FactorMode::kAdd)});
  study.bases.push_back({"run-in", coarse_case()});
  study.bases.push_back({"embedded", coarse_case()});
  const std::string key = "contact.boundary_shear_strength_coefficient";
  study.factors[0].targets = {{0, key, 0.01}, {1, key, 0.02}};
  const double zeta = study.bases[0].input.contact.boundary_shear_strength_coefficient;
  EXPECT_DOUBLE_EQ(outcome(study, {-2}, 0).c->contact.boundary_shear_strength_coefficient, zeta - 0.02);
  EXPECT_DOUBLE_EQ(outcome(study, {-2}, 1).c->contact.boundary_shear_strength_coefficient, zeta - 0.04);
  EXPECT_EQ(outcome(study, {-2}, 2).c->contact.boundary_shear_strength_coefficient, zeta);
  EXPECT_TRUE(applies(study.factors[0], 1));
  EXPECT_FALSE(applies(study.factors[0], 2));
}

TEST(Scenario, ListsAreScaledAsAWhole) {
  const Study study = study_of({factor("lubricant.kinematic_viscosity", Levels{{1}}, FactorMode::kScale),
                                factor("lubricant.density", Levels{{1}}, FactorMode::kScale),
                                factor("ring.face.coefficients", Levels{{1}}, FactorMode::kScale)});
  const cycle::Case& base = study.bases[0].input;
  const auto made = outcome(study, {1.1, 0.9, 2}).c;
  ASSERT_TRUE(made);
  ASSERT_GE(base.lubricant.kinematic_viscosity.size(), 2u);
  for (std::size_t i = 0; i < base.lubricant.kinematic_viscosity.size(); ++i) {
    EXPECT_EQ(made->lubricant.kinematic_viscosity[i].value, 1.1 * base.lubricant.kinematic_viscosity[i].value);
    EXPECT_EQ(made->lubricant.kinematic_viscosity[i].temperature, base.lubricant.kinematic_viscosity[i].temperature);
  }
  for (std::size_t i = 0; i < base.lubricant.density.size(); ++i)
    EXPECT_EQ(made->lubricant.density[i].value, 0.9 * base.lubricant.density[i].value);
  for (std::size_t i = 0; i < base.ring.face.coefficients.size(); ++i)
    EXPECT_EQ(made->ring.face.coefficients[i], 2 * base.ring.face.coefficients[i]);
}

TEST(Scenario, ANumberTakesThePlaceOfAListWhereTheKeyAllowsBoth) {
  const Study study = study_of({factor("lubricant.density", Levels{{1}})});
  const auto made = outcome(study, {840}).c;
  ASSERT_TRUE(made);
  EXPECT_EQ(made->lubricant.constant_density, 840);
  EXPECT_TRUE(made->lubricant.density.empty());
}

TEST(Scenario, ChoicesComeFirstWhateverTheirPlace) {
  Study study = study_of({factor("lubricant.kinematic_viscosity", Levels{{1}}, FactorMode::kScale),
                          factor("lubricant.file", Choices{{{"thin.toml", {}}}}),
                          factor("film.cavitation", Choices{{{"mass-conserving", {}}, {"reynolds-exit", {}}}})});
  study.readings.push_back({{1}, [](cycle::Case& c, std::size_t, const auto&) {
                              for (auto& point : c.lubricant.kinematic_viscosity)
                                point.value = 1e-3 / (point.temperature - 270);
                            }});
  const auto made = outcome(study, {3, 0, 1}).c;
  ASSERT_TRUE(made);
  const auto& first = made->lubricant.kinematic_viscosity.front();
  EXPECT_DOUBLE_EQ(first.value, 3e-3 / (first.temperature - 270));
  EXPECT_EQ(made->film.cavitation, cycle::Cavitation::kReynoldsExit);
  EXPECT_EQ(outcome(study, {3, 0, 0}).c->film.cavitation, cycle::Cavitation::kMassConserving);
}

TEST(Scenario, WhatIsSetIsThenScaledAndAddedTo) {
  const Study study = study_of({factor("offset", Levels{{1}}, FactorMode::kAdd, "operating.speed"),
                                factor("error", Levels{{1}}, FactorMode::kScale, "operating.speed"),
                                factor("speed", Levels{{1}}, FactorMode::kSet, "operating.speed")});
  EXPECT_DOUBLE_EQ(outcome(study, {7, 1.1, 100}).c->operating.speed, 117);
}

TEST(Scenario, WholeNumbersStayWhole) {
  const Study study = study_of({factor("solver.cells", Levels{{100, 200}})});
  EXPECT_EQ(outcome(study, {200}).c->solver.cells, 200);
  EXPECT_NE(outcome(study, {200.5}).refusal.find("solver.cells = 200.5 is not a whole number"), std::string::npos);
}

TEST(Scenario, ARefusalNamesFactorKeyAndRange) {
  Study study = study_of({factor("speed", normal(1, 1), FactorMode::kSet, "operating.speed"),
                          factor("modulus", normal(1, 1), FactorMode::kScale, "contact.composite_modulus"),
                          factor("rough", normal(1, 1), FactorMode::kAdd, "contact.roughness")});
  study.bases[0].input.contact.composite_modulus.reset();
  const std::string refusal = outcome(study, {-3, 1.1, -1}).refusal;
  EXPECT_NE(refusal.find("factor \"speed\": operating.speed = -3 rad/s is out of range"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("allowed is above 0 rad/s to 2094.4 rad/s"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("factor \"modulus\": contact.composite_modulus is not stated in this base"),
            std::string::npos);
  EXPECT_NE(refusal.find("factor \"rough\": contact.roughness = -1 m is out of range"), std::string::npos) << refusal;
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_NE(outcome(study, {infinity, std::nullopt, std::nullopt}).refusal.find("is not finite"), std::string::npos);
}

TEST(Scenario, RulesThatJoinKeysHoldForEachScenario) {
  const Study study = study_of({factor("engine.connecting_rod_length", Levels{{0.1}})});
  EXPECT_TRUE(outcome(study, {0.1}).c);
  EXPECT_NE(outcome(study, {0.03}).refusal.find("is not longer than the crank radius"), std::string::npos);
}

TEST(Scenario, ATraceIsNotReplacedByANumber) {
  Study study = study_of({factor("gas.crankcase_pressure", Levels{{1e5}}, FactorMode::kScale)});
  study.bases[0].input.gas.crankcase_pressure_file = "crankcase.csv";
  EXPECT_NE(outcome(study, {1.1}).refusal.find("is read from a file"), std::string::npos);
}

TEST(Scenario, APlanOfWhichNothingCanRunIsRefusedBeforehand) {
  // The base has an elastic pressure: the tension of the ring would be stated twice.
  const Plan twice(study_of({factor("ring.tangential_force", uniform(5, 15))}));
  try {
    check_scenarios(twice);
    FAIL() << "nothing of it can run";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no scenario of base \"new\" can be run, of 16 tried"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("the tension of the ring is stated twice"), std::string::npos);
  }
  const Plan absent(study_of({factor("ring.tangential_force", uniform(0.9, 1.1), FactorMode::kScale)}));
  EXPECT_THROW(check_scenarios(absent), InputError);
  // Some speeds below zero are rows with a reason.
  EXPECT_NO_THROW(check_scenarios(Plan(study_of({factor("operating.speed", normal(100, 90))}))));
  // The only good one is the last.
  EXPECT_NO_THROW(check_scenarios(
      Plan(study_of({factor("operating.speed", Levels{{-900, -800, -700, 100}}, FactorMode::kAdd)}, Method::kGrid))));
}

TEST(Scenario, EveryKeyReportsHowItTakesANumber) {
  // A key of a kind that is not known here would throw.
  std::set<Entry> seen;
  for (const cycle::Field& field : cycle::case_fields()) seen.insert(entry_of(field));
  EXPECT_EQ(seen.size(), 5u);
  EXPECT_EQ(entry_of(*cycle::find_field("engine.bore")), Entry::kAnyNumber);
  EXPECT_EQ(entry_of(*cycle::find_field("solver.cells")), Entry::kWholeNumber);
  EXPECT_EQ(entry_of(*cycle::find_field("lubricant.file")), Entry::kText);
  EXPECT_TRUE(is_file(*cycle::find_field("lubricant.file")));
  EXPECT_FALSE(is_file(*cycle::find_field("film.cavitation")));
}

TEST(Scenario, DigestTextDistinguishesCases) {
  const cycle::Case base = coarse_case();
  cycle::Case other = base;
  other.contact.roughness *= 1 + 1e-15;
  EXPECT_TRUE(digest_text(base) != digest_text(other)) << "to the last digit";
  other = base;
  other.files.push_back({"gas.cylinder_pressure", "p.csv", "abc"});
  EXPECT_TRUE(digest_text(base) != digest_text(other));
  other = base;
  other.film.cavitation = cycle::Cavitation::kMassConserving;
  EXPECT_TRUE(digest_text(base) != digest_text(other));
  EXPECT_EQ(digest_text(base), digest_text(cycle::Case(base)));
}

// All keys that name files, of whatever kind: a case that is read from another folder names them otherwise.
TEST(Scenario, DigestTextCountsFilesByTheirContentsNotByTheirNames) {
  cycle::Case near = coarse_case();
  near.lubricant.file = "oil.toml";
  near.files.push_back({"lubricant.file", "oil.toml", "abc"});
  cycle::Case far = near;
  far.lubricant.file = "../there/oil.toml";
  far.files.back().path = "../there/oil.toml";
  for (const cycle::Field& field : cycle::case_fields()) {
    if (const auto* file = std::get_if<cycle::FileKind>(&field.kind)) {
      file->ref(near) = "a.csv";
      file->ref(far) = "../there/a.csv";
    } else if (const auto* optional = std::get_if<cycle::OptionalFileKind>(&field.kind)) {
      optional->ref(near) = "a.csv";
      optional->ref(far) = "../there/a.csv";
    } else if (const auto* either = std::get_if<cycle::OptionalNumberOrFileKind>(&field.kind)) {
      either->ref(near).file = "a.csv";
      either->ref(far).file = "../there/a.csv";
    } else if (const auto* number = std::get_if<cycle::NumberOrFileKind>(&field.kind)) {
      number->file(near) = "a.csv";
      number->file(far) = "../there/a.csv";
    }
  }
  EXPECT_EQ(digest_text(near), digest_text(far));
  EXPECT_EQ(digest_text(near).find(".csv"), std::string::npos);
  far.files.back().sha256 = "abd";
  EXPECT_NE(digest_text(near), digest_text(far));
  far = near;
  far.lubricant.file.reset();
  EXPECT_NE(digest_text(near), digest_text(far));
}

}  // namespace
}  // namespace ringfilm::study
