#include "ringfilm/film/menisci/meniscus.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/film/gas_reach.hpp"

namespace ringfilm::film {
namespace {

/// Share of the gap that a meniscus leaves on the liner where it retreats as fast as one that nothing follows: oil that
/// the liner drains out of a gap which is a parabola comes to lie there in the mean [-].
constexpr double kHung = 0.73;

MenisciInputs::Edge edge(const ReducedPressure& oil, double pressure) {
  const double reduced = oil.of(pressure);
  return {pressure, reduced, oil.at(reduced).density};
}

}  // namespace

MenisciInputs::MenisciInputs(FilmInputs film_, double direction_, Surplus surplus_, double highest_pressure)
    : film(std::move(film_)),
      direction(direction_),
      surplus(surplus_),
      oil(*film.oil, highest_pressure),
      left(edge(oil, film.left.pressure)),
      right(edge(oil, film.right.pressure)) {}

MeniscusMotion meniscus_motion(double outward, double flow, double U, double h, double on_liner) {
  constexpr double kHalf = 0.5;
  MeniscusMotion motion;
  motion.leaves = outward * (flow - U * h) < 0;
  const double passing = U != 0 ? std::clamp(flow / (kHalf * U * h), 0.0, 1.0) : 0;
  motion.film = motion.leaves ? (kHung - (kHung - kHalf) * passing) * h : std::min(on_liner, kMaxEntering * h);
  motion.velocity = (flow - U * motion.film) / (h - motion.film);
  return motion;
}

double PassingFilm::at(double excess) const {
  return excess > 0 && most * std::sqrt(excess) > held ? held / std::sqrt(excess) : most;
}

double PassingFilm::excess(double lacking, double resistance) const {
  constexpr int kMaxIterations = 60;
  constexpr double kRounding = 1e-14;
  const double full = lacking + resistance * most;
  if (!(full > 0) || most * std::sqrt(full) <= held) return full;
  // Of u, the root of the excess: u^3 - lacking u - resistance held = 0, from above.
  double u = std::sqrt(full);
  for (int k = 0; k < kMaxIterations; ++k) {
    const double next = u - ((u * u - lacking) * u - resistance * held) / (3 * u * u - lacking);
    if (!(next < u * (1 - kRounding))) break;
    u = next;
  }
  return u * u;
}

PassingFilm passing_film(const MenisciInputs& inputs, const MenisciInputs::Edge& gas, double throat_length, double h) {
  const double eta = inputs.oil.at(gas.reduced).slope * gas.density;
  return {0.5 * h, 0.5 * throat_reach(inputs.film.broken, eta, inputs.film.U, throat_length)};
}

}  // namespace ringfilm::film
