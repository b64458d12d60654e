#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "batch_cases.hpp"
#include "ringfilm/cycle/closure/static_closure.hpp"
#include "ringfilm/cycle/integration/cycle_film.hpp"
#include "unrolled_cases.hpp"

/// Film, contact, gas and bending of the ring in a bore out of round.
namespace ringfilm::cycle::testing {
namespace {

Case bending_ring() {
  Case c = unrolled_ring();
  c.ring.conformity = Conformity::kBeam;
  c.ring.radial_thickness = 3.5e-3;
  c.solver.cells = 50;
  c.solver.cells_y = 60;
  c.solver.crank_step_deg = 4;
  c.output.crank_angle_step_deg = 4;
  return c;
}

TEST(BendingRing, InARoundBoreWithoutGapIsTheFilmAcrossTheFace) {
  for (const Cavitation cavitation : {Cavitation::kReynoldsExit, Cavitation::kMassConserving}) {
    Case c = bending_ring();
    c.ring.end_gap.reset();
    c.solver.cells_y = 24;
    c.film.cavitation = cavitation;
    const CycleResult ring = simulated(c);
    c.film.dimension = FilmDimension::kFace;
    const CycleResult face = simulated(c);
    ASSERT_EQ(ring.samples.size(), face.samples.size());
    constexpr double kLeft = 3e-6;  // by the iterations of both; seen 1.5e-6
    for (std::size_t k = 0; k < face.samples.size(); ++k) {
      const Sample &a = ring.samples[k], &b = face.samples[k];
      EXPECT_NEAR(a.min_film_thickness / b.min_film_thickness, 1, kLeft) << a.crank_angle_deg;
      EXPECT_NEAR(a.total_friction / b.total_friction, 1, kLeft) << a.crank_angle_deg;
      EXPECT_NEAR(ring.unrolled_samples[k].max_clearance / b.min_film_thickness, 1, kLeft) << a.crank_angle_deg;
    }
    EXPECT_NEAR(ring.values.mean_power_loss / face.values.mean_power_loss, 1, 1e-7);
  }
}

// Under the tips, which meet a crest of every order, the pressure is beyond the fits of the oil: they have no film
// there, and the laws have one.
TEST(BendingRing, OnSmoothSurfacesIsSolvedWithTheLawsWhereTheFitsFail) {
  Case c = bending_ring();
  c.film.cavitation = Cavitation::kMassConserving;
  c.contact.roughness = 0.3e-6;
  c.ring.gap_position_deg = 0;
  c.liner.distortion = {{2, 15e-6, 0, {}}, {3, 5e-6, 0, {}}, {4, 2e-6, 0, {}}};
  const cycle::Setup setup = prepare(c);
  ASSERT_TRUE(setup.ring.oil.range->has_fit());
  const CycleResult result = simulate(setup);
  EXPECT_TRUE(result.complete);
  EXPECT_GT(result.values.peak_film_pressure, setup.ring.oil.range->at(setup.ring.oil.temperature)->fit()->high);
  EXPECT_LT(result.effort.max_load_residual, 1e-6);
  EXPECT_LT(result.effort.max_mass_residual, 1e-4);
}

TEST(BendingRing, ForcesAroundItAndMassBalanceThroughTheCycle) {
  Case c = bending_ring();
  c.film.cavitation = Cavitation::kMassConserving;
  c.liner.distortion = {{2, 15e-6, 0, {}}, {4, 6e-6, 30, {}}};
  c.output.fields = FieldOutput::kAll;
  c.output.reduction = FieldReduction::kAlongFace;
  const CycleResult result = simulated(c);
  EXPECT_TRUE(result.complete);
  EXPECT_LT(result.effort.max_load_residual, 1e-6);
  EXPECT_LT(result.effort.max_mass_residual, 1e-4);
  EXPECT_GT(result.unrolled_values.peak_clearance, 2 * result.values.max_film_thickness);
  EXPECT_GT(result.unrolled_values.peak_open_area, 0);
  const UnrolledFields& fields = result.unrolled;
  const film::CircumferentialGrid around = strips_of(c);
  const std::size_t n = fields.y.size();
  ASSERT_EQ(fields.crank_angle_deg.size(), result.unrolled_samples.size());
  for (std::size_t k = 0; k < fields.crank_angle_deg.size(); ++k) {
    double lifted = 0, cubes = 0;
    const auto strips = fields.strip_min_film_thickness.begin() + static_cast<std::ptrdiff_t>(k * n);
    // The lowest place of the face lies between two nodes.
    const double above_lowest =
        *std::max_element(strips, strips + static_cast<std::ptrdiff_t>(n)) - result.unrolled_samples[k].max_clearance;
    for (std::size_t j = 0; j < n; ++j) {
      const double theta =
          c.ring.gap_position_deg * std::numbers::pi / 180 + (0.5 * fields.end_gap + fields.y[j]) / (c.engine.bore / 2);
      const double bore = 15e-6 * std::cos(2 * theta) + 6e-6 * std::cos(4 * (theta - std::numbers::pi / 6));
      // The beam counts the gap's angle at its neutral radius: 1e-4 of a radian.
      ASSERT_NEAR(fields.strip_bore_deviation[k * n + j], bore, 1e-8) << j;
      const double open = fields.strip_lifted_off[k * n + j] * around.share[j];
      lifted += open;
      cubes += open * std::pow(fields.strip_min_film_thickness[k * n + j] - above_lowest, 3);
    }
    const double degrees = lifted / (c.engine.bore / 2) * 180 / std::numbers::pi;
    EXPECT_NEAR(result.unrolled_samples[k].lifted_angle, degrees, 1e-9);
    // Laminar flow goes with the cube of the gap: alike all around, this one passes as much as the lifted parts do.
    const double all_around = std::cbrt(cubes / (std::numbers::pi * c.engine.bore));
    EXPECT_NEAR(result.unrolled_samples[k].gas_opening, all_around, 1e-4 * all_around);  // fields: single precision
  }
}

/// Hardly any film and stiff contact: a clearance that is that of the ring without film, over its thinnest film.
TEST(BendingRing, WithoutMuchFilmClosesAsTheRingWithoutFilm) {
  for (const double gap_position_deg : {45.0, 225.0}) {
    Case c = bending_ring();
    c.operating.speed = 1;
    c.contact.roughness = 0.05e-6;
    c.contact.asperity_radius = 1e-6;
    c.contact.asperity_density = 5e12;
    c.liner.distortion = {{4, 8e-6, 0, {}}};
    c.ring.gap_position_deg = gap_position_deg;
    c.ring.end_gap = 0.35e-3;
    c.solver.cells_y = 240;
    const cycle::Setup setup = prepare(c);
    CycleFilm film(setup);
    const RingConditions at = ring_conditions(setup, 270, film::kSteady);
    film::FilmState before, state;
    ASSERT_TRUE(film.solve_steady(at, before, state).converged);
    const double edges = 0.5 * (at.inputs.left.pressure + at.inputs.right.pressure);
    c.conform.gas_pressure = std::max(at.inputs.load / c.ring.face_width - setup.ring.elastic_pressure - edges, 0.0);
    const StaticClosure closure = static_closure(c);
    const std::vector<double> h = film::separations(*film.film2d(), state);
    const film::CircumferentialGrid& around = film.film2d()->around;
    for (int j = 0; j < around.n_strips(); ++j) {
      const double first = ring_beam(c).half_gap();
      const double phi = first + 2 * (std::numbers::pi - first) * around.y[j] / around.length;
      // Contact of this roughness gives way by 80 nm at each place, and so the ring moves as a whole.
      EXPECT_NEAR(h[j] - state.h_m, closure.ring.clearance(phi), 0.2e-6) << phi;
    }
    const double largest = *std::max_element(h.begin(), h.end()) - state.h_m;
    EXPECT_NEAR(largest / closure.values.max_clearance, 1, 0.02);
  }
}

TEST(BendingRing, ABoreThatChangesAlongTheStrokeIsThatOfItsHeights) {
  Case c = bending_ring();
  const double stroke = c.engine.stroke;
  c.liner.distortion = {{2, 4e-6, 0, 0.0}, {2, 12e-6, 0, stroke}};
  const film::CircumferentialGrid around = strips_of(c);
  const BendingRing varying(c, around);
  c.liner.distortion = {{2, 6e-6, 0, {}}};
  const BendingRing quarter(c, around);
  film::Film2dInputs at_quarter, straight;
  varying.press(stroke / 4, 0, at_quarter);
  quarter.press(0, 0, straight);
  ASSERT_EQ(at_quarter.bore_force.size(), straight.bore_force.size());
  for (std::size_t i = 0; i < straight.bore_force.size(); ++i) {
    EXPECT_NEAR(at_quarter.bore_force[i], straight.bore_force[i], 1e-12);
  }
}

/// Rows of a dynamic part of order 4 whose amplitude is given at crank angles [m].
void add_dynamic_part(const std::vector<std::pair<double, double>>& amplitudes, Case& c) {
  DynamicBore dynamic;
  for (const auto& [angle_deg, amplitude] : amplitudes) {
    dynamic.crank_angle_deg.push_back(angle_deg);
    std::vector<double> row;
    for (int i = 0; i < 36; ++i) row.push_back(amplitude * std::cos(4 * (10 * i - 20) * std::numbers::pi / 180));
    dynamic.deviation.push_back(std::move(row));
  }
  c.liner.dynamic_distortion = "dynamic.csv";
  c.liner.dynamic = std::move(dynamic);
}

TEST(BendingRing, ADynamicPartOfTheBoreIsThatOfItsCrankAngle) {
  Case c = bending_ring();
  c.ring.gap_position_deg = 35;
  c.liner.distortion = {{2, 9e-6, 10, {}}};
  const film::CircumferentialGrid around = strips_of(c);
  Case fixed = c;
  add_dynamic_part({{10, 2e-6}, {350, 4e-6}, {700, 6e-6}}, c);
  const BendingRing dynamic(c, around);
  for (const auto& [angle_deg, amplitude] :
       std::vector<std::pair<double, double>>{{10, 2e-6}, {95, 2.5e-6}, {525, 5e-6}, {715, 4e-6}, {5, 8e-6 / 3}}) {
    fixed.liner.distortion = {{2, 9e-6, 10, {}}, {4, amplitude, 20, {}}};
    const BendingRing of_now(fixed, around);
    film::Film2dInputs a, b;
    dynamic.press(0, angle_deg, a);
    of_now.press(0, angle_deg, b);
    // Integrals over elements, in pieces for the highest order of each series.
    for (std::size_t i = 0; i < b.bore_force.size(); ++i) EXPECT_NEAR(a.bore_force[i], b.bore_force[i], 1e-9) << i;
    const std::vector<double> bore = dynamic.bore_at_strips(0, angle_deg), other = of_now.bore_at_strips(0, angle_deg);
    for (std::size_t j = 0; j < bore.size(); ++j) EXPECT_NEAR(bore[j], other[j], 1e-17) << j;
  }
}

TEST(BendingRing, ADynamicPartThatStaysIsAStaticOne) {
  Case c = bending_ring(), fixed = c;
  fixed.liner.distortion = {{4, 6e-6, 20, {}}};
  add_dynamic_part({{0, 6e-6}, {240, 6e-6}, {480, 6e-6}}, c);
  const CycleResult dynamic = simulated(c), of_fixed = simulated(fixed);
  EXPECT_NEAR(dynamic.values.mean_power_loss / of_fixed.values.mean_power_loss, 1, 1e-8);
  EXPECT_NEAR(dynamic.unrolled_values.peak_clearance / of_fixed.unrolled_values.peak_clearance, 1, 1e-6);  // iteration
}

}  // namespace
}  // namespace ringfilm::cycle::testing
