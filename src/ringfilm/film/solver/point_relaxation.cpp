#include "ringfilm/film/solver/point_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {
namespace {

constexpr int kSweepsPerCell = 100;  // limit of sweeps in one solve, plus kFewSweeps
constexpr int kFewSweeps = 1000;
constexpr double kMaxCorrection = 0.25;  // largest change of ln h_m in one correction
constexpr double kDampingAtFirst = 0.2;  // d ln h_m over the relative imbalance, before a better one is known
constexpr double kLoadShare = 0.01;      // share of the imbalance that an unfinished relaxation may hide
constexpr double kNoise = 10;            // a change of the load is significant above so many iteration errors
constexpr double kMaxDamping = 1;        // the load falls at least about as fast as 1/h_m
constexpr double kMaxGrowth = 4;         // largest factor by which the damping rises or falls in one correction
constexpr double kSlowest = 1e-8;        // 1 - radius of Jacobi's iteration: no film of fewer than 10^4 cells is slower
constexpr int kHalvings = 12;            // halvings of ln(1 - radius) between its bounds, to within 0.5 %

/// The best factor for tridiagonal matrices (young1954), by the spectral radius of Jacobi's iteration.
double best_factor(double radius) { return 2 / (1 + std::sqrt(1 - radius * radius)); }

/// By how much over-relaxation multiplies an error each sweep, in the long run (young1954).
double long_run_rate(double factor, double radius) {
  const double discriminant = factor * factor * radius * radius - 4 * (factor - 1);
  if (discriminant <= 0) return factor - 1;
  const double root = 0.5 * (factor * radius + std::sqrt(discriminant));
  return root * root;
}

}  // namespace

class PointRelaxation {
 public:
  PointRelaxation(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                  RelaxationWorkspace& workspace)
      : problem_(problem),
        inputs_(inputs),
        previous_(previous),
        state_(state),
        work_(workspace),
        scale_(inputs.mean_pressure(problem.grid)),
        conserving_(problem.cavitation == Cavitation::kMassConserving) {
    state_.p.front() = inputs.left.pressure;
    state_.p.back() = inputs.right.pressure;
    const std::size_t n_nodes = state_.p.size();
    work_.theta_.assign(n_nodes, 1.0);
    for (std::size_t i = 1; i + 1 < n_nodes; ++i) {
      state_.p[i] = std::max(state_.p[i], inputs.p_cavitation);
      if (conserving_) work_.theta_[i] = 1 - state_.deficit[i];
      if (state_.deficit[i] > 0) state_.p[i] = inputs.p_cavitation;
    }
    for (auto* of_nodes : {&work_.conductance_, &work_.couette_, &work_.gain_, &work_.compliance_, &work_.kept_,
                           &work_.from_left_, &work_.from_right_}) {
      of_nodes->resize(n_nodes);
    }
  }

  bool solve(FilmReport& report);

 private:
  /// Sweeps at the present h_m until one changes less than `enough` [-], or the change that all further sweeps would
  /// make is less than `hidden`.
  bool relax(double enough, double hidden, FilmReport& report);

  /// (W_h + W_a)/W - 1 of the present film [-].
  double imbalance() const {
    return (hydrodynamic_load(problem_, inputs_, state_) + asperity_load(problem_, state_.h_m)) / inputs_.load - 1;
  }
  void linearise();
  double jacobi_radius() const;
  void choose_factor();
  double sweep();  ///< largest relative change of pressure or film content
  double sweep_reynolds_exit();
  double sweep_mass_conserving();
  void finish();

  const FilmProblem& problem_;
  const FilmInputs& inputs_;
  const FilmState& previous_;
  FilmState& state_;
  RelaxationWorkspace& work_;
  double scale_;
  bool conserving_;
  double factor_ = 1;
  double rate_ = 0;  ///< long-run rate of convergence at the factor
};

bool PointRelaxation::solve(FilmReport& report) {
  const double tolerance = problem_.tolerance;
  double damping = kDampingAtFirst;
  double excess = 1;
  double move = 0;
  while (true) {  // until the sweeps are used up
    const double excess_before = excess;
    if (!relax(tolerance, kLoadShare * std::min(std::abs(excess), 1.0), report)) return false;
    excess = imbalance();
    if (std::abs(excess) <= tolerance) {  // to be believed only of a film that is relaxed to the end
      if (!relax(tolerance, 0, report)) return false;
      excess = imbalance();
    }
    if (!std::isfinite(excess)) return false;
    if (std::abs(excess) <= tolerance) {
      finish();
      return true;
    }
    // The damping that the last correction should have had, as far as relaxation lets it be seen.
    const double relief = excess_before - excess;
    if (move != 0 && std::abs(relief) <= kLoadShare * std::abs(excess_before)) {
      damping = std::min(kMaxGrowth * damping, kMaxDamping);
    } else if (move * relief > 0 && std::abs(relief) > kNoise * tolerance / (1 - rate_)) {
      damping = std::clamp(move / relief, damping / kMaxGrowth, std::min(kMaxGrowth * damping, kMaxDamping));
    }
    move = std::clamp(damping * excess, -kMaxCorrection, kMaxCorrection);
    state_.h_m *= std::exp(move);
  }
}

bool PointRelaxation::relax(double enough, double hidden, FilmReport& report) {
  const int n = problem_.grid.n_cells();
  for (; report.sweeps < kFewSweeps + kSweepsPerCell * n; ++report.sweeps) {
    const double highest = *std::max_element(state_.p.begin(), state_.p.end());
    if (runs_away(*inputs_.oil, inputs_.p_cavitation, highest)) return false;
    linearise();
    if (report.sweeps % std::max(n / 4, 16) == 0) choose_factor();
    report.last_step = sweep();
    if (!std::isfinite(report.last_step)) return false;
    // What further sweeps would still change is a geometric series.
    if (report.last_step <= std::max(enough, hidden * (1 - rate_))) {
      ++report.sweeps;
      return true;
    }
  }
  return false;
}

void PointRelaxation::choose_factor() {
  const double radius = jacobi_radius();
  factor_ = work_.factor_.fixed.value_or(best_factor(radius));
  rate_ = long_run_rate(factor_, radius);
}

/// Spectral radius of Jacobi's iteration on the pressures that are not cut, by bisection: for any number above it, and
/// for none below, all pivots of the iteration's characteristic matrix are positive.
double PointRelaxation::jacobi_radius() const {
  const int n = problem_.grid.n_cells();
  const auto lies_below = [&](double radius) {
    const double inverse_square = 1 / (radius * radius);
    double pivot = 1;
    for (int i = 2; i < n; ++i) {
      const bool joined = state_.p[i] > inputs_.p_cavitation && state_.p[i - 1] > inputs_.p_cavitation;
      const double product = joined ? work_.from_left_[i] * work_.from_right_[i - 1] * inverse_square : 0.0;
      pivot = 1 - product / pivot;
      if (pivot <= 0) return false;
    }
    return true;
  };
  double low = std::log(kSlowest);
  double high = 0;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = 0.5 * (low + high);
    (lies_below(1 - std::exp(middle)) ? low : high) = middle;
  }
  return 1 - std::exp(low);
}

/// Everything that a sweep leaves as it is: oil at the present pressures, h at the present h_m, and of each node the
/// pressure that balances it as a linear function of its neighbours'.
void PointRelaxation::linearise() {
  const FilmGrid& grid = problem_.grid;
  const int n = grid.n_cells();
  work_.oil_.update(*inputs_.oil, state_.p);
  const NodalOil& oil = work_.oil_;
  const auto& p = state_.p;
  for (int i = 0; i < n; ++i) {
    const double h = state_.h_m + grid.face_height[i];
    work_.conductance_[i] = conductance(h * h * h, grid.spacing[i]) * (oil.K[i] + oil.K[i + 1]);
    work_.couette_[i] = entrainment(0.25 * inputs_.U, 1.0, h) * (oil.rho[i] + oil.rho[i + 1]);
  }
  for (int i = 1; i < n; ++i) {
    const double h = state_.h_m + grid.node_height[i];
    const double rate = grid.share[i] / inputs_.time_step;
    const double conductance_in = work_.conductance_[i - 1];
    const double conductance_out = work_.conductance_[i];
    const double stretch = grid.face_height[i] - grid.face_height[i - 1];
    // dK/dp acts through both faces, of which the conductance per K is known.
    const double stiffening = oil.dK_dp[i] * (conductance_out * (p[i] - p[i + 1]) / (oil.K[i] + oil.K[i + 1]) +
                                              conductance_in * (p[i] - p[i - 1]) / (oil.K[i] + oil.K[i - 1]));
    const double slope =
        conductance_in + conductance_out + (rate * h + 0.25 * inputs_.U * stretch) * oil.drho_dp[i] + stiffening;
    const double compliance = 1 / std::max(slope, 0.5 * (conductance_in + conductance_out));
    const double source = inputs_.source.empty() ? 0.0 : inputs_.source[i];
    work_.compliance_[i] = compliance;
    work_.gain_[i] = rate * (oil.rho[i] * h - previous_.mass_per_area[i]) - grid.share[i] * source;
    work_.kept_[i] = p[i] - compliance * (work_.gain_[i] + (conductance_in + conductance_out) * p[i]);
    work_.from_left_[i] = compliance * conductance_in;
    work_.from_right_[i] = compliance * conductance_out;
  }
}

double PointRelaxation::sweep() { return conserving_ ? sweep_mass_conserving() : sweep_reynolds_exit(); }

/// Projected over-relaxation.
double PointRelaxation::sweep_reynolds_exit() {
  const int n = problem_.grid.n_cells();
  const double p_c = inputs_.p_cavitation;
  const double factor = factor_;
  auto& p = state_.p;
  for (int i = 1; i < n; ++i) {
    const double couette = work_.couette_[i] - work_.couette_[i - 1];
    work_.kept_[i] = factor * (work_.kept_[i] - work_.compliance_[i] * couette) + (1 - factor) * p[i];
    work_.from_left_[i] *= factor;
    work_.from_right_[i] *= factor;
  }
  double largest = 0;
  double left = p[0];
  for (int i = 1; i < n; ++i) {
    const double before = p[i];
    left = std::max(p_c, work_.kept_[i] + work_.from_right_[i] * p[i + 1] + work_.from_left_[i] * left);
    p[i] = left;
    largest = std::max(std::abs(left - before), largest);
  }
  return std::isfinite(left) ? largest / scale_ : left;
}

/// Downstream, each node takes the pressure, or else the film content, that balances it.
double PointRelaxation::sweep_mass_conserving() {
  const int n = problem_.grid.n_cells();
  const double p_c = inputs_.p_cavitation;
  auto& p = state_.p;
  auto& theta = work_.theta_;
  double largest_p = 0;
  double largest_theta = 0;
  const int step = inputs_.U >= 0 ? 1 : -1;
  // What the node upstream of a face passes on, as a share of what a full one does, and its slope in its content.
  const auto passed = [&](int face, int node) {
    const double h = state_.h_m + problem_.grid.face_height[face];
    const CarriedGap<double> of = carried_gap(theta[node], state_.h_m + problem_.grid.node_height[node], h);
    return CarriedGap<double>{theta[node] * of.gap / h, of.slope / h};
  };
  for (int i = step > 0 ? 1 : n - 1; i > 0 && i < n; i += step) {
    const int out_of = step > 0 ? i : i - 1;
    const double in = work_.couette_[i - 1] * (step > 0 ? passed(i - 1, i - 1).gap : 1.0);
    const double out = work_.couette_[i] * (step > 0 ? 1.0 : passed(i, i + 1).gap);
    const double balanced = work_.kept_[i] + work_.from_left_[i] * p[i - 1] + work_.from_right_[i] * p[i + 1] -
                            work_.compliance_[i] * (out - in);  // balance of a full film
    const double before = p[i];
    double film_content = 1;
    if (balanced > p_c) {
      p[i] = std::max(p_c, before + factor_ * (balanced - before));
    } else {
      p[i] = p_c;
      // What the node would keep and pass on less than a full one, and by how much that changes with its content.
      const double kept =
          problem_.grid.share[i] / inputs_.time_step * work_.oil_.rho[i] * (state_.h_m + problem_.grid.node_height[i]);
      const double full = std::abs(work_.couette_[out_of]);
      const CarriedGap<double> now = passed(out_of, i);
      const double lack = kept * (1 - theta[i]) + full * (1 - now.gap), slope = kept + full * now.slope;
      const double missing = (p_c - balanced) / work_.compliance_[i];
      if (slope > 0)
        film_content = std::clamp(theta[i] - (missing - lack) / slope, 0.0, 1.0);
      else
        film_content = theta[i];
    }
    largest_theta = std::max(std::abs(film_content - theta[i]), largest_theta);
    theta[i] = film_content;
    largest_p = std::max(std::abs(p[i] - before), largest_p);
  }
  return std::max(largest_p / scale_, largest_theta);
}

void PointRelaxation::finish() {
  const int n = problem_.grid.n_cells();
  linearise();
  cavity_multiplier(problem_, state_, work_.oil_, work_.multiplier_);
  state_.deficit.assign(state_.p.size(), 0.0);
  for (int i = 1; i < n; ++i) {
    if (state_.p[i] > inputs_.p_cavitation) continue;
    if (conserving_) {
      state_.deficit[i] = 1 - work_.theta_[i];
    } else {
      const double gained = work_.gain_[i] + work_.couette_[i] - work_.couette_[i - 1] +
                            work_.conductance_[i] * (state_.p[i] - state_.p[i + 1]) +
                            work_.conductance_[i - 1] * (state_.p[i] - state_.p[i - 1]);
      state_.deficit[i] = std::max(gained, 0.0) / (work_.multiplier_[i] * scale_);
    }
  }
  complete_state(problem_, inputs_, LaneLaws::kGiven, state_);
}

FilmReport solve_by_point_relaxation(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                                     FilmState& state, RelaxationWorkspace& workspace) {
  FilmReport report;
  if (inputs.left.fluid == EdgeFluid::kGas || inputs.right.fluid == EdgeFluid::kGas) {
    throw std::invalid_argument("point relaxation solves films between edges of oil");
  }
  PointRelaxation relaxation(problem, inputs, previous, state, workspace);
  report.converged = relaxation.solve(report);
  if (report.converged) report.failure = Failure::kNone;
  return report;
}

}  // namespace ringfilm::film
