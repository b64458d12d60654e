#include "ringfilm/pad/load_search.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <vector>

#include "ringfilm/pad/steady_film.hpp"

namespace ringfilm::pad {
namespace {

constexpr int kCellsOfScan = 200;   // at the most: enough to see where the load is crossed
constexpr int kCellsOfFilm2d = 50;  // likewise, in each direction of a film of two
constexpr double kStep = 1.3;       // from one film of the scan to the next
constexpr double kThinnest = 1e-9;  // of the scan [m]: molecules
constexpr int kMostEvaluations = 80;

/// Two films next to each other in the scan, one of which carries the load.
struct Bracket {
  double thick, thin;  ///< h_m [m]
  Slope slope;
};

class Search {
 public:
  Search(PadFilms& films, double load, Effort& effort)
      : films_(films), setup_(films.finest().setup()), load_(load), effort_(effort) {}

  LoadSearch run() {
    const std::vector<Bracket> brackets = scan();
    found_.n_separations = static_cast<int>(brackets.size());
    const auto falls = [](const Bracket& b) { return b.slope == Slope::kFalling; };
    auto chosen = std::find_if(brackets.begin(), brackets.end(), falls);  // from thick to thin
    if (chosen == brackets.end()) chosen = brackets.begin();
    if (chosen == brackets.end()) return found_;
    found_.slope = chosen->slope;
    found_.n_stable = static_cast<int>(std::count_if(brackets.begin(), brackets.end(), falls));
    // What a film brings along fills a share of the inlet that depends on the separation.
    const bool is_known_inlet = !setup_.supply();
    found_.film = chosen->slope == Slope::kFalling && is_known_inlet ? by_newton(*chosen) : std::nullopt;
    if (!found_.film) found_.film = by_bracket(*chosen);
    return found_;
  }

 private:
  std::vector<Bracket> scan() {
    const cycle::Solver& solver = setup_.input.solver;
    const int along = std::min(solver.cells, setup_.surface ? kCellsOfFilm2d : kCellsOfScan);
    const auto coarse = pad_film(setup_, {along, std::min(solver.cells_y, kCellsOfFilm2d)});
    const film::FilmInputs inputs = setup_.steady_inputs();
    std::vector<Bracket> brackets;
    std::optional<double> before;  // excess of the load at the film before, where there is one
    film::FilmState state = coarse->full(setup_.input.pad.length);
    for (double h_m = setup_.input.pad.length; h_m > kThinnest; h_m /= kStep) {
      film::FilmState next = state;
      next.h_m = h_m;
      bool solved = solve_at_separation(*coarse, inputs, 0, state, next, effort_);
      if (!solved) {
        next = coarse->full(h_m);
        solved = solve_at_separation(*coarse, inputs, 0, state, next, effort_);
      }
      if (!solved) {
        before.reset();
        continue;
      }
      state = next;
      const double carried = coarse->load(state);
      if (!found_.most || carried > found_.most->load) found_.most = {carried, h_m};
      if (!found_.least || carried < found_.least->load) found_.least = {carried, h_m};
      const double excess = carried - load_;
      if (before && (*before < 0) != (excess < 0)) {
        brackets.push_back({h_m * kStep, h_m, *before < 0 ? Slope::kFalling : Slope::kRising});
      }
      before = excess;
    }
    return brackets;
  }

  std::optional<film::FilmState> film_at(double h_m) {
    return steady_film_at(films_, h_m - setup_.lowest_gap, effort_);
  }

  /// Film and separation together, from the middle of the bracket; what it finds far outside is another answer.
  std::optional<film::FilmState> by_newton(const Bracket& bracket) {
    const auto guess = film_at(std::sqrt(bracket.thick * bracket.thin));
    if (!guess) return std::nullopt;
    film::FilmInputs inputs = setup_.steady_inputs();
    inputs.load = load_;
    film::FilmState state = *guess;
    const film::FilmReport report = films_.finest().solve(inputs, *guess, state);
    effort_.newton_iterations += report.iterations;
    const bool is_near = state.h_m < bracket.thick * kStep && state.h_m > bracket.thin / kStep;
    if (!report.converged || !is_near) return std::nullopt;
    // Once more with pressures measured by those of the film.
    return film_at(state.h_m);
  }

  std::optional<film::FilmState> by_bracket(const Bracket& bracket) {
    std::optional<film::FilmState> film;
    bool solved = true;
    const auto excess = [&](double ln_h) {
      if (solved) film = film_at(std::exp(ln_h));
      solved = solved && film;
      return solved ? films_.finest().load(*film) - load_ : 0.0;
    };
    // The bracket is one of the scan's grid: on this one the crossing may lie a little outside.
    const double thin = std::log(bracket.thin / kStep), thick = std::log(bracket.thick * kStep);
    const double at_thin = excess(thin), at_thick = excess(thick);
    if (!solved || (at_thin < 0) == (at_thick < 0)) return std::nullopt;
    boost::uintmax_t evaluations = kMostEvaluations;
    const auto close_enough = [](double low, double high) { return high - low < 1e-13; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(excess, thin, thick, at_thin, at_thick, close_enough, evaluations);
    if (!solved) return std::nullopt;
    return film_at(std::exp(0.5 * (low + high)));
  }

  PadFilms& films_;
  const PadSetup& setup_;
  double load_;
  Effort& effort_;
  LoadSearch found_;
};

}  // namespace

LoadSearch steady_film_under(PadFilms& films, double load, Effort& effort) { return Search(films, load, effort).run(); }

}  // namespace ringfilm::pad
