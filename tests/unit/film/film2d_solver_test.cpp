#include "ringfilm/film/solver2d/film2d_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "../../traps/floating_point_traps.hpp"
#include "film2d_cases.hpp"

namespace ringfilm::film::testing {
namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, double scale) {
  double largest = a.size() == b.size() ? 0 : 1e300;
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]) / scale);
  return largest;
}

/// The film in one dimension through the same steps.
std::vector<FilmState> strip_states(const testing::LaneFilm& film) {
  FilmWorkspace workspace(film.problem);
  std::vector<FilmState> states;
  FilmState state = film.first;
  for (const FilmInputs& inputs : film.steps) {
    FilmState next = state;
    EXPECT_TRUE(solve_film(film.problem, inputs, state, next, workspace).converged);
    states.push_back(next);
    state = std::move(next);
  }
  return states;
}

class WithoutEnds : public ::testing::TestWithParam<Cavitation> {};

// Newton's method stops when its last step is below the square root of the tolerance, here 1e-5: what is left of two
// solves that took different steps is of the order of its square, with a factor that no theorem limits.
constexpr double kLeft = 1e-8;

TEST_P(WithoutEnds, EveryStripIsTheFilmInOneDimension) {
  int compared = 0;
  for (const testing::LaneFilm& film : testing::lane_films(kind(GetParam()))) {
    if (film.first.h_m == 0) continue;
    const auto strips = strip_states(film);
    for (const Ends ends : {Ends::kJoined, Ends::kClosed}) {
      for (const int n_cells : {1, 4, 9}) {
        if (ends == Ends::kJoined && n_cells == 1) continue;  // a strip beside itself: below
        Passage film2d(film, film2d_of(film.problem, uniform_around(n_cells, 0.05, ends)));
        for (std::size_t k = 0; k < film.steps.size(); ++k) {
          ASSERT_TRUE(film2d.step(inputs_of(film.steps[k])).converged);
          EXPECT_NEAR(std::log(film2d.state.h_m / strips[k].h_m), 0, kLeft);
          const FilmState same = of_strips(film2d.problem(), strips[k]);
          EXPECT_LT(largest_difference(film2d.state.p, same.p, film.steps[k].mean_pressure(film.problem.grid)), kLeft);
          EXPECT_LT(largest_difference(film2d.state.deficit, same.deficit, 1), kLeft);
          const auto of_strip =
              film_integrals(film.problem, film.steps[k], k == 0 ? film.first : strips[k - 1], strips[k]);
          EXPECT_NEAR(film2d.integrals.mean.shear_couette / of_strip.shear_couette, 1, 1e-7);
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 100);
}

TEST_P(WithoutEnds, AJoinedFilm2dOfOneStripIsIt) {
  const testing::LaneFilm film = testing::lane_films(kind(GetParam())).front();
  const auto strips = strip_states(film);
  Passage film2d(film, film2d_of(film.problem, uniform_around(1, 0.05, Ends::kJoined)));
  for (std::size_t k = 0; k < film.steps.size(); ++k) {
    ASSERT_TRUE(film2d.step(inputs_of(film.steps[k])).converged);
    EXPECT_NEAR(std::log(film2d.state.h_m / strips[k].h_m), 0, kLeft);
  }
}

TEST_P(WithoutEnds, TheOilMayChangeFromStepToStep) {
  const testing::BlockKind block = kind(GetParam());
  const testing::LaneFilm film = testing::with_changing_oil(block, testing::lane_films(block).front(), 403);
  const auto strips = strip_states(film);
  Passage film2d(film, film2d_of(film.problem, uniform_around(5, 0.05, Ends::kJoined)));
  for (std::size_t k = 0; k < film.steps.size(); ++k) {
    ASSERT_TRUE(film2d.step(inputs_of(film.steps[k])).converged);
    EXPECT_NEAR(std::log(film2d.state.h_m / strips[k].h_m), 0, 1e-10);
    const FilmIntegrals& mean = film2d.integrals.mean;
    if (GetParam() == Cavitation::kMassConserving) {
      EXPECT_NEAR(mean.mass_defect / mean.flow_middle, 0, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cavitation, WithoutEnds,
                         ::testing::Values(Cavitation::kMassConserving, Cavitation::kReynoldsExit));

TEST(Film2dSolver, ConservesMassAtEveryStepWithOpenEnds) {
  int cavities = 0;
  for (testing::LaneFilm film : testing::lane_films(kind(Cavitation::kMassConserving))) {
    if (film.first.h_m == 0) continue;
    film.problem.tolerance = 1e-12;
    Passage film2d(film, film2d_of(film.problem, refined_around(24, 0.02, 0.1e-3)));
    for (const FilmInputs& inputs : film.steps) {
      ASSERT_TRUE(film2d.step(inputs_of(inputs)).converged);
      const FilmIntegrals& mean = film2d.integrals.mean;
      const double largest =
          std::max({std::abs(mean.flow_left), std::abs(mean.flow_right), std::abs(mean.flow_middle)});
      // GMRES leaves a millionth of a last step below a millionth.
      EXPECT_LT(std::abs(mean.mass_defect), 1e-10 * largest);
      cavities += mean.cavitated_fraction > 0;
    }
  }
  EXPECT_GT(cavities, 10);
}

TEST(Film2dSolver, BalancesTheLoadOfTheWholeFilm2d) {
  for (const testing::LaneFilm& film : testing::lane_films(kind(Cavitation::kMassConserving))) {
    if (film.first.h_m == 0) continue;
    Passage film2d(film, film2d_of(film.problem, refined_around(24, 0.02, 0.1e-3)));
    for (const FilmInputs& inputs : film.steps) {
      ASSERT_TRUE(film2d.step(inputs_of(inputs)).converged);
      const FilmIntegrals& mean = film2d.integrals.mean;
      EXPECT_NEAR((mean.hydrodynamic_load + mean.asperity_load) / inputs.load, 1, 1e-8);
      EXPECT_NEAR(mean_load(film2d.problem(), inputs_of(inputs), film2d.state) / inputs.load, 1, 1e-8);
    }
  }
}

TEST(Film2dSolver, OpenEndsHaveTheirPressureAndTheFilm2dIsSymmetric) {
  const testing::LaneFilm film = testing::lane_films(kind(Cavitation::kMassConserving)).front();
  Passage film2d(film, film2d_of(film.problem, refined_around(25, 0.02, 0.1e-3)));
  const Film2dInputs inputs = inputs_of(film.steps[0]);
  ASSERT_TRUE(film2d.step(inputs).converged);
  const int last = film2d.problem().around.n_strips() - 1;
  const double scale = film.steps[0].mean_pressure(film.problem.grid);
  for (int i = 0; i < film2d.problem().n_across(); ++i) {
    EXPECT_EQ(film2d.p(i, 0), inputs.p_low);
    EXPECT_EQ(film2d.p(i, last), inputs.p_high);
    for (int j = 1; j < last; ++j) EXPECT_NEAR(film2d.p(i, j) / scale, film2d.p(i, last - j) / scale, 1e-8);
  }
  EXPECT_NEAR(film2d.integrals.flow_low / film2d.integrals.flow_high, 1, 1e-6);
}

// A plane of symmetry is a wall: half the two-dimensional film, open at one end only, cannot be stated, but a closed
// two-dimensional film with the heights mirrored can: a two-dimensional film with a gap that is even in y about its
// middle is twice its half.
TEST(Film2dSolver, AWallIsAPlaneOfSymmetry) {
  const testing::LaneFilm film = testing::lane_films(kind(Cavitation::kMassConserving)).front();
  const double length = 4e-3;
  const auto wavy = [&](Film2dProblem problem, double period) {
    const int n = problem.n_across();
    const auto rise = [&](double y) { return 0.4e-6 * (1 - std::cos(2 * M_PI * y / period)); };
    for (int j = 0; j < problem.around.n_strips(); ++j) {
      for (int i = 0; i < n; ++i) problem.gap.node[j * n + i] += rise(problem.around.y[j]);
      for (int i = 0; i + 1 < n; ++i) problem.gap.face_x[j * (n - 1) + i] += rise(problem.around.y[j]);
    }
    for (int c = 0; c < problem.around.n_cells(); ++c) {
      for (int i = 0; i < n; ++i)
        problem.gap.face_y[c * n + i] += rise(problem.around.y[c] + 0.5 * problem.around.spacing[c]);
    }
    return problem;
  };
  testing::LaneFilm smooth = film;  // asperities know the heights across alone
  smooth.problem.contact = nullptr;
  Passage half(smooth, wavy(film2d_of(smooth.problem, uniform_around(12, length, Ends::kClosed)), 2 * length));
  Passage whole(smooth, wavy(film2d_of(smooth.problem, uniform_around(24, 2 * length, Ends::kJoined)), 2 * length));
  for (const FilmInputs& inputs : smooth.steps) {
    ASSERT_TRUE(half.step(inputs_of(inputs)).converged);
    ASSERT_TRUE(whole.step(inputs_of(inputs)).converged);
    EXPECT_NEAR(std::log(half.state.h_m / whole.state.h_m), 0, kLeft);
    for (int j = 0; j <= 12; ++j) {
      for (int i = 0; i < half.problem().n_across(); ++i) {
        EXPECT_NEAR(half.p(i, j) / whole.p(i, j), 1, 1e-7);
      }
    }
    // and the strips differ, so that there was something to exchange
    EXPECT_GT(half.integrals.strips.front().hydrodynamic_load, 1.02 * half.integrals.strips.back().hydrodynamic_load);
  }
}

TEST(Film2dSolver, ARiseOfAllStripsIsAThickerFilm) {
  const testing::LaneFilm film = testing::lane_films(kind(Cavitation::kMassConserving)).front();
  const CircumferentialGrid around = refined_around(16, 0.02, 0.2e-3);
  Passage plain(film, film2d_of(film.problem, around)), raised(film, film2d_of(film.problem, around));
  Film2dInputs inputs = inputs_of(film.steps[0]);
  inputs.strip.time_step = kSteady;
  ASSERT_TRUE(plain.step(inputs).converged);
  const double rise = 0.2 * plain.state.h_m;
  inputs.rise.assign(around.n_strips(), rise);
  ASSERT_TRUE(raised.step(inputs).converged);
  EXPECT_NEAR((raised.state.h_m + rise) / plain.state.h_m, 1, 1e-7);
  EXPECT_NEAR(raised.integrals.mean.asperity_load / plain.integrals.mean.asperity_load, 1, 1e-5);
}

TEST(Film2dSolver, WhereTheRingIsFartherFromTheLinerItCarriesLess) {
  const testing::LaneFilm film = testing::lane_films(kind(Cavitation::kMassConserving)).front();
  const CircumferentialGrid around = uniform_around(16, 0.1, Ends::kJoined);
  Passage film2d(film, film2d_of(film.problem, around));
  Film2dInputs inputs = inputs_of(film.steps[0]);
  for (int j = 0; j < around.n_strips(); ++j)
    inputs.rise.push_back(1e-6 * (1 - std::cos(4 * M_PI * around.y[j] / 0.1)));
  ASSERT_TRUE(film2d.step(inputs).converged);
  // What flows out of a strip in y flows into the next, though they stand off differently: as in
  // ConservesMassAtEveryStepWithOpenEnds, with the tolerance of these films.
  EXPECT_LT(std::abs(film2d.integrals.mean.mass_defect), 1e-8 * std::abs(film2d.integrals.mean.flow_middle));
  const auto& strips = film2d.integrals.strips;
  EXPECT_GT(strips[0].hydrodynamic_load, 1.5 * strips[4].hydrodynamic_load);
  EXPECT_NEAR(strips[0].hydrodynamic_load / strips[8].hydrodynamic_load, 1, 1e-6);  // two waves around
  EXPECT_GT(strips[0].asperity_load, strips[4].asperity_load);
  EXPECT_NEAR((film2d.integrals.mean.hydrodynamic_load + film2d.integrals.mean.asperity_load) / inputs.strip.load, 1,
              1e-8);
}

TEST(Film2dSolver, FitsAndLawsAgree) {
  for (const Cavitation cavitation : {Cavitation::kMassConserving, Cavitation::kReynoldsExit}) {
    const testing::LaneFilm fitted = testing::lane_films(kind(cavitation)).front();
    const testing::LaneFilm exact = testing::lane_films(kind(cavitation, LaneLaws::kGiven)).front();
    Passage a(fitted, film2d_of(fitted.problem, refined_around(16, 0.02, 0.2e-3)));
    Passage b(exact, film2d_of(exact.problem, refined_around(16, 0.02, 0.2e-3)));
    for (std::size_t k = 0; k < fitted.steps.size(); ++k) {
      ASSERT_TRUE(a.step(inputs_of(fitted.steps[k])).converged);
      ASSERT_TRUE(b.step(inputs_of(exact.steps[k])).converged);
      EXPECT_NEAR(std::log(a.state.h_m / b.state.h_m), 0, kLeft);
      EXPECT_NEAR(a.integrals.flow_low / b.integrals.flow_low, 1, 1e-6);
    }
  }
}

TEST(Film2dSolver, AllKernelsAgree) {
  std::vector<double> h_m;
  for (const std::string_view name : kernel_names()) {
    const testing::LaneFilm film =
        testing::lane_films({&kernels(name), Cavitation::kMassConserving, LaneLaws::kFitted})[4];
    Passage film2d(film, film2d_of(film.problem, refined_around(19, 0.02, 0.2e-3)));
    for (const FilmInputs& inputs : film.steps) ASSERT_TRUE(film2d.step(inputs_of(inputs)).converged);
    h_m.push_back(film2d.state.h_m);
  }
  for (const double h : h_m) EXPECT_NEAR(std::log(h / h_m.front()), 0, kLeft);
}

TEST(Film2dSolver, TheSameSolveGivesTheSameBits) {
  const testing::LaneFilm film = testing::lane_films(kind(Cavitation::kMassConserving))[1];
  std::vector<FilmState> ends;
  for (int run = 0; run < 2; ++run) {
    Passage film2d(film, film2d_of(film.problem, refined_around(16, 0.02, 0.2e-3)));
    for (const FilmInputs& inputs : film.steps) ASSERT_TRUE(film2d.step(inputs_of(inputs)).converged);
    ends.push_back(film2d.state);
  }
  ASSERT_EQ(ends[0].p.size(), ends[1].p.size());
  EXPECT_EQ(std::memcmp(ends[0].p.data(), ends[1].p.data(), ends[0].p.size() * sizeof(double)), 0);
  EXPECT_EQ(ends[0].h_m, ends[1].h_m);
}

TEST(Film2dSolver, AWorkspaceRemembersNothing) {
  const testing::LaneFilm film = testing::lane_films(kind(Cavitation::kMassConserving))[1];
  const Film2dProblem problem = film2d_of(film.problem, refined_around(16, 0.02, 0.2e-3));
  const Film2dInputs inputs = inputs_of(film.steps[1]), others = inputs_of(film.steps[3]);
  const FilmState first = of_strips(problem, film.first);
  Film2dWorkspace used(problem), fresh(problem);
  FilmState a = first, b = first, between = first;
  ASSERT_TRUE(solve_film2d(problem, others, first, between, used).converged);
  ASSERT_TRUE(solve_film2d(problem, inputs, first, a, used).converged);
  ASSERT_TRUE(solve_film2d(problem, inputs, first, b, fresh).converged);
  EXPECT_EQ(a.h_m, b.h_m);
  EXPECT_EQ(a.p, b.p);
}

TEST(Film2dSolver, AnOverloadIsReportedAsSuch) {
  testing::LaneFilm film = testing::overloaded(testing::lane_films(kind(Cavitation::kMassConserving)).front());
  film.problem.contact = nullptr;
  Passage film2d(film, film2d_of(film.problem, uniform_around(4, 0.02, Ends::kJoined)));
  Film2dInputs inputs = inputs_of(film.steps[2]);
  inputs.strip.U = 0;
  inputs.strip.time_step = kSteady;
  const FilmReport report = film2d.step(inputs);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.failure, Failure::kOverloaded);
}

TEST(Film2dSolver, NaNInGivesNoFilm) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  const testing::LaneFilm film = testing::lane_films(kind(Cavitation::kMassConserving)).front();
  const Film2dProblem problem = film2d_of(film.problem, refined_around(8, 0.02, 0.2e-3));
  Film2dWorkspace workspace(problem);
  FilmState state = of_strips(problem, film.first);
  const FilmState before = state;
  state.p[problem.n_across() * 4 + 20] = std::nan("");
  const FilmReport report = solve_film2d_at_separation(problem, inputs_of(film.steps[0]), before, state, workspace);
  EXPECT_FALSE(report.converged);
}

}  // namespace
}  // namespace ringfilm::film::testing
