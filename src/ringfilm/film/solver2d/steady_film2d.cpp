#include "ringfilm/film/solver2d/steady_film2d.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ringfilm/film/kernels/balance.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

constexpr int kMaxSets = 200;        // cavities that were tried
constexpr double kEmptiest = 1e-12;  // least film content of a cavity node while the set changes [-]
constexpr double kSettled = 1e-10;   // change of film content and of pressure over their scales that ends the iteration

/// The nodes that are solved for, in an order in which elimination fills little: halves first, then the line between.
class Dissection {
 public:
  Dissection(int n_x, int n_y) : n_x_(n_x) { cut(0, n_x, 0, n_y); }
  std::vector<int> take() { return std::move(order_); }

 private:
  void cut(int x0, int x1, int y0, int y1) {
    constexpr int kSmall = 4;
    const int w = x1 - x0, d = y1 - y0;
    if (w <= 0 || d <= 0) return;
    if (w <= kSmall && d <= kSmall) return append(x0, x1, y0, y1);
    if (w >= d) {
      const int middle = x0 + w / 2;
      cut(x0, middle, y0, y1);
      cut(middle + 1, x1, y0, y1);
      append(middle, middle + 1, y0, y1);
    } else {
      const int middle = y0 + d / 2;
      cut(x0, x1, y0, middle);
      cut(x0, x1, middle + 1, y1);
      append(x0, x1, middle, middle + 1);
    }
  }
  void append(int x0, int x1, int y0, int y1) {
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) order_.push_back(y * n_x_ + x);
    }
  }
  int n_x_;
  std::vector<int> order_;
};

/// A face between two nodes: what motion and pressure drive through it.
struct Face {
  int left, right;     // nodes
  double conductance;  // conductance for K = 1 on both sides, per length of the other direction
  double carried;      // gap that the wall carries oil through; 0: the wall does not move across it [m]
  double weight;       // length of the face [m]
};

class ActiveSet {
 public:
  ActiveSet(const Film2dProblem& problem, const Film2dInputs& inputs, FilmState& state)
      : problem_(problem), inputs_(inputs), state_(state), n_x_(problem.n_across()), n_y_(problem.around.n_strips()) {
    number_nodes();
    list_faces();
  }

  FilmReport run() {
    FilmReport report;
    start();
    system_.resize(n_unknowns_, n_unknowns_);
    for (int k = 0; k < kMaxSets; ++k) {
      ++report.iterations;
      give_oil();
      assemble();
      if (k == 0) lu_.analyzePattern(system_);
      lu_.factorize(system_);
      if (lu_.info() != Eigen::Success) return report;
      const Eigen::VectorXd step = lu_.solve(rhs_);
      const int crossed = move(step);
      report.last_step = largest_;
      if (!std::isfinite(largest_)) return report;
      if (crossed == 0 && largest_ <= kSettled) {
        report.converged = true;
        report.failure = Failure::kNone;
        break;
      }
    }
    write();
    return report;
  }

 private:
  std::size_t n_nodes() const { return problem_.n_nodes(); }
  bool is_open() const { return problem_.around.ends == Ends::kOpen; }

  void number_nodes() {
    const int first = is_open() ? 1 : 0, count = is_open() ? n_y_ - 2 : n_y_;
    unknown_.assign(n_nodes(), -1);
    n_unknowns_ = 0;
    for (const int k : Dissection(n_x_ - 2, count).take()) {
      const int x = k % (n_x_ - 2) + 1, y = k / (n_x_ - 2) + first;
      unknown_[static_cast<std::size_t>(y) * n_x_ + x] = n_unknowns_++;
    }
  }

  void list_faces() {
    const FilmGrid& grid = problem_.strip.grid;
    const CircumferentialGrid& around = problem_.around;
    const Film2dGap& gap = problem_.gap;
    const bool steps = !gap.face_x_second.empty();
    const double h_m = state_.h_m;
    const auto cube = [&](double h, double second, double third) { return h * h * h + 3 * h * second + third; };
    for (int j = 0; j < n_y_; ++j) {
      for (int i = 0; i + 1 < n_x_; ++i) {
        const auto face = static_cast<std::size_t>(j) * (n_x_ - 1) + i;
        const double h = h_m + gap.face_x[face];
        const double c = cube(h, steps ? gap.face_x_second[face] : 0, steps ? gap.face_x_third[face] : 0);
        add({j * n_x_ + i, j * n_x_ + i + 1, conductance(c, grid.spacing[i]), h, around.share[j]});
      }
    }
    for (int j = 0; j < around.n_cells(); ++j) {
      const int next = (j + 1) % n_y_;
      for (int i = 0; i < n_x_; ++i) {
        const auto face = static_cast<std::size_t>(j) * n_x_ + i;
        const double h = h_m + gap.face_y[face];
        const double c = cube(h, steps ? gap.face_y_second[face] : 0, steps ? gap.face_y_third[face] : 0);
        add({j * n_x_ + i, next * n_x_ + i, conductance(c, around.spacing[j]), 0, grid.share[i]});
      }
    }
  }
  void add(const Face& face) {
    if (unknown_[face.left] >= 0 || unknown_[face.right] >= 0) faces_.push_back(face);
  }

  void start() {
    const FilmInputs& strip = inputs_.strip;
    scale_ = strip.mean_pressure(problem_.strip.grid);
    const double p_c = strip.p_cavitation;
    p_.assign(n_nodes(), 0.0);
    theta_.assign(n_nodes(), 1.0);
    is_film_.assign(n_nodes(), 1);
    for (std::size_t node = 0; node < n_nodes(); ++node) {
      if (unknown_[node] < 0) continue;
      is_film_[node] = state_.deficit[node] > 0 ? 0 : 1;
      p_[node] = is_film_[node] ? std::max(0.0, state_.p[node] - p_c) : 0.0;
      theta_[node] = is_film_[node] ? 1.0 : std::max(kEmptiest, 1 - state_.deficit[node]);
    }
    for (int j = 0; j < n_y_; ++j) {
      p_[static_cast<std::size_t>(j) * n_x_] = strip.left.pressure - p_c;
      p_[static_cast<std::size_t>(j) * n_x_ + n_x_ - 1] = strip.right.pressure - p_c;
    }
    if (!is_open()) return;
    std::fill_n(p_.begin(), n_x_, inputs_.p_low - p_c);
    std::fill_n(p_.end() - n_x_, n_x_, inputs_.p_high - p_c);
  }

  void give_oil() {
    std::vector<double> p(p_);
    for (double& one : p) one += inputs_.strip.p_cavitation;
    oil_.update(*inputs_.strip.oil, p);
  }

  void assemble() {
    const double quarter_U = 0.25 * inputs_.strip.U;
    entries_.clear();
    rhs_ = Eigen::VectorXd::Zero(n_unknowns_);
    for (const Face& face : faces_) {
      const int left = face.left, right = face.right;
      const int up = quarter_U >= 0 ? left : right;
      const double rho = oil_.rho[left] + oil_.rho[right], K = oil_.K[left] + oil_.K[right];
      const double dp = p_[right] - p_[left];
      double flux = -face.conductance * K * dp, by_left = 0, by_right = 0;
      if (face.carried > 0) {
        const double upstream = state_.h_m + problem_.gap.node[up];
        const double theta = theta_[up];
        const double most = kMaxExcess * face.carried;
        const double excess = std::clamp(upstream - face.carried, -most, most), cubed = theta * theta * theta;
        flux += quarter_U * rho * theta * (face.carried + excess * (1 - cubed));
        if (!is_film_[up]) {
          const double slope = quarter_U * rho * (face.carried + excess * (1 - 4 * cubed));
          (up == left ? by_left : by_right) += slope;
        }
      }
      if (is_film_[left]) by_left += face.conductance * K;
      if (is_film_[right]) by_right -= face.conductance * K;
      put(left, face.weight, flux, left, by_left, right, by_right);
      put(right, -face.weight, flux, left, by_left, right, by_right);
    }
    system_.setFromTriplets(entries_.begin(), entries_.end());
  }
  void put(int node, double weight, double flux, int left, double by_left, int right, double by_right) {
    const int row = unknown_[node];
    if (row < 0) return;
    rhs_[row] -= weight * flux;
    if (unknown_[left] >= 0) entries_.emplace_back(row, unknown_[left], weight * by_left * unit(left));
    if (unknown_[right] >= 0) entries_.emplace_back(row, unknown_[right], weight * by_right * unit(right));
  }
  /// Unknowns of film and cavity in one unit.
  double unit(int node) const { return is_film_[node] ? scale_ : 1.0; }

  int move(const Eigen::VectorXd& step) {
    int crossed = 0;
    largest_ = 0;
    for (std::size_t node = 0; node < n_nodes(); ++node) {
      const int k = unknown_[node];
      if (k < 0) continue;
      if (is_film_[node]) {
        const double next = p_[node] + step[k] * scale_;
        largest_ = std::max(largest_, std::abs(step[k]));
        if (next < 0) {
          is_film_[node] = 0;
          ++crossed;
        }
        p_[node] = std::max(0.0, next);
      } else {
        const double next = theta_[node] + step[k];
        largest_ = std::max(largest_, std::abs(step[k]));
        if (next > 1) {
          is_film_[node] = 1;
          ++crossed;
        }
        theta_[node] = std::clamp(next, kEmptiest, 1.0);
      }
    }
    return crossed;
  }

  void write() {
    state_.laws = LaneLaws::kGiven;
    state_.p.resize(n_nodes());
    state_.deficit.resize(n_nodes());
    state_.mass_per_area.resize(n_nodes());
    for (std::size_t node = 0; node < n_nodes(); ++node) {
      state_.p[node] = inputs_.strip.p_cavitation + p_[node];
      state_.deficit[node] = is_film_[node] ? 0.0 : 1 - theta_[node];
      state_.mass_per_area[node] = oil_.rho[node] * theta_[node] * (state_.h_m + problem_.gap.node[node]);
    }
  }

  const Film2dProblem& problem_;
  const Film2dInputs& inputs_;
  FilmState& state_;
  int n_x_, n_y_;
  int n_unknowns_ = 0;
  std::vector<int> unknown_;
  std::vector<Face> faces_;
  std::vector<double> p_, theta_;
  std::vector<std::uint8_t> is_film_;
  NodalOil oil_;
  double scale_ = 1, largest_ = 0;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> system_;
  Eigen::VectorXd rhs_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::NaturalOrdering<int>> lu_;  // the order is that of dissection
};

}  // namespace

bool has_active_set(const Film2dProblem& problem, const Film2dInputs& inputs) {
  return problem.strip.terms == Terms::kPlain && problem.strip.cavitation == Cavitation::kMassConserving &&
         !problem.ring.bends() && inputs.rise.empty() && inputs.strip.is_steady() && inputs.strip.U != 0 &&
         inputs.strip.source.empty();
}

FilmReport solve_steady_film2d(const Film2dProblem& problem, const Film2dInputs& inputs, FilmState& state) {
  return ActiveSet(problem, inputs, state).run();
}

}  // namespace ringfilm::film
