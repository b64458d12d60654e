#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "batch_cases.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::cycle::testing {
namespace {

/// A flat face whose only steady lift is that of the honing.
Case flat_on_hone() {
  Case c = styles_new_ring();
  c.ring.face.form = FaceForm::kParabola;
  c.ring.face.crown_height = 1e-12;  // flat
  c.solver.cells = 60;
  LandLawTable law;
  law.rows = {{0.6e-6, 1e-6, 1.4e-6, 2e-6, 3e-6}, {900e3, 266e3, 108e3, 31e3, 4e3}, {1, 1, 1, 1, 1}, 0.048, 1};
  law.width = c.ring.face_width;
  law.roughness = 0.4e-6;
  c.film.land_lift = LandLift::kTable;
  c.film.land_law_file = "land.nc";
  c.film.land_law = base::Shared<LandLawTable>(std::move(law));
  return c;
}

TEST(LandCase, TheTableCarriesItsShareOfTheLoad) {
  const cycle::Setup setup = prepare(flat_on_hone());
  const CycleResult result = simulate(setup);
  ASSERT_TRUE(result.complete);
  double largest = 0;
  const Case& c = setup.input;
  const double area = c.ring.face_width * std::numbers::pi * c.engine.bore;
  for (const Sample& s : result.samples) {
    EXPECT_LT(s.load_residual, 1e-3);
    const double eta_U = setup.ring.oil.viscosity * std::abs(s.piston_velocity);
    const double expected = area * setup.ring.land->at(s.min_film_thickness, eta_U).lift;
    EXPECT_NEAR(s.land_lift, expected, 0.01 * expected);  // viscosity at the cavitation pressure: 0.2 %
    largest = std::max(largest, s.land_lift / s.applied_load);
  }
  EXPECT_GT(largest, 0.1);
}

TEST(LandCase, TwiceTheLiftMakesAThickerFilmInMidStroke) {
  Case c = flat_on_hone();
  const CycleResult once = simulate(prepare(c));
  c.film.land_factor = 2;
  const CycleResult twice = simulate(prepare(c));
  ASSERT_TRUE(once.complete && twice.complete);
  EXPECT_GT(twice.values.max_film_thickness, once.values.max_film_thickness);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
