#include "ringfilm/life/life.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../cycle/styles_case.hpp"
#include "ringfilm/life/duty_batch.hpp"
#include "ringfilm/life/life_quantities.hpp"

namespace ringfilm::life {
namespace {

using ::testing::HasSubstr;

Life two_states() {
  Life life;
  const cycle::Case c = cycle::testing::styles_new_ring();
  life.points = {{"duty", 1, c}};
  life.times = {{0, {"life.toml", 1, 1, ""}}, {kHour, {"life.toml", 2, 1, ""}}};
  life.states = {{0, c, {"life.toml", 3, 1, ""}}, {10 * kHour, c, {"life.toml", 4, 1, ""}}};
  return life;
}

std::string refusal(const Life& life) {
  const std::vector<Fault> faults = faults_of(life);
  return faults.empty() ? "" : describe(faults);
}

TEST(Life, OneWithStatesInTheirOrderIsAccepted) { EXPECT_EQ(refusal(two_states()), ""); }

TEST(Life, StatesOutOfOrderAreRefusedAtTheirPlace) {
  Life life = two_states();
  std::swap(life.states[0].time, life.states[1].time);
  EXPECT_THAT(refusal(life), HasSubstr("life.toml:4:1: the state after 0 h follows that after 10 h"));
}

TEST(Life, TwoStatesOfOneTimeAreRefused) {
  Life life = two_states();
  life.states[1].time = 0;
  EXPECT_THAT(refusal(life), HasSubstr("two states have the running time 0 h"));
}

TEST(Life, APathNeedsTwoStates) {
  Life life = two_states();
  life.states.pop_back();
  EXPECT_THAT(refusal(life), HasSubstr("at least two measured states, not 1"));
}

TEST(Life, HoursBeforeTheFirstStateAreRefused) {
  Life life = two_states();
  life.states[0].time = 0.5 * kHour;
  EXPECT_THAT(refusal(life), HasSubstr("life.toml:1:1: the running time 0 h is before the first state, after 0.5 h"));
}

TEST(Life, HoursThatDoNotRiseAreRefused) {
  Life life = two_states();
  life.times[1].time = 0;
  EXPECT_THAT(refusal(life), HasSubstr("the running time 0 h does not follow 0 h"));
}

TEST(Life, RingsOfAnotherWidthAreRefused) {
  Life life = two_states();
  life.states[1].input.ring.face_width = 1e-3;
  EXPECT_THAT(refusal(life), HasSubstr("a face of 1 mm, that of the base case one of 1.2 mm"));
}

TEST(Life, ACaseWhoseFaceHasNodesOfItsOwnIsRefused) {
  Life by_gap = two_states();
  by_gap.states[1].input.solver.cell_lengths = cycle::CellLengths::kByGap;
  EXPECT_THAT(refusal(by_gap), HasSubstr("life.toml:4:1: the state after 10 h states solver.cell_lengths"));
  Life accurate = two_states();
  accurate.points[0].input.solver.accuracy = 1.0;
  EXPECT_THAT(refusal(accurate), HasSubstr("the base case states solver.accuracy"));
}

TEST(Life, HoursBeyondACenturyAreRefused) {
  Life life = two_states();
  life.times[1].time = 1e300;
  EXPECT_THAT(refusal(life), HasSubstr("is more than a century"));
}

TEST(Life, AFaceOfOneDatumThatGainsMaterialIsRefusedAtItsState) {
  Life life = two_states();
  life.datum = Datum::kCommon;
  EXPECT_EQ(refusal(life), "");
  std::vector<double>& coefficients = life.states[1].input.ring.face.coefficients;
  coefficients.back() += 2;  // um farther from the liner: lost
  EXPECT_EQ(refusal(life), "");
  coefficients.back() -= 5;
  EXPECT_THAT(refusal(life), HasSubstr("life.toml:4:1: the face after 10 h has gained 3 um of material"));
}

TEST(Life, FacesBetweenWhichNothingNeedBeLostFitNoCoefficient) {
  Life life = two_states();
  life.mode = Mode::kArchard;
  life.wear.source = CoefficientSource::kFitted;
  EXPECT_THAT(refusal(life), HasSubstr("nothing need have been lost: no wear coefficient can be fitted"));
  life.states[1].input.ring.face.coefficients.back() += 2;
  EXPECT_THAT(refusal(life), HasSubstr("nothing need have been lost"));
  life.states[1].input.ring.face.coefficients[0] *= 0.9;
  EXPECT_EQ(refusal(life), "");
}

Life fitted() {
  Life life = two_states();
  life.mode = Mode::kArchard;
  life.wear.source = CoefficientSource::kFitted;
  life.states[1].input.ring.face.coefficients[0] *= 0.9;
  return life;
}

TEST(Life, AFitOfASurfaceThatFollowsThePathIsRefused) {
  Life life = fitted();
  EXPECT_EQ(refusal(life), "");
  life.wear.surface = WornSurface::kPath;
  EXPECT_THAT(refusal(life), HasSubstr("wear.surface = \"path\" cannot be combined with coefficient = \"fit\""));
}

TEST(Life, AFitStartsFromTheFaceOfTheBaseCase) {
  Life life = fitted();
  life.points[0].input.ring.face.coefficients[0] *= 0.95;
  EXPECT_THAT(refusal(life), HasSubstr("life.toml:3:1: the face of the base case and that of the first state differ"));
}

Life running_in() {
  Life life = two_states();
  life.states.clear();
  life.mode = Mode::kArchard;
  life.wear.coefficient = 1e-19;
  life.wear.liner_coefficient = 1e-16;
  life.running_in = {0.35e-6, 0.1e-6, RunningInSurface::kLiner, {}, {}, {}};
  life.running_in->mark = {"life.toml", 5, 1, ""};
  life.running_in->limit_mark = {"life.toml", 6, 1, ""};
  life.running_in->scale_mark = {"life.toml", 7, 1, ""};
  return life;
}

TEST(Life, ARoughnessRunsInToALimitBelowThatOfTheCase) {
  Life life = running_in();
  EXPECT_EQ(refusal(life), "");
  life.running_in->roughness_limit = 0.5e-6;
  EXPECT_THAT(refusal(life), HasSubstr("life.toml:6:1: running_in.roughness_limit = 0.5 um is not below"));
}

TEST(Life, PeaksThatWouldLoseMoreThanIsWornAreRefused) {
  Life life = running_in();
  life.running_in->depth_scale = 0.05e-6;
  EXPECT_THAT(refusal(life), HasSubstr("life.toml:7:1: running_in.depth_scale = 0.05 um would take more material"));
}

TEST(Life, ARoughnessRunsInWithTheDepthOfASurfaceThatWears) {
  Life life = running_in();
  life.wear.liner_coefficient.reset();
  EXPECT_THAT(refusal(life), HasSubstr("life.toml:5:1: [running_in] smooths the liner"));
  life.running_in->surface = RunningInSurface::kRing;
  EXPECT_EQ(refusal(life), "");
}

TEST(Life, AMeasuredContactLawHasNoRoughnessToRunIn) {
  Life life = running_in();
  life.points[0].input.contact.model = cycle::ContactLaw::kTable;
  EXPECT_THAT(refusal(life), HasSubstr("the contact law of a measured pair (contact.model = \"table\") has none"));
}

TEST(LifeQuantities, APointWithoutAShareChangesNothing) {
  Life life = two_states();
  life.points.push_back({"beside", 0, life.points[0].input});
  const LifeValues of_the_duty(life_quantities().size(), 0.1), beside(life_quantities().size(), -7);
  EXPECT_EQ(n_duty_points(life), 1u);
  EXPECT_EQ(of_duty(life, {of_the_duty, beside}), of_the_duty);
}

TEST(LifeQuantities, APointAloneKeepsItsBits) {
  const LifeValues values(life_quantities().size(), 0.1);
  EXPECT_EQ(combined({{1, 1, values}}), values);
}

TEST(LifeQuantities, PointsAreWeightedByTimeOrCyclesOrTakenAtTheirExtreme) {
  const std::size_t n = life_quantities().size();
  const LifeValues all = combined({{0.25, 0.1, LifeValues(n, 1)}, {0.75, 0.9, LifeValues(n, 3)}});
  for (std::size_t i = 0; i < n; ++i) {
    switch (life_quantities()[i].combination) {
      case Combination::kTimeMean:
        EXPECT_DOUBLE_EQ(all[i], 2.5);
        break;
      case Combination::kCycleMean:
        EXPECT_DOUBLE_EQ(all[i], 2.8);
        break;
      case Combination::kMin:
        EXPECT_EQ(all[i], 1);
        break;
      case Combination::kMax:
        EXPECT_EQ(all[i], 3);
    }
  }
}

}  // namespace
}  // namespace ringfilm::life
