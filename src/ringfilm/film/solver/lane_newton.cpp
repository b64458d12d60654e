#include "ringfilm/film/solver/lane_newton.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ringfilm/base/aligned.hpp"
#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

constexpr int kMaxIterations = 40;  // limit for the coupled Newton iteration
constexpr int kMaxOfStep = 12;      // limit for a step that is shortened where no film is found
constexpr double kNowhere = -1;     // a reach of contact that no gap is within

constexpr int kNodalArrays = 20;
/// A face that no film has.
constexpr double kNoFace = -2;

/// Nothing moves and nothing changes: no equation holds the film content, and a node that the iteration put below p_c
/// is held there by the multiplier, as in Reynolds' exit, until its pressure comes back.
bool at_rest(const FilmInputs& inputs) { return inputs.U == 0 && inputs.time_step == kSteady; }

}  // namespace

LaneLaws best_laws(const FilmInputs& inputs) {
  return inputs.oil->fit() != nullptr ? LaneLaws::kFitted : LaneLaws::kGiven;
}

LaneNewton::LaneNewton(const FilmKernels& kernels, int width, int most_cells)
    : kernels_(&kernels), width_(width), most_cells_(most_cells), lanes_(width), block_{} {
  const std::size_t nodes = static_cast<std::size_t>(most_cells) + 1 + kPadding;
  const std::size_t stride =
      (nodes * width + base::kNumbersPerLine - 1) / base::kNumbersPerLine * base::kNumbersPerLine;
  double* array = base::aligned_zeros(memory_, kNodalArrays * stride);
  for (double** nodal :
       {&block_.z,           &block_.bound,       &block_.inflow, &block_.node_height, &block_.share,
        &block_.face_height, &block_.conductance, &block_.upper,  &block_.column,      &block_.rhs,
        &block_.rho,         &block_.drho_dp,     &block_.K,      &block_.dK_dp,       &block_.mobility,
        &block_.stored,      &block_.carried,     &block_.carry,  &block_.outlet,      &block_.load_share}) {
    *nodal = array;
    array += stride;
  }
  for (int lane = 0; lane < width; ++lane) clear(lane);
}

void LaneNewton::clear(int lane) {
  lanes_[lane] = {};
  block_.h_m[lane] = block_.start_h[lane] = 1;
  block_.scale[lane] = block_.inverse_scale[lane] = 1;
  block_.content_scale[lane] = block_.inverse_content_scale[lane] = 1;
  block_.fit_K[0][lane] = block_.fit_rho[0][lane] = 1;
  clear_contact(lane);
  block_.quarter_U[lane] = block_.rate[lane] = block_.load[lane] = block_.movable[lane] = 0;
  block_.contact_load[lane] = block_.contact_slope[lane] = 0;
  block_.left_supply[lane] = block_.right_supply[lane] = kUnlimited;
  set_throat(lane, {});
  clear_from(lane, 0);
  fit_block();
}

void LaneNewton::clear_from(int lane, int node) {
  for (int i = node; i < most_cells_ + 1 + kPadding; ++i) {
    for (double* array :
         {block_.bound, block_.inflow, block_.node_height, block_.share, block_.face_height, block_.conductance,
          block_.drho_dp, block_.dK_dp, block_.stored, block_.carried, block_.load_share}) {
      nodal(array, i, lane) = 0;
    }
    for (double* array : {block_.z, block_.rho, block_.K, block_.mobility, block_.carry, block_.outlet}) {
      nodal(array, i, lane) = 1;
    }
  }
}

void LaneNewton::fit_block() {
  block_.n_cells = 2;
  for (const Lane& lane : lanes_) block_.n_cells = std::max(block_.n_cells, lane.n_cells);
}

void LaneNewton::bind(int lane, const FilmProblem& problem) {
  const FilmGrid& grid = problem.grid;
  const int n = grid.n_cells();
  lanes_[lane] = {};
  lanes_[lane].problem = &problem;
  lanes_[lane].n_cells = n;
  lanes_[lane].enough = enough_of_newton(problem);
  lanes_[lane].thickest = thickest(problem);
  fit_block();
  clear_from(lane, n);
  for (int i = 0; i <= n; ++i) {
    nodal(block_.bound, i, lane) = 0;
    nodal(block_.node_height, i, lane) = grid.node_height[i];
    nodal(block_.share, i, lane) = grid.share[i];
  }
  for (int i = 0; i < n; ++i) {
    nodal(block_.face_height, i, lane) = grid.face_height[i];
    nodal(block_.conductance, i, lane) = conductance(1, grid.spacing[i]);
  }
  clear_contact(lane);
  set_contact(lane);
}

void LaneNewton::set_oil(int lane, const FilmInputs& inputs) {
  Lane& at = lanes_[lane];
  if (at.oil == inputs.oil) return;
  at.oil = inputs.oil;
  const models::OilFit* fit = at.oil->fit();
  if (fit == nullptr) return;
  block_.fit_centre[lane] = fit->centre;
  block_.fit_inverse_half_width[lane] = 1 / fit->half_width;
  for (int k = 0; k < kFluidityTerms; ++k) block_.fit_K[k][lane] = fit->K[k];
  for (int k = 0; k < kFluiditySlopeTerms; ++k) block_.fit_dK[k][lane] = fit->dK_dp[k];
  for (int k = 0; k < kDensityTerms; ++k) block_.fit_rho[k][lane] = fit->rho[k];
  for (int k = 0; k < kDensitySlopeTerms; ++k) block_.fit_drho[k][lane] = fit->drho_dp[k];
}

void LaneNewton::set_contact(int lane) {
  const FilmProblem& problem = *lanes_[lane].problem;
  if (problem.contact == nullptr) return;
  block_.contact_spread[lane] = problem.contact_spread == ContactSpread::kLocal ? 1 : 0;
  if (const models::ContactPieces* pieces = problem.contact->pieces()) {
    set_table(lane, *pieces);
  } else if (const auto fitted = problem.contact->fitted()) {
    set_polynomials(lane, *fitted);
  }
  note_laws();
}

void LaneNewton::set_polynomials(int lane, const models::FittedContact& law) {
  block_.contact_reach[lane] = law.reach;
  block_.contact_scale[lane] = law.pressure_scale;
  block_.contact_per_gap[lane] = 2 / law.reach;
  for (int k = 0; k < kContactTerms; ++k) block_.contact[k] = law.fit->P52[k];
  for (int k = 0; k < kContactSlopeTerms; ++k) block_.contact_slope_of[k] = law.fit->P52_slope[k];
}

void LaneNewton::set_table(int lane, const models::ContactPieces& pieces) {
  block_.table[lane] = pieces.pressure.front().data();
  block_.table_end[lane] = std::nextafter(static_cast<double>(pieces.pressure.size()), 0.0);
  block_.table_reach[lane] = pieces.reach;
  block_.table_per_gap[lane] = static_cast<double>(pieces.pressure.size()) / pieces.reach;
  block_.table_scale[lane] = pieces.pressure_scale;
}

void LaneNewton::clear_contact(int lane) {
  static constexpr double kNoContact[4] = {};
  block_.contact_spread[lane] = 0;
  block_.contact_reach[lane] = block_.table_reach[lane] = kNowhere;
  block_.contact_per_gap[lane] = block_.contact_scale[lane] = 0;
  block_.table[lane] = kNoContact;
  block_.table_end[lane] = block_.table_per_gap[lane] = block_.table_scale[lane] = 0;
  note_laws();
}

void LaneNewton::note_laws() {
  block_.has_polynomials = block_.has_tables = false;
  for (int lane = 0; lane < width_; ++lane) {
    block_.has_polynomials = block_.has_polynomials || block_.contact_reach[lane] > 0;
    block_.has_tables = block_.has_tables || block_.table_reach[lane] > 0;
  }
}

void LaneNewton::start(int lane, const FilmInputs& inputs, const FilmState& previous, const FilmState& guess,
                       double h_m, Unknowns unknowns, LaneLaws laws) {
  Lane& at = lanes_[lane];
  if (at.inputs == nullptr) {
    block_.content_scale[lane] = inputs.mean_pressure(at.problem->grid);
    block_.inverse_content_scale[lane] = 1 / block_.content_scale[lane];
  }
  set_step(lane, inputs, previous, h_m, unknowns, laws);
  const double *p = guess.p.data(), *deficit = guess.deficit.data();
  const double p_c = inputs.p_cavitation, content_scale = block_.content_scale[lane];
  const double beyond = kBeyondKink * block_.scale[lane];
  double* z = block_.z + lane;
  for (int i = 0; i <= at.n_cells; ++i) {
    const double over = p[i] - p_c - nodal(block_.bound, i, lane);
    const double film = over < beyond ? beyond : over;  // a NaN stays
    z[i * width_] = deficit[i] > 0 ? -deficit[i] * content_scale : film;
  }
  set_edges(lane);
}

void LaneNewton::limit_search_effort(int lane) {
  constexpr int kMaxOfSearch = 200;
  constexpr double kFarTooMuch = 3;  // loads
  Lane& at = lanes_[lane];
  at.most_iterations = std::min(at.most_iterations, kMaxOfSearch);
  at.far_too_much = kFarTooMuch * at.inputs->load;
}

void LaneNewton::set_edges(int lane) {
  const Lane& at = lanes_[lane];
  nodal(block_.z, 0, lane) = edge_z(at.inputs->left, at.inputs->p_cavitation);
  nodal(block_.z, at.n_cells, lane) = edge_z(at.inputs->right, at.inputs->p_cavitation);
}

void LaneNewton::set_step(int lane, const FilmInputs& inputs, const FilmState& previous, double h_m, Unknowns unknowns,
                          LaneLaws laws) {
  Lane& at = lanes_[lane];
  const FilmProblem& problem = *at.problem;
  const FilmGrid& grid = problem.grid;
  block_.laws = laws;
  block_.cavity = problem.cavitation == Cavitation::kMassConserving && !at_rest(inputs) ? LaneCavity::kFilmContent
                                                                                        : LaneCavity::kMultiplier;
  at.inputs = &inputs;
  set_oil(lane, inputs);
  at.phase = laws == LaneLaws::kFitted && at.oil->fit() == nullptr ? Phase::kFailed : Phase::kRunning;
  at.iterations = 0;
  at.last_step = 0;
  const int most = inputs.fallback == Fallback::kNone ? kMaxOfStep : kMaxIterations;
  at.most_iterations = unknowns == Unknowns::kFilmAndSeparation
                           ? most
                           : kMaxIterations + at.n_cells;  // a front may have to cross the face
  at.far_too_much = 0;
  at.fronts.restart();

  const double scale = inputs.mean_pressure(grid);
  const double rate = 1 / inputs.time_step;  // 0 when steady
  block_.h_m[lane] = block_.start_h[lane] = h_m;
  block_.quarter_U[lane] = 0.25 * inputs.U;
  block_.rate[lane] = rate;
  block_.p_cavitation[lane] = inputs.p_cavitation;
  block_.scale[lane] = scale;
  block_.inverse_scale[lane] = 1 / scale;
  block_.load[lane] = inputs.load;
  block_.contact_load[lane] = block_.contact_slope[lane] = 0;
  block_.movable[lane] = unknowns == Unknowns::kFilmAndSeparation ? 1 : 0;
  if (block_.cavity == LaneCavity::kMultiplier && at.phase != Phase::kFailed) {
    block_.cavity_K[lane] =
        density_at(*at.oil, laws, inputs.p_cavitation) / viscosity_at(*at.oil, laws, inputs.p_cavitation);
  }
  set_terms(lane, inputs);
  const double *content = previous.mass_per_area.data(), *share = grid.share.data();
  double* inflow = block_.inflow + lane;
  for (int i = 0; i <= at.n_cells; ++i) inflow[i * width_] = share[i] * rate * content[i];
  for (std::size_t i = 0; i < inputs.source.size(); ++i) {
    nodal(block_.inflow, static_cast<int>(i), lane) += grid.share[i] * inputs.source[i];
  }
}

void LaneNewton::set_terms(int lane, const FilmInputs& inputs) {
  const Lane& at = lanes_[lane];
  block_.terms = at.problem->terms;
  lanes_[lane].meeting_place = {};
  if (block_.terms == Terms::kPlain) {
    if (inputs.has_gas()) throw std::invalid_argument("a film between edges of oil has gas at an edge");
    if (inputs.factors) throw std::invalid_argument("a film between smooth walls has flow factors");
    return;
  }
  block_.left_supply[lane] = std::min(4 * inputs.left_supply(), kUnlimited);
  block_.right_supply[lane] = std::min(4 * inputs.right_supply(), kUnlimited);
  const GasReach reach(at.problem->grid, inputs);
  const double outlet = reach.outlet();
  block_.has_outlets = block_.has_outlets || outlet < 1;
  const FlowFactors* factors = inputs.factors.get();
  const auto factor = [](const std::vector<double>& of, int i, double none) { return of.empty() ? none : of[i]; };
  for (int i = 0; i <= at.n_cells; ++i) {
    nodal(block_.mobility, i, lane) = factors ? factor(factors->mobility, i, 1) : 1;
    nodal(block_.carry, i, lane) = reach.carry(i);
    nodal(block_.outlet, i, lane) = reach.is_outlet(i) ? outlet : 1;
    nodal(block_.stored, i, lane) = factors ? factor(factors->stored, i, 0) : 0;
    if (i < at.n_cells) nodal(block_.carried, i, lane) = factors ? factor(factors->carried, i, 0) : 0;
  }
  for (int i = 0; i <= at.n_cells; ++i) {
    nodal(block_.bound, i, lane) = reach.pressure_bound(i) - inputs.p_cavitation;
    nodal(block_.load_share, i, lane) = at.problem->grid.share[i];
  }
  lanes_[lane].meeting_place = reach.meeting_place();
  set_throat(lane, reach.throat());
}

/// The load shares of the nodes between which the gases meet, as the iteration has filled them; their slopes are
/// omitted, since they change in few steps.
void LaneNewton::set_load_shares(int lane) {
  const MeetingPlace& at = lanes_[lane].meeting_place;
  if (at.beyond == 0) return;
  const std::vector<double>& share = lanes_[lane].problem->grid.share;
  const auto deficit = [&](int i) { return -nodal(block_.z, i, lane) * block_.inverse_content_scale[lane]; };
  const double shift = at.shift(deficit(at.before), deficit(at.after));
  nodal(block_.load_share, at.after, lane) = share[at.after] + shift;
  nodal(block_.load_share, at.before, lane) = share[at.before] - shift;
}

void LaneNewton::set_throat(int lane, const Throat& throat) {
  const bool is_there = throat.last_face >= throat.first_face;
  block_.throat_begin[lane] = is_there ? throat.first_face - 0.5 : kNoFace;
  block_.throat_end[lane] = is_there ? throat.last_face + 0.5 : kNoFace;
  block_.throat_pressure[lane] = throat.pressure;
  block_.throat_reach[lane] = throat.reach;
  block_.throat_place[lane] = throat.place;
}

void LaneNewton::evaluate_properties(int lane) {
  const FilmProblem& problem = *lanes_[lane].problem;
  if (problem.contact != nullptr && (block_.laws == LaneLaws::kGiven || (block_.contact_reach[lane] == kNowhere &&
                                                                         block_.table_reach[lane] == kNowhere))) {
    block_.contact_load[lane] = asperity_load(problem, block_.h_m[lane], &block_.contact_slope[lane]);
  } else if (problem.land != nullptr) {
    block_.contact_load[lane] = block_.contact_slope[lane] = 0;
  }
  if (problem.land != nullptr) {
    double slope = 0;
    block_.contact_load[lane] += land_load(problem, *lanes_[lane].inputs, block_.h_m[lane], &slope);
    block_.contact_slope[lane] += slope;
  }
  if (block_.laws == LaneLaws::kFitted) return;
  if (lanes_[lane].iterations > 0 && runs_away(*lanes_[lane].oil, block_.p_cavitation[lane], peak_pressure(lane))) {
    lanes_[lane].phase = Phase::kFailed;
    return;
  }
  p_.resize(problem.grid.x.size());
  for (std::size_t i = 0; i < p_.size(); ++i) {
    const int node = static_cast<int>(i);
    p_[i] = block_.p_cavitation[lane] + nodal(block_.bound, node, lane) + std::max(nodal(block_.z, node, lane), 0.0);
  }
  oil_.update(*lanes_[lane].oil, p_);
  for (int i = 0; i <= lanes_[lane].n_cells; ++i) {
    nodal(block_.rho, i, lane) = oil_.rho[i];
    nodal(block_.drho_dp, i, lane) = oil_.drho_dp[i];
    nodal(block_.K, i, lane) = oil_.K[i];
    nodal(block_.dK_dp, i, lane) = oil_.dK_dp[i];
  }
}

void LaneNewton::iterate() {
  for (int lane = 0; lane < width_; ++lane) {
    if (lanes_[lane].phase == Phase::kRunning) {
      evaluate_properties(lane);
      set_load_shares(lane);
    }
    if (is_damped(lane) || has_outlet(lane)) keep_contents(lane);
  }
  (width_ == 1 ? kernels_->single_sweep : kernels_->sweep)(block_);
  for (int lane = 0; lane < width_; ++lane) {
    if (has_outlet(lane)) stop_where_oil_hangs(lane);
    if (is_damped(lane)) damp_contents(lane);
    if (lanes_[lane].phase == Phase::kRunning) conclude(lane);
  }
}

/// Late contents of cavities next to gas move by half a step: they may else repeat in a cycle, since a node that is
/// more than half full passes on as much as a full one (carried_share).
bool LaneNewton::is_damped(int lane) const {
  const Lane& at = lanes_[lane];
  const bool is_late = block_.terms == Terms::kAll && at.phase == Phase::kRunning && at.iterations >= kMaxIterations;
  return is_late || alternates(lane);
}

void LaneNewton::keep_contents(int lane) {
  std::vector<double>& z = lanes_[lane].z_before;
  z.resize(lanes_[lane].n_cells + 1);
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = nodal(block_.z, static_cast<int>(i), lane);
}

void LaneNewton::damp_contents(int lane) {
  const std::vector<double>& before = lanes_[lane].z_before;
  for (std::size_t i = 0; i < before.size(); ++i) {
    double& z = nodal(block_.z, static_cast<int>(i), lane);
    if (z < 0 && before[i] < 0) z = 0.5 * (z + before[i]);
  }
}

bool LaneNewton::has_outlet(int lane) const {
  const Lane& at = lanes_[lane];
  return block_.has_outlets && at.phase == Phase::kRunning && at.inputs->surface_tension > 0;
}

/// Where oil hangs, contents take two half steps before each whole one, after which alone the film may count as solved.
bool LaneNewton::alternates(int lane) const {
  constexpr int kMany = 10, kPeriod = 3;
  const int iterations = lanes_[lane].iterations;
  return has_outlet(lane) && iterations >= kMany && iterations % kPeriod != kPeriod - 1;
}

/// What flows has two kinks in the content where oil hangs (hanging_share): a node stops just beyond the first of them.
void LaneNewton::stop_where_oil_hangs(int lane) {
  const std::vector<double>& before = lanes_[lane].z_before;
  const double scale = block_.content_scale[lane];
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double outlet = nodal(block_.outlet, static_cast<int>(i), lane);
    double& z = nodal(block_.z, static_cast<int>(i), lane);
    if (!(outlet < 1 && z < 0 && before[i] < 0)) continue;
    const double laid = scale * (outlet / kOnWall - 1), hanging = scale * (kHanging - 1), beyond = kBeyondKink * scale;
    const auto stop_at = [&](double kink) {
      if (before[i] < kink && z > kink) z = kink + beyond;
      if (before[i] > kink && z < kink) z = kink - beyond;
    };
    const bool fills = z > before[i];
    stop_at(fills ? hanging : laid);
    stop_at(fills ? laid : hanging);  // the nearer one
  }
}

void LaneNewton::conclude(int lane) {
  Lane& at = lanes_[lane];
  const double d_ln_h = block_.d_ln_h[lane];
  const double largest = block_.largest[lane];
  const bool is_half = alternates(lane);
  ++at.iterations;
  const bool sound = std::isfinite(block_.check[lane]) && std::isfinite(block_.excess[lane]) &&
                     std::isfinite(largest) && std::isfinite(d_ln_h);
  at.phase = Phase::kFailed;
  if (!sound) return;
  at.last_step = std::max(largest, std::abs(d_ln_h));
  if (d_ln_h != 0) {
    block_.h_m[lane] *= std::exp(d_ln_h);
    const double h_m = block_.h_m[lane];
    if (h_m < kThinnest || h_m > at.thickest) return;
  }
  const bool to_film = block_.to_film[lane] != 0;
  const bool to_cavity = block_.to_cavity[lane] != 0;
  if (!to_film && !to_cavity && !is_half && at.last_step <= at.enough) {
    at.phase = Phase::kSolved;
    return;
  }
  const bool too_thin = at.far_too_much > 0 && at.iterations > kMaxIterations && block_.excess[lane] > at.far_too_much;
  if (too_thin || at.iterations == at.most_iterations) return;
  advance_fronts(lane, to_film && !to_cavity);
  at.phase = Phase::kRunning;
}

void LaneNewton::advance_fronts(int lane, bool only_advanced) {
  Lane& at = lanes_[lane];
  const int reach = at.fronts.cells(only_advanced);
  if (reach == 0) return;
  const auto z = [&](int i) -> double& { return nodal(block_.z, i, lane); };
  advance_fronts_of_strip(z, at.n_cells, kBeyondKink * block_.scale[lane], reach);
}

double LaneNewton::peak_pressure(int lane) const {
  const FilmInputs& inputs = *lanes_[lane].inputs;
  return std::max({inputs.p_cavitation + block_.peak[lane], inputs.left.pressure, inputs.right.pressure});
}

void LaneNewton::read(int lane, FilmState& state) const {
  const FilmInputs& inputs = *lanes_[lane].inputs;
  const std::size_t n_nodes = lanes_[lane].problem->grid.x.size();
  state.h_m = block_.h_m[lane];
  state.p.resize(n_nodes);
  state.deficit.resize(n_nodes);
  kernels_->read({block_.z + lane, width_, inputs.p_cavitation, block_.inverse_content_scale[lane]},
                 static_cast<int>(n_nodes), {state.p.data(), state.deficit.data()});
  if (block_.terms == Terms::kAll) {
    for (std::size_t i = 0; i < n_nodes; ++i) state.p[i] += nodal(block_.bound, static_cast<int>(i), lane);
  }
  state.p.front() = inputs.left.pressure;
  state.p.back() = inputs.right.pressure;
  const std::vector<double>& rise = lanes_[lane].problem->grid.node_height;
  const auto full = [&](const EdgeState& edge, double height) {
    return inputs.oil->density(edge.pressure) * (state.h_m + height) / (inputs.is_steady() ? kOnWall : kBetweenWalls);
  };
  state.deficit.front() = edge_deficit(
      inputs.left, [&] { return full(inputs.left, rise.front()); }, state.deficit[1]);
  state.deficit.back() = edge_deficit(
      inputs.right, [&] { return full(inputs.right, rise.back()); }, state.deficit[state.deficit.size() - 2]);
}

}  // namespace ringfilm::film
