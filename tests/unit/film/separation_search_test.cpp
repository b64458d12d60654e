#include "ringfilm/film/solver/separation_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../traps/floating_point_traps.hpp"

namespace ringfilm::film {
namespace {

constexpr double kLoad = 100;
constexpr SearchLimits kLimits{0.1, kLoad, 1e-8};

/// Carries `a`/h^2, as a film does; cannot be solved below `unsolved`.
class Inverse : public FilmAtSeparation {
 public:
  Inverse(double a, double unsolved) : a_(a), unsolved_(unsolved) {}
  bool solve_at(double h_m) override {
    ++solves;
    h = h_m;
    if (h >= unsolved_) thinnest = std::min(thinnest, h);
    return h >= unsolved_;
  }
  double excess() const override { return h >= unsolved_ ? a_ / (h * h) - kLoad : std::nan(""); }
  double h = 0;
  double thinnest = 1;  ///< of those that were solved
  int solves = 0;

 private:
  double a_, unsolved_;
};

TEST(SeparationSearch, FindsWhereTheLoadBalances) {
  for (const double start : {1e-9, 1e-6, 1e-3}) {
    Inverse film(kLoad * 4e-12, 0);
    FilmReport report;
    ASSERT_TRUE(search_separation(film, start, kLimits, report)) << start;
    EXPECT_NEAR(film.h / 2e-6, 1, 1e-8);
    EXPECT_EQ(report.route, Route::kSecant);
    EXPECT_LE(report.last_step, 1e-9);
  }
}

TEST(SeparationSearch, StartsFromAThickerFilmWhereNoneIsFound) {
  const ringfilm::traps::NoTraps no_traps;  // films that are not numbers, on purpose
  Inverse film(kLoad * 4e-12, 1.2e-6);
  FilmReport report;
  ASSERT_TRUE(search_separation(film, 1e-7, kLimits, report));
  EXPECT_NEAR(film.h / 2e-6, 1, 1e-8);
}

TEST(SeparationSearch, ReportsAnOverloadAndALift) {
  Inverse weak(1e-40, 0), strong(1e3, 0);
  FilmReport report;
  EXPECT_FALSE(search_separation(weak, 1e-6, kLimits, report));
  EXPECT_EQ(report.failure, Failure::kOverloaded);
  EXPECT_FALSE(search_separation(strong, 1e-6, kLimits, report));
  EXPECT_EQ(report.failure, Failure::kLiftedOff);
}

TEST(SeparationSearch, GivesUpWhereNothingCanBeSolved) {
  const ringfilm::traps::NoTraps no_traps;  // films that are not numbers, on purpose
  Inverse film(1, std::numeric_limits<double>::infinity());
  FilmReport report;
  EXPECT_FALSE(search_separation(film, 1e-6, kLimits, report));
  EXPECT_EQ(report.failure, Failure::kNotConverged);
  EXPECT_LT(film.solves, 100);
}

TEST(SeparationSearch, GoesInShorterStridesWhereThinnerFilmsHaveNoPressure) {
  const ringfilm::traps::NoTraps no_traps;  // films that are not numbers, on purpose
  for (const double gap : {0.5, 1e-2, 1e-5}) {
    Inverse film(kLoad * 4e-12, 2e-6 * (1 - gap));  // balances at 2 um; nothing is found from just below that
    FilmReport report;
    ASSERT_TRUE(search_separation(film, 2.00001e-6, kLimits, report)) << gap;
    EXPECT_NEAR(film.h / 2e-6, 1, 1e-8) << gap;
  }
}

TEST(SeparationSearch, EndsNextToTheThinnestFilmThatHasAPressure) {
  const ringfilm::traps::NoTraps no_traps;  // films that are not numbers, on purpose
  Inverse film(kLoad * 4e-12, 2.5e-6);      // would balance at 2 um, where it has no pressure
  FilmReport report;
  EXPECT_FALSE(search_separation(film, 1e-5, kLimits, report));
  EXPECT_EQ(report.failure, Failure::kNotConverged);
  EXPECT_NEAR(film.thinnest / 2.5e-6, 1, 1e-6);
}

}  // namespace
}  // namespace ringfilm::film
