#include "ringfilm/film/solver/separation_search.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <optional>

#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {
namespace {

constexpr double kRunaway = 1e6;       // multiple of the load beyond which only the sign counts
const double kStride = std::log(1.5);  // largest stride of the search in ln h_m
constexpr double kShorter = 0.25;  // the next stride, where there is no film: a film that is not found takes longest
const double kThicker = std::log(2.5);
/// Strides below this one no longer separate a film that has a solution from one that has none. In ln h_m, as a
/// multiple of the tolerance.
constexpr double kMinStride = 10;
constexpr int kMaxBrackets = 200;

/// A film at hand: ln h_m and W_h + W_a - W [N/m].
struct Point {
  double ln_h, excess;
};

class Search {
 public:
  Search(FilmAtSeparation& film, const SearchLimits& limits, FilmReport& report)
      : film_(film), limits_(limits), report_(report), least_stride_(kMinStride * limits.tolerance) {}

  bool run(double h_m) {
    std::optional<Point> start = film_at(std::log(h_m));
    // A film that is far too thin for the load may itself be beyond Newton's method; a thicker one never is.
    const double highest = std::log(limits_.thickest);
    for (double ln_h = std::log(h_m); !start && ln_h < highest;) start = film_at(ln_h += kThicker);
    if (!start) return false;
    std::optional<Point> other = across(*start);
    if (!other) return false;
    Point thin = *start, thick = *other;
    if (thin.ln_h > thick.ln_h) std::swap(thin, thick);
    return close(thin, thick);
  }

 private:
  /// Nothing where no film is found and the load of the failed attempt does not show that it is too thin.
  std::optional<Point> film_at(double ln_h) {
    is_solved_ = true;
    if (film_.solve_at(std::exp(ln_h))) return point(ln_h, film_.excess());
    is_solved_ = false;
    const double unfinished = film_.excess();
    return unfinished > limits_.load ? point(ln_h, unfinished) : std::nullopt;
  }

  std::optional<Point> point(double ln_h, double excess) const {
    if (std::isnan(excess)) return std::nullopt;
    return Point{ln_h, std::min(excess, kRunaway * limits_.load)};
  }

  /// From a film to one on the other side of the balance. Where there is no film, the next try is nearer.
  std::optional<Point> across(Point& from) {
    const double lowest = std::log(kThinnest), highest = std::log(limits_.thickest);
    // Films carry at least about twice as much at half the thickness, and far more next to one that has no pressure.
    double stride =
        std::copysign(std::clamp(std::abs(from.excess) / limits_.load, least_stride_, kStride), from.excess);
    while (from.ln_h >= lowest && from.ln_h <= highest) {
      const std::optional<Point> next = film_at(from.ln_h + stride);
      if (next && next->excess * from.excess <= 0) return next;
      if (next) {
        from = *next;
        stride = std::copysign(std::min(2 * std::abs(stride), kStride), stride);
      } else if (std::abs(stride *= kShorter) < least_stride_) {
        return std::nullopt;
      }
    }
    report_.failure = from.ln_h < lowest ? Failure::kOverloaded : Failure::kLiftedOff;
    return std::nullopt;
  }

  /// Between a film that is too thin and one that is too thick.
  bool close(Point thin, Point thick) {
    struct NoFilm {
      double ln_h;
    };
    const auto excess_at = [&](double ln_h) {
      const std::optional<Point> here = film_at(ln_h);
      if (!here) throw NoFilm{ln_h};
      return here->excess;
    };
    const double close_enough = 0.1 * limits_.tolerance;
    for (int k = 0; k < kMaxBrackets && thick.ln_h - thin.ln_h >= close_enough; ++k) {
      try {
        boost::uintmax_t evaluations = 60;
        const auto [low, high] = boost::math::tools::toms748_solve(
            excess_at, thin.ln_h, thick.ln_h, thin.excess, thick.excess,
            [&](double a, double b) { return b - a < close_enough; }, evaluations);
        report_.last_step = high - low;
        return high - low < close_enough && balances(0.5 * (low + high));
      } catch (const NoFilm& gap) {
        // Nearer and nearer to the thick film, from which one can be found.
        std::optional<Point> nearer;
        for (double way = gap.ln_h - thick.ln_h; !nearer && std::abs(way) > least_stride_;) {
          nearer = film_at(thick.ln_h + (way *= kShorter));
        }
        if (!nearer) return false;
        (nearer->excess > 0 ? thin : thick) = *nearer;
      }
    }
    return false;
  }

  bool balances(double ln_h) {
    const std::optional<Point> here = film_at(ln_h);
    return here && is_solved_ && std::abs(here->excess) < std::sqrt(limits_.tolerance) * limits_.load;
  }

  FilmAtSeparation& film_;
  const SearchLimits& limits_;
  FilmReport& report_;
  double least_stride_;
  bool is_solved_ = false;  ///< the last film converged
};

}  // namespace

bool search_separation(FilmAtSeparation& film, double h_m, const SearchLimits& limits, FilmReport& report) {
  report.route = Route::kSecant;
  report.exact_laws = true;
  return Search(film, limits, report).run(h_m);
}

}  // namespace ringfilm::film
