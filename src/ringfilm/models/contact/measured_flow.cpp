#include "ringfilm/models/contact/measured_flow.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

// Lengths S from far below any gap to far above it.
constexpr double kMinLength = 1e-13, kLengthsPerDecade = 8;  // [m]
constexpr int kLengths = 81;
constexpr double kRoundingOfShares = 1e-6;
// Lower bound of phi where the spots close the map: a film passes some oil around them.
constexpr double kMinFlow = 1e-4;

double length_at(int k) { return kMinLength * std::pow(10.0, k / kLengthsPerDecade); }

[[noreturn]] void refuse(const char* what) {
  throw InputError(std::string("the flow factors of a contact law ") + what,
                   "write them with ringfilm contact --flow-factors --output law.nc");
}

void check(const FlowTable& table) {
  const std::size_t rows = table.h.size();
  if (rows < 2) refuse("have fewer than 2 separations");
  for (const auto* const column :
       {&table.pressure_flow_x, &table.pressure_flow_y, &table.shear_flow, &table.pressure_stress, &table.mean_gap}) {
    if (column->size() != rows) refuse("have columns of unequal length");
    if (!std::all_of(column->begin(), column->end(), [](double v) { return std::isfinite(v); })) {
      refuse("are not numbers everywhere");
    }
  }
  for (std::size_t k = 0; k < rows; ++k) {
    if (!(table.h[k] > (k == 0 ? 0 : table.h[k - 1]))) refuse("have separations that do not rise from above 0");
    if (!(table.pressure_flow_x[k] >= 0 && table.pressure_flow_y[k] >= 0)) refuse("have a flow against the pressure");
  }
  if (table.gap.empty() || table.gap_share.size() != rows) refuse("have no distribution of the gap");
  for (const auto& shares : table.gap_share) {
    double sum = 0;
    for (const double share : shares) sum += share;
    if (shares.size() != table.gap.size() || !(sum > 0 && sum <= 1 + kRoundingOfShares)) {
      refuse("have a distribution of the gap that is not one of shares of the area");
    }
  }
}

/// Slopes by the harmonic mean of both neighbouring secants after @cite fritsch1984, which keep the cubic between
/// its rows.
std::vector<double> limited_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> slope(n, 0.0);
  const auto secant = [&](std::size_t k) { return (y[k + 1] - y[k]) / (x[k + 1] - x[k]); };
  slope.front() = secant(0);
  slope.back() = secant(n - 2);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double before = secant(k - 1), after = secant(k);
    if (!(before * after > 0)) continue;
    const double d_0 = x[k] - x[k - 1], d_1 = x[k + 1] - x[k];
    slope[k] = 3 * (d_0 + d_1) / ((2 * d_1 + d_0) / before + (d_1 + 2 * d_0) / after);
  }
  return slope;
}

}  // namespace

MeasuredFlow::MeasuredFlow(FlowTable table) : table_(std::move(table)) {
  check(table_);
  for (auto* const flow : {&table_.pressure_flow_x, &table_.pressure_flow_y}) {
    for (double& phi : *flow) phi = std::max(phi, kMinFlow);
  }
  x_ = column(table_.pressure_flow_x);
  y_ = column(table_.pressure_flow_y);
  shear_ = column(table_.shear_flow);
  stress_ = column(table_.pressure_stress);
  std::vector<double> excess(table_.mean_gap);
  for (std::size_t k = 0; k < excess.size(); ++k) excess[k] -= table_.h[k];
  excess_ = column(std::move(excess));
  for (std::size_t k = 0; k < table_.h.size(); ++k) {
    auto& row = sliding_.emplace_back();
    for (int place = 0; place < kLengths; ++place) {
      const double S = length_at(place);
      double mean = 0;
      for (std::size_t i = 0; i < table_.gap.size(); ++i) {
        if (table_.gap_share[k][i] > 0) mean += table_.gap_share[k][i] * std::asinh(S / table_.gap[i]);
      }
      row.push_back(mean / std::asinh(S / table_.h[k]));
    }
  }
}

MeasuredFlow MeasuredFlow::shifted(double shift) const {
  if (shift == 0) return *this;
  FlowTable moved;
  moved.gap = table_.gap;
  moved.sigma = table_.sigma;
  for (std::size_t k = 0; k < table_.h.size(); ++k) {
    const double h = table_.h[k] + shift;
    if (!(h > 0)) continue;
    const double ratio = table_.h[k] / h;
    moved.h.push_back(h);
    moved.pressure_flow_x.push_back(table_.pressure_flow_x[k] * ratio * ratio * ratio);
    moved.pressure_flow_y.push_back(table_.pressure_flow_y[k] * ratio * ratio * ratio);
    moved.shear_flow.push_back(table_.shear_flow[k]);
    moved.pressure_stress.push_back(table_.pressure_stress[k] * ratio);
    moved.mean_gap.push_back(table_.mean_gap[k]);
    moved.gap_share.push_back(table_.gap_share[k]);
  }
  if (moved.h.size() < 2) {
    throw InputError("contact.law_shift moves all flow factors of contact.law but " + std::to_string(moved.h.size()) +
                         " to separations below 0",
                     "state a shift of less than its separations");
  }
  return MeasuredFlow(std::move(moved));
}

MeasuredFlow::Column MeasuredFlow::column(std::vector<double> values) const {
  std::vector<double> slope = limited_slopes(table_.h, values);
  return {std::move(values), std::move(slope)};
}

double MeasuredFlow::value(const Column& column, double h) const {
  const auto& x = table_.h;
  if (h <= x.front()) return column.y.front();
  if (h >= x.back()) return column.y.back();
  const auto k = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), h) - x.begin()) - 1;
  const double d = x[k + 1] - x[k], t = (h - x[k]) / d, rise = column.y[k + 1] - column.y[k];
  const double a = column.slope[k] * d, b = column.slope[k + 1] * d;
  return column.y[k] + t * (a + t * (3 * rise - 2 * a - b + t * (a + b - 2 * rise)));
}

double MeasuredFlow::beyond(double at_last, double power, double h) const {
  return h > last() ? at_last * std::pow(last() / h, power) : at_last;
}

double MeasuredFlow::pressure_flow(double h) const { return 1 + beyond(value(x_, h) - 1, 2, h); }
double MeasuredFlow::pressure_flow_across(double h) const { return 1 + beyond(value(y_, h) - 1, 2, h); }
double MeasuredFlow::shear_flow(double h) const { return beyond(value(shear_, h), 1, h); }
double MeasuredFlow::pressure_stress(double h) const { return 1 + beyond(value(stress_, h) - 1, 2, h); }
double MeasuredFlow::mean_gap(double h) const { return h + beyond(value(excess_, h), 2, h); }

double MeasuredFlow::sliding_stress(double h, double S) const {
  const double length = std::abs(S);
  if (!(length > 0)) return 1;
  const double place = std::clamp(kLengthsPerDecade * std::log10(length / kMinLength), 0.0, kLengths - 1.0);
  const auto low = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(kLengths - 2));
  const auto of_row = [&](std::size_t k) {
    const auto& row = sliding_[k];
    return row[low] + (place - static_cast<double>(low)) * (row[low + 1] - row[low]);
  };
  const auto& x = table_.h;
  const double inside = std::clamp(h, x.front(), x.back());
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, inside);
  const auto k = static_cast<std::size_t>(above - x.begin()) - 1;
  const double share = (inside - x[k]) / (x[k + 1] - x[k]);
  const double ratio = of_row(k) + share * (of_row(k + 1) - of_row(k));
  const double thick = 1 + beyond(ratio - 1, 2, h);
  return thick * std::asinh(length / h) * h / length;
}

double MeasuredFlow::mean_inverse_gap(double h) const { return sliding_stress(h, kMinLength); }

}  // namespace ringfilm::models
