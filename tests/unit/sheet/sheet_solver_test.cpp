#include "ringfilm/sheet/sheet_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "../../traps/floating_point_traps.hpp"
#include "sheet_cases.hpp"

namespace ringfilm::sheet::testing {
namespace {

using film::Cavitation;

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, double scale) {
  double largest = a.size() == b.size() ? 0 : 1e300;
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]) / scale);
  return largest;
}

/// The film in one dimension through the same steps.
std::vector<film::FilmState> strip_states(const film::testing::LaneFilm& film) {
  film::FilmWorkspace workspace(film.problem);
  std::vector<film::FilmState> states;
  film::FilmState state = film.first;
  for (const film::FilmInputs& inputs : film.steps) {
    film::FilmState next = state;
    EXPECT_TRUE(film::solve_film(film.problem, inputs, state, next, workspace).converged);
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
  for (const film::testing::LaneFilm& film : film::testing::lane_films(kind(GetParam()))) {
    if (film.first.h_m == 0) continue;
    const auto strips = strip_states(film);
    for (const Ends ends : {Ends::kJoined, Ends::kClosed}) {
      for (const int n_cells : {1, 4, 9}) {
        if (ends == Ends::kJoined && n_cells == 1) continue;  // a strip beside itself: below
        Passage sheet(film, sheet_of(film.problem, uniform_around(n_cells, 0.05, ends)));
        for (std::size_t k = 0; k < film.steps.size(); ++k) {
          ASSERT_TRUE(sheet.step(inputs_of(film.steps[k])).converged);
          EXPECT_NEAR(std::log(sheet.state.h_m / strips[k].h_m), 0, kLeft);
          const film::FilmState same = of_strips(sheet.problem(), strips[k]);
          EXPECT_LT(largest_difference(sheet.state.p, same.p, film.steps[k].mean_pressure(film.problem.grid)), kLeft);
          EXPECT_LT(largest_difference(sheet.state.deficit, same.deficit, 1), kLeft);
          const auto of_strip =
              film::film_integrals(film.problem, film.steps[k], k == 0 ? film.first : strips[k - 1], strips[k]);
          EXPECT_NEAR(sheet.integrals.mean.shear_couette / of_strip.shear_couette, 1, 1e-7);
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 100);
}

TEST_P(WithoutEnds, AJoinedSheetOfOneStripIsIt) {
  const film::testing::LaneFilm film = film::testing::lane_films(kind(GetParam())).front();
  const auto strips = strip_states(film);
  Passage sheet(film, sheet_of(film.problem, uniform_around(1, 0.05, Ends::kJoined)));
  for (std::size_t k = 0; k < film.steps.size(); ++k) {
    ASSERT_TRUE(sheet.step(inputs_of(film.steps[k])).converged);
    EXPECT_NEAR(std::log(sheet.state.h_m / strips[k].h_m), 0, kLeft);
  }
}

INSTANTIATE_TEST_SUITE_P(Cavitation, WithoutEnds,
                         ::testing::Values(Cavitation::kMassConserving, Cavitation::kReynoldsExit));

TEST(SheetSolver, ConservesMassAtEveryStepWithOpenEnds) {
  int cavities = 0;
  for (film::testing::LaneFilm film : film::testing::lane_films(kind(Cavitation::kMassConserving))) {
    if (film.first.h_m == 0) continue;
    film.problem.tolerance = 1e-12;
    Passage sheet(film, sheet_of(film.problem, refined_around(24, 0.02, 0.1e-3)));
    for (const film::FilmInputs& inputs : film.steps) {
      ASSERT_TRUE(sheet.step(inputs_of(inputs)).converged);
      const film::FilmIntegrals& mean = sheet.integrals.mean;
      const double largest =
          std::max({std::abs(mean.flow_left), std::abs(mean.flow_right), std::abs(mean.flow_middle)});
      // GMRES leaves a millionth of a last step below a millionth.
      EXPECT_LT(std::abs(mean.mass_defect), 1e-10 * largest);
      cavities += mean.cavitated_fraction > 0;
    }
  }
  EXPECT_GT(cavities, 10);
}

TEST(SheetSolver, BalancesTheLoadOfTheWholeSheet) {
  for (const film::testing::LaneFilm& film : film::testing::lane_films(kind(Cavitation::kMassConserving))) {
    if (film.first.h_m == 0) continue;
    Passage sheet(film, sheet_of(film.problem, refined_around(24, 0.02, 0.1e-3)));
    for (const film::FilmInputs& inputs : film.steps) {
      ASSERT_TRUE(sheet.step(inputs_of(inputs)).converged);
      const film::FilmIntegrals& mean = sheet.integrals.mean;
      EXPECT_NEAR((mean.hydrodynamic_load + mean.asperity_load) / inputs.load, 1, 1e-8);
      EXPECT_NEAR(mean_load(sheet.problem(), inputs_of(inputs), sheet.state) / inputs.load, 1, 1e-8);
    }
  }
}

TEST(SheetSolver, OpenEndsHaveTheirPressureAndTheSheetIsSymmetric) {
  const film::testing::LaneFilm film = film::testing::lane_films(kind(Cavitation::kMassConserving)).front();
  Passage sheet(film, sheet_of(film.problem, refined_around(25, 0.02, 0.1e-3)));
  const SheetInputs inputs = inputs_of(film.steps[0]);
  ASSERT_TRUE(sheet.step(inputs).converged);
  const int last = sheet.problem().around.n_strips() - 1;
  const double scale = film.steps[0].mean_pressure(film.problem.grid);
  for (int i = 0; i < sheet.problem().n_across(); ++i) {
    EXPECT_EQ(sheet.p(i, 0), inputs.p_low);
    EXPECT_EQ(sheet.p(i, last), inputs.p_high);
    for (int j = 1; j < last; ++j) EXPECT_NEAR(sheet.p(i, j) / scale, sheet.p(i, last - j) / scale, 1e-8);
  }
  EXPECT_NEAR(sheet.integrals.flow_low / sheet.integrals.flow_high, 1, 1e-6);
}

// A plane of symmetry is a wall: half the sheet, open at one end only, cannot be stated, but a closed sheet with the
// heights mirrored can: a sheet with a gap that is even in y about its middle is twice its half.
TEST(SheetSolver, AWallStandsForAPlaneOfSymmetry) {
  const film::testing::LaneFilm film = film::testing::lane_films(kind(Cavitation::kMassConserving)).front();
  const double length = 4e-3;
  const auto wavy = [&](SheetProblem problem, double period) {
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
  film::testing::LaneFilm smooth = film;  // asperities know the heights across alone
  smooth.problem.contact = nullptr;
  Passage half(smooth, wavy(sheet_of(smooth.problem, uniform_around(12, length, Ends::kClosed)), 2 * length));
  Passage whole(smooth, wavy(sheet_of(smooth.problem, uniform_around(24, 2 * length, Ends::kJoined)), 2 * length));
  for (const film::FilmInputs& inputs : smooth.steps) {
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

TEST(SheetSolver, ARiseOfAllStripsIsAThickerFilm) {
  const film::testing::LaneFilm film = film::testing::lane_films(kind(Cavitation::kMassConserving)).front();
  const Around around = refined_around(16, 0.02, 0.2e-3);
  Passage plain(film, sheet_of(film.problem, around)), raised(film, sheet_of(film.problem, around));
  SheetInputs inputs = inputs_of(film.steps[0]);
  inputs.strip.time_step = film::kSteady;
  ASSERT_TRUE(plain.step(inputs).converged);
  const double rise = 0.2 * plain.state.h_m;
  inputs.rise.assign(around.n_strips(), rise);
  ASSERT_TRUE(raised.step(inputs).converged);
  EXPECT_NEAR((raised.state.h_m + rise) / plain.state.h_m, 1, 1e-7);
  EXPECT_NEAR(raised.integrals.mean.asperity_load / plain.integrals.mean.asperity_load, 1, 1e-5);
}

TEST(SheetSolver, WhereTheRingStandsOffItCarriesLess) {
  const film::testing::LaneFilm film = film::testing::lane_films(kind(Cavitation::kMassConserving)).front();
  const Around around = uniform_around(16, 0.1, Ends::kJoined);
  Passage sheet(film, sheet_of(film.problem, around));
  SheetInputs inputs = inputs_of(film.steps[0]);
  for (int j = 0; j < around.n_strips(); ++j)
    inputs.rise.push_back(1e-6 * (1 - std::cos(4 * M_PI * around.y[j] / 0.1)));
  ASSERT_TRUE(sheet.step(inputs).converged);
  // What flows out of a strip in y flows into the next, though they stand off differently: as in
  // ConservesMassAtEveryStepWithOpenEnds, with the tolerance of these films.
  EXPECT_LT(std::abs(sheet.integrals.mean.mass_defect), 1e-8 * std::abs(sheet.integrals.mean.flow_middle));
  const auto& strips = sheet.integrals.strips;
  EXPECT_GT(strips[0].hydrodynamic_load, 1.5 * strips[4].hydrodynamic_load);
  EXPECT_NEAR(strips[0].hydrodynamic_load / strips[8].hydrodynamic_load, 1, 1e-6);  // two waves around
  EXPECT_GT(strips[0].asperity_load, strips[4].asperity_load);
  EXPECT_NEAR((sheet.integrals.mean.hydrodynamic_load + sheet.integrals.mean.asperity_load) / inputs.strip.load, 1,
              1e-8);
}

TEST(SheetSolver, FitsAndLawsAgree) {
  for (const Cavitation cavitation : {Cavitation::kMassConserving, Cavitation::kReynoldsExit}) {
    const film::testing::LaneFilm fitted = film::testing::lane_films(kind(cavitation)).front();
    const film::testing::LaneFilm exact = film::testing::lane_films(kind(cavitation, film::LaneLaws::kGiven)).front();
    Passage a(fitted, sheet_of(fitted.problem, refined_around(16, 0.02, 0.2e-3)));
    Passage b(exact, sheet_of(exact.problem, refined_around(16, 0.02, 0.2e-3)));
    for (std::size_t k = 0; k < fitted.steps.size(); ++k) {
      ASSERT_TRUE(a.step(inputs_of(fitted.steps[k])).converged);
      ASSERT_TRUE(b.step(inputs_of(exact.steps[k])).converged);
      EXPECT_NEAR(std::log(a.state.h_m / b.state.h_m), 0, kLeft);
      EXPECT_NEAR(a.integrals.flow_low / b.integrals.flow_low, 1, 1e-6);
    }
  }
}

TEST(SheetSolver, AllKernelsAgree) {
  std::vector<double> h_m;
  for (const std::string_view name : film::kernel_names()) {
    const film::testing::LaneFilm film =
        film::testing::lane_films({&film::kernels(name), Cavitation::kMassConserving, film::LaneLaws::kFitted})[4];
    Passage sheet(film, sheet_of(film.problem, refined_around(19, 0.02, 0.2e-3)));
    for (const film::FilmInputs& inputs : film.steps) ASSERT_TRUE(sheet.step(inputs_of(inputs)).converged);
    h_m.push_back(sheet.state.h_m);
  }
  for (const double h : h_m) EXPECT_NEAR(std::log(h / h_m.front()), 0, kLeft);
}

TEST(SheetSolver, TheSameSolveGivesTheSameBits) {
  const film::testing::LaneFilm film = film::testing::lane_films(kind(Cavitation::kMassConserving))[1];
  std::vector<film::FilmState> ends;
  for (int run = 0; run < 2; ++run) {
    Passage sheet(film, sheet_of(film.problem, refined_around(16, 0.02, 0.2e-3)));
    for (const film::FilmInputs& inputs : film.steps) ASSERT_TRUE(sheet.step(inputs_of(inputs)).converged);
    ends.push_back(sheet.state);
  }
  ASSERT_EQ(ends[0].p.size(), ends[1].p.size());
  EXPECT_EQ(std::memcmp(ends[0].p.data(), ends[1].p.data(), ends[0].p.size() * sizeof(double)), 0);
  EXPECT_EQ(ends[0].h_m, ends[1].h_m);
}

TEST(SheetSolver, AWorkspaceRemembersNothing) {
  const film::testing::LaneFilm film = film::testing::lane_films(kind(Cavitation::kMassConserving))[1];
  const SheetProblem problem = sheet_of(film.problem, refined_around(16, 0.02, 0.2e-3));
  const SheetInputs inputs = inputs_of(film.steps[1]), others = inputs_of(film.steps[3]);
  const film::FilmState first = of_strips(problem, film.first);
  SheetWorkspace used(problem), fresh(problem);
  film::FilmState a = first, b = first, between = first;
  ASSERT_TRUE(solve_sheet(problem, others, first, between, used).converged);
  ASSERT_TRUE(solve_sheet(problem, inputs, first, a, used).converged);
  ASSERT_TRUE(solve_sheet(problem, inputs, first, b, fresh).converged);
  EXPECT_EQ(a.h_m, b.h_m);
  EXPECT_EQ(a.p, b.p);
}

TEST(SheetSolver, AnOverloadIsToldAsSuch) {
  film::testing::LaneFilm film =
      film::testing::overloaded(film::testing::lane_films(kind(Cavitation::kMassConserving)).front());
  film.problem.contact = nullptr;
  Passage sheet(film, sheet_of(film.problem, uniform_around(4, 0.02, Ends::kJoined)));
  SheetInputs inputs = inputs_of(film.steps[2]);
  inputs.strip.U = 0;
  inputs.strip.time_step = film::kSteady;
  const film::FilmReport report = sheet.step(inputs);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.failure, film::Failure::kOverloaded);
}

TEST(SheetSolver, NoNumberInIsNoFilmOut) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  const film::testing::LaneFilm film = film::testing::lane_films(kind(Cavitation::kMassConserving)).front();
  const SheetProblem problem = sheet_of(film.problem, refined_around(8, 0.02, 0.2e-3));
  SheetWorkspace workspace(problem);
  film::FilmState state = of_strips(problem, film.first);
  const film::FilmState before = state;
  state.p[problem.n_across() * 4 + 20] = std::nan("");
  const film::FilmReport report =
      solve_sheet_at_separation(problem, inputs_of(film.steps[0]), before, state, workspace);
  EXPECT_FALSE(report.converged);
}

}  // namespace
}  // namespace ringfilm::sheet::testing
