#include "ringfilm/film/wall_transport.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "film_cases.hpp"
#include "gas_edge_cases.hpp"

/// Oil next to gas that moves with the wall, eq-wall-transport.
namespace ringfilm::film::testing {
namespace {

constexpr double kWay = 0.11e-3;  // [m], nine cells

/// A dry ring: 0.2 um on the wall, with a hump of 1 um ahead of the lowest place. Density 1.
struct DryRing {
  static constexpr int kCells = 100;

  explicit DryRing(double U) : film(film_of(GasFilm{.crown = 40e-6}, kCells)) {
    inputs = film.inputs();
    inputs.U = U;
    inputs.left = inputs.right = {1e5, EdgeFluid::kGas};
    inputs.left.supply = inputs.right.supply = 0.2e-6;
    inputs.time_step = kWay / std::abs(U);
    state = with(0);
  }
  double hump(double x) const {
    const double width = film.problem.grid.width, from_middle = x - (inputs.U > 0 ? 0.2 : 0.8) * width;
    const double t = from_middle / 0.1e-3;
    return 0.2e-6 + (std::abs(t) < 1 ? 0.5e-6 * (1 + std::cos(std::numbers::pi * t)) : 0);
  }
  /// The oil after the wall has moved by `way`.
  FilmState with(double way) const {
    FilmState oil;
    oil.h_m = 1e-6;
    const FilmGrid& grid = film.problem.grid;
    for (int i = 0; i <= kCells; ++i) {
      const double f = hump(grid.x[i] - (inputs.U > 0 ? way : -way)), h = oil.h_m + grid.node_height[i];
      oil.p.push_back(1e5);
      oil.deficit.push_back(1 - f / h);
      oil.mass_per_area.push_back(f);
    }
    return oil;
  }
  double all(const FilmState& oil) const {
    double sum = 0;
    for (int i = 1; i < kCells; ++i) sum += film.problem.grid.share[i] * oil.mass_per_area[i];
    return sum;
  }

  decltype(film_of(GasFilm{}, kCells)) film;
  FilmInputs inputs;
  FilmState state;
};

TEST(WallTransport, AHumpMovesWithTheWallAndKeepsItsShape) {
  for (const double U : {6.5, -6.5}) {
    const DryRing ring(U);
    // A balance that has spread the hump over the way of the step: its oil counts, and not its place.
    FilmState state = ring.with(kWay);
    const FilmState want = state;
    const auto is_ahead = [U](int i) { return (i < DryRing::kCells / 2) == (U > 0); };
    double oil = 0, length = 0;
    for (int i = 1; i < DryRing::kCells; ++i) {
      if (!is_ahead(i)) continue;
      oil += ring.film.problem.grid.share[i] * state.mass_per_area[i];
      length += ring.film.problem.grid.share[i];
    }
    for (int i = 1; i < DryRing::kCells; ++i) {
      if (!is_ahead(i)) continue;
      state.mass_per_area[i] = oil / length;
      state.deficit[i] = 1 - state.mass_per_area[i] / (state.h_m + ring.film.problem.grid.node_height[i]);
    }
    const double before = ring.all(state);
    PassedOil passed{0.2e-6 * kWay, 0.2e-6 * kWay};
    move_with_wall(ring.film.problem, ring.inputs, ring.state, kWay, passed, state);
    EXPECT_NEAR(ring.all(state) + passed.out, before + 0.2e-6 * kWay, 1e-12 * before) << U;
    for (int i = 5; i < DryRing::kCells - 5; ++i) {
      if (std::abs(i - DryRing::kCells / 2) < 10) continue;  // next to the lowest place is what the balance let pass
      EXPECT_NEAR(state.mass_per_area[i], want.mass_per_area[i], 0.02e-6) << U << " node " << i;
      const double h = state.h_m + ring.film.problem.grid.node_height[i];
      EXPECT_NEAR((1 - state.deficit[i]) * h, state.mass_per_area[i], 1e-12 * h) << i;
    }
  }
}

TEST(WallTransport, WithoutGasNothingMoves) {
  DryRing ring(6.5);
  ring.inputs.left = ring.inputs.right = {1e5};
  FilmState state = ring.state;
  PassedOil passed{1e-9, 2e-9};
  move_with_wall(ring.film.problem, ring.inputs, ring.with(kWay), kWay, passed, state);
  EXPECT_EQ(state.mass_per_area, ring.state.mass_per_area);
  EXPECT_EQ(passed.out, 2e-9);
}

TEST(WallTransport, ADebtIsPaidByNeighboursInTheSameGas) {
  const DryRing ring(6.5);
  std::vector<double> remembered = ring.state.mass_per_area;
  remembered[20] = -0.1e-6;
  remembered[80] = -0.1e-6;
  const auto all = [&] {
    double sum = 0;
    for (int i = 1; i < DryRing::kCells; ++i) sum += ring.film.problem.grid.share[i] * remembered[i];
    return sum;
  };
  const double before = all();
  EXPECT_GE(spread_debt_in_gas(ring.film.problem, ring.inputs, remembered), 0);
  EXPECT_NEAR(all(), before, 1e-15 * before);
  EXPECT_EQ(remembered[20], 0);
}

}  // namespace
}  // namespace ringfilm::film::testing
