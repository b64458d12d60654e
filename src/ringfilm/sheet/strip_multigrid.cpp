#include "ringfilm/sheet/strip_multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace ringfilm::sheet {
namespace {

/// A mode across the strip hardly reaches a neighbour that is so many widths away.
constexpr double kFarApart = 1.0;

}  // namespace

double StripPlaces::distance(int s) const {
  const int n = n_strips();
  if (s > 0 && s < n) return centre[s] - centre[s - 1];
  switch (ends) {
    case Ends::kJoined:
      return n == 1 ? length : length - (centre.back() - centre.front());
    case Ends::kOpen:
      return s == 0 ? centre.front() : length - centre.back();
    case Ends::kClosed:
      break;
  }
  return length;
}

void StripMultigrid::join_ends(const ZebraShape& shape, Ends ends, double* x) {
  if (ends != Ends::kJoined) return;
  for (int i = 0; i < shape.n_across; ++i) {
    x[shape.at(i, -1)] = x[shape.at(i, shape.n_strips - 1)];
    x[shape.at(i, shape.n_strips)] = x[shape.at(i, 0)];
  }
}

StripMultigrid::Level StripMultigrid::coarser(Level& fine) {
  const int n_fine = fine.places.n_strips(), n = (n_fine + 1) / 2;
  Level coarse;
  coarse.places = {fine.places.ends, fine.places.length, std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  for (int s = 0; s < n_fine; ++s) {
    coarse.places.share[s / 2] += fine.places.share[s];
    coarse.places.centre[s / 2] += fine.places.share[s] * fine.places.centre[s];
  }
  for (int s = 0; s < n; ++s) coarse.places.centre[s] /= coarse.places.share[s];
  for (int s = 0; s < n_fine; ++s) {
    const int own = s / 2;
    const double away = fine.places.centre[s] - coarse.places.centre[own];
    const int next = away < 0 ? own - 1 : own + 1;
    const bool is_wall = fine.places.ends == Ends::kClosed && (next < 0 || next >= n);
    fine.share.push_back(fine.places.share[s] / coarse.places.share[own]);
    fine.beside.push_back(next);
    fine.toward.push_back(is_wall ? 0.0 : std::abs(away) / coarse.places.distance(std::max(next, own)));
  }
  for (int s = 0; s < n; ++s) {
    coarse.low_ratio.push_back(fine.places.distance(2 * s) / coarse.places.distance(s));
    coarse.high_ratio.push_back(fine.places.distance(std::min(2 * s + 2, n_fine)) / coarse.places.distance(s + 1));
  }

  coarse.system.shape = ZebraShape(fine.system.shape.n_across, n);
  const std::size_t size = coarse.system.shape.size();
  constexpr int kArrays = 10;
  constexpr std::size_t kPerLine = 8;
  coarse.memory.assign(kArrays * size + kPerLine, 0.0);
  double* array = coarse.memory.data();
  while (reinterpret_cast<std::uintptr_t>(array) % (kPerLine * sizeof(double)) != 0) ++array;
  StripSystem& to = coarse.system;
  for (double** of : {&to.west, &to.diagonal, &to.east, &to.low, &to.high, &to.inverse, &to.upper, &coarse.film,
                      &coarse.rhs, &coarse.x}) {
    *of = array;
    array += size;
  }
  std::fill_n(to.diagonal, size, 1.0);
  return coarse;
}

StripMultigrid::StripMultigrid(const SheetKernels& kernels, const StripSystem& system, StripPlaces places, double width)
    : kernels_(&kernels) {
  Level first;
  first.places = std::move(places);
  first.system = system;
  first.memory.assign(system.shape.size(), 0.0);
  first.film = first.memory.data();
  levels_.push_back(std::move(first));
  const auto nearest = [](const StripPlaces& of) {
    double least = of.length;
    for (int s = 1; s < of.n_strips(); ++s) least = std::min(least, of.distance(s));
    return least;
  };
  while (levels_.back().places.n_strips() > 1 && nearest(levels_.back().places) < kFarApart * width) {
    levels_.push_back(coarser(levels_.back()));
  }
}

void StripMultigrid::prepare(const double* z) {
  Level& first = levels_.front();
  for (std::size_t k = 0; k < first.memory.size(); ++k) first.film[k] = z[k] > 0 ? 1 : 0;
  for (std::size_t level = 0; level + 1 < levels_.size(); ++level) coarsen(levels_[level], levels_[level + 1]);
  for (Level& level : levels_) kernels_->factor(level.system);
}

void StripMultigrid::coarsen(const Level& fine, Level& coarse) {
  const StripSystem &from = fine.system, &to = coarse.system;
  const int n_fine = fine.places.n_strips(), n = coarse.places.n_strips();
  const std::size_t stride = from.shape.stride;
  for (int i = 1; i < from.shape.n_across - 1; ++i) {
    for (int s = 0; s < n; ++s) {
      // What the strips of the pair give; without a second one the first stands for both.
      double west = 0, along = 0, east = 0, low = 0, high = 0, film = 0;
      for (int of_pair = 2 * s; of_pair < std::min(2 * s + 2, n_fine); ++of_pair) {
        const std::size_t at = from.shape.at(i, of_pair);
        if (fine.film[at] == 0) continue;
        const double weight = fine.share[of_pair] * from.diagonal[at];
        film = 1;
        along += weight * (1 + from.low[at] + from.high[at]);
        west += weight * fine.film[at - stride] * from.west[at];
        east += weight * fine.film[at + stride] * from.east[at];
        if (of_pair == 2 * s) low = weight * from.low[at] * coarse.low_ratio[s];
        if (of_pair == std::min(2 * s + 1, n_fine - 1)) high = weight * from.high[at] * coarse.high_ratio[s];
      }
      const double diagonal = film > 0 ? along - low - high : 1;
      const std::size_t at = to.shape.at(i, s);
      coarse.film[at] = film;
      to.diagonal[at] = diagonal;
      to.west[at] = west / diagonal;
      to.east[at] = east / diagonal;
      to.low[at] = low / diagonal;
      to.high[at] = high / diagonal;
    }
  }
  join_ends(to.shape, coarse.places.ends, coarse.film);
  if (coarse.places.ends != Ends::kOpen) return;
  for (int i = 0; i < to.shape.n_across; ++i) coarse.film[to.shape.at(i, -1)] = coarse.film[to.shape.at(i, n)] = 1;
}

void StripMultigrid::restrict_to(const Level& fine, const double* rhs, Level& coarse) {
  const ZebraShape &from = fine.system.shape, &to = coarse.system.shape;
  const int n_fine = fine.places.n_strips(), n = coarse.places.n_strips();
  for (int i = 1; i < from.n_across - 1; ++i) {
    for (int s = 0; s < n; ++s) {
      double sum = 0;
      for (int of_pair = 2 * s; of_pair < std::min(2 * s + 2, n_fine); ++of_pair) {
        const std::size_t at = from.at(i, of_pair);
        sum += fine.share[of_pair] * fine.film[at] * fine.system.diagonal[at] * rhs[at];
      }
      const std::size_t at = to.at(i, s);
      coarse.rhs[at] = sum / coarse.system.diagonal[at];
    }
  }
}

void StripMultigrid::interpolate(const Level& coarse, const Level& fine, double* x) {
  const ZebraShape &from = coarse.system.shape, &to = fine.system.shape;
  const int n = fine.places.n_strips();
  for (int i = 1; i < from.n_across - 1; ++i) {
    for (int s = 0; s < n; ++s) {
      // Beside the last strip of an open sheet stands its end, where nothing is corrected.
      const double own = coarse.x[from.at(i, s / 2)];
      const std::size_t beside = from.at(i, fine.beside[s]);
      const std::size_t at = to.at(i, s);
      x[at] = fine.film[at] * (own + fine.toward[s] * coarse.film[beside] * (coarse.x[beside] - own));
    }
  }
}

void StripMultigrid::solve(const double* rhs, double* x) { solve_level(0, rhs, x); }

void StripMultigrid::solve_level(std::size_t level, const double* rhs, double* x) {
  const Level& here = levels_[level];
  const ZebraShape& shape = here.system.shape;
  const Ends ends = here.places.ends;
  if (level + 1 < levels_.size()) {
    Level& coarse = levels_[level + 1];
    restrict_to(here, rhs, coarse);
    solve_level(level + 1, coarse.rhs, coarse.x);
    interpolate(coarse, here, x);
  } else {
    std::fill_n(x, shape.size(), 0.0);
  }
  for (const int colour : {0, 1}) {
    join_ends(shape, ends, x);
    kernels_->relax(here.system, colour, rhs, x);
  }
  join_ends(shape, ends, x);
}

}  // namespace ringfilm::sheet
