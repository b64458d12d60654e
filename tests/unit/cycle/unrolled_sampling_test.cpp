#include "ringfilm/cycle/integration/unrolled_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/cycle/integration/sampling.hpp"
#include "unrolled_cases.hpp"

/// Figures of the gap's ends from integrals that are made up.
namespace ringfilm::cycle::testing {
namespace {

Case small_ring() {
  Case c = unrolled_ring();
  c.solver.cells = 16;
  c.solver.cells_y = 8;
  return c;
}

/// Nine strips that differ from the one halfway only at the ends.
film::Film2dIntegrals made_up() {
  film::Film2dIntegrals integrals;
  film::StripIntegrals strip;
  strip.hydrodynamic_load = 900;
  strip.asperity_load = 100;
  strip.shear_couette = 20;
  strip.shear_poiseuille = -5;
  strip.flow_middle = 2e-4;
  integrals.strips.assign(9, strip);
  integrals.strips.front().hydrodynamic_load = integrals.strips.back().hydrodynamic_load = 0;
  integrals.mean.hydrodynamic_load = 880;
  integrals.mean.asperity_load = 100;
  integrals.mean.asperity_area = 2e-7;
  integrals.mean.shear_couette = 19;
  integrals.mean.shear_poiseuille = -5;
  integrals.mean.flow_middle = 1.9e-4;
  integrals.flow_low = 3e-7;
  integrals.flow_high = -1e-7;
  return integrals;
}

/// A full film of 1 um at no pressure.
film::FilmState full_film(const TimeIntegration& integration) {
  film::FilmState state;
  state.h_m = 1e-6;
  state.p.assign(integration.film2d()->n_nodes(), 0.0);
  state.deficit = state.p;
  return state;
}

TEST(UnrolledSampling, SharesOfTheEndsCompareTheRingWithItsStripHalfway) {
  const cycle::Setup setup = prepare(small_ring());
  const TimeIntegration integration(setup);
  const film::FilmState state = full_film(integration);
  Instant instant;
  instant.at.inputs.oil = setup.ring.oil.range->at(setup.ring.oil.temperature);
  instant.crank_angle_deg = 400;
  instant.at.inputs.U = -5;
  instant.at.inputs.load = 980;
  instant.state = &state;
  const film::Film2dIntegrals integrals = made_up();
  const Sample whole = sample(setup, integration.problem(), instant, integrals.mean);
  const double L = setup.input.ring_length();
  EXPECT_DOUBLE_EQ(whole.applied_load, 980 * L);  // of what there is of the ring
  EXPECT_DOUBLE_EQ(whole.oil_flow_middle, 1.9e-4 * L);

  const UnrolledSample ends = unrolled_sample(setup, integration, instant, integrals, whole);
  EXPECT_DOUBLE_EQ(ends.gap_leakage, 2e-7);
  EXPECT_EQ(ends.gap_leakage_low_end, 3e-7);
  EXPECT_EQ(ends.gap_leakage_high_end, -1e-7);
  EXPECT_DOUBLE_EQ(ends.ends_share_load, 1 - 1000.0 / 980);
  EXPECT_DOUBLE_EQ(ends.ends_share_flow, 1 - 2.0 / 1.9);
  EXPECT_DOUBLE_EQ(ends.oil_flow_without_ends, 2e-4 * L);
  const double boundary = 2e6 * 2e-7 + 0.3581 * 100;
  EXPECT_DOUBLE_EQ(ends.ends_share_friction, 1 - (boundary + 15) / (boundary + 14));

  // A ring that was turned over has its x from the crankcase.
  instant.at.axis = Axis::kFromCrankcase;
  const Sample turned = sample(setup, integration.problem(), instant, integrals.mean);
  EXPECT_DOUBLE_EQ(turned.oil_flow_middle, -1.9e-4 * L);
  EXPECT_DOUBLE_EQ(unrolled_sample(setup, integration, instant, integrals, turned).oil_flow_without_ends, -2e-4 * L);
}

TEST(UnrolledSampling, AShareOfNoFlowIsNone) {
  const cycle::Setup setup = prepare(small_ring());
  const TimeIntegration integration(setup);
  const film::FilmState state = full_film(integration);
  Instant instant;
  instant.at.inputs.oil = setup.ring.oil.range->at(setup.ring.oil.temperature);
  instant.at.inputs.load = 980;
  instant.state = &state;
  film::Film2dIntegrals integrals = made_up();
  integrals.mean.flow_middle = 0;
  const Sample whole = sample(setup, integration.problem(), instant, integrals.mean);
  EXPECT_TRUE(std::isnan(unrolled_sample(setup, integration, instant, integrals, whole).ends_share_flow));
}

// An odd number of cells has no strip at its middle, and rounding decides which is next to it: both the fields along
// the face and the shares take the one that the two-dimensional film names.
TEST(UnrolledSampling, TheStripHalfwayIsThatOfTheFilm2d) {
  Case c = small_ring();
  c.solver.cells_y = 9;
  const cycle::Setup setup = prepare(c);
  const TimeIntegration integration(setup);
  const auto halfway = static_cast<std::size_t>(integration.film2d()->around.halfway());
  film::FilmState state = full_film(integration);
  const auto n_across = static_cast<std::size_t>(integration.film2d()->n_across());
  state.p[halfway * n_across + 3] = 5e5;
  Instant instant;
  instant.at.inputs.oil = setup.ring.oil.range->at(setup.ring.oil.temperature);
  instant.at.inputs.load = 980;
  instant.state = &state;
  film::Film2dIntegrals integrals = made_up();
  integrals.strips.push_back(integrals.strips.front());  // nine cells have ten strips
  integrals.strips[halfway].flow_middle = 3e-4;
  const Sample whole = sample(setup, integration.problem(), instant, integrals.mean);
  const UnrolledSample ends = unrolled_sample(setup, integration, instant, integrals, whole);
  EXPECT_DOUBLE_EQ(ends.oil_flow_without_ends, 3e-4 * setup.input.ring_length());
  FaceFields fields = empty_fields(setup, integration.unloaded_grid());
  append_fields(setup, integration, instant, fields);
  EXPECT_EQ(fields.film_pressure[3], 5e5);
}

// An instant that carries nothing has no share of its own; that of the cycle stays a number.
TEST(UnrolledSampling, AnInstantWithoutAShareLeavesThatOfTheCycle) {
  std::vector<Sample> whole(2);
  whole[0].hydrodynamic_load = 0;
  whole[0].power_loss = 0;
  whole[1].hydrodynamic_load = 200;
  whole[1].power_loss = 40;
  whole[1].piston_velocity = 8;
  std::vector<UnrolledSample> ends(2);
  ends[0].ends_share_load = ends[0].ends_share_friction = std::nan("");
  ends[0].load_without_ends = 2;
  ends[1].load_without_ends = 194;
  ends[1].friction_without_ends = 4.5;
  const UnrolledValues values = unrolled_values(whole, ends);
  EXPECT_NEAR(values.ends_share_mean_load, 0.02, 1e-15);  // rounding of a difference
  EXPECT_NEAR(values.ends_share_friction_power, 0.1, 1e-15);
}

TEST(UnrolledSampling, ValuesOfTheCycleWeighSharesByWhatTheyAreSharesOf) {
  std::vector<Sample> whole(2);
  whole[0].crank_angle_deg = 0;
  whole[0].hydrodynamic_load = 300;
  whole[0].power_loss = 10;
  whole[0].oil_flow_middle = 4e-6;
  whole[1].crank_angle_deg = 360;
  whole[1].hydrodynamic_load = 80;
  whole[1].asperity_load = 20;
  whole[1].power_loss = 30;
  whole[1].oil_flow_middle = -1e-6;
  whole[0].piston_velocity = 2;
  whole[1].piston_velocity = -5;
  std::vector<UnrolledSample> ends(2);
  ends[0].gap_leakage = -1e-8;
  ends[0].load_without_ends = 0.98 * 300;
  ends[0].friction_without_ends = 0.9 * 10 / 2;
  ends[0].oil_flow_without_ends = 3.6e-6;
  ends[1].gap_leakage = 3e-8;
  ends[1].load_without_ends = 1.01 * 100;
  ends[1].friction_without_ends = 1.02 * 30 / 5;
  ends[1].oil_flow_without_ends = -1.2e-6;
  const UnrolledValues values = unrolled_values(whole, ends);
  EXPECT_DOUBLE_EQ(values.mean_gap_leakage, 1e-8);
  EXPECT_DOUBLE_EQ(values.mean_absolute_gap_leakage, 2e-8);
  EXPECT_DOUBLE_EQ(values.peak_gap_leakage, 3e-8);
  EXPECT_EQ(values.peak_gap_leakage_angle, 360);
  EXPECT_DOUBLE_EQ(values.gap_leakage_share, 2e-8 / 2.5e-6);
  constexpr double kRounding = 1e-15;  // of a difference
  EXPECT_NEAR(values.ends_share_mean_load, (0.02 * 300 - 0.01 * 100) / 400, kRounding);
  EXPECT_NEAR(values.ends_share_friction_power, (0.1 * 10 - 0.02 * 30) / 40, kRounding);
  EXPECT_NEAR(values.ends_share_absolute_flow, 0.04, kRounding);
  ends[0].gap_leakage = -4e-8;
  EXPECT_DOUBLE_EQ(unrolled_values(whole, ends).peak_gap_leakage, -4e-8);
  EXPECT_EQ(unrolled_values(whole, ends).peak_gap_leakage_angle, 0);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
