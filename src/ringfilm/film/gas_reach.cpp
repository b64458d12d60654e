#include "ringfilm/film/gas_reach.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/film/kernels/balance.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/models/oil/lubricant.hpp"

namespace ringfilm::film {
namespace {

/// Places that are wider than the lowest one by no more than this share, or by an atom, are one stretch [-]. A meniscus
/// there holds up to 0.6 % less pressure (eq-gas-holding-limit), as if the oil was 0.3 K hotter.
constexpr double kNarrowest = 0.002;
/// A stretch that is shorter than this share of the throat is the lowest place of a rounded face [-].
constexpr double kShort = 0.15;
/// A place that is nearer to a node than this share of a cell is the node [-].
constexpr double kOnNode = 1e-9;
/// Limit that no film reaches [m Pa^1/2].
constexpr double kAnyFilm = 1e3;
/// Share of what a free surface passes that counts as nothing [-].
constexpr double kHardlyAny = 1e-3;

double cube(double x) { return x * x * x; }

}  // namespace

GasReach::GasReach(const FilmGrid& grid, const FilmInputs& inputs)
    : grid_(&grid), inputs_(&inputs), n_cells_(grid.n_cells()) {
  if (!inputs.has_gas()) return;
  if (inputs.crest) {
    begin_ = end_ = *inputs.crest;
    bound_ = {inputs.p_cavitation};
    return;
  }
  const std::vector<double>& height = grid.node_height;
  const double lowest = *std::min_element(height.begin(), height.end());
  const double narrowest = std::max(inputs.h_m_before + lowest, 0.0),
               widest = narrowest + std::max(kNarrowest * narrowest, kAtom);
  const auto is_narrow = [&](double h) { return h == lowest || inputs.h_m_before + h < widest; };
  begin_ = static_cast<int>(std::find_if(height.begin(), height.end(), is_narrow) - height.begin());
  end_ = static_cast<int>(height.rend() - std::find_if(height.rbegin(), height.rend(), is_narrow)) - 1;
  // An edge that is the lowest place keeps the gas of the other one out of it.
  const bool is_inside = begin_ > 0 && end_ < n_cells_;
  throat_length_ = throat_length(grid, inputs.h_m_before, lowest);
  if (is_inside && grid.x[end_] - grid.x[begin_] <= kShort * throat_length_) {
    set_place();
  } else {
    share_fall(narrowest, widest);
  }
}

double throat_length(const FilmGrid& grid, double h_m, double lowest) {
  constexpr double kOfParabola = 3 * std::numbers::pi / 8;
  const std::vector<double>& height = grid.node_height;
  const double narrowest = std::max(h_m + lowest, kAtom);
  double length = 0;
  for (std::size_t i = 0; i < height.size(); ++i) {
    length += grid.share[i] * cube(narrowest / (narrowest + (height[i] - lowest)));
  }
  return length / kOfParabola;
}

double throat_reach(BrokenFilm broken, double viscosity, double U, double length) {
  if (broken == BrokenFilm::kHalfPasses) return kAnyFilm;
  // 2/3 U f* passes: the wall carries as much with twice that in a full gap.
  const double reach = 4.0 / 3 * std::sqrt(viscosity * std::abs(U) * length);
  return broken == BrokenFilm::kNothingPasses ? kHardlyAny * reach : reach;
}

double left_by_meniscus(double capillary_number) {
  // A meniscus of the radius of half the gap leaves 1.34 Ca^(2/3) of that radius.
  const double thin = 1.34 * std::cbrt(capillary_number * capillary_number);
  return thin / (1 + thin);
}

/// The gases meet where the slope of the face, which is linear along a parabola, is 0.
void GasReach::set_place() {
  const std::vector<double>&height = grid_->node_height, &x = grid_->x;
  const auto slope = [&](int cell) { return (height[cell + 1] - height[cell]) / (x[cell + 1] - x[cell]); };
  const auto middle = [&](int cell) { return 0.5 * (x[cell] + x[cell + 1]); };
  const double fall = -slope(begin_ - 1), rise = slope(end_), from = middle(begin_ - 1), to = middle(end_);
  place_ = fall + rise > 0 ? from + (to - from) * fall / (fall + rise) : 0.5 * (from + to);
  int before = begin_ - 1;
  while (x[before + 1] < place_ - kOnNode * grid_->spacing[before]) ++before;
  // A node that is the place itself belongs to the film before it, whichever way the wall moves.
  const bool is_node = std::abs(x[before + 1] - place_) < kOnNode * grid_->spacing[before];
  end_ = is_node && inputs_->U >= 0 ? before + 1 : before;
  begin_ = end_ + 1;
}

/// The bounds of the nodes of the stretch, by the resistance of each to a flow by pressure above that of a gap of the
/// widest: it begins at 0.
void GasReach::share_fall(double narrowest, double widest) {
  const double before_film = inputs_->h_m_before;
  double sum = 0;
  for (int i = begin_; i <= end_; ++i) {
    const double h = before_film + grid_->node_height[i];
    const double resistance = narrowest > 0 ? cube(narrowest / h) - cube(narrowest / widest) : h <= narrowest;
    sum += grid_->share[i] * std::max(resistance, 0.0);
    bound_.push_back(sum);  // up to the end of the node
  }
  const double from = beside(inputs_->left), to = beside(inputs_->right);
  double passed = 0;
  for (double& one : bound_) {
    const double before = from + (to - from) * passed / sum, after = from + (to - from) * one / sum;
    passed = one;
    one = std::min(before, after);
  }
}

const EdgeState* GasReach::gas_at(int i) const {
  if (is_within(i)) return nullptr;
  const EdgeState& edge = i == 0 || (i < begin_ && i < n_cells_) ? inputs_->left : inputs_->right;
  return edge.fluid == EdgeFluid::kGas ? &edge : nullptr;
}

double GasReach::pressure_bound(int i) const {
  if (is_within(i) && !bound_.empty()) return bound_[i - begin_];
  const EdgeState* gas = gas_at(i);
  return gas != nullptr ? gas->pressure : inputs_->p_cavitation;
}

double GasReach::carry(int i) const {
  const bool follows_wall =
      !inputs_->is_steady() && (std::isfinite(inputs_->left.supply) || std::isfinite(inputs_->right.supply));
  return follows_wall && gas_at(i) != nullptr ? kOnWall : kBetweenWalls;
}

double GasReach::outlet() const {
  if (!(inputs_->surface_tension > 0)) return 1;
  const double eta = inputs_->oil->viscosity(behind().pressure);
  return left_by_meniscus(eta * std::abs(inputs_->U) / inputs_->surface_tension);
}

MeetingPlace GasReach::meeting_place() const {
  if (!is_place()) return {};
  const auto per_deficit = [this](int i) {
    const bool is_edge = i == 0 || i == n_cells_;
    if (is_edge) return 1.0;
    return 1 / (1 - (carry(i) > kBetweenWalls ? kPressingOnWall : kPressingBetweenWalls));
  };
  return {end_, begin_, 0.5 * (grid_->x[end_] + grid_->x[begin_]) - place_, per_deficit(end_), per_deficit(begin_)};
}

double GasReach::load_beyond_place(const std::vector<double>& p, const std::vector<double>& deficit) const {
  if (!is_place()) return 0;
  const MeetingPlace at = meeting_place();
  const double shift = deficit.empty() ? at.beyond : at.shift(deficit[at.before], deficit[at.after]);
  return shift * (p[at.after] - p[at.before]);
}

Throat GasReach::throat() const {
  const double U = inputs_->U;
  const EdgeState &behind = U >= 0 ? inputs_->right : inputs_->left, &ahead = U >= 0 ? inputs_->left : inputs_->right;
  // A steady film on a narrowest stretch ends where the gas along it has its pressure; at an edge there is no film to
  // hold back.
  const bool is_at_edge = std::min(begin_, end_) == 0 || std::max(begin_, end_) == n_cells_;
  if (!is_place() && (inputs_->is_steady() || is_at_edge)) return {};
  if (inputs_->crest || behind.fluid != EdgeFluid::kGas || !(behind.pressure > beside(ahead))) return {};
  Throat throat;
  throat.pressure = behind.pressure;
  if (is_place()) {
    throat.first_face = throat.last_face = end_;
    const double from_left = (place_ - grid_->x[end_]) / grid_->spacing[end_];
    throat.place = U >= 0 ? from_left : 1 - from_left;
  } else {
    throat.first_face = std::max(U >= 0 ? begin_ : begin_ - 1, 0);
    throat.last_face = std::min(U >= 0 ? end_ : end_ - 1, n_cells_ - 1);
  }
  throat.reach = throat_reach(inputs_->broken, inputs_->oil->viscosity(behind.pressure), U, throat_length_);
  return throat;
}

}  // namespace ringfilm::film
