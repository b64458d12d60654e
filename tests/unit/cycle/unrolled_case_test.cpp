#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/advice/advice.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/integration/cycle_film.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "unrolled_cases.hpp"

/// Keys and rules of a film on the unrolled ring.
namespace ringfilm::cycle::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> keys_at_fault(const Case& c) {
  std::vector<std::string> keys;
  for (const RuleBreach& breach : broken_rules(c)) keys.push_back(breach.key);
  return keys;
}

std::string message(const Case& c, const std::string& key) {
  for (const RuleBreach& breach : broken_rules(c)) {
    if (breach.key == key) return breach.message + "; " + breach.remedy;
  }
  return "nothing is wrong";
}

bool active(const std::string& key, const Case& c) { return is_active(*find_field(key), c); }

TEST(UnrolledCase, KeysCountOnlyWithTheUnrolledFilm) {
  const Case face = styles_new_ring();
  const Case ring = unrolled_ring();
  for (const char* key : {"ring.end_gap", "ring.gap_position", "solver.cells_y", "solver.end_cell"}) {
    EXPECT_FALSE(active(key, face)) << key;
    EXPECT_TRUE(active(key, ring)) << key;
  }
  Case closed = ring;
  closed.ring.end_gap.reset();
  EXPECT_TRUE(active("solver.cells_y", closed));
  EXPECT_FALSE(active("ring.gap_position", closed));
  EXPECT_FALSE(active("solver.end_cell", closed));
  Case with_fields = ring;
  EXPECT_FALSE(active("output.reduction", with_fields));
  with_fields.output.fields = FieldOutput::kAll;
  EXPECT_TRUE(active("output.reduction", with_fields));
}

TEST(UnrolledCase, SatisfiesTheRulesUnchanged) { EXPECT_THAT(keys_at_fault(unrolled_ring()), IsEmpty()); }

TEST(UnrolledCase, RefusesAGapThatLeavesNothingOfTheRing) {
  Case c = unrolled_ring();
  c.ring.end_gap = std::numbers::pi * c.engine.bore;
  EXPECT_THAT(message(c, "ring.end_gap"), HasSubstr("279.602 mm is not below the circumference"));
  c.ring.end_gap = 0.5;
  EXPECT_THAT(message(c, "ring.end_gap"), HasSubstr("500 mm"));
  c.film.dimension = FilmDimension::kFace;  // not in use
  EXPECT_THAT(keys_at_fault(c), IsEmpty());
}

TEST(UnrolledCase, RefusesMethodsThatKnowNoUnrolledFilm) {
  Case c = unrolled_ring();
  c.solver.method = Method::kPointRelaxation;
  EXPECT_THAT(keys_at_fault(c), Contains("solver.method"));
}

TEST(UnrolledCase, RefusesEndCellsLongerThanCellsThatAreAllAlike) {
  Case c = unrolled_ring();
  c.solver.end_cell = c.ring_length() / c.solver.cells_y * (1 + 1e-9);
  EXPECT_THAT(keys_at_fault(c), Contains("solver.end_cell"));
  c.solver.end_cell = c.ring_length() / c.solver.cells_y * (1 - 1e-9);
  EXPECT_THAT(keys_at_fault(c), IsEmpty());
}

bool reports_long_end_cells(const Case& c) {
  const std::vector<Note> notes = advice(prepare(c));
  return std::any_of(notes.begin(), notes.end(), [](const Note& note) { return note.topic == "end-cells-long"; });
}

TEST(UnrolledCase, RefusesEndCellsLongerThanTheFaceIsWideAndReportsHowManyWouldDo) {
  Case c = unrolled_ring();
  c.solver.cells_y = 20;
  EXPECT_THAT(message(c, "solver.cells_y"), HasSubstr("mm long, more than the face is wide"));
  const std::string reported = message(c, "solver.cells_y");
  c.solver.cells_y = std::stoi(reported.substr(reported.find("; take ") + 7));
  EXPECT_LE(strips_of(c).spacing.front(), 1.1 * c.end_cell());  // longer than that is reported
  EXPECT_FALSE(reports_long_end_cells(c));
  --c.solver.cells_y;
  EXPECT_GT(strips_of(c).spacing.front(), 1.1 * c.end_cell());
}

TEST(UnrolledCase, ReportsLongEndCellsBeforeItIsIntegrated) {
  Case c = unrolled_ring();
  c.solver.cells_y = 40;
  ASSERT_THAT(keys_at_fault(c), IsEmpty());
  EXPECT_TRUE(reports_long_end_cells(c));
}

TEST(UnrolledCase, RefusesWhatWouldFillTheMemoryAndStatesTheMemory) {
  Case c = unrolled_ring();
  c.output.fields = FieldOutput::kAll;
  // 720 angles of 201 x 181 nodes, 16 bytes each
  EXPECT_THAT(message(c, "output.fields"), HasSubstr("419.109 MB"));
  EXPECT_THAT(message(c, "output.fields"), HasSubstr("along-face"));
  c.output.reduction = FieldReduction::kAlongFace;
  EXPECT_THAT(keys_at_fault(c), IsEmpty());
  c.output.reduction = FieldReduction::kNone;
  c.output.fields = FieldOutput::kListed;
  c.output.field_angles_deg = {0, 20, 90};
  EXPECT_THAT(keys_at_fault(c), IsEmpty());
  c.solver.cells = 100000;
  c.solver.cells_y = 100000;
  EXPECT_THAT(keys_at_fault(c), Contains("solver.cells_y"));
}

TEST(UnrolledCase, EndsItsRingAtTheGapAndRefinesTheCellsThere) {
  Case c = unrolled_ring();
  EXPECT_DOUBLE_EQ(c.ring_length(), std::numbers::pi * 0.089 - 0.3e-3);
  const film::CircumferentialGrid open = strips_of(c);
  EXPECT_EQ(open.ends, film::Ends::kOpen);
  EXPECT_EQ(open.n_strips(), 181);
  EXPECT_EQ(open.y.back(), c.ring_length());
  EXPECT_NEAR(open.spacing.front() / (c.ring.face_width / 50), 1, 0.1);  // the grid is fitted to the length
  c.ring.end_gap.reset();
  const film::CircumferentialGrid joined = strips_of(c);
  EXPECT_EQ(joined.ends, film::Ends::kJoined);
  EXPECT_EQ(joined.n_strips(), 180);
  EXPECT_DOUBLE_EQ(joined.length, std::numbers::pi * 0.089);
}

TEST(UnrolledCase, ItsEndsHaveTheMeanOfThePressuresAtTheEdges) {
  film::FilmInputs inputs;
  inputs.left.pressure = 40e5;
  inputs.right.pressure = 1e5;
  const film::Film2dInputs film2d = film2d_inputs(inputs);
  EXPECT_EQ(film2d.p_low, 20.5e5);
  EXPECT_EQ(film2d.p_high, 20.5e5);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
