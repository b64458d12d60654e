#include "ringfilm/film/separation_search.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {
namespace {

constexpr double kRunaway = 1e6;       // multiple of the load beyond which only the sign counts
const double kStride = std::log(1.5);  // of the search, in ln h_m
const double kThicker = std::log(2.5);

}  // namespace

bool search_separation(SoughtFilm& film, double h_m, const SearchLimits& limits, FilmReport& report) {
  report.route = Route::kSecant;
  report.exact_laws = true;
  bool solved = true;
  const auto excess_at = [&](double ln_h) {
    double excess = 0;
    if (film.solve_at(std::exp(ln_h))) {
      excess = film.excess();
    } else {
      const double unfinished = film.excess();
      if (film.solve_afresh_at(std::exp(ln_h))) {
        excess = film.excess();
      } else {
        // Pressures that run away tell enough for a bracket: the film is too thin. If one of the two films is no
        // number, the other one tells.
        excess = std::fmax(unfinished, film.excess());
        solved = solved && excess > limits.load;
      }
    }
    solved = solved && !std::isnan(excess);
    return solved ? std::min(excess, kRunaway * limits.load) : 0.0;
  };
  const double lowest = std::log(kThinnest), highest = std::log(limits.thickest);
  double a = std::log(h_m);
  double excess_a = excess_at(a);
  // A film that is far too thin for the load may itself be beyond Newton's method; a thicker one never is.
  while (!solved && a < highest) {
    solved = true;
    a += kThicker;
    excess_a = excess_at(a);
  }
  const double stride = std::copysign(kStride, excess_a);
  double b = a;
  double excess_b = excess_a;
  while (solved && excess_a * excess_b > 0) {
    if (b < lowest) report.failure = Failure::kOverloaded;
    if (b > highest) report.failure = Failure::kLiftedOff;
    if (b < lowest || b > highest) return false;
    a = b;
    excess_a = excess_b;
    b = a + stride;
    excess_b = excess_at(b);
  }
  if (!solved) return false;
  if (excess_b == 0) return true;
  if (a > b) {
    std::swap(a, b);
    std::swap(excess_a, excess_b);
  }
  boost::uintmax_t evaluations = 60;
  const auto close_enough = [&](double low, double high) { return high - low < 0.1 * limits.tolerance; };
  const auto [low, high] =
      boost::math::tools::toms748_solve(excess_at, a, b, excess_a, excess_b, close_enough, evaluations);
  if (!solved) return false;
  const double rest = excess_at(0.5 * (low + high));
  report.last_step = high - low;
  return solved && close_enough(low, high) && std::abs(rest) < std::sqrt(limits.tolerance) * limits.load;
}

}  // namespace ringfilm::film
