#include "ringfilm/film/solver/lane_newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <limits>
#include <map>
#include <numeric>
#include <string>

#include "../../traps/floating_point_traps.hpp"
#include "lane_films.hpp"
#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/integrals/film_integrals.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film::testing {
namespace {

using Phase = LaneNewton::Phase;

/// All that became of a film on its way through its steps.
struct Passage {
  std::vector<double> numbers;  ///< effort, h_m, pressures and deficits of every step
  std::vector<FilmState> states;
  bool failed = false;

  bool same_bits(const Passage& other) const {
    return failed == other.failed && numbers.size() == other.numbers.size() &&
           std::memcmp(numbers.data(), other.numbers.data(), numbers.size() * sizeof(double)) == 0;
  }
};

/// One lane at work.
struct Worker {
  int film = -1;
  std::size_t step = 0;
  FilmState before;
  Passage passage;
};

/// Takes the films, in this order, through their steps in these lanes; a lane that is done takes the next film.
std::map<int, Passage> taken_through(const BlockKind& kind, const std::vector<LaneFilm>& films, std::deque<int> order,
                                     const std::vector<int>& lanes) {
  int most_cells = 0;
  for (const int i : order) most_cells = std::max(most_cells, films[i].problem.grid.n_cells());
  LaneNewton newton(*kind.kernels, kind.kernels->width, most_cells);
  std::vector<Worker> workers(kind.kernels->width);
  std::map<int, Passage> passages;
  const auto take = [&](int lane) {
    workers[lane] = {};
    if (order.empty()) return newton.clear(lane);
    Worker& worker = workers[lane];
    worker.film = order.front();
    order.pop_front();
    const LaneFilm& film = films[worker.film];
    worker.before = film.first;
    newton.bind(lane, film.problem);
    newton.start(lane, film.steps[0], worker.before, worker.before, worker.before.h_m, Unknowns::kFilmAndSeparation,
                 kind.laws);
  };
  const auto conclude = [&](int lane) {
    Worker& worker = workers[lane];
    Passage& passage = worker.passage;
    const LaneFilm& film = films[worker.film];
    passage.numbers.push_back(newton.iterations(lane));
    passage.failed = newton.phase(lane) == Phase::kFailed;
    if (!passage.failed) {
      newton.read(lane, worker.before);
      complete_state(film.problem, film.steps[worker.step], kind.laws, worker.before);
      passage.states.push_back(worker.before);
      passage.numbers.insert(passage.numbers.end(),
                             {worker.before.h_m, newton.last_step(lane), newton.peak_pressure(lane)});
      for (const auto* nodal : {&worker.before.p, &worker.before.deficit}) {
        passage.numbers.insert(passage.numbers.end(), nodal->begin(), nodal->end());
      }
    }
    if (passage.failed || ++worker.step == film.steps.size()) {
      passages[worker.film] = std::move(passage);
      return take(lane);
    }
    newton.start(lane, film.steps[worker.step], worker.before, worker.before, worker.before.h_m,
                 Unknowns::kFilmAndSeparation, kind.laws);
  };
  for (const int lane : lanes) take(lane);
  while (std::any_of(workers.begin(), workers.end(), [](const Worker& worker) { return worker.film >= 0; })) {
    newton.iterate();
    for (const int lane : lanes) {
      if (workers[lane].film >= 0 && newton.phase(lane) != Phase::kRunning) conclude(lane);
    }
  }
  return passages;
}

std::vector<int> up_to(int n) {
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// What `films` give in company, in several orders, must be what each gives alone in whatever lane, to the last bit.
void expect_lanes_apart(const BlockKind& kind, const std::vector<LaneFilm>& films) {
  const int width = kind.kernels->width;
  std::map<int, Passage> alone;
  for (const int i : up_to(static_cast<int>(films.size()))) {
    alone[i] = taken_through(kind, films, {i}, {0}).at(i);
    for (int lane = 1; lane < width; ++lane) {
      EXPECT_TRUE(alone[i].same_bits(taken_through(kind, films, {i}, {lane}).at(i))) << "film " << i << " in " << lane;
    }
  }
  const std::vector<int> forwards = up_to(static_cast<int>(films.size()));
  std::vector<int> lanes = up_to(width);
  for (const bool turned : {false, true}) {
    std::deque<int> order(forwards.begin(), forwards.end());
    for (int first = 0; first < static_cast<int>(films.size()); ++first) {
      for (const auto& [i, passage] : taken_through(kind, films, order, lanes)) {
        EXPECT_TRUE(passage.same_bits(alone[i])) << "film " << i << " after " << first << ", turned: " << turned;
      }
      order.push_back(order.front());
      order.pop_front();
    }
    std::reverse(lanes.begin(), lanes.end());
  }
}

class LaneNewtonOf : public ::testing::TestWithParam<std::tuple<std::string_view, Cavitation, LaneLaws>> {
 protected:
  BlockKind kind() const {
    return {&kernels(std::get<0>(GetParam())), std::get<1>(GetParam()), std::get<2>(GetParam())};
  }
};

std::string name_of(const ::testing::TestParamInfo<LaneNewtonOf::ParamType>& info) {
  const auto& [kernels, cavitation, laws] = info.param;
  return std::string(kernels) + (cavitation == Cavitation::kMassConserving ? "_mass" : "_exit") +
         (laws == LaneLaws::kFitted ? "_fitted" : "_laws");
}

INSTANTIATE_TEST_SUITE_P(Everywhere, LaneNewtonOf,
                         ::testing::Combine(::testing::ValuesIn(kernel_names()),
                                            ::testing::Values(Cavitation::kMassConserving, Cavitation::kReynoldsExit),
                                            ::testing::Values(LaneLaws::kFitted, LaneLaws::kGiven)),
                         name_of);

TEST_P(LaneNewtonOf, AFilmNeverFeelsItsNeighbours) {
  std::vector<LaneFilm> films = lane_films(kind());
  films.insert(films.begin() + 3, overloaded(films[0]));
  films.insert(films.begin() + 7, overloaded(films[5]));
  expect_lanes_apart(kind(), films);
}

TEST_P(LaneNewtonOf, AFilmNeverFeelsANeighbourThatIsNotANumber) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  std::vector<LaneFilm> films = lane_films(kind());
  films.resize(4);
  LaneFilm broken = films[1];
  broken.first.mass_per_area[5] = std::numeric_limits<double>::quiet_NaN();
  films.insert(films.begin() + 1, broken);
  EXPECT_TRUE(taken_through(kind(), films, {1}, {0}).at(1).failed);
  expect_lanes_apart(kind(), films);
}

TEST_P(LaneNewtonOf, OnlyTheOverloadedFail) {
  std::vector<LaneFilm> films = lane_films(kind());
  films.push_back(overloaded(films[0]));
  for (const auto& [i, passage] : taken_through(kind(), films, {2, 3, 10, 0, 1, 4, 5, 6, 7, 8, 9}, up_to(2))) {
    EXPECT_EQ(passage.failed, i == 10) << "film " << i;
    EXPECT_EQ(passage.states.size(), i == 10 ? 2u : 4u);
  }
}

/// Largest relative difference of film and pressure.
double difference(const LaneFilm& film, const FilmState& a, const FilmState& b) {
  double largest = std::abs(std::log(a.h_m / b.h_m));
  for (std::size_t i = 0; i < a.p.size(); ++i) {
    largest = std::max(largest, std::abs(a.p[i] - b.p[i]) / film.steps[0].mean_pressure(film.problem.grid));
  }
  return largest;
}

// Both stop where an iteration changes less than the root of the tolerance; by quadratic convergence both are then
// within some tens of it (1e-10) of the solution, which a few steps add up.
constexpr double kBothConverged = 1e-8;

TEST_P(LaneNewtonOf, FindsTheFilmsThatTheSingleSolverFinds) {
  const std::vector<LaneFilm> films = lane_films(kind());
  const std::vector<int> all = up_to(static_cast<int>(films.size()));
  for (const auto& [i, passage] :
       taken_through(kind(), films, {all.begin(), all.end()}, up_to(kind().kernels->width))) {
    const LaneFilm& film = films[i];
    ASSERT_GT(film.first.h_m, 0) << "film " << i;
    FilmWorkspace workspace(film.problem);
    FilmState before = film.first;
    ASSERT_EQ(passage.states.size(), film.steps.size()) << "film " << i;
    for (std::size_t step = 0; step < film.steps.size(); ++step) {
      FilmState state = before;
      const FilmReport report = solve_film(film.problem, film.steps[step], before, state, workspace);
      ASSERT_TRUE(report.converged && report.route == Route::kNewton) << "film " << i;
      EXPECT_LT(difference(film, state, passage.states[step]), kBothConverged) << "film " << i << ", step " << step;
      before = state;
    }
  }
}

// Oils of other viscosity and density: what a step stores is weighed with the oil of each end of it.
TEST_P(LaneNewtonOf, TheOilMayChangeFromStepToStep) {
  std::vector<LaneFilm> films = lane_films(kind());
  films = {with_changing_oil(kind(), films[0], 403), with_changing_oil(kind(), films[4], 320)};
  for (const auto& [i, passage] : taken_through(kind(), films, {0, 1}, {0, 1})) {
    const LaneFilm& film = films[i];
    FilmWorkspace workspace(film.problem);
    FilmState before = film.first;
    ASSERT_EQ(passage.states.size(), film.steps.size()) << "film " << i;
    for (std::size_t step = 0; step < film.steps.size(); ++step) {
      const FilmInputs& inputs = film.steps[step];
      FilmState alone = before;
      ASSERT_TRUE(solve_film(film.problem, inputs, before, alone, workspace).converged);
      const FilmState& state = passage.states[step];
      EXPECT_LT(difference(film, state, alone), 1e-11) << "film " << i << ", step " << step;
      double stored = 0;
      for (std::size_t k = 0; k < state.p.size(); ++k) {
        const double mass = inputs.oil->density(state.p[k]) * film_content(kind().cavitation, state.deficit[k]) *
                            (state.h_m + film.problem.grid.node_height[k]);
        EXPECT_NEAR(state.mass_per_area[k] / mass, 1, 1e-9);  // of fits
        stored += film.problem.grid.share[k] * (state.mass_per_area[k] - before.mass_per_area[k]) / inputs.time_step;
      }
      if (kind().cavitation == Cavitation::kMassConserving) {
        const FilmIntegrals sums = film_integrals(film.problem, inputs, before, state);
        EXPECT_NEAR((sums.flow_left - sums.flow_right - stored) / sums.flow_middle, 0, 1e-9);
      }
      before = state;
    }
  }
}

// A node that leaves the film is put just into the cavity, whatever the load has become since the lane was bound: by
// more than rounding and it would be counted as one.
TEST_P(LaneNewtonOf, ANodeThatLeavesTheFilmIsNotACavityYet) {
  const LaneFilm film = lane_films(kind()).front();
  LaneNewton newton(*kind().kernels, kind().kernels->width, 100);
  newton.bind(0, film.problem);
  FilmInputs low = film.steps.front();
  low.load *= 1e-2;
  const auto start = [&](const FilmInputs& inputs) {
    FilmState full = film.first;
    full.p.assign(full.p.size(), 1.2 * inputs.p_cavitation);
    full.deficit.assign(full.p.size(), 0.0);
    newton.start(0, inputs, full, full, full.h_m, Unknowns::kFilmAlone, kind().laws);
  };
  start(low);
  FilmInputs high = film.steps.front();
  high.load *= 1e2;
  start(high);
  newton.iterate();
  FilmState once;
  newton.read(0, once);
  int left = 0;
  for (const double deficit : once.deficit) {
    left += deficit > 0;
    EXPECT_FALSE(is_cavity(deficit));
  }
  EXPECT_GT(left, 0);
}

// One iteration of two films, each deep in contact where the other is out of its reach: there the polynomial of the
// contact, taken far out of its range, overflows.
TEST_P(LaneNewtonOf, ContactOutOfReachOfOneFilmOnlyStaysANumber) {
  const std::vector<LaneFilm> films = lane_films(kind());
  LaneNewton newton(*kind().kernels, kind().kernels->width, 100);
  for (const auto& [lane, i] : std::map<int, int>{{0, 2}, {1, 7}}) {
    newton.bind(lane, films[i].problem);
    newton.start(lane, films[i].steps[0], films[i].first, films[i].first, 0.5 * films[i].contact->parameters().sigma,
                 Unknowns::kFilmAndSeparation, kind().laws);
  }
  newton.iterate();
  for (const int lane : {0, 1}) EXPECT_NE(newton.phase(lane), Phase::kFailed) << "lane " << lane;
}

}  // namespace
}  // namespace ringfilm::film::testing
