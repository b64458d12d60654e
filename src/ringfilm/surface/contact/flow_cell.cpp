#include "ringfilm/surface/contact/flow_cell.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::surface {
namespace {

constexpr double kFlowTolerance = 1e-7;  // residual over that at the start; conductances err by its square
constexpr int kMaxFlowIterations = 400;
constexpr std::size_t kCoarsest = 4;  // points along an axis
constexpr int kCoarseVisits = 2;      // visits of a level per visit of the next finer one; one from the finest

/// Axis along which the flow is driven.
enum class Axis { x, y };

/// Conductances of one level: from each point to its right and lower neighbour, and to a fixed pressure.
struct Level {
  std::size_t nx = 0, ny = 0;
  bool wraps = false;
  std::vector<double> right, down, edge, diagonal;
  std::vector<double> x, b, work;

  std::size_t points() const { return nx * ny; }
  std::size_t right_of(std::size_t i, std::size_t j) const { return j * nx + (i + 1 == nx ? 0 : i + 1); }
  std::size_t below(std::size_t i, std::size_t j) const { return (j + 1 == ny ? 0 : j + 1) * nx + i; }

  /// Calls visit(point, neighbour, conductance) for each pair.
  template <class Visit>
  void for_faces(const Visit& visit) const {
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t point = j * nx + i;
        if (right[point] > 0) visit(point, right_of(i, j), right[point]);
        if (down[point] > 0) visit(point, below(i, j), down[point]);
      }
    }
  }

  void complete() {
    diagonal = edge;
    for_faces([&](std::size_t a, std::size_t c, double k) {
      diagonal[a] += k;
      diagonal[c] += k;
    });
    x.assign(points(), 0);
    b.assign(points(), 0);
    work.assign(points(), 0);
  }

  /// Sum of conductance times value of the neighbours.
  double of_neighbours(std::size_t i, std::size_t j, const std::vector<double>& v) const {
    const std::size_t point = j * nx + i, left = j * nx + (i == 0 ? nx - 1 : i - 1);
    const std::size_t above = (j == 0 ? ny - 1 : j - 1) * nx + i;
    return right[point] * v[right_of(i, j)] + down[point] * v[below(i, j)] + right[left] * v[left] +
           down[above] * v[above];
  }

  void relax(std::size_t i, std::size_t j) {
    const std::size_t point = j * nx + i;
    if (diagonal[point] > 0) x[point] = (b[point] + of_neighbours(i, j, x)) / diagonal[point];
  }
  void relax_forward() {
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) relax(i, j);
    }
  }
  void relax_backward() {
    for (std::size_t j = ny; j-- > 0;) {
      for (std::size_t i = nx; i-- > 0;) relax(i, j);
    }
  }

  void apply(const std::vector<double>& v, std::vector<double>& to) const {
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t point = j * nx + i;
        to[point] = diagonal[point] * v[point] - of_neighbours(i, j, v);
      }
    }
  }
};

/// Aggregates of 2 x 2 points. Constants on aggregates make sums of conductances; half of them are those of a grid of
/// twice the step.
Level coarser(const Level& fine) {
  Level coarse;
  coarse.nx = (fine.nx + 1) / 2;
  coarse.ny = (fine.ny + 1) / 2;
  coarse.wraps = fine.wraps;
  for (auto* const field : {&coarse.right, &coarse.down, &coarse.edge}) field->assign(coarse.points(), 0);
  for (std::size_t j = 0; j < fine.ny; ++j) {
    for (std::size_t i = 0; i < fine.nx; ++i) {
      const std::size_t point = j * fine.nx + i, to = j / 2 * coarse.nx + i / 2;
      coarse.edge[to] += 0.5 * fine.edge[point];
      if (coarse.nx > 1 && fine.right_of(i, j) % fine.nx / 2 != i / 2) coarse.right[to] += 0.5 * fine.right[point];
      if (coarse.ny > 1 && fine.below(i, j) / fine.nx / 2 != j / 2) coarse.down[to] += 0.5 * fine.down[point];
    }
  }
  coarse.complete();
  return coarse;
}

class FlowCell {
 public:
  FlowCell(std::span<const double> gap, const ContactGrid& grid, Axis axis) : gap_(gap), grid_(grid), axis_(axis) {
    Level fine;
    fine.nx = grid.points_x;
    fine.ny = grid.points_y;
    fine.wraps = grid.edges == MapEdges::periodic;
    for (auto* const field : {&fine.right, &fine.down, &fine.edge}) field->assign(fine.points(), 0);
    const double along = grid.step_y_m / grid.step_x_m;
    const std::size_t nx = fine.nx, ny = fine.ny;
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t point = j * nx + i;
        if (nx > 1 && (fine.wraps || i + 1 < nx)) fine.right[point] = along * cube_between(point, fine.right_of(i, j));
        if (ny > 1 && (fine.wraps || j + 1 < ny)) fine.down[point] = cube_between(point, fine.below(i, j)) / along;
        if (fine.wraps) continue;
        const double half = 2 * cube(gap_[point]);
        if (axis == Axis::x) {
          fine.edge[point] = along * half * ((i == 0 ? 1 : 0) + (i + 1 == nx ? 1 : 0));
        } else {
          fine.edge[point] = half / along * ((j == 0 ? 1 : 0) + (j + 1 == ny ? 1 : 0));
        }
      }
    }
    fine.complete();
    levels_.push_back(std::move(fine));
    while (levels_.back().nx > kCoarsest || levels_.back().ny > kCoarsest) levels_.push_back(coarser(levels_.back()));
  }

  /// Means over the faces across the axis, of the flow and of the stress.
  struct Means {
    double flow, stress;
  };
  /// <H^3 (1 + d chi/dx)>, of a pressure that falls by 1 along the axis, and <H (1 + d chi/dx)>.
  Means of_pressure() {
    return solve([](double k) { return k; },
                 [](double k, double rise) {
                   return Means{k * (1 + rise), std::cbrt(k) * (1 + rise)};
                 });
  }

  /// <H - H^3 dw/dx> with div(H^3 grad w) = dH/dx. Its stress <H dw/dx> grows without end where contact begins.
  double of_sliding() {
    return solve([](double k) { return -std::cbrt(k); },
                 [](double k, double rise) {
                   return Means{std::cbrt(k) - k * rise, 0};
                 })
        .flow;
  }

  double residual() const { return residual_; }

 private:
  static double cube(double h) { return h * h * h; }
  double cube_between(std::size_t a, std::size_t c) const {
    const double left = cube(gap_[a]), right = cube(gap_[c]);
    return left > 0 && right > 0 ? 2 * left * right / (left + right) : 0;
  }

  /// Calls visit(left, right, k = H^3 of the face) for each face across the axis; a point outside is -1 and lies half
  /// a step away.
  template <class Visit>
  void for_faces_across(const Visit& visit) const {
    const Level& fine = levels_.front();
    const std::size_t nx = fine.nx, ny = fine.ny;
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        const auto point = static_cast<std::ptrdiff_t>(j * nx + i);
        const bool is_first = axis_ == Axis::x ? i == 0 : j == 0;
        const bool is_last = axis_ == Axis::x ? i + 1 == nx : j + 1 == ny;
        const auto at = static_cast<std::size_t>(point);
        if (!fine.wraps && is_first) visit(std::ptrdiff_t{-1}, point, cube(gap_[at]));
        if (!fine.wraps && is_last) {
          visit(point, std::ptrdiff_t{-1}, cube(gap_[at]));
        } else {
          const std::size_t next = axis_ == Axis::x ? fine.right_of(i, j) : fine.below(i, j);
          if (next != at) visit(point, static_cast<std::ptrdiff_t>(next), cube_between(at, next));
        }
      }
    }
  }

  /// Solves div(k grad chi) = -div(source) and returns means over all faces across the axis.
  /// @param source of k of a face @param of_face of k and the rise of chi over a step, divided by it
  template <class Source, class OfFace>
  Means solve(const Source& source, const OfFace& of_face) {
    const double step = axis_ == Axis::x ? grid_.step_x_m : grid_.step_y_m;
    const double width = axis_ == Axis::x ? grid_.step_y_m : grid_.step_x_m;
    Level& fine = levels_.front();
    std::vector<double> b(fine.points(), 0.0), chi(fine.points(), 0.0);
    for_faces_across([&](std::ptrdiff_t left, std::ptrdiff_t right, double k) {
      const double out = width * source(k);
      if (left >= 0) b[static_cast<std::size_t>(left)] += out;
      if (right >= 0) b[static_cast<std::size_t>(right)] -= out;
    });
    iterate(b, chi);
    Means sum{0, 0};
    double count = 0;
    for_faces_across([&](std::ptrdiff_t left, std::ptrdiff_t right, double k) {
      const bool is_edge = left < 0 || right < 0;
      const double from = left < 0 ? 0 : chi[static_cast<std::size_t>(left)];
      const double to = right < 0 ? 0 : chi[static_cast<std::size_t>(right)];
      const double share = is_edge ? 0.5 : 1;
      const Means of = of_face(k, (to - from) / (share * step));
      sum.flow += share * of.flow;
      sum.stress += share * of.stress;
      count += share;
    });
    return count > 0 ? Means{sum.flow / count, sum.stress / count} : Means{0, 0};
  }

  void iterate(const std::vector<double>& b, std::vector<double>& chi) {
    Level& fine = levels_.front();
    const std::size_t n = fine.points();
    std::vector<double> r = b, z(n), p(n, 0.0), Ap(n);
    const auto dot = [n](const std::vector<double>& v, const std::vector<double>& w) {
      double sum = 0;
      for (std::size_t i = 0; i < n; ++i) sum += v[i] * w[i];
      return sum;
    };
    const double start = std::sqrt(dot(r, r));
    if (!(start > 0)) return;
    double former = 0, size = start;
    for (int iteration = 0; iteration < kMaxFlowIterations && size > kFlowTolerance * start; ++iteration) {
      precondition(r, z);
      const double product = dot(r, z), keep = former > 0 ? product / former : 0;
      for (std::size_t i = 0; i < n; ++i) p[i] = z[i] + keep * p[i];
      fine.apply(p, Ap);
      const double curvature = dot(p, Ap);
      if (!(curvature > 0)) break;
      const double length = product / curvature;
      for (std::size_t i = 0; i < n; ++i) {
        chi[i] += length * p[i];
        r[i] -= length * Ap[i];
      }
      former = product;
      size = std::sqrt(dot(r, r));
    }
    residual_ = std::max(residual_, size / start);
  }

  void precondition(const std::vector<double>& r, std::vector<double>& z) {
    levels_.front().b = r;
    cycle(0);
    z = levels_.front().x;
  }

  /// x of the level from its b, starting at 0: one sweep, two corrections by the next level, one sweep back.
  void cycle(std::size_t k) {
    Level& level = levels_[k];
    std::fill(level.x.begin(), level.x.end(), 0.0);
    level.relax_forward();
    if (k + 1 == levels_.size()) {
      for (int sweep = 0; sweep < 8; ++sweep) {
        level.relax_backward();
        level.relax_forward();
      }
      level.relax_backward();
      return;
    }
    for (int visit = 0; visit < (k == 0 ? 1 : kCoarseVisits); ++visit) correct(level, levels_[k + 1], k + 1);
    level.relax_backward();
  }

  void correct(Level& level, Level& coarse, std::size_t k) {
    level.apply(level.x, level.work);
    std::fill(coarse.b.begin(), coarse.b.end(), 0.0);
    for (std::size_t j = 0; j < level.ny; ++j) {
      for (std::size_t i = 0; i < level.nx; ++i) {
        const std::size_t point = j * level.nx + i;
        coarse.b[j / 2 * coarse.nx + i / 2] += level.b[point] - level.work[point];
      }
    }
    cycle(k);
    for (std::size_t j = 0; j < level.ny; ++j) {
      for (std::size_t i = 0; i < level.nx; ++i) {
        level.x[j * level.nx + i] += coarse.x[j / 2 * coarse.nx + i / 2];
      }
    }
  }

  std::span<const double> gap_;
  const ContactGrid& grid_;
  Axis axis_;
  std::vector<Level> levels_;
  double residual_ = 0;
};

}  // namespace

FlowFactorsOfGap flow_factors(std::span<const double> gap_m, const ContactGrid& grid) {
  FlowFactorsOfGap of;
  FlowCell along(gap_m, grid, Axis::x);
  const auto by_pressure = along.of_pressure();
  of.conductance_x = by_pressure.flow;
  of.pressure_stress = by_pressure.stress;
  of.couette = along.of_sliding();
  of.residual = along.residual();
  if (grid.points_y > 1) {
    FlowCell across(gap_m, grid, Axis::y);
    of.conductance_y = across.of_pressure().flow;
    of.residual = std::max(of.residual, across.residual());
  } else {
    double sum = 0;
    for (const double h : gap_m) sum += h * h * h;
    of.conductance_y = sum / static_cast<double>(gap_m.size());
  }
  return of;
}

}  // namespace ringfilm::surface
