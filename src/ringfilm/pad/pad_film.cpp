#include "ringfilm/pad/pad_film.hpp"

#include <algorithm>

#include "ringfilm/pad/pad_film_2d.hpp"
#include "ringfilm/pad/wide_film.hpp"

namespace ringfilm::pad {
namespace {

constexpr int kCoarsest = 16;  // cells of the first grid, in either direction

/// A place on a coarser grid: between which nodes, and how far along.
struct Between {
  std::size_t low, high;
  double part;
};

std::vector<Between> between(const std::vector<double>& coarse, const std::vector<double>& fine) {
  std::vector<Between> all;
  std::size_t k = 0;
  for (const double at : fine) {
    while (k + 2 < coarse.size() && coarse[k + 1] < at) ++k;
    if (coarse.size() == 1) {
      all.push_back({0, 0, 0});
    } else {
      all.push_back({k, k + 1, (at - coarse[k]) / (coarse[k + 1] - coarse[k])});
    }
  }
  return all;
}

/// From the grid of the case to the coarsest.
std::vector<Cells> levels(const cycle::Case& c) {
  std::vector<Cells> all{{c.solver.cells, c.pad.width ? c.solver.cells_y : 0}};
  const auto halved = [](int cells) { return cells >= 2 * kCoarsest ? cells / 2 : cells; };
  while (all.back().along >= 2 * kCoarsest || all.back().across >= 2 * kCoarsest) {
    all.push_back({halved(all.back().along), halved(all.back().across)});
  }
  return all;
}

}  // namespace

film::FilmState PadFilm::guess_from(const PadFilm& coarse, const film::FilmState& solved) const {
  const std::size_t n = coarse.nodes().size();
  const std::size_t n_strips = coarse.strips().size();
  std::vector<double> across = coarse.strips();
  if (coarse.is_joined()) across.push_back(setup_.input.pad.width.value());  // the first strip again
  const std::vector<Between> along = between(coarse.nodes(), nodes());
  film::FilmState guess;
  guess.h_m = solved.h_m;
  for (Between y : between(across, strips())) {
    y.high %= n_strips;
    for (const Between& x : along) {
      const auto at = [&](const std::vector<double>& values) {
        const auto on_strip = [&](std::size_t j) {
          const double* strip = values.data() + j * n;
          return strip[x.low] + (strip[x.high] - strip[x.low]) * x.part;
        };
        const double low = on_strip(y.low);
        return y.low == y.high ? low : low + (on_strip(y.high) - low) * y.part;
      };
      const auto in_cavity = [&](std::size_t j) {
        return solved.deficit[j * n + x.low] > 0 && solved.deficit[j * n + x.high] > 0;
      };
      guess.p.push_back(at(solved.p));
      guess.deficit.push_back(in_cavity(y.low) && in_cavity(y.high) ? at(solved.deficit) : 0.0);
    }
  }
  guess.mass_per_area.assign(guess.p.size(), 0.0);
  return guess;
}

std::unique_ptr<PadFilm> pad_film(const PadSetup& setup, Cells cells) {
  if (setup.surface) return std::make_unique<PadFilm2d>(setup, cells);
  return std::make_unique<WideFilm>(setup, cells.along);
}

PadFilms::PadFilms(const PadSetup& setup) {
  for (const Cells& cells : levels(setup.input)) films_.push_back(pad_film(setup, cells));
  std::reverse(films_.begin(), films_.end());
}

}  // namespace ringfilm::pad
