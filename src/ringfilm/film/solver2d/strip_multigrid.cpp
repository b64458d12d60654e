#include "ringfilm/film/solver2d/strip_multigrid.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/aligned.hpp"

namespace ringfilm::film {
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
  for (int s = 0; s < n_fine; ++s) fine.share.push_back(fine.places.share[s] / coarse.places.share[s / 2]);
  for (std::vector<double>* of : {&fine.to_coarse, &fine.of_own, &fine.of_beside}) {
    of->assign(fine.system.shape.size(), 0.0);
  }

  coarse.system.shape = ZebraShape(fine.system.shape.n_across, n);
  const std::size_t size = coarse.system.shape.size();
  constexpr int kArrays = 10;
  double* array = base::aligned_zeros(coarse.memory, kArrays * size);
  StripSystem& to = coarse.system;
  for (double** of : {&to.west, &to.diagonal, &to.east, &to.low, &to.high, &to.inverse, &to.upper, &coarse.film,
                      &coarse.rhs, &coarse.x}) {
    *of = array;
    array += size;
  }
  std::fill_n(to.diagonal, size, 1.0);
  return coarse;
}

StripMultigrid::Level StripMultigrid::part_of(const Level& whole, int begin, int end) {
  const int n = whole.places.n_strips();
  const StripPlaces& places = whole.places;
  Level part;
  part.places = places;
  if (begin > 0 || end < n) {
    part.places.ends = Ends::kOpen;
    part.places.centre.assign(places.centre.begin() + begin, places.centre.begin() + end);
    part.places.share.assign(places.share.begin() + begin, places.share.begin() + end);
  }
  part.system = whole.system;
  part.system.shape.n_strips = end - begin;
  const int offset = begin / 2;
  StripSystem& to = part.system;
  for (double** of : {&to.west, &to.diagonal, &to.east, &to.low, &to.high, &to.inverse, &to.upper}) {
    *of += offset;
  }
  part.film = whole.film + offset;
  return part;
}

StripMultigrid::StripMultigrid(const Film2dKernels& kernels, const StripSystem& system, StripPlaces places,
                               double width)
    : kernels_(&kernels) {
  finest_.places = std::move(places);
  finest_.system = system;
  finest_.memory.assign(system.shape.size(), 0.0);
  finest_.film = finest_.memory.data();
  const auto nearest = [](const StripPlaces& of) {
    double least = of.length;
    for (int s = 1; s < of.n_strips(); ++s) least = std::min(least, of.distance(s));
    return least;
  };
  const int n = finest_.places.n_strips();
  const auto is_close = [&](int s) { return finest_.places.distance(s) < kFarApart * width; };  // to the one before
  int begin = 0;
  while (begin < n) {
    int end = begin + 1;
    while (end < n && is_close(end)) ++end;
    if (end > begin + 1) {
      // Pairs begin at even strips.
      Run run{static_cast<std::size_t>(begin / 2), {}};
      run.levels.push_back(part_of(finest_, begin - begin % 2, end));
      while (run.levels.back().places.n_strips() > 1 && nearest(run.levels.back().places) < kFarApart * width) {
        run.levels.push_back(coarser(run.levels.back()));
      }
      runs_.push_back(std::move(run));
    }
    begin = end;
  }
}

void StripMultigrid::prepare(const double* z) {
  for (std::size_t k = 0; k < finest_.memory.size(); ++k) finest_.film[k] = z[k] > 0 ? 1 : 0;
  for (Run& run : runs_) {
    for (std::size_t level = 0; level + 1 < run.levels.size(); ++level) {
      coarsen(run.levels[level], run.levels[level + 1]);
      kernels_->factor(run.levels[level + 1].system);
    }
  }
  prepare_finest();
}

void StripMultigrid::prepare_finest() { kernels_->factor(finest_.system); }

void StripMultigrid::coarsen(Level& fine, Level& coarse) {
  const StripSystem &from = fine.system, &to = coarse.system;
  const int n_fine = fine.places.n_strips(), n = coarse.places.n_strips();
  const bool joined = fine.places.ends == Ends::kJoined;
  const std::size_t stride = from.shape.stride;
  const auto second_of = [n_fine](int s) { return std::min(2 * s + 1, n_fine - 1); };
  // Resistances in y: of half the way between the strips of a pair, which begins where the pair's pressure is.
  std::vector<double> half(n + 2);
  double* const half_of = half.data() + 1;
  for (int i = 0; i < from.shape.n_across; ++i) {
    for (int s = 0; s < n; ++s) {
      coarse.film[to.shape.at(i, s)] =
          std::max(fine.film[from.shape.at(i, 2 * s)], fine.film[from.shape.at(i, second_of(s))]);
    }
  }
  for (int i = 1; i < from.shape.n_across - 1; ++i) {
    const auto conductance = [&](int s, const double* coupling) {
      const std::size_t at = from.shape.at(i, s);
      return -fine.places.share[s] * from.diagonal[at] * coupling[at];
    };
    for (int s = 0; s < n; ++s) {
      const double inside = second_of(s) > 2 * s ? conductance(2 * s + 1, from.low) : 0;
      half_of[s] = inside > 0 ? 0.5 / inside : 0;
    }
    half_of[-1] = joined ? half_of[n - 1] : 0;
    half_of[n] = joined ? half_of[0] : 0;
    // From pair s to the one before or after it, through a coupling of its strip `edge`.
    const auto between = [&](int s, int beside, int edge, const double* coupling) {
      const double outside = conductance(edge, coupling);
      return outside > 0 ? 1 / (half_of[s] + 1 / outside + half_of[beside]) : 0.0;
    };
    for (int s = 0; s < n; ++s) {
      const std::size_t at = to.shape.at(i, s);
      const double film = coarse.film[at];
      double west = 0, along = 0, east = 0;
      for (int of_pair = 2 * s; of_pair <= second_of(s); ++of_pair) {
        const std::size_t place = from.shape.at(i, of_pair);
        const double weight = fine.share[of_pair] * fine.film[place] * from.diagonal[place];
        fine.to_coarse[place] = weight;
        along += weight * (1 + from.low[place] + from.high[place]);
        west += weight * fine.film[place - stride] * from.west[place];
        east += weight * fine.film[place + stride] * from.east[place];
      }
      double low = between(s, s - 1, 2 * s, from.low) / coarse.places.share[s];
      double high = between(s, s + 1, second_of(s), from.high) / coarse.places.share[s];
      if (film == 0 || (n == 1 && joined)) low = high = 0;  // a strip beside itself exchanges nothing
      const double diagonal = film > 0 ? along + low + high : 1;
      const double inverse = 1 / diagonal;
      to.diagonal[at] = diagonal;
      to.west[at] = west * inverse;
      to.east[at] = east * inverse;
      to.low[at] = -low * inverse;
      to.high[at] = -high * inverse;
      for (int of_pair = 2 * s; of_pair <= second_of(s); ++of_pair)
        fine.to_coarse[from.shape.at(i, of_pair)] *= inverse;
      if (second_of(s) == 2 * s) continue;
      // The pressure of an odd strip, as what flows from its pair to the next would have it.
      const double toward = half_of[s] * between(s, s + 1, 2 * s + 1, from.high);
      const std::size_t odd = from.shape.at(i, 2 * s + 1);
      fine.of_own[odd] = fine.film[odd] * (1 - toward);
      fine.of_beside[odd] = fine.film[odd] * toward;
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

void StripMultigrid::relax(const Level& of, const double* rhs, double* x) {
  for (const int colour : {0, 1}) {
    join_ends(of.system.shape, of.places.ends, x);
    kernels_->relax(of.system, colour, rhs, x);
  }
  join_ends(of.system.shape, of.places.ends, x);
}

void StripMultigrid::solve(const double* rhs, double* x) {
  std::fill_n(x, finest_.system.shape.size(), 0.0);
  for (Run& run : runs_) correct(run, 0, rhs + run.offset, x + run.offset);
  relax(finest_, rhs, x);
}

void StripMultigrid::correct(Run& run, std::size_t level, const double* rhs, double* x) {
  const Level& here = run.levels[level];
  const ZebraShape& shape = here.system.shape;
  Level& coarse = run.levels[level + 1];
  kernels_->to_coarse(shape, here.to_coarse.data(), rhs, coarse.system.shape, coarse.rhs);
  solve_level(run, level + 1, coarse.rhs, coarse.x);
  kernels_->from_coarse(coarse.system.shape, coarse.x, shape, here.of_own.data(), here.of_beside.data(), x);
  if (here.places.ends == Ends::kJoined && shape.n_strips % 2 == 1) start_ends(coarse, here, x);
}

void StripMultigrid::solve_level(Run& run, std::size_t level, const double* rhs, double* x) {
  const Level& here = run.levels[level];
  if (level + 1 < run.levels.size()) {
    correct(run, level, rhs, x);
  } else {
    std::fill_n(x, here.system.shape.size(), 0.0);
  }
  relax(here, rhs, x);
}

}  // namespace ringfilm::film
