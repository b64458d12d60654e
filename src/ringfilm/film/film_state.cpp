#include "ringfilm/film/film_state.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::film {

FilmGrid uniform_grid(int n_cells, double width, const std::function<double(double)>& height) {
  return grid_of_pieces(n_cells, {{0, width, height}});
}

namespace {

/// Share of the film by which it may change within a cell of a graded grid.
constexpr double kChangePerCell = 0.5;
constexpr int kMaxHalvings = 20;
/// Places at which the gap is looked at: measured points may lie closer than the first cells are long.
constexpr int kSamplesPerCell = 8;
/// Places at which the gap of a face whose cells follow the gap is evaluated, over the whole face.
constexpr int kSamplesOfFace = 500;

}  // namespace

void complete_grid(FilmGrid& grid) {
  grid.share.assign(grid.x.size(), 0.0);
  for (int i = 0; i < grid.n_cells(); ++i) {
    grid.share[i] += 0.5 * grid.spacing[i];
    grid.share[i + 1] += 0.5 * grid.spacing[i];
  }
}

FilmGrid graded_grid(int n_cells, double width, const std::function<double(double)>& height, double thinnest,
                     Turning turning) {
  const auto changes_much = [&](double begin, double end) {
    double low = height(begin), high = low;
    for (int k = 1; k <= kSamplesPerCell; ++k) {
      const double here = height(begin + (end - begin) * k / kSamplesPerCell);
      low = std::min(low, here);
      high = std::max(high, here);
    }
    return high - low > kChangePerCell * (thinnest + low);
  };
  FilmGrid grid;
  grid.width = width;
  grid.x = {0};
  grid.node_height = {height(0)};
  const std::function<void(double, double, int)> add_cells = [&](double end, double h_end, int halvings) {
    const double begin = grid.x.back(), middle = 0.5 * (begin + end), h_middle = height(middle);
    const bool too_long =
        changes_much(begin, end) || (turning == Turning::kPossible && changes_much(width - end, width - begin));
    if (halvings < kMaxHalvings && too_long) {
      add_cells(middle, h_middle, halvings + 1);
      return add_cells(end, h_end, halvings + 1);
    }
    grid.x.push_back(end);
    grid.node_height.push_back(h_end);
    grid.spacing.push_back(end - begin);
    grid.face_height.push_back(h_middle);
  };
  for (int i = 1; i <= n_cells; ++i) add_cells(width * i / n_cells, height(width * i / n_cells), 0);
  complete_grid(grid);
  return grid;
}

FilmGrid grid_by_gap(int n_cells, double width, const std::function<double(double)>& height, double reference,
                     Turning turning) {
  const int samples = kSamplesOfFace;
  const auto lower = [&](double x) {
    return turning == Turning::kPossible ? std::min(height(x), height(width - x)) : height(x);
  };
  std::vector<double> cells(samples + 1, 0.0);  // up to each sample, to a factor
  for (int k = 0; k < samples; ++k) {
    cells[k + 1] = cells[k] + 1 / std::sqrt(reference + std::max(lower(width * (k + 0.5) / samples), 0.0));
  }
  FilmGrid grid;
  grid.width = width;
  grid.x = {0};
  for (int i = 1, k = 0; i <= n_cells; ++i) {
    const double up_to = cells[samples] * i / n_cells;
    while (k + 1 < samples && cells[k + 1] < up_to) ++k;
    const double x = width * (k + (up_to - cells[k]) / (cells[k + 1] - cells[k])) / samples;
    grid.x.push_back(i == n_cells ? width : x);
  }
  for (int i = 0; i < n_cells; ++i) {
    grid.spacing.push_back(grid.x[i + 1] - grid.x[i]);
    grid.face_height.push_back(height(0.5 * (grid.x[i] + grid.x[i + 1])));
  }
  for (const double x : grid.x) grid.node_height.push_back(height(x));
  complete_grid(grid);
  return grid;
}

FilmGrid grid_of_pieces(int n_cells, const std::vector<GapPiece>& pieces) {
  constexpr int kMin = 2;
  FilmGrid grid;
  grid.width = pieces.back().end;
  double left_height = 0;  // height at the end of the piece before
  for (const GapPiece& piece : pieces) {
    const double length = piece.end - piece.begin;
    const int n = std::max(kMin, static_cast<int>(std::lround(n_cells * length / grid.width)));
    const auto at = [&](double i) { return piece.begin + length * i / n; };
    const double first = piece.height(piece.begin);
    if (grid.x.empty()) {
      grid.x.push_back(piece.begin);
      grid.node_height.push_back(first);
    } else {
      const double before = grid.spacing.back();
      const double after = length / n;
      grid.jumps.push_back({static_cast<int>(grid.x.size()) - 1, left_height, first});
      grid.node_height.back() = (before * left_height + after * first) / (before + after);
    }
    for (int i = 1; i <= n; ++i) {
      grid.x.push_back(at(i));
      grid.spacing.push_back(length / n);
      grid.face_height.push_back(piece.height(at(i - 0.5)));
      grid.node_height.push_back(piece.height(at(i)));
    }
    left_height = grid.node_height.back();
  }
  complete_grid(grid);
  return grid;
}

void FilmReport::add(const FilmReport& next) {
  const int all_iterations = iterations + next.iterations;
  const long all_sweeps = sweeps + next.sweeps;
  const bool was_searched = route == Route::kSecant;
  *this = next;
  iterations = all_iterations;
  sweeps = all_sweeps;
  if (was_searched) route = Route::kSecant;
}

}  // namespace ringfilm::film
