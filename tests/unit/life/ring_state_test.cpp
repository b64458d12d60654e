#include "ringfilm/life/ring_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../cycle/styles_case.hpp"
#include "ringfilm/case/case_face.hpp"
#include "ringfilm/models/ring.hpp"

namespace ringfilm::life {
namespace {

/// Constants and coefficients of Tables 1, 2 and 4 of styles2014.
cycle::Case ring_of(std::vector<double> coefficients, double N, double beta, double sigma, double zeta) {
  cycle::Case c = cycle::testing::styles_new_ring();
  c.ring.face.coefficients = std::move(coefficients);
  c.contact.asperity_density = N;
  c.contact.asperity_radius = beta;
  c.contact.roughness = sigma;
  c.contact.boundary_shear_strength_coefficient = zeta;
  return c;
}

std::vector<MeasuredState> three_states() {
  return {
      {0, ring_of({427.9, -1455.8, 1971.4, -1354.4, 544.57, -150.49, 25.3}, 0.097e12, 1.56e-6, 0.48e-6, 0.3581), {}},
      {10 * kHour,
       ring_of({-197.16, 578.85, -583.44, 200.37, 56.366, -62.709, 13.857}, 0.1e12, 1.34e-6, 0.5e-6, 0.2565),
       {}},
      {150 * kHour,
       ring_of({-6.493, -49.845, 143.22, -98.541, 27.351, -17.338, 7.4986}, 0.101e12, 1.82e-6, 0.35e-6, 0.1423),
       {}}};
}

struct Moments {
  double m0, m2, m4;
};

/// Spectral moments of a Gaussian surface with these constants; McCool 1987.
Moments moments_of(const RingState& ring) {
  using namespace std::numbers;
  const double m4 = std::pow(3 * std::sqrt(pi) / (8 * ring.asperity_radius), 2);
  return {ring.roughness * ring.roughness, m4 / (6 * pi * std::sqrt(3) * ring.asperity_density), m4};
}

models::RingFace model_of(const cycle::RingFace& face, double width) {
  return face.form == cycle::FaceForm::kPoints ? models::RingFace::points(face.x, face.height, width)
                                               : cycle::face_of_formula(face, width);
}

TEST(RingState, AnAnchorIsTheMeasuredStateToTheBit) {
  const auto states = three_states();
  for (const MeasuredState& state : states) {
    const RingState ring = state_on_path(states, {}, state.time, 200);
    EXPECT_EQ(ring.face.coefficients, state.input.ring.face.coefficients);
    EXPECT_EQ(ring.asperity_density, state.input.contact.asperity_density);
    EXPECT_EQ(ring.asperity_radius, state.input.contact.asperity_radius);
    EXPECT_EQ(ring.roughness, state.input.contact.roughness);
    EXPECT_EQ(ring.boundary_shear_strength_coefficient, state.input.contact.boundary_shear_strength_coefficient);
    EXPECT_EQ(state_origin_at(states, state.time), StateOrigin::kMeasured);
  }
}

TEST(RingState, AfterTheLastStateItIsHeld) {
  const auto states = three_states();
  EXPECT_EQ(state_origin_at(states, 151 * kHour), StateOrigin::kHeld);
  EXPECT_EQ(state_on_path(states, {}, 1000 * kHour, 200).roughness, 0.35e-6);
}

TEST(RingState, ConstantsOfThePathAreThoseOfTheStudy) {
  const auto states = three_states();
  const RingState three = state_on_path(states, {}, 3 * kHour, 200), half = state_on_path(states, {}, 75 * kHour, 200);
  EXPECT_NEAR(three.asperity_density, 0.0987e12, 0.5e8);
  EXPECT_NEAR(three.asperity_radius, 1.429e-6, 0.5e-9);
  EXPECT_NEAR(three.roughness, 0.491e-6, 0.5e-9);
  EXPECT_NEAR(three.boundary_shear_strength_coefficient, 0.2953, 5e-5);
  EXPECT_NEAR(half.asperity_radius, 1.680e-6, 0.5e-9);
  EXPECT_NEAR(half.roughness, 0.384e-6, 0.5e-9);
  EXPECT_NEAR(half.boundary_shear_strength_coefficient, 0.1661, 5e-5);
}

TEST(RingState, LogarithmsOfTheSpectralMomentsAreLinear) {
  const auto states = three_states();
  const double s = 0.37;
  const RingState a = ring_state_of(states[0].input), b = ring_state_of(states[1].input);
  const Moments from = moments_of(a), to = moments_of(b), at = moments_of(interpolated(a, b, s, 1.2e-3, 200));
  EXPECT_NEAR(std::log(at.m0), (1 - s) * std::log(from.m0) + s * std::log(to.m0), 1e-13);
  EXPECT_NEAR(std::log(at.m2), (1 - s) * std::log(from.m2) + s * std::log(to.m2), 1e-13);
  EXPECT_NEAR(std::log(at.m4), (1 - s) * std::log(from.m4) + s * std::log(to.m4), 1e-13);
}

TEST(RingState, TheFaceIsLinearAtEachPlaceFromBothMinima) {
  const auto states = three_states();
  const double width = 1.2e-3, s = 0.6;
  const auto& first = states[0].input.ring.face;
  const auto& second = states[2].input.ring.face;
  const models::RingFace from = model_of(first, width), to = model_of(second, width);
  const RingState between = interpolated(ring_state_of(states[0].input), ring_state_of(states[2].input), s, width, 200);
  const models::RingFace at = model_of(between.face, width);
  for (int i = 0; i <= 24; ++i) {
    const double x = width * i / 24;
    const double expected =
        (1 - s) * (from.height(x) - from.minimum().height) + s * (to.height(x) - to.minimum().height);
    EXPECT_NEAR(at.height(x), expected, 1e-18) << x;
  }
  EXPECT_GE(at.minimum().height, 0);
  EXPECT_LT(at.minimum().height, 0.02e-6);
}

TEST(RingState, FacesOfOtherFormsAreLinearAtTheNodesOfTheFilm) {
  cycle::Case parabola = three_states()[0].input, polynomial = parabola;
  parabola.ring.face = {};
  parabola.ring.face.form = cycle::FaceForm::kParabola;
  parabola.ring.face.crown_height = 8e-6;
  const double width = 1.2e-3;
  const int cells = 50;
  const RingState between = interpolated(ring_state_of(polynomial), ring_state_of(parabola), 0.25, width, cells);
  const models::RingFace from = model_of(polynomial.ring.face, width), at = model_of(between.face, width);
  for (int i = 0; i <= 2 * cells; ++i) {
    const double x = width * i / (2 * cells), share = (x - width / 2) / (width / 2);
    EXPECT_NEAR(at.height(x), 0.75 * (from.height(x) - from.minimum().height) + 0.25 * 8e-6 * share * share, 1e-18);
  }
}

TEST(RingState, OnePartIsTakenFromTheLaterState) {
  const auto states = three_states();
  const RingState a = ring_state_of(states[0].input), b = ring_state_of(states[2].input);
  const RingState rough = with_part(a, b, Part::kRoughness);
  EXPECT_EQ(rough.roughness, b.roughness);
  EXPECT_EQ(rough.asperity_radius, b.asperity_radius);
  EXPECT_EQ(rough.face.coefficients, a.face.coefficients);
  EXPECT_EQ(rough.boundary_shear_strength_coefficient, a.boundary_shear_strength_coefficient);
  EXPECT_EQ(with_part(a, b, Part::kFace).face.coefficients, b.face.coefficients);
  EXPECT_EQ(with_part(a, b, Part::kShearStrength).boundary_shear_strength_coefficient, 0.1423);
}

/// Heights scaled by one factor, distances kept: all moments fall with the square of the roughness.
TEST(RingState, ASurfaceThatRunsInKeepsItsBandwidthAndTheDensityOfItsPeaks) {
  const cycle::Case c = three_states()[0].input;
  const RingState before = ring_state_of(c), after = run_in_state(c, 0.35e-6);
  const Moments from = moments_of(before), to = moments_of(after);
  const double square = std::pow(0.35 / 0.48, 2);
  EXPECT_EQ(after.asperity_density, before.asperity_density);
  EXPECT_NEAR(to.m0 / from.m0, square, 1e-14);
  EXPECT_NEAR(to.m2 / from.m2, square, 1e-14);
  EXPECT_NEAR(to.m4 / from.m4, square, 1e-14);
  EXPECT_EQ(after.boundary_shear_strength_coefficient, before.boundary_shear_strength_coefficient);
}

TEST(RingState, ASurfaceThatHasNotRunInIsThatOfTheCaseToTheBit) {
  cycle::Case c = three_states()[0].input;
  for (const bool has_plateau : {false, true}) {
    if (has_plateau) {
      c.contact.plateau.Rk = 0.4e-6;
      c.contact.plateau.Rpk = 0.15e-6;
      c.contact.plateau.Rvk = 1.5e-6;
      c.contact.plateau.Mr2 = 0.8;
    }
    const RingState same = run_in_state(c, run_in_roughness(c)), given = ring_state_of(c);
    EXPECT_EQ(same.roughness, given.roughness);
    EXPECT_EQ(same.asperity_radius, given.asperity_radius);
    EXPECT_EQ(with_ring_state(c, same).contact.plateau, c.contact.plateau);
  }
}

/// Lines of the material ratio curve in closed form: F_1 of eq-gaussian-integral at the quantile where they meet.
TEST(RingState, APlateauRunsInOverValleysThatStay) {
  cycle::Case c = three_states()[0].input;
  constexpr double kMeet = 0.84134474606854293;    // share below one standard deviation
  constexpr double kBeyond = 0.08331547058768629;  // F_1(1)
  c.contact.plateau.Rpq = 0.2e-6;
  c.contact.plateau.Rvq = 1e-6;
  c.contact.plateau.Rmq = kMeet;
  c.contact.plateau.ring_roughness = 0.15e-6;
  c.contact.plateau.offset = 0.05e-6;
  c.contact.plateau.surface_roughness = 0.4e-6;
  const RingState after = run_in_state(c, 0.08e-6);
  const cycle::Plateau plateau = with_ring_state(c, after).contact.plateau;
  EXPECT_EQ(plateau.Rpq, 0.08e-6);
  EXPECT_EQ(plateau.Rvq, 1e-6);
  EXPECT_EQ(plateau.Rmq, kMeet);
  EXPECT_EQ(plateau.ring_roughness, 0.15e-6);
  EXPECT_NEAR(plateau.offset.value(), 0.05e-6 + 0.12e-6 * kBeyond, 1e-18);
  EXPECT_LT(plateau.surface_roughness.value(), 0.4e-6);
  EXPECT_NEAR(after.roughness, std::hypot(0.15e-6, *plateau.surface_roughness), 1e-18);
  EXPECT_NEAR(after.asperity_radius, 1.56e-6 * 0.25 / 0.17, 1e-17);  // hypot of 0.15 with 0.2 and 0.08
}

TEST(RingState, PeaksLoseNoMoreThanIsWornFromTheLeastDepthScaleOn) {
  cycle::Case c = three_states()[0].input;
  const double share = 1 / std::sqrt(2 * std::numbers::pi);
  EXPECT_NEAR(least_depth_scale(c, 0.35e-6), share * 0.13e-6, 1e-20);
  c.contact.roughness_measure = cycle::RoughnessMeasure::kRaToRq;
  EXPECT_NEAR(least_depth_scale(c, 0.35e-6), share * 0.13e-6 * std::sqrt(std::numbers::pi / 2), 1e-20);
}

TEST(RingState, TheShareOfThePathRunsFromOneStateToTheNext) {
  const Interpolation logarithmic, linear{TimeScale::kLinear, kHour};
  EXPECT_DOUBLE_EQ(path_share(logarithmic, 0, 10 * kHour, 10 * kHour), 1);
  EXPECT_DOUBLE_EQ(path_share(logarithmic, 0, 10 * kHour, kHour), std::log(2) / std::log(11));
  EXPECT_DOUBLE_EQ(path_share(linear, 10, 150, 45), 0.25);
}

}  // namespace
}  // namespace ringfilm::life
