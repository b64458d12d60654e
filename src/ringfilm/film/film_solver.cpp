#include "ringfilm/film/film_solver.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {
namespace {

constexpr int kMostIterations = 40;         // of the coupled Newton
const double kLargestFall = std::log(0.4);  // trust region in ln h_m
const double kLargestRise = std::log(2.5);
constexpr double kBlindStep = 0.2;   // in ln h_m, where the load seems to rise with the film
constexpr double kThinnest = 1e-12;  // [m], below any film that a continuum describes
constexpr double kThickest = 1e2;    // widths: no wedge is left
constexpr double kRunaway = 1e6;     // multiple of the load beyond which only the sign counts

}  // namespace

FilmWorkspace::FilmWorkspace(const FilmProblem& problem) : system_(problem.grid.n_cells() - 1) {}

/// One step's Newton iteration over the workspace.
class CoupledNewton {
 public:
  CoupledNewton(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                FilmWorkspace& workspace)
      : problem_(problem),
        inputs_(inputs),
        previous_(previous),
        state_(state),
        work_(workspace),
        scale_(inputs.mean_pressure(problem.grid)) {
    impose_edges();
    z_from_state(state_, inputs_.p_cavitation, scale_, work_.z_);
    work_.oil_.update(*problem_.oil, state_.p);
    cavity_multiplier(problem_, state_, work_.oil_, work_.multiplier_);
  }

  enum class Unknowns { kFilmAndSeparation, kFilmAlone };

  /// Iterates until the stop test holds; true if it did.
  bool solve(Unknowns unknowns, FilmReport& report) {
    work_.update_.start();
    const int most = unknowns == Unknowns::kFilmAndSeparation
                         ? kMostIterations
                         : kMostIterations + problem_.grid.n_cells();  // a front may have to cross the face
    for (int iteration = 1; iteration <= most; ++iteration) {
      const double excess = assemble();
      auto& system = work_.system_;
      if (!system.eliminate()) return false;
      double d_ln_h = 0;
      if (unknowns == Unknowns::kFilmAndSeparation) {
        // The load carried must fall with h_m; where the linearisation says otherwise, only its sign is believed.
        d_ln_h = system.corner < 0 ? system.corner_rhs / system.corner : std::copysign(kBlindStep, excess);
        d_ln_h = std::clamp(d_ln_h, kLargestFall, kLargestRise);
      }
      system.back_substitute(d_ln_h);
      const auto outcome = work_.update_.apply(work_.z_, system.rhs, scale_);
      state_.h_m *= std::exp(d_ln_h);
      state_from_z(work_.z_, inputs_.p_cavitation, scale_, state_);
      ++report.iterations;
      report.last_step = std::max(outcome.largest, std::abs(d_ln_h));
      if (!std::isfinite(outcome.largest + d_ln_h + state_.h_m + excess)) return false;
      if (d_ln_h != 0 && (state_.h_m < kThinnest || state_.h_m > thickest())) return false;
      if (outcome.to_film + outcome.to_cavity == 0 && report.last_step <= std::sqrt(problem_.tolerance)) {
        finish();
        return true;
      }
    }
    return false;
  }

  /// The fallback: the load carried falls with h_m, so that a bracket can be closed on it.
  bool solve_by_search(const FilmState& guess, FilmReport& report) {
    report.route = Route::kSecant;
    bool solved = true;
    const auto excess_at = [&](double ln_h) {
      state_.h_m = std::exp(ln_h);
      if (!solve(Unknowns::kFilmAlone, report)) {
        restore(guess);
        state_.h_m = std::exp(ln_h);
        // Pressures that run away tell enough for a bracket: the film is too thin.
        solved = solved && (solve(Unknowns::kFilmAlone, report) || load_excess() > inputs_.load);
      }
      const double excess = load_excess();
      solved = solved && !std::isnan(excess);
      return solved ? std::min(excess, kRunaway * inputs_.load) : 0.0;
    };
    restore(guess);
    double a = std::log(guess.h_m);
    double excess_a = excess_at(a);
    // A film that is far too thin for the load may itself be beyond Newton's method; a thicker one never is.
    while (!solved && a < std::log(thickest())) {
      solved = true;
      a -= kLargestFall;
      excess_a = excess_at(a);
    }
    const double stride = std::copysign(std::log(1.5), excess_a);
    double b = a;
    double excess_b = excess_a;
    while (solved && excess_a * excess_b > 0) {
      if (b < std::log(kThinnest)) report.failure = Failure::kOverloaded;
      if (b > std::log(thickest())) report.failure = Failure::kLiftedOff;
      if (b < std::log(kThinnest) || b > std::log(thickest())) return false;
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
    const auto close_enough = [&](double low, double high) { return high - low < 0.1 * problem_.tolerance; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(excess_at, a, b, excess_a, excess_b, close_enough, evaluations);
    if (!solved) return false;
    const double rest = excess_at(0.5 * (low + high));
    report.last_step = high - low;
    return solved && close_enough(low, high) && std::abs(rest) < std::sqrt(problem_.tolerance) * inputs_.load;
  }

 private:
  void impose_edges() {
    state_.p.front() = inputs_.p_left;
    state_.p.back() = inputs_.p_right;
    state_.deficit.front() = state_.deficit.back() = 0;
  }

  void restore(const FilmState& guess) {
    state_ = guess;
    impose_edges();
    z_from_state(state_, inputs_.p_cavitation, scale_, work_.z_);
    state_from_z(work_.z_, inputs_.p_cavitation, scale_, state_);
  }

  /// Balance of mass and load row; returns W_h + W_a - W per length [N/m].
  double assemble() {
    work_.oil_.update(*problem_.oil, state_.p);
    assemble_balance(problem_, inputs_, previous_, state_, work_.oil_, scale_, work_.multiplier_, work_.system_);
    const int n = problem_.grid.n_cells();
    for (int i = 1; i < n; ++i) work_.system_.row[i - 1] = state_.deficit[i] == 0 ? problem_.grid.share[i] : 0.0;
    double d_load = 0;
    const double excess = load_excess(&d_load);
    work_.system_.corner = d_load * state_.h_m;
    work_.system_.corner_rhs = -excess;
    return excess;
  }

  double load_excess(double* d_load_dh = nullptr) const {
    const FilmGrid& grid = problem_.grid;
    const std::size_t n_nodes = grid.x.size();
    double load = hydrodynamic_load(problem_, state_);
    double slope = 0;
    const auto add_contact = [&](double h, double share) {
      if (h >= problem_.contact->reach()) return;
      double p_a;
      double dp_a;
      problem_.contact->pressure(h, p_a, dp_a);
      load += share * p_a;
      slope += share * dp_a;
    };
    if (problem_.contact == nullptr) {
      // smooth surfaces
    } else if (problem_.contact_spread == ContactSpread::kNominal) {
      add_contact(state_.h_m, grid.width);
    } else {
      for (std::size_t i = 0; i < n_nodes; ++i) add_contact(state_.h_m + grid.node_height[i], grid.share[i]);
    }
    if (d_load_dh != nullptr) *d_load_dh = slope;
    return load - inputs_.load;
  }

  double thickest() const { return kThickest * problem_.grid.width; }

  void finish() {
    work_.oil_.update(*problem_.oil, state_.p);
    complete_state(problem_, work_.oil_, state_);
  }

  const FilmProblem& problem_;
  const FilmInputs& inputs_;
  const FilmState& previous_;
  FilmState& state_;
  FilmWorkspace& work_;
  double scale_;
};

FilmReport solve_film(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                      FilmWorkspace& workspace) {
  FilmReport report;
  const FilmState guess = state;
  CoupledNewton newton(problem, inputs, previous, state, workspace);
  report.converged =
      newton.solve(CoupledNewton::Unknowns::kFilmAndSeparation, report) || newton.solve_by_search(guess, report);
  if (report.converged) report.failure = Failure::kNone;
  return report;
}

FilmReport solve_film_at_separation(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                                    FilmState& state, FilmWorkspace& workspace) {
  FilmReport report;
  CoupledNewton newton(problem, inputs, previous, state, workspace);
  report.converged = newton.solve(CoupledNewton::Unknowns::kFilmAlone, report);
  if (report.converged) report.failure = Failure::kNone;
  return report;
}

}  // namespace ringfilm::film
