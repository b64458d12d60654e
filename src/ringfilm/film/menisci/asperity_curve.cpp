#include "ringfilm/film/menisci/asperity_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {
namespace {

/// Over the reach of a law, eight times the rms height of its surfaces: cubics a 15th of that height long are within
/// 1e-7.
constexpr int kPieces = 120;

}  // namespace

AsperityCurve::AsperityCurve(const FilmProblem& problem) {
  if (problem.contact == nullptr) return;
  spacing_ = problem.contact->reach() / kPieces;
  for (int k = 0; k <= kPieces; ++k) {
    double slope = 0;
    const double load = k < kPieces ? asperity_load(problem, k * spacing_, &slope) : 0;
    root_.push_back(load > 0 ? std::pow(load, 0.125) : 0);
    slope_.push_back(load > 0 ? 0.125 * root_.back() * slope / load * spacing_ : 0);
  }
}

double AsperityCurve::load(double h_m) const {
  const double place = spacing_ > 0 ? h_m / spacing_ : kPieces;
  if (!(place < kPieces)) return 0;
  const auto k = static_cast<std::size_t>(place);
  const double d = place - static_cast<double>(k), rise = root_[k + 1] - root_[k];
  const double bend = slope_[k] + slope_[k + 1] - 2 * rise;
  const double root = root_[k] + d * (slope_[k] + d * (rise - slope_[k] - bend + d * bend));
  const double square = root * root, fourth = square * square;
  return fourth * fourth;
}

double AsperityCurve::film_under(double wanted) const {
  double thin = 0, thick = spacing_ * kPieces;
  if (!(load(thin) > wanted)) return 0;
  // First the piece, then the place within it.
  const auto end = std::partition_point(
      root_.begin(), root_.end(), [root = std::pow(std::max(wanted, 0.0), 0.125)](double at) { return at > root; });
  const auto piece = static_cast<double>(end - root_.begin());
  thin = std::max(piece - 1, 0.0) * spacing_;
  thick = std::min(piece * spacing_, thick);
  constexpr int kHalvings = 40;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (thin + thick);
    (load(middle) > wanted ? thin : thick) = middle;
  }
  return thick;
}

}  // namespace ringfilm::film
