#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "film_cases.hpp"
#include "gas_edge_cases.hpp"
#include "ringfilm/film/menisci/menisci_film.hpp"
#include "ringfilm/film/menisci/rosenbrock_step.hpp"

namespace ringfilm::film::testing {
namespace {

using Rosenbrock = RosenbrockStep<3>;

/// A film that a liner with oil of density 1 feeds from the left, under a load of time: h_m and both menisci.
class FedFilm {
 public:
  FedFilm(const GasFilm& form, int n_cells)
      : smooth_(film_of(form, n_cells)), film_(smooth_.problem.grid, smooth_.problem) {
    inputs_ = inputs_of(form, smooth_);
    supply_ = form.h_star / 2;
    state_.left = {form.begin, MeniscusPlace::kFree};
    state_.right = {form.end, MeniscusPlace::kFree};
  }

  MenisciFilm& film() { return film_; }
  FilmInputs& inputs() { return inputs_; }
  MenisciState& state() { return state_; }
  OnLiner on_liner() const { return {supply_, 0}; }

  MenisciInputs acting(double load) const {
    FilmInputs inputs = inputs_;
    inputs.load = load;
    return {inputs, 1, Surplus::kStays, 4 * load / smooth_.problem.grid.width};
  }
  MenisciBalance balance(const MenisciState& state) {
    return film_.balance(acting(inputs_.load), state, on_liner(), 0);
  }

  /// Rates of ln h_m and of both menisci, without a bead.
  template <class Load>
  Rosenbrock::Vector rate(const Load& load, double t, const Rosenbrock::Vector& y) {
    MenisciState state = state_;
    state.ln_h_m = y[0];
    state.left.x = y[1];
    state.right.x = y[2];
    const MenisciBalance found = film_.balance(acting(load(t)), state, on_liner(), 0);
    return {found.lift_rate / std::exp(y[0]), found.left.velocity, found.right.velocity};
  }

  /// Steps of equal length from `y`, by central differences.
  template <class Load>
  Rosenbrock::Vector integrated(const Load& load, double end, int steps, Rosenbrock::Vector y) {
    const auto f = [&](double t, const Rosenbrock::Vector& at) { return rate(load, t, at); };
    const Rosenbrock::Vector shift(1e-4, 1e-8, 1e-8);
    const double h = end / steps, later = 1e-4 * end;
    for (int k = 0; k < steps; ++k) {
      Rosenbrock::Begin begin;
      begin.t = k * h;
      begin.y = y;
      begin.rate = f(begin.t, y);
      for (int i = 0; i < 3; ++i) {
        Rosenbrock::Vector less = y, more = y;
        less[i] -= shift[i];
        more[i] += shift[i];
        begin.by_unknowns.col(i) = (f(begin.t, more) - f(begin.t, less)) / (2 * shift[i]);
      }
      const Rosenbrock::Vector by_time = (f(begin.t + later, y) - f(begin.t - later, y)) / (2 * later);
      y = Rosenbrock::take(begin, h, by_time, f).y;
    }
    return y;
  }

 private:
  SmoothFilm smooth_;
  MenisciFilm film_;
  FilmInputs inputs_;
  MenisciState state_;
  double supply_;
};

TEST(Menisci, AFilmComesToRestAsTheQuadratureHasIt) {
  for (const double supply : {0.55e-6, 0.58e-6}) {
    const GasFilm form = starved(supply);
    FedFilm film(form, 64);
    const double load = film.inputs().load;
    const Rosenbrock::Vector start(std::log(1.2 * form.h_m), 1.1 * form.begin, form.end - 0.05e-3);
    const Rosenbrock::Vector rest = film.integrated([=](double) { return load; }, 0.05, 1000, start);
    EXPECT_NEAR(std::exp(rest[0]) / form.h_m, 1, 1e-4) << supply;
    EXPECT_NEAR(rest[1], form.begin, 1e-6) << supply;
    EXPECT_NEAR(rest[2], form.end, 1e-6) << supply;
  }
}

TEST(Menisci, StepsAreOfThirdOrder) {
  const GasFilm form = starved(0.58e-6);
  FedFilm film(form, 64);
  const double mean = film.inputs().load;
  const auto load = [=](double t) { return mean * (1 + 0.2 * std::sin(2 * std::numbers::pi * t / 2e-3)); };
  const Rosenbrock::Vector start(std::log(form.h_m), form.begin, form.end);
  const Rosenbrock::Vector exact = film.integrated(load, 2e-3, 1280, start);
  const auto error = [&](int steps) { return std::abs(film.integrated(load, 2e-3, steps, start)[0] - exact[0]); };
  const double coarse = error(20), fine = error(40);
  EXPECT_LT(fine, 1e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 3, 0.4);
}

TEST(Menisci, ABrokenFilmIsReleasedWithoutAJump) {
  const GasFilm form = starved(0.58e-6);
  FedFilm film(form, 64);
  MenisciState held = film.state();
  held.right = {film.film().throat().x, MeniscusPlace::kAtThroat};
  // The film holds the gas at the throat below some h_m: there a meniscus without the gas is at rest, too.
  const auto excess = [&](double ln_h_m) {
    held.ln_h_m = ln_h_m;
    return film.balance(held).excess;
  };
  held.ln_h_m = root_of(excess, std::log(0.1e-6), std::log(3e-6));
  MenisciState released = held;
  released.right.place = MeniscusPlace::kFree;
  const MenisciBalance before = film.balance(held), after = film.balance(released);
  EXPECT_NEAR(before.excess / 20e5, 0, 1e-6);
  EXPECT_NEAR(after.flow_right / before.flow_right, 1, 1e-6);
  EXPECT_NEAR(after.lift_rate / before.lift_rate, 1, 1e-5);
  EXPECT_NEAR(after.right.velocity / film.inputs().U, 0, 1e-6);
  // One that falls presses oil out: its meniscus moves on into the widening gap. One that rises lets gas through.
  held.ln_h_m += 0.05;
  released.ln_h_m = held.ln_h_m;
  EXPECT_LT(film.balance(held).lift_rate, before.lift_rate);
  EXPECT_LT(film.balance(held).excess, 0);
  EXPECT_GT(film.balance(released).right.velocity, 0);
  held.ln_h_m -= 0.1;
  released.ln_h_m = held.ln_h_m;
  EXPECT_GT(film.balance(held).excess, 0);
  EXPECT_LT(film.balance(released).right.velocity, 0);
}

TEST(Menisci, AFilmEndsWhereItsPressureHasNoSlope) {
  const GasFilm form = starved(0.58e-6);
  FedFilm film(form, 64);
  film.state().ln_h_m = std::log(form.h_m);
  const MenisciBalance at_rest = film.balance(film.state());
  // A meniscus farther out, as after a dead centre: the film ends where it did, and oil hangs behind it.
  MenisciState hanging = film.state();
  hanging.right.x += 0.2e-3;
  const MenisciBalance found = film.balance(hanging);
  EXPECT_NEAR(found.outlet, form.end, 1e-6);
  EXPECT_NEAR(found.flow_left / at_rest.flow_left, 1, 1e-3);
  EXPECT_LT(found.right.velocity, 0);
  EXPECT_GT(found.film_mass, at_rest.film_mass);
}

TEST(Menisci, OneIterationIsExactToFirstOrder) {
  const GasFilm form = starved(0.58e-6);
  FedFilm film(form, 64);
  const MenisciInputs inputs = film.acting(film.inputs().load);
  film.state().ln_h_m = std::log(form.h_m);
  const MenisciBalance solved = film.balance(film.state());
  MenisciState shifted = film.state();
  shifted.ln_h_m += 1e-4;
  const double once =
      film.film().balance(inputs, shifted, film.on_liner(), solved.lift_rate, Iteration::kOnce).lift_rate;
  const double whole = film.balance(shifted).lift_rate;
  EXPECT_NEAR((once - solved.lift_rate) / (whole - solved.lift_rate), 1, 1e-2);
}

TEST(Menisci, PointsOfAGapAreTheSameInBothDirections) {
  const FilmGrid grid = uniform_grid(10, 1e-3, [](double x) { return 1e-3 * (x - 0.42e-3) * (x - 0.42e-3) / 1e-3; });
  GapPoints forward, back;
  forward.set(grid, 1e-6, 0.15e-3, 0.42e-3, 0.83e-3);
  back.set(grid, 1e-6, 0.83e-3, 0.42e-3, 0.15e-3);
  ASSERT_EQ(forward.size(), back.size());
  const std::size_t n = forward.size();
  EXPECT_EQ(forward.x()[forward.at_place()], 0.42e-3);
  std::vector<double> sum(GapPoints::most(grid));
  forward.integrate([&](std::size_t j) { return forward.h()[j]; }, sum);
  double weighed = 0;
  for (std::size_t j = 0; j < n; ++j) {
    EXPECT_NEAR(forward.x()[j], back.x()[n - 1 - j], 1e-15);
    EXPECT_NEAR(forward.h()[j], back.h()[n - 1 - j], 1e-15);
    weighed += back.weight()[j] * back.h()[j];
  }
  const auto whole = [](double x) { return 1e-6 * x + std::pow(x - 0.42e-3, 3) / 3; };
  EXPECT_NEAR(sum[n - 1] / (whole(0.83e-3) - whole(0.15e-3)), 1, 1e-9);
  EXPECT_NEAR(weighed / sum[n - 1], 1, 1e-12);
}

TEST(Menisci, AFreeSurfaceCarriesTwoThirdsOfItsFilm) {
  // f - f^3/(3 f*^2) is largest at f*, 2/3 of it.
  const GasFilm form = starved(0.58e-6);
  FedFilm film(form, 64);
  const MenisciInputs inputs = film.acting(film.inputs().load);
  const double length = 1e-4, h = 5e-6;
  const PassingFilm passing = passing_film(inputs, inputs.right, length, h);
  double most = 0;
  const double excess = 10e5;
  for (double f = 0; f < 2.5e-6; f += 1e-10)
    most = std::max(most, f - f * f * f * excess / (3 * form.eta * form.U * length));
  EXPECT_NEAR(passing.at(excess) / most, 1, 1e-6);
  EXPECT_EQ(passing.at(0), 0.5 * h);
  // The root of its own equation.
  const double found = passing.excess(2e5, 1e12);
  EXPECT_NEAR(found / (2e5 + 1e12 * passing.at(found)), 1, 1e-12);
}

TEST(Menisci, EnteringAndLeavingMeetAtTheSpeedOfTheLiner) {
  const double h = 2e-6, U = 5;
  for (const double outward : {-1.0, 1.0}) {
    for (const double flow : {U * h * (1 - 1e-9), U * h * (1 + 1e-9)}) {
      EXPECT_NEAR(meniscus_motion(outward, flow, U, h, 0.3e-6).velocity / U, 1, 1e-7);
    }
  }
}

TEST(Menisci, ReducedPressureIsTheIntegralOfTheLaws) {
  const auto oil = models::closed_form_oil(5e-3, 800.0, 0.6, {6e-10, 1.7e-9});
  const ReducedPressure reduced(*oil, 20e6);
  const auto K = [&](double p) { return oil->density(p) / oil->viscosity(p); };
  for (const double p : {1e5, 3e6, 12e6, 20e6}) {
    const double phi = integral(K, 0, p);
    EXPECT_NEAR(reduced.of(p) / phi, 1, 1e-6) << p;
    const auto at = reduced.at(phi);
    EXPECT_NEAR(at.pressure, p, 1e-7 * 20e6) << p;
    EXPECT_NEAR(at.slope * K(p), 1, 1e-4) << p;
    EXPECT_NEAR(at.density / oil->density(p), 1, 1e-6) << p;
  }
}

}  // namespace
}  // namespace ringfilm::film::testing
