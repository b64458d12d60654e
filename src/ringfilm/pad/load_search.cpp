#include "ringfilm/pad/load_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ringfilm/pad/steady_film.hpp"

namespace ringfilm::pad {
namespace {

constexpr int kCellsOfScan = 200;   // at most: enough to see where the load is crossed
constexpr double kStep = 1.3;       // from one film of the scan to the next
constexpr double kThinnest = 1e-9;  // smallest separation of the scan [m]: molecules
/// So many films in a row that were not found, on the finest grid either: from there on that grid is not tried, which
/// takes seconds a film in two dimensions.
constexpr int kMaxFinestInRow = 3;
constexpr int kHalvings = 12;         // halvings of a step of the scan, towards a film that was not found
constexpr int kMaxEvaluations = 100;  // bisection alone takes 45 from one film of the scan to the next
constexpr double kLnResolution = 1e-13;
/// Relative error of a load that is found. Where the load jumps, as with another cavity, no film carries it.
constexpr double kLoadError = 1e-6;
/// Steps of a golden-section search, which then has the place of an extremum to 1 % of a step of the scan: to 1e-4 of
/// what the load changes by in that step.
constexpr int kGoldenSteps = 10;

/// A film of the scan, and what it carries beyond the load.
struct Tried {
  double h_m;     ///< [m]
  double excess;  ///< [N/m]
};

/// Two films next to each other in the scan, between which the load is crossed.
struct Bracket {
  double thick, thin;  ///< h_m [m]
  Slope slope;
};

class Search {
 public:
  Search(PadFilms& films, double load, Effort& effort)
      : films_(films), setup_(films.finest().setup()), load_(load), effort_(effort) {}

  /// An infinitely wide pad on the grid of the case: a coarser one may not have the places that carry. A film in two
  /// dimensions costs seconds there, and is searched on a coarse grid first.
  LoadSearch run() {
    const cycle::Solver& solver = setup_.input.solver;
    const bool is_coarser = solver.cells > kCellsOfScan || solver.cells_y > kCellsOfScan;
    if (setup_.surface && is_coarser) {
      const auto coarse =
          pad_film(setup_, {std::min(solver.cells, kCellsOfScan), std::min(solver.cells_y, kCellsOfScan)});
      if (search(*coarse)) return found_;
    }
    if (!search(films_.finest())) found_.film.reset();
    return found_;
  }

 private:
  bool search(PadFilm& grid) {
    grid_ = &grid;
    found_ = {};
    unsolved_in_row_ = 0;
    std::vector<Bracket> brackets = this->brackets(scan());
    const auto falls = [](const Bracket& b) { return b.slope == Slope::kFalling; };
    found_.n_separations = static_cast<int>(brackets.size());
    found_.n_stable = static_cast<int>(std::count_if(brackets.begin(), brackets.end(), falls));
    std::stable_partition(brackets.begin(), brackets.end(), falls);  // each kind from thick to thin
    for (const Bracket& bracket : brackets) {
      found_.slope = bracket.slope;
      // What a film brings along fills a share of the inlet that depends on the separation.
      const bool is_known_inlet = !setup_.supply();
      if (bracket.slope == Slope::kFalling && is_known_inlet) found_.film = by_newton(bracket);
      if (!carries_load(found_.film)) found_.film = by_bracket(bracket);
      if (carries_load(found_.film)) return true;
    }
    return false;
  }

  /// What films from the length of the pad down to molecules carry, without those that were not found.
  std::vector<Tried> scan() {
    std::vector<Tried> tried;
    bool was_found = false;
    film::FilmState state = grid_->full(setup_.input.pad.length);
    found_.thickest = found_.thinnest = setup_.input.pad.length;
    for (double h_m = setup_.input.pad.length; h_m > kThinnest; h_m /= kStep) {
      found_.thinnest = h_m;
      if (const auto carried = load_at(h_m, state)) {
        tried.push_back({h_m, *carried - load_});
        was_found = true;
        continue;
      }
      if (was_found) approach(h_m, state, tried);
      was_found = false;
      ++found_.n_unsolved;
    }
    return tried;
  }

  /// Films ever closer to a thinner one that was not found: where viscosity runs away the load rises steeply there.
  void approach(double not_found, film::FilmState& state, std::vector<Tried>& tried) {
    double low = std::log(not_found), high = std::log(tried.back().h_m);
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (low + high);
      if (const auto carried = load_at(std::exp(middle), state)) {
        tried.push_back({std::exp(middle), *carried - load_});
        high = middle;
      } else {
        low = middle;
      }
    }
  }

  /// @param state film that is near, and then this one; nothing: no film was found [N/m]
  std::optional<double> load_at(double h_m, film::FilmState& state) {
    film::FilmState next = state;
    next.h_m = h_m;
    const film::FilmInputs inputs = setup_.steady_inputs();
    bool solved = solve_at_separation(*grid_, inputs, 0, state, next, effort_);
    if (!solved) {
      next = grid_->full(h_m);
      solved = solve_at_separation(*grid_, inputs, 0, state, next, effort_);
    }
    double carried = 0;
    if (solved) {
      state = std::move(next);
      carried = grid_->load(state);
    } else {
      const auto film = unsolved_in_row_ < kMaxFinestInRow ? film_at(h_m) : std::nullopt;
      if (!film) {
        ++unsolved_in_row_;
        return std::nullopt;
      }
      carried = films_.finest().load(*film);
    }
    unsolved_in_row_ = 0;
    if (!found_.most || carried > found_.most->load) found_.most = {carried, h_m};
    if (!found_.least || carried < found_.least->load) found_.least = {carried, h_m};
    return carried;
  }

  std::vector<Bracket> brackets(const std::vector<Tried>& tried) {
    std::vector<Bracket> found;
    const auto add = [&](const Tried& thick, const Tried& thin) {
      if ((thick.excess < 0) == (thin.excess < 0)) return;
      found.push_back({thick.h_m, thin.h_m, thick.excess < 0 ? Slope::kFalling : Slope::kRising});
    };
    for (std::size_t k = 1; k < tried.size(); ++k) {
      if (k + 1 < tried.size()) {
        if (const auto between = extremum(tried[k - 1], tried[k], tried[k + 1])) {
          // The load is crossed twice within two steps of the scan.
          add(tried[k - 1], *between);
          add(*between, tried[k + 1]);
          ++k;
          continue;
        }
      }
      add(tried[k - 1], tried[k]);
    }
    return found;
  }

  /// A film between three that carry less than the load and that carries more, or the other way round: near the most
  /// (the least) that films there carry. Nothing: there is none, or the three show no extremum towards the load.
  std::optional<Tried> extremum(const Tried& thick, const Tried& middle, const Tried& thin) {
    const double sign = middle.excess < 0 ? 1 : -1;  // the excess times it is below zero
    const bool same_side = sign * thick.excess < 0 && sign * thin.excess < 0;
    const bool is_extremum = sign * middle.excess >= sign * thick.excess && sign * middle.excess >= sign * thin.excess;
    if (!same_side || !is_extremum || thick.excess == thin.excess) return std::nullopt;
    constexpr double kGolden = 0.3819660112501051;
    film::FilmState state = grid_->full(middle.h_m);
    double low = std::log(thin.h_m), high = std::log(thick.h_m), best = std::log(middle.h_m);
    double of_best = sign * middle.excess;
    for (int step = 0; step < kGoldenSteps; ++step) {
      const bool in_upper = high - best > best - low;
      const double at = in_upper ? best + kGolden * (high - best) : best - kGolden * (best - low);
      const auto carried = load_at(std::exp(at), state);
      if (!carried) return std::nullopt;
      const double here = sign * (*carried - load_);
      if (here >= 0) return Tried{std::exp(at), *carried - load_};
      if (here > of_best) {
        (in_upper ? low : high) = best;
        best = at;
        of_best = here;
      } else {
        (in_upper ? high : low) = at;
      }
    }
    return std::nullopt;
  }

  std::optional<film::FilmState> film_at(double h_m) {
    return steady_film_at(films_, h_m - setup_.lowest_gap, effort_);
  }
  bool carries_load(const std::optional<film::FilmState>& film) {
    return film && std::abs(films_.finest().load(*film) - load_) <= kLoadError * std::abs(load_);
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

  /// A separation of the finest grid. @param excess what its film carries beyond the load [N/m]
  struct Evaluated {
    double ln_h, excess;
  };
  std::optional<Evaluated> evaluated(double ln_h, std::optional<film::FilmState>& film) {
    film = film_at(std::exp(ln_h));
    if (!film) return std::nullopt;
    return Evaluated{ln_h, films_.finest().load(*film) - load_};
  }

  /// An end of the bracket, which may be one of a coarser grid: a step further, or where no film is found there, the
  /// end itself.
  std::optional<Evaluated> end_of_bracket(double h_m, double outwards) {
    std::optional<film::FilmState> film;
    auto end = evaluated(std::log(h_m) + outwards, film);
    return end ? end : evaluated(std::log(h_m), film);
  }

  /// The crossing by false position and bisection in turn, beside separations at which no film is found.
  std::optional<film::FilmState> by_bracket(const Bracket& bracket) {
    const auto differ = [](const std::optional<Evaluated>& low, const std::optional<Evaluated>& high) {
      return low && high && (low->excess < 0) != (high->excess < 0);
    };
    std::optional<film::FilmState> film;
    auto low = end_of_bracket(bracket.thin, -std::log(kStep)), high = end_of_bracket(bracket.thick, std::log(kStep));
    if (!differ(low, high)) {  // a step further lies beyond an extremum
      low = evaluated(std::log(bracket.thin), film);
      high = evaluated(std::log(bracket.thick), film);
    }
    if (!differ(low, high)) return std::nullopt;
    for (int k = 0; k < kMaxEvaluations && high->ln_h - low->ln_h > kLnResolution; ++k) {
      const double by_secant = low->excess / (low->excess - high->excess);
      std::optional<Evaluated> next;
      for (const double share : {k % 2 == 0 ? by_secant : 0.5, 0.5, 0.3, 0.7}) {
        if (!next) next = evaluated(low->ln_h + share * (high->ln_h - low->ln_h), film);
      }
      if (!next || carries_exactly(*next)) return film;
      ((next->excess < 0) == (low->excess < 0) ? low : high) = next;
    }
    return film;
  }
  /// To rounding of the sum over the nodes.
  bool carries_exactly(const Evaluated& at) const {
    constexpr double kRounding = 1e-14;
    return std::abs(at.excess) <= kRounding * std::abs(load_);
  }

  PadFilms& films_;
  const PadSetup& setup_;
  double load_;
  Effort& effort_;
  PadFilm* grid_ = nullptr;  ///< film of the scan
  int unsolved_in_row_ = 0;
  LoadSearch found_;
};

}  // namespace

LoadSearch steady_film_under(PadFilms& films, double load, Effort& effort) { return Search(films, load, effort).run(); }

}  // namespace ringfilm::pad
