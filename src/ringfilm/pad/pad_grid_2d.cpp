#include "ringfilm/pad/pad_grid_2d.hpp"

#include <algorithm>
#include <limits>

namespace ringfilm::pad {
namespace {

/// A uniform grid in each piece, without heights.
film::FilmGrid flat_grid(int n_cells, const std::vector<std::pair<double, double>>& pieces) {
  std::vector<film::GapPiece> flat;
  for (const auto& [begin, end] : pieces) flat.push_back({begin, end, [](double) { return 0.0; }});
  return film::grid_of_pieces(n_cells, flat);
}

std::vector<int> steps_of(film::FilmGrid& grid) {
  std::vector<int> nodes;
  for (const film::GapJump& jump : grid.jumps) nodes.push_back(jump.node);
  grid.jumps.clear();
  return nodes;
}

/// Piece of each cell: one further after every step.
std::vector<int> pieces_of_cells(int n_cells, const std::vector<int>& steps) {
  std::vector<int> pieces;
  std::size_t piece = 0;
  for (int cell = 0; cell < n_cells; ++cell) {
    while (piece < steps.size() && steps[piece] <= cell) ++piece;
    pieces.push_back(static_cast<int>(piece));
  }
  return pieces;
}

/// Heights that share a node or a face, and what each has of it.
class Shares {
 public:
  void add(double height, double weight) {
    heights_[n_] = height;
    weights_[n_++] = weight;
  }

  double mean() const {
    double sum = 0, all = 0;
    for (int k = 0; k < n_; ++k) {
      sum += weights_[k] * heights_[k];
      all += weights_[k];
    }
    // Equal heights must not differ by rounding, which would be a step of the gap.
    return is_level() ? heights_[0] : sum / all;
  }

  double moment(int order) const {
    if (is_level()) return 0;
    const double centre = mean();
    double sum = 0, all = 0;
    for (int k = 0; k < n_; ++k) {
      const double d = heights_[k] - centre;
      sum += weights_[k] * (order == 2 ? d * d : d * d * d);
      all += weights_[k];
    }
    return sum / all;
  }

  double lowest() const { return *std::min_element(heights_, heights_ + n_); }

 private:
  bool is_level() const {
    return std::all_of(heights_, heights_ + n_, [this](double height) { return height == heights_[0]; });
  }

  double heights_[4] = {}, weights_[4] = {};
  int n_ = 0;
};

/// One of the two sides of a node in one direction: the cell there, its length, and where the node lies for it.
struct Side {
  int cell;
  double spacing, place;
};

/// The cells beside a node in one direction; at an open end only one.
struct Sides {
  Side sides[2];
  int n = 0;
  const Side* begin() const { return sides; }
  const Side* end() const { return sides + n; }
};

/// Sides of all nodes of a direction. Where its ends are joined, the first node lies at the end for the last cell.
std::vector<Sides> sides_of(const std::vector<double>& places, const std::vector<double>& spacing, double length) {
  const int n_nodes = static_cast<int>(places.size()), n_cells = static_cast<int>(spacing.size());
  const bool joined = n_nodes == n_cells;
  std::vector<Sides> all(n_nodes);
  const auto add = [&](int node, int cell, double place) {
    Sides& sides = all[node];
    sides.sides[sides.n++] = {cell, spacing[cell], place};
  };
  for (int node = 0; node < n_nodes; ++node) {
    if (node > 0) add(node, node - 1, places[node]);
    if (node == 0 && joined) add(node, n_cells - 1, length);
    if (node < n_cells) add(node, node, places[node]);
  }
  return all;
}

class Builder {
 public:
  Builder(const GapSurface& surface, PadGrid2d& film2d) : surface_(surface), film2d_(film2d) {
    const film::CircumferentialGrid& around = film2d.around;
    sides_x_ = sides_of(film2d.grid.x, film2d.grid.spacing, film2d.grid.width);
    sides_y_ = sides_of(around.y, around.spacing, around.length);
    film2d.lowest = std::numeric_limits<double>::infinity();
  }

  void run() {
    film::Film2dGap& gap = film2d_.gap;
    const int n_x = film2d_.grid.n_cells() + 1;
    for (const Sides& y : sides_y_) {
      for (int i = 0; i < n_x; ++i) gap.node.push_back(counted(node(sides_x_[i], y)).mean());
    }
    for (const Sides& y : sides_y_) {
      for (int i = 0; i + 1 < n_x; ++i) add(face_x(i, y), gap.face_x, gap.face_x_second, gap.face_x_third);
    }
    for (int j = 0; j < film2d_.around.n_cells(); ++j) {
      for (const Sides& x : sides_x_) add(face_y(x, j), gap.face_y, gap.face_y_second, gap.face_y_third);
    }
    if (has_steps(gap)) return;
    for (auto* moments : {&gap.face_x_second, &gap.face_x_third, &gap.face_y_second, &gap.face_y_third}) {
      moments->clear();
    }
  }

 private:
  double height(int cell_x, int cell_y, double x, double y) const {
    return surface_.height(film2d_.piece_of_x[cell_x], film2d_.piece_of_y[cell_y], x, y);
  }

  Shares node(const Sides& x, const Sides& y) const {
    Shares shares;
    for (const Side& b : y) {
      for (const Side& a : x) shares.add(height(a.cell, b.cell, a.place, b.place), a.spacing * b.spacing);
    }
    return shares;
  }

  Shares face_x(int cell, const Sides& y) const {
    const double middle = 0.5 * (film2d_.grid.x[cell] + film2d_.grid.x[cell + 1]);
    Shares shares;
    for (const Side& b : y) shares.add(height(cell, b.cell, middle, b.place), b.spacing);
    return shares;
  }

  Shares face_y(const Sides& x, int cell) const {
    const double middle = film2d_.around.y[cell] + 0.5 * film2d_.around.spacing[cell];
    Shares shares;
    for (const Side& a : x) shares.add(height(a.cell, cell, a.place, middle), a.spacing);
    return shares;
  }

  const Shares& counted(const Shares& shares) {
    film2d_.lowest = std::min(film2d_.lowest, shares.lowest());
    return shares;
  }

  void add(const Shares& shares, std::vector<double>& mean, std::vector<double>& second, std::vector<double>& third) {
    mean.push_back(counted(shares).mean());
    second.push_back(shares.moment(2));
    third.push_back(shares.moment(3));
  }

  static bool has_steps(const film::Film2dGap& gap) {
    const auto is_step = [](double moment) { return moment > 0; };
    return std::any_of(gap.face_x_second.begin(), gap.face_x_second.end(), is_step) ||
           std::any_of(gap.face_y_second.begin(), gap.face_y_second.end(), is_step);
  }

  const GapSurface& surface_;
  PadGrid2d& film2d_;
  std::vector<Sides> sides_x_, sides_y_;
};

}  // namespace

PadGrid2d pad_grid_2d(const GapSurface& surface, Cells cells, film::Ends ends) {
  PadGrid2d film2d;
  film2d.grid = flat_grid(cells.along, surface.pieces_x());
  film::FilmGrid across = flat_grid(cells.across, surface.pieces_y());
  film2d.steps_x = steps_of(film2d.grid);
  film2d.steps_y = steps_of(across);
  film2d.piece_of_x = pieces_of_cells(film2d.grid.n_cells(), film2d.steps_x);
  film2d.piece_of_y = pieces_of_cells(across.n_cells(), film2d.steps_y);
  if (ends == film::Ends::kJoined) across.x.pop_back();
  film2d.around = film::around_at(std::move(across.x), across.width, ends);
  Builder(surface, film2d).run();
  return film2d;
}

}  // namespace ringfilm::pad
