#include "ringfilm/surface/contact/law_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ringfilm::surface {
namespace {

/// ln p of the mean and its slope at the separations that count, largest first.
struct MeanLaw {
  std::vector<std::size_t> row;
  std::vector<double> value, slope;
};

MeanLaw mean_law(std::span<const double> h, const std::vector<std::vector<double>>& pressure) {
  MeanLaw law;
  std::vector<std::size_t> order(h.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return h[a] > h[b]; });
  for (const std::size_t k : order) {
    double sum = 0;
    const bool all_carry = std::all_of(pressure.begin(), pressure.end(), [&](const auto& p) { return p[k] > 0; });
    if (!all_carry) continue;
    for (const auto& p : pressure) sum += p[k];
    law.row.push_back(k);
    law.value.push_back(std::log(sum / static_cast<double>(pressure.size())));
  }
  // Slopes of the parabola through a row and its neighbours; the first and the last row use that of the row next to
  // them.
  const std::size_t n = law.row.size();
  for (std::size_t i = 0; i < n && n > 2; ++i) {
    const std::size_t middle = std::clamp<std::size_t>(i, 1, n - 2);
    const auto place = [&](std::size_t k) { return h[law.row[k]]; };
    const auto secant = [&](std::size_t k) { return (law.value[k + 1] - law.value[k]) / (place(k + 1) - place(k)); };
    const double before = secant(middle - 1), after = secant(middle);
    const double bend = (after - before) / (place(middle + 1) - place(middle - 1));
    law.slope.push_back(before + bend * (2 * place(i) - place(middle) - place(middle - 1)));
  }
  return law;
}

}  // namespace

double LawScatter::shift_deviation() const { return std::sqrt(shift_variance); }
double LawScatter::log_deviation() const { return std::sqrt(log_variance); }
double LawScatter::correlation() const {
  const double both = shift_deviation() * log_deviation();
  return both > 0 ? std::clamp(covariance / both, -1.0, 1.0) : 0;
}

LawScatter law_scatter(std::span<const double> separations_m, std::span<const double> weight,
                       const std::vector<std::vector<double>>& pressure) {
  LawScatter of;
  of.samples = pressure.size();
  if (of.samples < 2) return of;
  const MeanLaw mean = mean_law(separations_m, pressure);
  if (mean.row.size() < 3) return of;
  double weights = 0, squares = 0;
  for (std::size_t i = 0; i < mean.row.size(); ++i) {
    weights += weight[mean.row[i]];
    squares += weight[mean.row[i]] * mean.slope[i] * mean.slope[i];
  }
  for (const auto& p : pressure) {
    double product = 0, rest = 0;
    for (std::size_t i = 0; i < mean.row.size(); ++i) {
      product += weight[mean.row[i]] * (std::log(p[mean.row[i]]) - mean.value[i]) * mean.slope[i];
    }
    const double dh = -product / squares;
    for (std::size_t i = 0; i < mean.row.size(); ++i) {
      rest += weight[mean.row[i]] * (std::log(p[mean.row[i]]) - mean.value[i] + dh * mean.slope[i]);
    }
    const double ds = rest / weights, share = 1 / static_cast<double>(of.samples - 1);
    of.shift_variance += share * dh * dh;
    of.log_variance += share * ds * ds;
    of.covariance += share * dh * ds;
  }
  return of;
}

LawScatter operator+(const LawScatter& one, const LawScatter& other) {
  return {one.shift_variance + other.shift_variance, one.log_variance + other.log_variance,
          one.covariance + other.covariance,
          std::max<std::size_t>(one.samples, 1) + std::max<std::size_t>(other.samples, 1) - 1};
}

}  // namespace ringfilm::surface
