#include "ringfilm/study/design/study_values.hpp"

#include "../study_example.hpp"

/// Which values a study has.
namespace ringfilm::study {
namespace {

using namespace testing;

/// A study of one ring whose oil on the liner is followed.
Study study_with_oil(std::vector<Factor> factors = {}) {
  Study study = study_of(std::move(factors));
  cycle::Case& base = study.bases.front().input;
  base.film.chamber_edge = base.film.crankcase_edge = cycle::EdgeFluid::kGas;
  base.film.supply = cycle::OilSupply::kFilmOnLiner;
  return study;
}

StudyValues values_of(const Study& study) { return study_values(study, study.bases.front().input); }

TEST(StudyValues, HaveTheOilConsumptionWhereTheOilIsFollowed) {
  const StudyValues values = values_of(study_with_oil());
  EXPECT_TRUE(values.index("oil_consumption"));
  EXPECT_TRUE(values.index("oil_thrown_off"));
  EXPECT_EQ(values.main.back(), "oil_consumption");
  EXPECT_FALSE(values_of(study_of({})).index("oil_consumption")) << "a flooded ring has none";
}

TEST(StudyValues, HaveThatOfTheEngineWhereItsKeysAreStated) {
  EXPECT_FALSE(values_of(study_with_oil()).index("oil_consumption_engine"));
  Study study = study_with_oil({factor("operating.brake_power", Levels{{25e3}})});
  study.bases.front().input.engine.cylinders = 4;
  study.bases.front().input.stated.insert("engine.cylinders");
  const StudyValues values = values_of(study);
  EXPECT_TRUE(values.index("oil_consumption_engine"));
  EXPECT_TRUE(values.index("oil_consumption_brake_specific")) << "each point of a list has a power of its own";
  EXPECT_FALSE(values.index("oil_consumption_fuel_share"));
}

TEST(StudyValues, OfARingWithItsOilAreNotThoseOfALane) {
  const Study study = study_with_oil();
  EXPECT_FALSE(is_one_film(study, study.bases.front().input));
  EXPECT_TRUE(is_one_film(study, study_of({}).bases.front().input));
}

}  // namespace
}  // namespace ringfilm::study
