#include "ringfilm/cycle/cycle_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "styles_case.hpp"

namespace ringfilm::cycle::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A nearly flat face in oil so cold that the film is squeezed out over tens of cycles.
Case cold_flat_ring(double crown_height, double speed_rpm) {
  Case c = styles_new_ring();
  c.ring.face.form = FaceForm::kParabola;
  c.ring.face.crown_height = crown_height;
  c.operating.oil_temperature = 273.15 - 65;
  c.operating.speed = speed_rpm * std::numbers::pi / 30;
  c.solver.cells = 60;
  c.solver.crank_step_deg = 2;
  c.output.crank_angle_step_deg = 2;
  return c;
}

TEST(CycleRun, FollowsASlowFilmUntilItRepeats) {
  const CycleResult result = simulated(cold_flat_ring(0.2e-6, 3000));
  EXPECT_TRUE(result.complete);
  EXPECT_GT(result.effort.cycles_integrated, 20);
  EXPECT_LE(result.effort.periodicity_error, 1e-7);
  // The state that it repeats is that of a film followed for longer. A difference of 1e-7 from one cycle to the next,
  // which falls by a third in each, leaves 3e-7 to go.
  Case further = cold_flat_ring(0.2e-6, 3000);
  further.solver.tolerance = 1e-11;
  const CycleResult limit = simulated(further);
  EXPECT_GT(limit.effort.cycles_integrated, result.effort.cycles_integrated + 5);
  EXPECT_NEAR(result.values.min_film_thickness / limit.values.min_film_thickness, 1, 1e-6);
}

TEST(CycleRun, ReportsHowFarFromRepeatingACycleStopped) {
  // Below the rounding of the iteration, which is 1e-12 and more of such a film.
  Case c = cold_flat_ring(0.05e-6, 9000);
  c.solver.tolerance = 1e-14;
  try {
    simulated(c);
    ADD_FAILURE() << "repeats to 1e-13";
  } catch (const StoppedCycle& stop) {
    EXPECT_THAT(stop.what(), AllOf(HasSubstr("the cycle does not repeat itself: after "),
                                   HasSubstr(" 1e-13 is allowed"), HasSubstr("larger solver.tolerance")));
    EXPECT_GT(stop.result.effort.cycles_integrated, 50);
    EXPECT_LT(stop.result.effort.periodicity_error, 1e-9);
    EXPECT_FALSE(stop.result.complete);
  }
}

}  // namespace
}  // namespace ringfilm::cycle::testing
