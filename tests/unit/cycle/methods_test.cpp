#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "styles_case.hpp"

/// Both methods of solution, over whole cycles of the three rings.
namespace ringfilm::cycle::testing {
namespace {

constexpr int kCells = 80;
constexpr double kTolerance = 1e-8;  // the default of solver.tolerance

CycleResult solved_by(Method method, Case c, Cavitation cavitation) {
  c.solver.method = method;
  c.solver.cells = kCells;
  c.solver.crank_step_deg = 2;
  c.output.crank_angle_step_deg = 2;
  c.film.cavitation = cavitation;
  return simulated(c);
}

/// Largest difference_of_methods over the cycle, of the film relative to itself, of friction and flow to their peaks.
struct DifferenceOfMethods {
  double film = 0, friction = 0, flow = 0;
};

DifferenceOfMethods difference_of_methods(const CycleResult& a, const CycleResult& b) {
  DifferenceOfMethods largest;
  double friction = 0, flow = 0;
  EXPECT_EQ(a.samples.size(), 360u);
  EXPECT_EQ(b.samples.size(), 360u);
  for (std::size_t k = 0; k < std::min(a.samples.size(), b.samples.size()); ++k) {
    const Sample& x = a.samples[k];
    const Sample& y = b.samples[k];
    largest.film = std::max(largest.film, std::abs(x.min_film_thickness / y.min_film_thickness - 1));
    largest.friction = std::max(largest.friction, std::abs(x.friction_on_liner - y.friction_on_liner));
    largest.flow = std::max(largest.flow, std::abs(x.oil_flow_middle - y.oil_flow_middle));
    friction = std::max(friction, std::abs(y.friction_on_liner));
    flow = std::max(flow, std::abs(y.oil_flow_middle));
  }
  largest.friction /= friction;
  largest.flow /= flow;
  return largest;
}

class OnEveryRing : public ::testing::TestWithParam<Cavitation> {
 protected:
  void expect_agreement(double within) const {
    for (const Case& ring : {styles_new_ring(), styles_run_in_ring(), styles_embedded_ring()}) {
      SCOPED_TRACE(ring.title);
      const CycleResult newton = solved_by(Method::kCoupledNewton, ring, GetParam());
      const CycleResult other = solved_by(Method::kPointRelaxation, ring, GetParam());
      const DifferenceOfMethods apart = difference_of_methods(other, newton);
      EXPECT_LT(apart.film, within);
      EXPECT_LT(apart.friction, within);
      EXPECT_LT(apart.flow, within);
      EXPECT_EQ(other.effort.fallback_sub_step, 0);
      EXPECT_EQ(newton.effort.relaxation_sweeps, 0);
      EXPECT_GT(other.effort.relaxation_sweeps, other.effort.crank_steps);
    }
  }
};

TEST_P(OnEveryRing, PointRelaxationAgreesWithTheCoupledNewton) {
  // A change per sweep below the tolerance leaves 1/(1 - rate) times as much, at the best factor N/(2 pi); flow goes
  // with the cube of the film. Seen 3.5e-8.
  expect_agreement(3 * kTolerance * kCells / (2 * std::numbers::pi));
}

INSTANTIATE_TEST_SUITE_P(Methods, OnEveryRing,
                         ::testing::Values(Cavitation::kReynoldsExit, Cavitation::kMassConserving),
                         [](const auto& cavitation) {
                           return cavitation.param == Cavitation::kReynoldsExit ? "ReynoldsExit" : "MassConserving";
                         });

}  // namespace
}  // namespace ringfilm::cycle::testing
