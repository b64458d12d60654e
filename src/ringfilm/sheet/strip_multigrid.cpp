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
    fine.toward.push_back(is_wall ? 0.0 : std::abs(away) / coarse.places.distance(std::max(next, own)));
  }
  for (int s = 0; s < n; ++s) {
    coarse.low_ratio.push_back(fine.places.distance(2 * s) / coarse.places.distance(s));
    coarse.high_ratio.push_back(fine.places.distance(std::min(2 * s + 2, n_fine)) / coarse.places.distance(s + 1));
  }

  for (std::vector<double>* of : {&fine.to_coarse, &fine.of_own, &fine.of_beside}) {
    of->assign(fine.system.shape.size(), 0.0);
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

void StripMultigrid::coarsen(Level& fine, Level& coarse) {
  const StripSystem &from = fine.system, &to = coarse.system;
  const int n_fine = fine.places.n_strips(), n = coarse.places.n_strips();
  const std::size_t stride = from.shape.stride;
  for (int i = 1; i < from.shape.n_across - 1; ++i) {
    for (int s = 0; s < n; ++s) {
      // What the strips of the pair give; without a second one the first stands for both.
      const int first = 2 * s, second = std::min(2 * s + 1, n_fine - 1);
      double west = 0, along = 0, east = 0, low = 0, high = 0, film = 0;
      for (int of_pair = first; of_pair <= second; ++of_pair) {
        const std::size_t at = from.shape.at(i, of_pair);
        const double weight = fine.share[of_pair] * fine.film[at] * from.diagonal[at];
        fine.to_coarse[at] = weight;
        film = std::max(film, fine.film[at]);
        along += weight * (1 + from.low[at] + from.high[at]);
        west += weight * fine.film[at - stride] * from.west[at];
        east += weight * fine.film[at + stride] * from.east[at];
        if (of_pair == first) low = weight * from.low[at] * coarse.low_ratio[s];
        if (of_pair == second) high = weight * from.high[at] * coarse.high_ratio[s];
      }
      if (n == 1 && fine.places.ends == Ends::kJoined) low = high = 0;  // a strip beside itself exchanges nothing
      const double diagonal = film > 0 ? along - low - high : 1;
      const double inverse = 1 / diagonal;
      const std::size_t at = to.shape.at(i, s);
      coarse.film[at] = film;
      to.diagonal[at] = diagonal;
      to.west[at] = west * inverse;
      to.east[at] = east * inverse;
      to.low[at] = low * inverse;
      to.high[at] = high * inverse;
      for (int of_pair = first; of_pair <= second; ++of_pair) fine.to_coarse[from.shape.at(i, of_pair)] *= inverse;
    }
  }
  join_ends(to.shape, coarse.places.ends, coarse.film);
  if (coarse.places.ends == Ends::kOpen) {  // at the end, nothing is corrected
    for (int i = 0; i < to.shape.n_across; ++i) coarse.film[to.shape.at(i, -1)] = coarse.film[to.shape.at(i, n)] = 1;
  }
  for (int i = 1; i < from.shape.n_across - 1; ++i) {
    for (int s = 1; s < n_fine; s += 2) {
      const std::size_t at = from.shape.at(i, s);
      const double toward = fine.toward[s] * coarse.film[to.shape.at(i, s / 2 + 1)];
      fine.of_own[at] = fine.film[at] * (1 - toward);
      fine.of_beside[at] = fine.film[at] * toward;
    }
  }
}

void StripMultigrid::start_ends(const Level& coarse, const Level& fine, double* x) {
  const ZebraShape &from = coarse.system.shape, &to = fine.system.shape;
  for (int i = 1; i < from.n_across - 1; ++i) {
    for (const int s : {0, to.n_strips - 1}) {
      x[to.at(i, s)] = fine.film[to.at(i, s)] * coarse.x[from.at(i, s / 2)];
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
    kernels_->to_coarse(shape, here.to_coarse.data(), rhs, coarse.system.shape, coarse.rhs);
    solve_level(level + 1, coarse.rhs, coarse.x);
    kernels_->from_coarse(coarse.system.shape, coarse.x, shape, here.of_own.data(), here.of_beside.data(), x);
    if (ends == Ends::kJoined && shape.n_strips % 2 == 1) start_ends(coarse, here, x);
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
