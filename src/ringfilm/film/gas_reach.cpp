#include "ringfilm/film/gas_reach.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {
namespace {

/// Places that are wider than the lowest one by no more than this share, or by no more than molecules, are one stretch
/// [-]. A meniscus there holds up to 0.6 % less pressure (eq-gas-holding-limit), as if the oil was 0.3 K hotter.
constexpr double kNarrowest = 0.002;

double cube(double x) { return x * x * x; }

}  // namespace

GasReach::GasReach(const FilmGrid& grid, const FilmInputs& inputs) : inputs_(&inputs), n_cells_(grid.n_cells()) {
  if (!inputs.has_gas()) return;
  if (inputs.crest) {
    begin_ = end_ = *inputs.crest;
    bound_ = {inputs.p_cavitation};
    return;
  }
  const std::vector<double>& height = grid.node_height;
  const double lowest = *std::min_element(height.begin(), height.end());
  const double narrowest = std::max(inputs.h_m_before + lowest, 0.0),
               widest = narrowest + std::max(kNarrowest * narrowest, kMolecules);
  const auto is_narrow = [&](double h) { return h == lowest || inputs.h_m_before + h < widest; };
  begin_ = static_cast<int>(std::find_if(height.begin(), height.end(), is_narrow) - height.begin());
  end_ = static_cast<int>(height.rend() - std::find_if(height.rbegin(), height.rend(), is_narrow)) - 1;
  // Resistance of each node to a flow by pressure, above that of a gap of the widest: it begins at 0.
  double sum = 0;
  for (int i = begin_; i <= end_; ++i) {
    const double h = inputs.h_m_before + height[i];
    const double resistance = narrowest > 0 ? cube(narrowest / h) - cube(narrowest / widest) : h <= narrowest;
    if (is_narrow(height[i])) sum += grid.share[i] * std::max(resistance, 0.0);
    bound_.push_back(sum);  // up to the end of the node
  }
  const double from = beside(inputs.left), to = beside(inputs.right);
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

}  // namespace ringfilm::film
