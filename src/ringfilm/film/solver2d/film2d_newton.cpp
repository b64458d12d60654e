#include "ringfilm/film/solver2d/film2d_newton.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/aligned.hpp"
#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/kernels/newton_sweep.hpp"
#include "ringfilm/film/solver/load_balance.hpp"

namespace ringfilm::film {
namespace {

constexpr int kMostIterationsOfStrips = 60;  // of Newton's method with the load

/// By how much GMRES must reduce what is left of a linear system: by the square root of the tolerance, so that the last
/// step's linear errors are as small as its nonlinear ones; after a step larger than kFarStep by no more than this. (A
/// hundredth there saves GMRES less than it costs Newton's method.)
constexpr double kLooseReduction = 1e-4;
constexpr double kFarStep = 0.1;
/// A step that is not even half solved is none.
constexpr double kUnsolved = 0.5;

StripPlaces places_of(const CircumferentialGrid& around, int first, int n_strips) {
  StripPlaces places;
  places.ends = around.ends;
  places.length = around.length;
  places.centre.assign(around.y.begin() + first, around.y.begin() + first + n_strips);
  places.share.assign(around.share.begin() + first, around.share.begin() + first + n_strips);
  return places;
}

int solved_strips(const CircumferentialGrid& around) {
  return around.ends == Ends::kOpen ? around.n_strips() - 2 : around.n_strips();
}

}  // namespace

Film2dNewton::Film2dNewton(const Film2dProblem& problem)
    : kernels_(&film2d_kernels(problem.strip.kernels->name)),
      shape_(problem.n_across(), solved_strips(problem.around)),
      ends_(problem.around.ends),
      first_(problem.around.ends == Ends::kOpen ? 1 : 0),
      gmres_(*kernels_, shape_.size() + 1),
      step_(shape_.size() + 1, 0.0),
      rhs_(shape_.size() + 1, 0.0),
      product_(shape_.size(), 0.0),
      column_solution_(shape_.size(), 0.0) {
  StripSystem& system = block_.system;
  system.shape = shape_;
  block_.has_steps = !problem.gap.face_x_second.empty();
  std::vector<double**> nodal = {
      &system.west,      &system.diagonal, &system.east,    &system.low,         &system.high,   &system.inverse,
      &system.upper,     &block_.z,        &block_.inflow,  &block_.node_height, &block_.face_x, &block_.low_face,
      &block_.high_face, &block_.rho,      &block_.drho_dp, &block_.K,           &block_.dK_dp,  &block_.column,
      &block_.rhs,       &block_.load_row, &block_.bound};
  if (block_.has_steps) {
    for (double** moment : {&block_.face_x_second, &block_.face_x_third, &block_.low_second, &block_.low_third,
                            &block_.high_second, &block_.high_third}) {
      nodal.push_back(moment);
    }
  }
  const std::vector<double**> of_strips = {
      &block_.h_m,          &block_.low_h_m,         &block_.high_h_m,         &block_.is_strip,
      &block_.weight,       &block_.low_conductance, &block_.high_conductance, &block_.flux,
      &block_.flux_by_left, &block_.flux_by_right,   &block_.flux_by_h};
  const auto across = static_cast<std::size_t>(2 * shape_.n_across);
  double* array =
      base::aligned_zeros(memory_, nodal.size() * shape_.size() + of_strips.size() * shape_.strip_size() + across);
  for (double** of : nodal) {
    *of = array;
    array += shape_.size();
  }
  for (double** of : of_strips) {
    *of = array;
    array += shape_.strip_size();
  }
  const FilmGrid& grid = problem.strip.grid;
  double* share = array;
  double* conductance = array + shape_.n_across;
  for (int i = 0; i < shape_.n_across; ++i) share[i] = grid.share[i];
  for (int i = 0; i < grid.n_cells(); ++i) conductance[i] = film::conductance(1, grid.spacing[i]);
  block_.share = share;
  block_.conductance = conductance;
  for (double* ones : {block_.z, block_.rho, block_.K, system.diagonal}) std::fill_n(ones, shape_.size(), 1.0);
  for (double* ones : {block_.h_m, block_.low_h_m, block_.high_h_m}) std::fill_n(ones, shape_.strip_size(), 1.0);
  set_gap(problem);
  multigrid_.emplace(*kernels_, system, places_of(problem.around, first_, shape_.n_strips), grid.width);
}

void Film2dNewton::set_gap(const Film2dProblem& problem) {
  const CircumferentialGrid& around = problem.around;
  const Film2dGap& gap = problem.gap;
  const int n_across = shape_.n_across, n_strips = around.n_strips(), n_cells = around.n_cells();
  for (int j = 0; j < n_strips; ++j) block_.weight[shape_.strip(strip_of(j))] = around.share[j] / around.length;
  for (int s = 0; s < shape_.n_strips; ++s) {
    const int j = s + first_;
    const std::size_t strip = shape_.strip(s);
    block_.is_strip[strip] = 1;
    const int low_cell = j > 0 ? j - 1 : (ends_ == Ends::kJoined ? n_cells - 1 : -1);
    const int high_cell = j < n_cells ? j : -1;
    const auto per_share = [&](int cell) { return conductance(1, around.spacing[cell]) / around.share[j]; };
    if (low_cell >= 0) block_.low_conductance[strip] = per_share(low_cell);
    if (high_cell >= 0) block_.high_conductance[strip] = per_share(high_cell);
    for (int i = 0; i < n_across; ++i) {
      const std::size_t place = shape_.at(i, s);
      const auto node = static_cast<std::size_t>(j) * n_across + i;
      const auto low = static_cast<std::size_t>(std::max(low_cell, 0)) * n_across + i;
      const auto high = static_cast<std::size_t>(high_cell >= 0 ? high_cell : n_cells - 1) * n_across + i;
      block_.node_height[place] = gap.node[node];
      block_.low_face[place] = gap.face_y[low];
      block_.high_face[place] = gap.face_y[high];
      const auto face = static_cast<std::size_t>(j) * (n_across - 1) + i;
      if (i + 1 < n_across) block_.face_x[place] = gap.face_x[face];
      if (!block_.has_steps) continue;
      block_.low_second[place] = gap.face_y_second[low];
      block_.low_third[place] = gap.face_y_third[low];
      block_.high_second[place] = gap.face_y_second[high];
      block_.high_third[place] = gap.face_y_third[high];
      if (i + 1 == n_across) continue;
      block_.face_x_second[place] = gap.face_x_second[face];
      block_.face_x_third[place] = gap.face_x_third[face];
    }
  }
}

void Film2dNewton::set_separation(const Film2dInputs& inputs, double h_m) {
  block_.ln_h_scale = h_m;
  for (int s = 0; s < shape_.n_strips; ++s) {
    const int j = s + first_, n = static_cast<int>(inputs.rise.size());
    const bool joined = ends_ == Ends::kJoined;
    const auto rise = [&](int strip) { return inputs.rise.empty() ? 0.0 : inputs.rise[strip]; };
    // Beside the first and the last strip of a closed two-dimensional film there is none, and nothing flows.
    const int low = j > 0 ? j - 1 : (joined ? n - 1 : j), high = j + 1 < n ? j + 1 : (joined ? 0 : j);
    const std::size_t place = shape_.strip(s);
    block_.h_m[place] = h_m + rise(j);
    block_.low_h_m[place] = h_m + 0.5 * (rise(low) + rise(j));
    block_.high_h_m[place] = h_m + 0.5 * (rise(j) + rise(high));
  }
}

void Film2dNewton::set_given(const Film2dInputs& inputs) {
  const int last = shape_.n_across - 1;
  const auto put = [&](int s, double p) {
    for (int i = 0; i <= last; ++i) block_.z[shape_.at(i, s)] = p - inputs.strip.p_cavitation;
  };
  const auto z_of = [&](const EdgeState& edge) {
    return edge_z(edge, inputs.strip.p_cavitation, block_.content_scale);
  };
  if (ends_ == Ends::kOpen) {
    put(-1, inputs.p_low);
    put(shape_.n_strips, inputs.p_high);
  }
  for (int s = 0; s < shape_.n_strips; ++s) {
    block_.z[shape_.at(0, s)] = z_of(inputs.strip.left);
    block_.z[shape_.at(last, s)] = z_of(inputs.strip.right);
  }
}

void Film2dNewton::set_step(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous,
                            LaneLaws laws, const FilmState& guess) {
  const FilmInputs& strip = inputs.strip;
  const bool at_rest = strip.U == 0 && strip.time_step == kSteady;
  block_.laws = laws;
  block_.cavity = problem.strip.cavitation == Cavitation::kMassConserving && !at_rest ? LaneCavity::kFilmContent
                                                                                      : LaneCavity::kMultiplier;
  block_.quarter_U = 0.25 * strip.U;
  block_.rate = 1 / strip.time_step;
  block_.p_cavitation = strip.p_cavitation;
  block_.bounds = problem.strip.bounds;
  block_.scale = block_.content_scale = strip.mean_pressure(problem.strip.grid);
  block_.start_h = guess.h_m;
  block_.cavity_K = strip.oil->density(strip.p_cavitation) / strip.oil->viscosity(strip.p_cavitation);
  if (const models::OilFit* fit = strip.oil->fit()) {
    block_.fit_centre = fit->centre;
    block_.fit_inverse_half_width = 1 / fit->half_width;
    block_.fit_K = fit->K.data();
    block_.fit_dK = fit->dK_dp.data();
    block_.fit_rho = fit->rho.data();
    block_.fit_drho = fit->drho_dp.data();
  }
  border_scale_ = block_.scale * std::sqrt(static_cast<double>(shape_.n_across) * shape_.n_strips);
  fronts_.restart();

  const double beyond = kBeyondKink * block_.scale;
  for (int s = 0; s < shape_.n_strips; ++s) {
    const auto from = static_cast<std::size_t>(s + first_) * shape_.n_across;
    for (int i = 0; i < shape_.n_across; ++i) {
      const std::size_t place = shape_.at(i, s);
      block_.bound[place] = strip.pressure_bound(problem.strip.grid, i) - strip.p_cavitation;
      const double over = guess.p[from + i] - strip.p_cavitation - block_.bound[place];
      const double film = over < beyond ? beyond : over;  // a NaN stays
      block_.z[place] = guess.deficit[from + i] > 0 ? -guess.deficit[from + i] * block_.content_scale : film;
      const double source = strip.source.empty() ? 0.0 : strip.source[from + i];
      block_.inflow[place] = block_.share[i] * (block_.rate * previous.mass_per_area[from + i] + source);
    }
  }
  if (ends_ == Ends::kJoined) StripMultigrid::join_ends(shape_, ends_, block_.bound);
  set_given(inputs);
  set_separation(inputs, guess.h_m);
}

void Film2dNewton::give_oil(const models::OilAtTemperature& oil) {
  StripMultigrid::join_ends(shape_, ends_, block_.z);
  if (block_.laws == LaneLaws::kFitted) return kernels_->oil(block_);
  p_.resize(shape_.n_across);
  for (int s = -1; s <= shape_.n_strips; ++s) {
    for (int i = 0; i < shape_.n_across; ++i) {
      p_[i] = block_.p_cavitation + block_.bound[shape_.at(i, s)] + std::max(block_.z[shape_.at(i, s)], 0.0);
    }
    oil_.update(oil, p_);
    for (int i = 0; i < shape_.n_across; ++i) {
      const std::size_t place = shape_.at(i, s);
      block_.rho[place] = oil_.rho[i];
      block_.drho_dp[place] = oil_.drho_dp[i];
      block_.K[place] = oil_.K[i];
      block_.dK_dp[place] = oil_.dK_dp[i];
    }
  }
}

Film2dNewton::LoadRow Film2dNewton::load_row(const Film2dProblem& problem, const Film2dInputs& inputs,
                                             double h_m) const {
  LoadRow row{block_.load - inputs.strip.load, 0};
  if (problem.strip.contact == nullptr) return row;
  const CircumferentialGrid& around = problem.around;
  const auto add = [&](double rise, double share) {
    double slope = 0;
    row.excess += share * asperity_load(problem.strip, h_m + rise, &slope);
    row.slope += share * slope * h_m;
  };
  if (inputs.rise.empty()) {
    add(0, 1);
  } else {
    for (int j = 0; j < around.n_strips(); ++j) add(inputs.rise[j], around.share[j] / around.length);
  }
  return row;
}

bool Film2dNewton::solve_at(double d_ln_h, double reduction) {
  const std::size_t n = shape_.size();
  std::copy_n(block_.rhs, n, rhs_.begin());
  kernels_->add(-d_ln_h, block_.column, rhs_.data(), n);
  multigrid_->solve(rhs_.data(), product_.data());
  std::copy_n(product_.begin(), n, rhs_.begin());
  rhs_[n] = 0;
  const auto map = [&](const double* x, double* y) {
    kernels_->product(block_.system, x, product_.data());
    multigrid_->solve(product_.data(), y);
    y[n] = x[n];
  };
  left_ = gmres_.solve(map, rhs_.data(), reduction, step_.data()).reduction;
  return left_ < kUnsolved;
}

std::optional<double> Film2dNewton::solve_linear(const LoadRow& load, Unknowns unknowns, double reduction,
                                                 int iteration) {
  multigrid_->prepare(block_.z);
  if (unknowns == Unknowns::kFilmAlone) {
    return solve_at(0, reduction) ? std::optional(0.0) : std::nullopt;
  }
  // The border is eliminated with what the preconditioner makes of its column. That changes little within a step, and
  // GMRES makes up for it.
  const std::size_t n = shape_.size();
  const auto corner_with = [&] { return load.slope - kernels_->dot(block_.load_row, column_solution_.data(), n); };
  double corner = iteration > 1 ? corner_with() : 0;
  if (!(corner < 0)) {
    multigrid_->solve(block_.column, column_solution_.data());
    corner = corner_with();
  }
  if (!(corner < 0)) {
    const double blind = load.excess < 0 ? -kSignOnlyStep : kSignOnlyStep;
    return solve_at(blind, reduction) ? std::optional(blind) : std::nullopt;
  }
  const auto precondition = [&](const double* mass, double border, double* x) {
    multigrid_->solve(mass, x);
    const double d_ln_h = (border - kernels_->dot(block_.load_row, x, n)) / corner;
    kernels_->add(-d_ln_h, column_solution_.data(), x, n);
    x[n] = d_ln_h * border_scale_;
  };
  const auto map = [&](const double* x, double* y) {
    const double d_ln_h = x[n] / border_scale_;
    kernels_->product(block_.system, x, product_.data());
    kernels_->add(d_ln_h, block_.column, product_.data(), n);
    precondition(product_.data(), kernels_->dot(block_.load_row, x, n) + load.slope * d_ln_h, y);
  };
  precondition(block_.rhs, -load.excess, rhs_.data());
  left_ = gmres_.solve(map, rhs_.data(), reduction, step_.data()).reduction;
  if (!(left_ < kUnsolved)) return std::nullopt;
  const double d_ln_h = step_[n] / border_scale_;
  const double limited = std::clamp(d_ln_h, kLargestFall, kLargestRise);
  if (limited != d_ln_h && !solve_at(limited, reduction)) return std::nullopt;
  return limited;
}

void Film2dNewton::advance_fronts(bool only_advanced) {
  const int reach = fronts_.cells(only_advanced);
  for (int s = 0; reach > 0 && s < shape_.n_strips; ++s) {
    const auto z = [&](int i) -> double& { return block_.z[shape_.at(i, s)]; };
    advance_fronts_of_strip(z, shape_.n_across - 1, kBeyondKink * block_.scale, reach);
  }
}

Film2dNewton::Outcome Film2dNewton::solve(const Film2dProblem& problem, const Film2dInputs& inputs,
                                          const FilmState& previous, Unknowns unknowns, LaneLaws laws,
                                          FilmState& state) {
  set_step(problem, inputs, previous, laws, state);
  const double enough = enough_of_newton(problem.strip);
  const int most_iterations =
      unknowns == Unknowns::kFilmAndSeparation ? kMostIterationsOfStrips : kMostIterationsOfStrips + shape_.n_across;
  Outcome outcome;
  double h_m = state.h_m;
  outcome.last_step = 1;
  while (outcome.iterations < most_iterations) {
    ++outcome.iterations;
    give_oil(*inputs.strip.oil);
    kernels_->balance(block_);
    const LoadRow load = load_row(problem, inputs, h_m);
    const double reduction = outcome.last_step > kFarStep ? std::max(kLooseReduction, enough) : enough;
    const auto d_ln_h = solve_linear(load, unknowns, reduction, outcome.iterations);
    if (!d_ln_h) break;
    kernels_->update(block_, step_.data());
    if (!std::isfinite(block_.check) || !std::isfinite(block_.largest) || !std::isfinite(*d_ln_h)) break;
    outcome.last_step = std::max(block_.largest, std::abs(*d_ln_h));
    if (*d_ln_h != 0) {
      h_m *= std::exp(*d_ln_h);
      if (h_m < kThinnest || h_m > thickest(problem.strip)) break;
      set_separation(inputs, h_m);
    }
    const bool nothing_crossed = !block_.to_film && !block_.to_cavity;
    // What the linear system left of the step is an error like that of Newton's method, the square of the step.
    const bool linear_is_solved = left_ * outcome.last_step <= problem.strip.tolerance;
    outcome.solved = nothing_crossed && outcome.last_step <= enough && linear_is_solved;
    if (outcome.solved) break;
    advance_fronts(block_.to_film && !block_.to_cavity);
  }
  state.h_m = h_m;
  read(problem, inputs, state);
  outcome.peak_pressure =
      std::max({inputs.strip.p_cavitation + block_.peak, inputs.strip.left.pressure, inputs.strip.right.pressure});
  if (ends_ == Ends::kOpen) outcome.peak_pressure = std::max({outcome.peak_pressure, inputs.p_low, inputs.p_high});
  return outcome;
}

void Film2dNewton::read(const Film2dProblem& problem, const Film2dInputs& inputs, FilmState& state) const {
  const FilmInputs& strip = inputs.strip;
  const int n_strips = problem.around.n_strips(), last = shape_.n_across - 1;
  state.p.resize(problem.n_nodes());
  state.deficit.resize(problem.n_nodes());
  for (int j = 0; j < n_strips; ++j) {
    for (int i = 0; i <= last; ++i) {
      const auto node = static_cast<std::size_t>(j) * shape_.n_across + i;
      const double z = block_.z[shape_.at(i, strip_of(j))];
      state.p[node] = strip.p_cavitation + block_.bound[shape_.at(i, strip_of(j))] + std::max(0.0, z);
      state.deficit[node] = std::max(0.0, -z / block_.content_scale);
    }
    const auto first = static_cast<std::size_t>(j) * shape_.n_across;
    const bool is_given = ends_ == Ends::kOpen && (j == 0 || j == n_strips - 1);
    if (is_given) {
      std::fill_n(state.p.begin() + static_cast<std::ptrdiff_t>(first), shape_.n_across,
                  j == 0 ? inputs.p_low : inputs.p_high);
    } else {
      state.p[first] = strip.left.pressure;
      state.p[first + last] = strip.right.pressure;
    }
    state.deficit[first] = edge_deficit(strip.left);
    state.deficit[first + last] = edge_deficit(strip.right);
  }
}

}  // namespace ringfilm::film
