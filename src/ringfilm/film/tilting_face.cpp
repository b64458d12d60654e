#include "ringfilm/film/tilting_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ringfilm::film {
namespace {

/// Passes at the most; some five are usual.
constexpr int kMaxTilts = 30;
/// Rise of the face over its width by a change of the tilt that is let through, over h_m, in units of the tolerance,
/// and the least [-].
constexpr double kTiltTolerance = 1000, kRoundedTilt = 1e-9;
/// Share of the change that the first pass takes over: under a usual load film and section are about equally stiff [-].
constexpr double kFirstShare = 0.5;

/// Search for the tilt at which what the ring asks for less what the film has vanishes, as it falls with the tilt.
class TiltSearch {
 public:
  /// The next tilt after `excess` was found at `tilt` [rad].
  double next(double tilt, double excess) {
    if (excess > 0) {
      low_ = tilt;
    } else {
      high_ = tilt;
    }
    double to = tilt + kFirstShare * excess;
    if (before_) {
      const double slope = (excess - before_->excess) / (tilt - before_->tilt);
      if (slope < 0) to = tilt - excess / slope;
    }
    // A ring that a flank or both hold has one tilt whatever the film.
    const double asked = tilt + excess;
    if (asked_ && asked == *asked_) to = asked;
    const bool is_slow = before_ && std::abs(excess) > 0.5 * std::abs(before_->excess);
    before_ = {tilt, excess};
    asked_ = asked;
    const bool is_between = to > low_ && to < high_;
    const bool has_both = std::isfinite(low_) && std::isfinite(high_);
    if (has_both && (!is_between || (is_slow && to != asked))) return 0.5 * (low_ + high_);
    return is_between ? to : tilt + excess;
  }

 private:
  struct Found {
    double tilt, excess;
  };
  double low_ = -std::numeric_limits<double>::infinity(), high_ = std::numeric_limits<double>::infinity();
  std::optional<Found> before_;
  std::optional<double> asked_;
};

}  // namespace

TiltingFace::TiltingFace(const FilmGrid& grid)
    : level_(grid), lowest_(*std::min_element(grid.node_height.begin(), grid.node_height.end())) {}

void TiltingFace::lay(double tilt, FilmGrid& grid) const {
  const std::size_t n = level_.x.size();
  const auto rise = [&](double x) { return tilt * (level_.width / 2 - x); };
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    grid.node_height[i] = level_.node_height[i] + rise(level_.x[i]);
    lowest = std::min(lowest, grid.node_height[i]);
  }
  const double lower = lowest - lowest_;
  for (std::size_t i = 0; i < n; ++i) grid.node_height[i] -= lower;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    grid.face_height[i] = level_.face_height[i] + rise(level_.x[i] + 0.5 * level_.spacing[i]) - lower;
  }
}

FilmReport TiltingFace::solve(FilmProblem& problem, FilmState& state, const Solve& solve,
                              const Balance& balance) const {
  const double enough = std::max(kTiltTolerance * problem.tolerance, kRoundedTilt);
  const FilmState begin = state;
  FilmReport total;
  TiltSearch search;
  double tilt = begin.tilt;
  for (int pass = 0; pass < kMaxTilts; ++pass) {
    lay(tilt, problem.grid);
    total.add(solve(state));
    if (!total.converged && pass == 0) return total;
    if (!total.converged) break;
    state.tilt = tilt;
    const double excess = balance(state) - tilt;
    if (std::abs(excess) * level_.width <= enough * state.h_m) return total;
    tilt = search.next(tilt, excess);
  }
  state = begin;
  lay(begin.tilt, problem.grid);
  total.add(solve(state));
  return total;
}

}  // namespace ringfilm::film
