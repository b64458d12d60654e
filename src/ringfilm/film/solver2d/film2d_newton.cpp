#include "ringfilm/film/solver2d/film2d_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/aligned.hpp"
#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/kernels/newton_sweep.hpp"
#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {
namespace {

constexpr double kThinnestClosed = 1.05;    // to start from, of closed_film()
constexpr int kMaxIterationsOfStrips = 60;  // limit of Newton iterations with the separation as an unknown

/// By how much GMRES must reduce what is left of a linear system: by the square root of the tolerance, so that the last
/// step's linear errors are as small as its nonlinear ones; after a step larger than kFarStep by no more than this. (A
/// hundredth there saves GMRES less than it costs Newton's method.)
constexpr double kLooseReduction = 1e-4;
constexpr double kFarStep = 0.1;
/// A step whose linear residual is not even halved is rejected.
constexpr double kUnsolved = 0.5;

StripPlaces places_of(const CircumferentialGrid& around, int first, int n_strips) {
  StripPlaces places;
  places.ends = around.ends;
  places.length = around.length;
  places.centre.assign(around.y.begin() + first, around.y.begin() + first + n_strips);
  places.share.assign(around.share.begin() + first, around.share.begin() + first + n_strips);
  return places;
}

/// Before and after strip j. Next to the first and the last strip of a closed film there is none, and nothing flows.
std::pair<int, int> neighbour_strips(int j, int n_strips, Ends ends) {
  const bool joined = ends == Ends::kJoined;
  return {j > 0 ? j - 1 : (joined ? n_strips - 1 : j), j + 1 < n_strips ? j + 1 : (joined ? 0 : j)};
}

int border_count(const Film2dProblem& problem) { return problem.ring.bends() ? problem.ring.n_unknowns() : 1; }

int solved_strips(const CircumferentialGrid& around) {
  return around.ends == Ends::kOpen ? around.n_strips() - 2 : around.n_strips();
}

}  // namespace

Film2dNewton::Film2dNewton(const Film2dProblem& problem)
    : kernels_(&film2d_kernels(problem.strip.kernels->name)),
      shape_(problem.n_across(), solved_strips(problem.around)),
      ends_(problem.around.ends),
      first_(problem.around.ends == Ends::kOpen ? 1 : 0),
      gmres_(*kernels_, shape_.size() + border_count(problem)),
      elastic_(problem.ring),
      closed_(closed_film(problem)),
      rigid_border_(*kernels_, block_, shape_.size()),
      border_(&rigid_border_),
      step_(shape_.size() + border_count(problem), 0.0),
      rhs_(step_),
      product_(shape_.size(), 0.0),
      excess_(border_count(problem), 0.0),
      border_step_(excess_),
      strip_loads_(shape_.strip_size(), 0.0) {
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
  if (problem.strip.terms == Terms::kAll) {
    for (double** factor : {&block_.mobility, &block_.mobility_across, &block_.stored, &block_.carried}) {
      nodal.push_back(factor);
    }
  }
  if (elastic_.bends()) {
    for (double** slopes : {&block_.own_column, &block_.low_column, &block_.high_column}) nodal.push_back(slopes);
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
  if (elastic_.bends()) border_ = &beam_border_.emplace(*kernels_, block_, problem, first_);
  multigrid_.emplace(*kernels_, system, places_of(problem.around, first_, shape_.n_strips), grid.width);
}

void Film2dNewton::set_gap(const Film2dProblem& problem) {
  const CircumferentialGrid& around = problem.around;
  const Film2dGap& gap = problem.gap;
  const int n_across = shape_.n_across, n_strips = around.n_strips(), n_cells = around.n_cells();
  for (int j = 0; j < n_strips; ++j) {
    block_.weight[shape_.strip(strip_of(j))] = around.share[j] / around.length;
    const auto strip = gap.node.begin() + static_cast<std::ptrdiff_t>(j) * n_across;
    lowest_.push_back(*std::min_element(strip, strip + n_across));
  }
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

void Film2dNewton::set_separation(const Film2dProblem& problem, const Film2dInputs& inputs) {
  rise_ = rise_of_strips(problem, inputs, ring_);
  block_.ln_h_scale = h_m_;
  const auto rise = [&](int strip) { return rise_.empty() ? 0.0 : rise_[strip]; };
  for (int s = 0; s < shape_.n_strips; ++s) {
    const int j = s + first_;
    const auto [low, high] = neighbour_strips(j, problem.around.n_strips(), ends_);
    const std::size_t place = shape_.strip(s);
    block_.h_m[place] = h_m_ + rise(j);
    block_.low_h_m[place] = h_m_ + 0.5 * (rise(low) + rise(j));
    block_.high_h_m[place] = h_m_ + 0.5 * (rise(j) + rise(high));
  }
}

/// The lowest separation of a ring that bends is its h_m, from which its bending counts.
void Film2dNewton::set_lowest() {
  if (!beam_border_) return;
  double lowest = ring_[elastic_.of_strip(0)];
  const int n = static_cast<int>(lowest_.size());
  for (int j = 1; j < n; ++j) lowest = std::min(lowest, ring_[elastic_.of_strip(j)]);
  h_m_ += lowest;
  for (std::size_t i = 0; i < ring_.size(); i += 2) ring_[i] -= lowest;
}

void Film2dNewton::set_given(const Film2dInputs& inputs) {
  const int last = shape_.n_across - 1;
  const auto put = [&](int s, double p) {
    for (int i = 0; i <= last; ++i) block_.z[shape_.at(i, s)] = p - inputs.strip.p_cavitation;
  };
  if (ends_ == Ends::kOpen) {
    put(-1, inputs.p_low);
    put(shape_.n_strips, inputs.p_high);
  }
  for (int s = 0; s < shape_.n_strips; ++s) {
    block_.z[shape_.at(0, s)] = edge_z(inputs.strip.left, inputs.strip.p_cavitation);
    block_.z[shape_.at(last, s)] = edge_z(inputs.strip.right, inputs.strip.p_cavitation);
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
  block_.terms = problem.strip.terms;
  block_.left_supply = std::min(4 * strip.left_supply(), kUnlimited);
  block_.right_supply = std::min(4 * strip.right_supply(), kUnlimited);
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
  const int of_each = beam_border_ ? 1 : shape_.n_strips;
  border_scale_ = block_.scale * std::sqrt(static_cast<double>(shape_.n_across) * of_each);
  fronts_.restart();

  const double beyond = kBeyondKink * block_.scale, content_scale = block_.content_scale, rate = block_.rate;
  double *z = block_.z, *inflow = block_.inflow;
  const GasReach reach(problem.strip.grid, strip);
  for (int i = 0; i < shape_.n_across; ++i) {
    // The bound is the same in all strips.
    const double bound = block_.terms == Terms::kAll ? reach.pressure_bound(i) - strip.p_cavitation : 0;
    const double share = block_.share[i];
    for (int s = 0; s < shape_.n_strips; ++s) {
      const std::size_t place = shape_.at(i, s), node = static_cast<std::size_t>(s + first_) * shape_.n_across + i;
      block_.bound[place] = bound;
      const double over = guess.p[node] - strip.p_cavitation - bound;
      const double film = over < beyond ? beyond : over;  // a NaN stays
      z[place] = guess.deficit[node] > 0 ? -guess.deficit[node] * content_scale : film;
      const double source = strip.source.empty() ? 0.0 : strip.source[node];
      inflow[place] = share * (rate * previous.mass_per_area[node] + source);
    }
  }
  if (block_.terms == Terms::kAll) set_factors(strip.factors.get());
  if (ends_ == Ends::kJoined) StripMultigrid::join_ends(shape_, ends_, block_.bound);
  set_given(inputs);
  h_m_ = guess.h_m;
  ring_ = guess.ring;
  ring_.resize(elastic_.n_unknowns(), 0.0);
  for (int j = 0; closed_ > 0 && j < problem.around.n_strips(); ++j) {
    double& own = ring_[elastic_.of_strip(j)];
    own = std::max(own, kThinnestClosed * closed_ - h_m_);
  }
  set_lowest();
  set_separation(problem, inputs);
}

void Film2dNewton::set_factors(const FlowFactors* factors) {
  const int n_cells = shape_.n_across - 1, last = ends_ == Ends::kOpen ? shape_.n_strips : shape_.n_strips - 1;
  const auto put = [&](double* to, std::vector<double> FlowFactors::*of, int across, double none) {
    for (int s = -first_; s <= last; ++s) {
      for (int i = 0; i < across; ++i) {
        const auto place = static_cast<std::size_t>(s + first_) * across + i;
        const bool is_given = factors != nullptr && !(factors->*of).empty();
        to[shape_.at(i, s)] = is_given ? (factors->*of)[place] : none;
      }
    }
    StripMultigrid::join_ends(shape_, ends_, to);
  };
  put(block_.mobility, &FlowFactors::mobility, shape_.n_across, 1);
  put(block_.mobility_across, &FlowFactors::mobility_across, shape_.n_across, 1);
  put(block_.stored, &FlowFactors::stored, shape_.n_across, 0);
  put(block_.carried, &FlowFactors::carried, n_cells, 0);
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

void Film2dNewton::set_loads(const Film2dProblem& problem, const Film2dInputs& inputs) {
  if (beam_border_) {
    set_loads_of_beam(problem, inputs);
  } else {
    set_load_of_rigid_ring(problem, inputs);
  }
}

void Film2dNewton::set_load_of_rigid_ring(const Film2dProblem& problem, const Film2dInputs& inputs) {
  const CircumferentialGrid& around = problem.around;
  double& corner = rigid_border_.corner();
  corner = 0;
  excess_[0] = block_.load - inputs.strip.load;
  const auto add = [&](double rise, double share) {
    double slope = 0;
    excess_[0] += share * asperity_load(problem.strip, h_m_ + rise, &slope);
    corner += share * slope * h_m_;
    excess_[0] += share * land_load(problem.strip, inputs.strip, h_m_ + rise, &slope);
    corner += share * slope * h_m_;
  };
  if (rise_.empty()) {
    if (problem.strip.contact != nullptr || problem.strip.land != nullptr) add(0, 1);
    return;
  }
  for (int j = 0; j < around.n_strips(); ++j) add(rise_[j], around.share[j] / around.length);
}

void Film2dNewton::set_loads_of_beam(const Film2dProblem& problem, const Film2dInputs& inputs) {
  const CircumferentialGrid& around = problem.around;
  const int n_strips = around.n_strips();
  kernels_->strip_loads(block_, strip_loads_.data());
  std::vector<double> contact_slope(n_strips), closing(n_strips, 1.0), carried(n_strips);
  std::vector<double> displaced = displacements(problem, h_m_, ring_);
  for (int j = 0; j < n_strips; ++j) {
    const double share = around.share[j] / around.length;
    const bool is_given = ends_ == Ends::kOpen && (j == 0 || j == n_strips - 1);
    const double given = (j == 0 ? inputs.p_low : inputs.p_high) * problem.strip.grid.width;
    const double of_film = is_given ? given : strip_loads_[shape_.strip(strip_of(j))];
    double slope = 0, separation = h_m_ + rise_[j];
    if (closed_ > 0) separation = closed_separation(separation, closed_, &closing[j]);
    double lift_slope = 0;
    const double lift = land_load(problem.strip, inputs.strip, h_m_ + rise_[j], &lift_slope);
    carried[j] = of_film + asperity_load(problem.strip, separation, &slope) + lift - inputs.load_of(j);
    contact_slope[j] = share * (slope * closing[j] + lift_slope) * h_m_;
    displaced[elastic_.of_strip(j)] -= elastic_.flattening * carried[j];
  }
  excess_ = bending_force(elastic_, inputs, displaced);
  for (double& force : excess_) force /= around.length;
  for (int j = 0; j < n_strips; ++j) excess_[elastic_.of_strip(j)] += around.share[j] / around.length * carried[j];
  const auto lowest = std::min_element(rise_.begin(), rise_.end()) - rise_.begin();
  beam_border_->set(h_m_, static_cast<int>(lowest), std::move(contact_slope), closing);
}

bool Film2dNewton::solve_at_border_step(double reduction) {
  const std::size_t n = shape_.size();
  std::vector<double> back;
  for (const double step : border_step_) back.push_back(-step);
  std::copy_n(block_.rhs, n, rhs_.begin());
  border_->add_columns(back.data(), rhs_.data());
  multigrid_->solve(rhs_.data(), product_.data());
  std::copy_n(product_.begin(), n, rhs_.begin());
  std::fill(rhs_.begin() + static_cast<std::ptrdiff_t>(n), rhs_.end(), 0.0);
  const auto map = [&](const double* x, double* y) {
    kernels_->product(block_.system, x, product_.data());
    multigrid_->solve(product_.data(), y);
    std::copy_n(x + n, border_->count(), y + n);
  };
  const Gmres::Report report = gmres_.solve(map, rhs_.data(), reduction, step_.data());
  left_ = report.reduction;
  krylov_ = report.iterations;
  return left_ < kUnsolved;
}

/// Coarser two-dimensional films change little from one iteration to the next: they are renewed where GMRES has become
/// slower with them.
void Film2dNewton::prepare_multigrid(int iteration) {
  constexpr int kSlower = 2;
  if (iteration == 2) krylov_prepared_ = krylov_;
  if (iteration > 1 && krylov_ <= krylov_prepared_ + kSlower) return multigrid_->prepare_finest();
  multigrid_->prepare(block_.z);
}

bool Film2dNewton::solve_linear(Unknowns unknowns, double reduction, int iteration) {
  prepare_multigrid(iteration);
  const int count = border_->count();
  std::fill(border_step_.begin(), border_step_.end(), 0.0);
  if (unknowns == Unknowns::kFilmAlone) return solve_at_border_step(reduction);
  // The border is eliminated with what the preconditioner makes of its columns. These change little within a step, and
  // GMRES makes up for it.
  bool falls = iteration > 1 && border_->factor();
  if (!falls) {
    border_->solve_columns([&](const double* rhs, double* x) { multigrid_->solve(rhs, x); });
    falls = border_->factor();
  }
  if (!falls) {
    if (beam_border_) return false;
    border_step_[0] = excess_[0] < 0 ? -kSignOnlyStep : kSignOnlyStep;
    return solve_at_border_step(reduction);
  }
  const std::size_t n = shape_.size();
  std::vector<double> b(count), g(count);
  const auto precondition = [&](const double* mass, const double* border, double* x) {
    multigrid_->solve(mass, x);
    border_->eliminate(border, x, b.data());
    for (int k = 0; k < count; ++k) x[n + k] = b[k] * border_scale_;
  };
  const auto map = [&](const double* x, double* y) {
    for (int k = 0; k < count; ++k) b[k] = x[n + k] / border_scale_;
    kernels_->product(block_.system, x, product_.data());
    border_->add_columns(b.data(), product_.data());
    border_->multiply(x, b.data(), g.data());
    precondition(product_.data(), g.data(), y);
  };
  for (int k = 0; k < count; ++k) g[k] = -excess_[k];
  precondition(block_.rhs, g.data(), rhs_.data());
  const Gmres::Report report = gmres_.solve(map, rhs_.data(), reduction, step_.data());
  left_ = report.reduction;
  krylov_ = report.iterations;
  if (!(left_ < kUnsolved)) return false;
  for (int k = 0; k < count; ++k) border_step_[k] = step_[n + k] / border_scale_;
  return !limit_border_step() || solve_at_border_step(reduction);
}

double Film2dNewton::change_of_strip(int j) const { return border_step_[elastic_.of_strip(j)] * h_m_; }

bool Film2dNewton::has_film_everywhere() const {
  for (std::size_t j = 0; j < rise_.size() && beam_border_; ++j) {
    if (h_m_ + rise_[j] + lowest_[j] < kThinnest) return false;
  }
  return true;
}

/// True if the step would have changed the film by too much.
bool Film2dNewton::limit_border_step() {
  if (beam_border_) return limit_step_of_beam();
  const double d_ln_h = border_step_[0];
  border_step_[0] = std::clamp(d_ln_h, kMaxFall, kMaxRise);
  return border_step_[0] != d_ln_h;
}

bool Film2dNewton::limit_step_of_beam() {
  double share = 1;
  for (std::size_t j = 0; j < rise_.size(); ++j) {
    const double film = h_m_ + rise_[j] + lowest_[j], change = change_of_strip(static_cast<int>(j));
    double most = (change < 0 ? std::expm1(kMaxFall) : std::expm1(kMaxRise)) * film;
    if (h_m_ + rise_[j] + change < 2 * closed_) {
      most = std::max(most, std::expm1(kMaxFall) * (h_m_ + rise_[j] - closed_));
    }
    if (std::abs(change) > std::abs(most)) share = std::min(share, most / change);
  }
  for (double& step : border_step_) step *= share;
  return share < 1;
}

double Film2dNewton::largest_move() const {
  if (!beam_border_) return std::abs(border_step_[0]);
  double moved = 0;
  for (std::size_t j = 0; j < rise_.size(); ++j) {
    const double film = h_m_ + rise_[j] + (h_m_ + rise_[j] < 2 * closed_ ? -closed_ : lowest_[j]);
    moved = std::max(std::abs(change_of_strip(static_cast<int>(j))) / film, moved);  // a NaN stays
  }
  return moved;
}

void Film2dNewton::move_border(const Film2dProblem& problem, const Film2dInputs& inputs) {
  if (beam_border_) {
    for (std::size_t i = 0; i < ring_.size(); ++i) ring_[i] += border_step_[i] * h_m_;
    set_lowest();
  } else {
    h_m_ *= std::exp(border_step_[0]);
  }
  set_separation(problem, inputs);
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
      unknowns == Unknowns::kFilmAndSeparation ? kMaxIterationsOfStrips : kMaxIterationsOfStrips + shape_.n_across;
  Outcome outcome;
  outcome.last_step = 1;
  while (outcome.iterations < most_iterations && has_film_everywhere()) {
    ++outcome.iterations;
    give_oil(*inputs.strip.oil);
    kernels_->balance(block_);
    set_loads(problem, inputs);
    const double reduction = outcome.last_step > kFarStep ? std::max(kLooseReduction, enough) : enough;
    if (!solve_linear(unknowns, reduction, outcome.iterations)) break;
    kernels_->update(block_, step_.data());
    const double moved = largest_move();
    if (!std::isfinite(block_.check) || !std::isfinite(block_.largest) || !std::isfinite(moved)) break;
    outcome.last_step = std::max(block_.largest, moved);
    if (moved != 0) {
      move_border(problem, inputs);
      if (h_m_ < kThinnest || h_m_ > thickest(problem.strip)) break;
    }
    const bool nothing_crossed = !block_.to_film && !block_.to_cavity;
    // What the linear system left of the step is an error like that of Newton's method, the square of the step.
    const bool linear_is_solved = left_ * outcome.last_step <= problem.strip.tolerance;
    outcome.solved = nothing_crossed && outcome.last_step <= enough && linear_is_solved;
    if (outcome.solved) break;
    advance_fronts(block_.to_film && !block_.to_cavity);
  }
  state.h_m = h_m_;
  state.ring = ring_;
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
    const auto full = [&](const EdgeState& edge, std::size_t node) {
      return strip.oil->density(edge.pressure) * (state.h_m + problem.gap.node[node]);
    };
    state.deficit[first] = edge_deficit(
        strip.left, [&] { return full(strip.left, first); }, state.deficit[first + 1]);
    state.deficit[first + last] = edge_deficit(
        strip.right, [&] { return full(strip.right, first + last); }, state.deficit[first + last - 1]);
  }
}

}  // namespace ringfilm::film
