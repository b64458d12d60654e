#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "film_cases.hpp"
#include "gas_edge_cases.hpp"
#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/solver/lane_newton.hpp"

/// What the liner takes along of oil that hangs on the face behind the film, eqs eq-meniscus-film, eq-outlet.
namespace ringfilm::film::testing {
namespace {

constexpr double kMineralOil = 0.03;  // [N/m]

/// Part of a stroke that begins at rest, with oil in all of the gap behind the lowest place. Density 1.
class Stroke {
 public:
  static constexpr int kCells = 100;
  static constexpr double kTimeStep = 2e-5;  // [s]

  explicit Stroke(double surface_tension) : film_(film_of(form(), kCells)) {
    const double gas = form().p_in, supply = 1e-6;
    inputs_ = film_.inputs();
    inputs_.surface_tension = surface_tension;
    inputs_.p_cavitation = gas;
    inputs_.load = 2 * gas * form().width;
    inputs_.left = {gas, EdgeFluid::kGas, supply};
    inputs_.right = {gas, EdgeFluid::kGas};
    inputs_.time_step = kTimeStep;
    state_.h_m = 2e-6;
    const FilmGrid& grid = film_.problem.grid;
    for (int i = 0; i <= kCells; ++i) {
      const double h = state_.h_m + grid.node_height[i];
      const double filled = grid.x[i] < 0.4 * grid.width ? supply / h : 1;
      state_.p.push_back(gas);
      state_.deficit.push_back(1 - filled);
      state_.mass_per_area.push_back(filled * h);
    }
  }

  void step() {
    set_step();
    const FilmState before = state_;
    FilmWorkspace workspace(film_.problem);
    const FilmReport report = solve_film(film_.problem, inputs_, before, state_, workspace);
    EXPECT_TRUE(report.converged && report.route == Route::kNewton) << step_;
    flows_ = film_integrals(film_.problem, inputs_, before, state_);
    left_ += kTimeStep * flows_.flow_right;
    taken_ += kTimeStep * flows_.flow_left;
  }
  /// The next step in lane 1, beside films with another surface tension.
  FilmState step_beside(double surface_tension) {
    set_step();
    LaneNewton lanes(*film_.problem.kernels, film_.problem.kernels->width, kCells);
    FilmInputs other = inputs_;
    other.surface_tension = surface_tension;
    for (int lane = 0; lane < lanes.width(); ++lane) {
      lanes.bind(lane, film_.problem);
      lanes.start(lane, lane == 1 ? inputs_ : other, state_, state_, state_.h_m, Unknowns::kFilmAndSeparation,
                  LaneLaws::kGiven);
    }
    while (lanes.phase(1) == LaneNewton::Phase::kRunning) lanes.iterate();
    EXPECT_EQ(lanes.phase(1), LaneNewton::Phase::kSolved);
    FilmState state;
    lanes.read(1, state);
    return state;
  }

  double on_face() const {
    double sum = 0;
    for (int i = 1; i < kCells; ++i) sum += film_.problem.grid.share[i] * state_.mass_per_area[i];
    return sum;
  }
  double left() const { return left_; }    ///< on the liner so far [kg/m]
  double taken() const { return taken_; }  ///< from the liner so far [kg/m]
  double leaving() const { return flows_.flow_right; }
  double entering() const { return flows_.flow_left; }

 private:
  static GasFilm form() {
    GasFilm form;
    form.eta = 8e-3;
    form.h_m = 0;
    return form;
  }
  void set_step() {
    inputs_.U = 10 * std::sin(157 * kTimeStep * ++step_);
    inputs_.h_m_before = state_.h_m;
  }

  SmoothFilm film_;
  FilmInputs inputs_;
  FilmState state_;
  FilmIntegrals flows_;
  int step_ = 0;
  double left_ = 0, taken_ = 0;
};

Stroke after(int steps, double surface_tension) {
  Stroke stroke(surface_tension);
  for (int k = 0; k < steps; ++k) stroke.step();
  return stroke;
}

TEST(Outlet, AMeniscusLeavesUpToHalfOfTheGap) {
  EXPECT_EQ(left_by_meniscus(0), 0);
  EXPECT_NEAR(left_by_meniscus(1e-6) / 1.34e-4, 1, 1e-3);
  EXPECT_NEAR(left_by_meniscus(1e6), 1, 1e-3);
  for (const double filled : {0.1, 0.5, 0.9, 0.95, 1.0}) {
    const double share = carried_share(filled, kOnWall);
    EXPECT_EQ(std::min(share, hanging_share(filled, 1.0)), share);
    EXPECT_LE(hanging_share(filled, 0.2), 1);
  }
  EXPECT_EQ(hanging_share(0.9, 0.2), 0.2);
  EXPECT_NEAR(hanging_share(1.0, 0.2), 1, 1e-15);
}

TEST(Outlet, OilHangsLongerAndIsNotLost) {
  const double before = Stroke(0).on_face();
  const Stroke half = after(40, 0), capillary = after(40, kMineralOil);
  EXPECT_LT(capillary.left(), 0.6 * half.left());  // seen: 1.45 and 2.72 mm3/m
  EXPECT_GT(capillary.left(), 0.4 * half.left());
  for (const Stroke* stroke : {&half, &capillary}) {
    EXPECT_NEAR((stroke->on_face() + stroke->left() - stroke->taken()) / before, 1, 1e-10);
  }
  EXPECT_NEAR(after(40, 1e-9).left() / half.left(), 1, 1e-3);  // Ca of 1e6 and more
}

TEST(Outlet, ASteadyFilmLeavesWhatComes) {
  const Stroke stroke = after(400, kMineralOil);
  EXPECT_NEAR(stroke.leaving() / stroke.entering(), 1, 5e-3);
}

TEST(Outlet, HalfOfTheGapHasTheSameBitsBesideCapillaryFilms) {
  const Stroke start = after(20, 0);
  Stroke one = start, other = start;
  const FilmState beside_capillary = one.step_beside(kMineralOil), beside_half = other.step_beside(0);
  EXPECT_EQ(beside_capillary.h_m, beside_half.h_m);
  EXPECT_EQ(beside_capillary.p, beside_half.p);
  EXPECT_EQ(beside_capillary.deficit, beside_half.deficit);
}

}  // namespace
}  // namespace ringfilm::film::testing
