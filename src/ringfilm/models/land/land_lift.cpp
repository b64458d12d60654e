#include "ringfilm/models/land/land_lift.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

std::vector<double> logarithms(const std::vector<double>& of) {
  std::vector<double> logarithm;
  for (const double value : of) logarithm.push_back(std::log(value));
  return logarithm;
}

LandTable checked(LandTable table) {
  const std::size_t n = table.separation.size();
  if (n < LandLift::kMinRows) {
    throw InputError("the land table has " + std::to_string(n) + " separations with lift, and 3 are needed",
                     "compute more separations with ringfilm land");
  }
  for (std::size_t k = 0; k < n; ++k) {
    const bool is_first = k == 0;
    if (!(table.separation[k] > (is_first ? 0 : table.separation[k - 1])) || !(table.lift[k] > 0) ||
        !(table.friction_factor[k] > 0) || !std::isfinite(table.lift[k])) {
      throw InputError("separations of the land table do not rise, or a lift or friction is not above 0",
                       "state separations that differ");
    }
    if (!is_first && !(table.lift[k] < table.lift[k - 1])) {
      throw InputError("the lift of the land table does not fall with the separation",
                       "more --patches make it smoother; omit the separations at which it rises");
    }
  }
  if (!(table.speed_viscosity > 0)) {
    throw InputError("the land table has no speed or no viscosity", "state --speed and --viscosity above 0");
  }
  return table;
}

}  // namespace

LandLift::LandLift(LandTable table)
    : table_(checked(std::move(table))),
      log_lift_(logarithms(table_.separation), logarithms(table_.lift)),
      friction_factor_(logarithms(table_.separation), table_.friction_factor) {}

LandLift::At LandLift::at(double h, double eta_U) const {
  if (!(eta_U > 0)) return {};
  const double thin = std::max(h, 1e-3 * table_.separation.front());  // no power of 0
  const auto log_lift = log_lift_.at(std::log(thin));
  At at;
  at.lift = std::exp(log_lift.value) * std::pow(eta_U / table_.speed_viscosity, table_.speed_exponent);
  at.lift_slope = at.lift * log_lift.slope / thin;
  return at;
}

double LandLift::friction_factor(double h) const {
  const double within = std::clamp(h, table_.separation.front(), table_.separation.back());
  return friction_factor_.at(std::log(within)).value;
}

LandFit fit_land(const std::vector<double>& separation, const std::vector<double>& lift, double sigma, double width,
                 double speed_viscosity) {
  std::vector<double> x, y;
  for (std::size_t k = 0; k < separation.size(); ++k) {
    if (!(lift[k] > 0)) continue;
    x.push_back(std::log(separation[k] / sigma));
    y.push_back(std::log(lift[k] * sigma * sigma / (speed_viscosity * width)));
  }
  LandFit fit;
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    mean_x += x[k] / n;
    mean_y += y[k] / n;
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mean_x) * (x[k] - mean_x);
    xy += (x[k] - mean_x) * (y[k] - mean_y);
  }
  if (x.size() < 2 || !(xx > 0)) return fit;
  fit.rows = static_cast<int>(x.size());
  fit.exponent = -xy / xx;
  fit.coefficient = std::exp(mean_y + fit.exponent * mean_x);
  double squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double left = y[k] - mean_y + fit.exponent * (x[k] - mean_x);
    squares += left * left;
  }
  fit.residual = std::sqrt(squares / n);
  return fit;
}

}  // namespace ringfilm::models
