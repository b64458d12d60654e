#include "ringfilm/film/solver2d/bent_ring_guess.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/solver2d/film2d_solver.hpp"

namespace ringfilm::film {
namespace {

constexpr int kMaxIterations = 300;
constexpr double kEnough = 1e-6;
/// Between the film of a parabola, 1, and that of a slider whose inlet is far, 2.
constexpr double kPower = 1.5;
/// Largest share of the way to zero film thickness that one step covers.
constexpr double kMaxOfFilm = 0.9;

class RingOnSprings {
 public:
  RingOnSprings(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& across)
      : problem_(problem),
        inputs_(inputs),
        h_0_(across.h_m),
        at_edges_(0.5 * (inputs.strip.left.pressure + inputs.strip.right.pressure) * problem.strip.grid.width),
        by_film_(std::max(inputs.strip.load - at_edges_ - asperity_load(problem.strip, across.h_m), 0.0)),
        u_(problem.ring.n_unknowns(), 0.0) {
    for (std::size_t i = 0; i < u_.size(); i += 2) u_[i] = h_0_;
  }

  /// Separations and slopes.
  const std::vector<double>& balanced() {
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
      const std::vector<double> force = forces(u_);
      const std::vector<double> step = newton_step(force);
      double share = 1, most = 0;
      for (int j = 0; j < problem_.around.n_strips(); ++j) {
        const int i = problem_.ring.of_strip(j);
        if (step[i] < 0) share = std::min(share, -kMaxOfFilm * u_[i] / step[i]);
        most = std::max(most, std::abs(step[i]) / u_[i]);
      }
      move(step, force, share);
      if (most < kEnough) break;
    }
    return u_;
  }

 private:
  double load(double h, double* slope) const {
    const double film = by_film_ * std::pow(h_0_ / h, kPower);
    const double asperities = asperity_load(problem_.strip, h, slope);
    *slope -= kPower * film / h;
    return at_edges_ + film + asperities;
  }

  /// Away from the liner.
  std::vector<double> forces(const std::vector<double>& u) const {
    std::vector<double> force = bending_force(problem_.ring, inputs_, u);
    for (int j = 0; j < problem_.around.n_strips(); ++j) {
      const int i = problem_.ring.of_strip(j);
      double slope = 0;
      force[i] += problem_.around.share[j] * (load(u[i], &slope) - inputs_.load_of(j));
    }
    return force;
  }

  std::vector<double> newton_step(std::vector<double> force) const {
    constexpr int kWidth = ElasticRing::kWidth;
    std::vector<double> band = problem_.ring.band;
    for (int j = 0; j < problem_.around.n_strips(); ++j) {
      const int i = problem_.ring.of_strip(j);
      double slope = 0;
      load(u_[i], &slope);
      band[static_cast<std::size_t>(i) * kWidth] -= problem_.around.share[j] * slope;
    }
    factor_band(band);
    solve_band(band, force.data());
    return force;
  }

  /// Shortens the step until the force along it no longer points back beyond where it began to.
  void move(const std::vector<double>& step, const std::vector<double>& force, double share) {
    const auto along = [&](const std::vector<double>& of) {
      double sum = 0;
      for (std::size_t i = 0; i < step.size(); ++i) sum += step[i] * of[i];
      return sum;
    };
    const std::vector<double> start = u_;
    const double at_start = along(force);
    for (int halved = 0; halved < 30; ++halved, share /= 2) {
      for (std::size_t i = 0; i < u_.size(); ++i) u_[i] = start[i] + share * step[i];
      if (along(forces(u_)) > -0.5 * std::abs(at_start)) return;
    }
  }

  const Film2dProblem& problem_;
  const Film2dInputs& inputs_;
  double h_0_, at_edges_, by_film_;
  std::vector<double> u_;
};

}  // namespace

FilmState guess_of_bent_ring(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& across) {
  FilmState guess = of_strips(problem, across);
  guess.ring = RingOnSprings(problem, inputs, across).balanced();
  for (std::size_t i = 0; i < guess.ring.size(); i += 2) guess.ring[i] -= across.h_m;
  return guess;
}

}  // namespace ringfilm::film
