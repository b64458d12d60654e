#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../../traps/floating_point_traps.hpp"
#include "film_cases.hpp"

namespace ringfilm::film::testing {
namespace {

TEST(FilmSolver, NotANumberIsNeverASolution) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  constexpr double b = 1.2e-3;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SmoothFilm film(
      50, b, [](double x) { return 8e-6 * std::pow(x / b - 0.4, 2); }, 0.005, Cavitation::kMassConserving);
  FilmInputs sound = film.inputs();
  sound.U = 6;
  sound.left.pressure = sound.right.pressure = sound.p_cavitation = 1e5;
  sound.load = 9e5 * b;
  sound.time_step = 1e-4;
  FilmWorkspace workspace(film.problem);
  const FilmState start = steady_under_load(film.problem, sound, 1e-6).state;
  const auto converges = [&](const FilmInputs& inputs, const FilmState& previous, const FilmState& guess) {
    FilmState state = guess;
    FilmState fixed = guess;
    return solve_film(film.problem, inputs, previous, state, workspace).converged ||
           solve_film_at_separation(film.problem, inputs, previous, fixed, workspace).converged;
  };
  ASSERT_TRUE(converges(sound, start, start));

  FilmState broken = start;
  broken.mass_per_area[10] = nan;
  EXPECT_FALSE(converges(sound, broken, start));
  broken = start;
  broken.p[10] = nan;
  EXPECT_FALSE(converges(sound, start, broken));
  broken = start;
  broken.h_m = nan;
  EXPECT_FALSE(converges(sound, start, broken));
  const auto refuses = [&](const auto& corrupt) {
    FilmInputs inputs = sound;
    corrupt(inputs);
    EXPECT_FALSE(converges(inputs, start, start));
  };
  refuses([nan](FilmInputs& inputs) { inputs.U = nan; });
  refuses([nan](FilmInputs& inputs) { inputs.left.pressure = nan; });
  refuses([nan](FilmInputs& inputs) { inputs.p_cavitation = nan; });
}

}  // namespace
}  // namespace ringfilm::film::testing
