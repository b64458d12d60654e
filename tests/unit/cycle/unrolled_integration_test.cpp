#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "batch_cases.hpp"
#include "unrolled_cases.hpp"

/// The integration of a film on the unrolled ring.
namespace ringfilm::cycle::testing {
namespace {

Case small(Case c) {
  c.solver.cells = 40;
  c.solver.cells_y = 12;
  c.solver.crank_step_deg = 4;
  c.output.crank_angle_step_deg = 4;
  return c;
}

Case closed_ring() {
  Case c = small(unrolled_ring());
  c.ring.end_gap.reset();
  return c;
}

Case face_of(Case c) {
  c.film.dimension = FilmDimension::kFace;
  return c;
}

/// Largest difference in a value of the cycle that does not jump, by its fair scale.
double largest_difference(const CycleResult& a, const CycleResult& b) { return difference(a, {}, b, {}).largest; }

TEST(UnrolledIntegration, AClosedRingIsTheFilmAcrossTheFace) {
  for (const Cavitation cavitation : {Cavitation::kReynoldsExit, Cavitation::kMassConserving}) {
    for (const Orientation orientation : {Orientation::kX0Chamber, Orientation::kLeadingEdge}) {
      Case c = closed_ring();
      c.film.cavitation = cavitation;
      c.ring.face.orientation = orientation;
      const CycleResult face = simulated(face_of(c));
      const CycleResult ring = simulated(c);
      EXPECT_EQ(ring.effort.crank_steps, face.effort.crank_steps);
      // Both iterations may leave solver.tolerance, 1e-8, at each step; a value of the cycle is made of hundreds.
      EXPECT_LT(largest_difference(ring, face), 1e-7);
      ASSERT_EQ(ring.samples.size(), face.samples.size());
      for (std::size_t k = 0; k < face.samples.size(); ++k) {
        EXPECT_NEAR(ring.samples[k].min_film_thickness / face.samples[k].min_film_thickness, 1, 1e-7);
        EXPECT_EQ(ring.unrolled_samples[k].gap_leakage, 0);
        EXPECT_NEAR(ring.unrolled_samples[k].ends_share_load, 0, 1e-8);  // what the iteration may leave
      }
      EXPECT_TRUE(face.unrolled.is_absent());
      EXPECT_EQ(ring.unrolled.y.size(), 12u);
    }
  }
}

TEST(UnrolledIntegration, AdaptiveStepsOfAClosedRingAreThoseOfTheFace) {
  Case c = closed_ring();
  c.film.cavitation = Cavitation::kMassConserving;
  c.solver.crank_step_control = StepControl::kAdaptive;
  const CycleResult face = simulated(face_of(c));
  const CycleResult ring = simulated(c);
  EXPECT_EQ(ring.effort.crank_steps, face.effort.crank_steps);
  EXPECT_GT(ring.effort.sub_steps, 100);
  EXPECT_LT(largest_difference(ring, face), 1e-7);
}

TEST(UnrolledIntegration, AGapLeaksWhatTheFilmTakesInAndDoesNotGiveBack) {
  Case c = testing::by_backward_euler(small(unrolled_ring()));
  c.film.cavitation = Cavitation::kMassConserving;
  c.solver.tolerance = 1e-12;
  const CycleResult result = simulated(c);
  // A last step is below a millionth of the pressures and GMRES leaves at most a millionth of it: 1e-12 of the terms of
  // a balance, which are up to some hundred times the flow that passes.
  EXPECT_LT(result.effort.max_mass_residual, 1e-9);
  double taken = 0, leaked = 0, leaked_either_way = 0, scale = 0;
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    taken += result.samples[k].oil_flow_chamber_edge - result.samples[k].oil_flow_crankcase_edge;
    leaked += result.unrolled_samples[k].gap_leakage;
    leaked_either_way += std::abs(result.unrolled_samples[k].gap_leakage);
    scale += std::abs(result.samples[k].oil_flow_middle);
    const UnrolledSample& s = result.unrolled_samples[k];
    EXPECT_NEAR(s.gap_leakage_low_end, s.gap_leakage_high_end, 1e-6 * std::abs(s.gap_leakage) + 1e-15);
  }
  EXPECT_GT(leaked_either_way / scale, 1e-5);
  EXPECT_NEAR((taken - leaked) / scale, 0, 1e-11);  // steps one way and the other average out
}

// Converged in y, 200 x 300 cells with ends of 12 um: -0.019 % of the load, -0.012 % of the flow, and against the face
// -0.001 % of the thinnest film, -0.081 % of the power and -0.171 % of the flow, 0.107 % of both for the length of the
// gap (docs/manual/unrolled.md). Sixty cells with ends of 24 um are within 0.001 % of it there; the bounds leave that
// much again for 40 cells across, which move all of the ends' film a little, and what the table rounds.
TEST(UnrolledIntegration, WhatTheEndsChangeIsWhatAFineMeshStates) {
  Case c = small(unrolled_ring());
  c.solver.cells_y = 60;
  const CycleResult face = simulated(face_of(c));
  const CycleResult ring = simulated(c);
  const UnrolledValues& ends = ring.unrolled_values;
  const double fewer = -c.ring.end_gap.value() / (c.ring_length() + c.ring.end_gap.value());
  EXPECT_NEAR(fewer, -0.107e-2, 0.001e-2);
  constexpr double kOfMesh = 0.003e-2;
  EXPECT_NEAR(ends.ends_share_mean_load, -0.019e-2, kOfMesh);
  EXPECT_NEAR(ends.ends_share_friction_power, 0, kOfMesh);
  EXPECT_NEAR(ends.ends_share_absolute_flow, -0.012e-2, kOfMesh);
  EXPECT_NEAR(ring.values.min_film_thickness / face.values.min_film_thickness - 1, -0.001e-2, kOfMesh);
  EXPECT_NEAR(ring.values.mean_power_loss / face.values.mean_power_loss - 1, -0.081e-2, kOfMesh);
}

TEST(UnrolledIntegration, NotesReportTheEndGap) {
  const Case c = small(unrolled_ring());  // twelve cells cannot be short at the ends
  const CycleResult face = simulated(face_of(c));
  const CycleResult ring = simulated(c);
  for (const char* topic : {"end-cells-long", "gap-leakage-grows"}) {
    const auto is_it = [&](const Note& note) { return note.topic == topic; };
    EXPECT_TRUE(std::any_of(ring.notes.begin(), ring.notes.end(), is_it)) << topic;
    EXPECT_FALSE(std::any_of(face.notes.begin(), face.notes.end(), is_it)) << topic;
  }
}

TEST(UnrolledIntegration, FieldsAreKeptInFullOrByStripsAndTheFaceHasTheStripHalfway) {
  Case c = small(unrolled_ring());
  c.output.fields = FieldOutput::kListed;
  c.output.field_angles_deg = {20, 21.5};  // one of them on the side
  const CycleResult full = simulated(c);
  const UnrolledFields& fields = full.unrolled;
  ASSERT_EQ(fields.crank_angle_deg, (std::vector<double>{20, 21.5}));
  ASSERT_EQ(fields.film_pressure.size(), 2u * 13 * 41);
  ASSERT_EQ(full.fields.film_pressure.size(), 2u * 41);
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i < 41; ++i) {
      EXPECT_EQ(fields.film_pressure[(k * 13 + 6) * 41 + i], static_cast<float>(full.fields.film_pressure[k * 41 + i]));
      EXPECT_EQ(fields.film_content[(k * 13 + 6) * 41 + i], static_cast<float>(full.fields.film_content[k * 41 + i]));
    }
    // At the end of the ring the mean of the pressures at its edges.
    const float middle = fields.film_pressure[k * 13 * 41 + 20];
    const double edges = 0.5 * (full.fields.film_pressure[k * 41] + full.fields.film_pressure[k * 41 + 40]);
    EXPECT_NEAR(middle / edges, 1, 1e-6);
  }
  EXPECT_TRUE(fields.strip_bore_deviation.empty());  // the ring is rigid

  c.output.reduction = FieldReduction::kAlongFace;
  const CycleResult reduced = simulated(c);
  EXPECT_TRUE(reduced.unrolled.film_pressure.empty());
  for (const UnrolledField& field : strip_fields()) {
    if (field.values == &UnrolledFields::strip_bore_deviation) continue;
    EXPECT_EQ((reduced.unrolled.*field.values).size(), 2u * 13) << field.name;
    EXPECT_EQ(reduced.unrolled.*field.values, fields.*field.values) << field.name;
  }
  const auto peak = std::max_element(reduced.unrolled.strip_peak_film_pressure.begin(),
                                     reduced.unrolled.strip_peak_film_pressure.begin() + 13);
  EXPECT_FLOAT_EQ(*peak, static_cast<float>(full.samples[5].peak_film_pressure));
}

TEST(UnrolledIntegration, SameCaseGivesTheSameBitsAloneAndInABatch) {
  const Case c = small(unrolled_ring());
  const CycleResult a = simulated(c);
  const Batch batch = batch_of({small_engine(1), c, small_engine(2)}, {0, 1, 2}, film::kernels().name);
  const CycleResult& b = batch.outcomes.at(1).result;
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t k = 0; k < a.samples.size(); ++k) {
    for (const CurveQuantity& q : curve_quantities()) {
      const double x = a.samples[k].*q.value, y = b.samples[k].*q.value;
      EXPECT_EQ(std::memcmp(&x, &y, sizeof x), 0) << q.name << " at " << k;
    }
    for (const UnrolledQuantity& q : unrolled_quantities()) {
      const double x = a.unrolled_samples[k].*q.value, y = b.unrolled_samples[k].*q.value;
      EXPECT_EQ(std::memcmp(&x, &y, sizeof x), 0) << q.name << " at " << k;
    }
  }
}

}  // namespace
}  // namespace ringfilm::cycle::testing
