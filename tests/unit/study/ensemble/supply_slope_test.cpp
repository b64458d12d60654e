#include "ringfilm/study/ensemble/supply_slope.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../study_case.hpp"
#include "ringfilm/case/conditions.hpp"

namespace {

using namespace ringfilm;
using ::testing::HasSubstr;

cycle::Case engine_ring() {
  cycle::Case c = study::testing::coarse_case();
  cycle::set_conditions(cycle::Conditions::kEngine, c);
  c.stated.erase("supply.film");
  return c;
}

/// How cases with these FMEP [Pa] ended.
std::vector<study::Ending> endings_with(const std::vector<double>& fmep) {
  std::vector<study::Ending> ended(fmep.size());
  for (std::size_t i = 0; i < fmep.size(); ++i) ended[i].result.values.fmep = fmep[i];
  return ended;
}

std::string note_with(const cycle::Case& c, const std::vector<double>& fmep) {
  const auto note = study::supply_note(c, endings_with(fmep));
  return note ? note->message : "";
}

TEST(SupplySlope, CasesChangeTheFilmAloneByAFifthAndToTheEndsOfTheBandOfADefault) {
  const cycle::Case c = engine_ring();
  const auto cases = study::supply_cases(c);
  ASSERT_EQ(cases.size(), 5u);
  const std::vector<double> films = {0.8e-6, 0.64e-6, 0.96e-6, 0.4e-6, 0.8e-6};
  for (std::size_t i = 0; i < films.size(); ++i) EXPECT_NEAR(cases[i].supply.film.front().value, films[i], 1e-15);
  cycle::Case stated = c;
  stated.stated.insert("supply.film");
  EXPECT_EQ(study::supply_cases(stated).size(), 3u);
}

TEST(SupplySlope, AFloodedRingHasNoCases) { EXPECT_TRUE(study::supply_cases(study::testing::coarse_case()).empty()); }

TEST(SupplySlope, ASteepFrictionIsNotedWithBothSides) {
  cycle::Case c = engine_ring();
  c.stated.insert("supply.film");
  const std::string steep = note_with(c, {5000, 6350, 4250});
  EXPECT_THAT(steep, HasSubstr("supply.film (0.8 um)"));
  EXPECT_THAT(steep, HasSubstr("with 20 % less oil on the liner the FMEP is 27 % higher, with 20 % more 15 % lower"));
  EXPECT_EQ(note_with(c, {5000, 5200, 4800}), "");  // 4 %
  EXPECT_NE(note_with(c, {5000, 5300, 5000}), "");  // on one side
}

TEST(SupplySlope, OfADefaultTheNoteHasTheBand) {
  EXPECT_THAT(
      note_with(engine_ring(), {5000, 6350, 4250, 7780, 5000}),
      HasSubstr("between 0.4 um and 0.8 um, what packs leave at 1000 to 4000 rpm, it lies between 5 and 7.78 kPa"));
}

TEST(SupplySlope, WhereACaseWasNotSolvedThereIsNoNote) {
  auto ended = endings_with({5000, 9000, 3000, 9000, 3000});
  ended[1].refusal = InputError("refused");
  EXPECT_FALSE(study::supply_note(engine_ring(), ended));
}

}  // namespace
