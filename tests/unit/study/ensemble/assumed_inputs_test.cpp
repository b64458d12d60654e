#include "ringfilm/study/ensemble/assumed_inputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "../study_case.hpp"
#include "ringfilm/case/conditions.hpp"

namespace {

using namespace ringfilm;
using study::AssumedInput;

AssumedInput input(const char* key, double fmep_change, bool solved = true) {
  return {key, "", true, "", fmep_change, 0, solved};
}

TEST(AssumedInputs, TheLargestChangeEitherWayIsTheFirstAndWhatWasNotSolvedTheLast) {
  std::vector<AssumedInput> inputs = {input("a", 0.01), input("b", 9, false), input("c", -0.2), input("d", 0.1)};
  study::rank(inputs);
  std::vector<std::string> keys;
  for (const AssumedInput& one : inputs) keys.push_back(one.key);
  EXPECT_THAT(keys, ::testing::ElementsAre("c", "d", "a", "b"));
}

TEST(AssumedInputs, AStarvedRingBetweenGasIsQuickAndAFloodedOneIsNot) {
  cycle::Case c = study::testing::coarse_case();
  EXPECT_FALSE(study::is_quick(c));
  EXPECT_EQ(study::coarse_case(c).solver.method, cycle::Method::kCoupledNewton);
  cycle::set_conditions(cycle::Conditions::kEngine, c);
  c.ring.face = {};
  c.ring.face.form = cycle::FaceForm::kParabola;
  c.ring.face.crown_height = 6e-6;
  EXPECT_TRUE(study::is_quick(c));
  EXPECT_EQ(study::coarse_case(c).solver.method, cycle::Method::kMenisci);
}

TEST(AssumedInputs, ACoarseCaseIsNotFinerThanTheCaseItself) {
  cycle::Case c = study::testing::coarse_case();
  c.solver.cells = 30;
  c.solver.step_error = 1e-2;
  const cycle::Case coarse = study::coarse_case(c);
  EXPECT_EQ(coarse.solver.cells, 30);
  EXPECT_EQ(coarse.solver.step_error, 1e-2);
  EXPECT_EQ(coarse.output.fields, cycle::FieldOutput::kNone);
}

}  // namespace
