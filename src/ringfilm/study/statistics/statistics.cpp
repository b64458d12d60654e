#include "ringfilm/study/statistics/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <stdexcept>

#include "ringfilm/study/sampling/distribution.hpp"

namespace ringfilm::study {
namespace {

using ExactRules = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Binomial = boost::math::binomial_distribution<double, ExactRules>;

/// Probability that no more than k of n values are below the quantile; k may be -1.
double no_more_below(const Binomial& below, long k) {
  if (k < 0) return 0;
  return boost::math::cdf(below, static_cast<double>(k));
}

}  // namespace

std::optional<Mean> mean_of(std::span<const double> values) {
  Mean result;
  double sum = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++result.count;
    sum += value;
  }
  result.omitted = values.size() - result.count;
  if (result.count < 2) return std::nullopt;
  const auto n = static_cast<double>(result.count);
  // A second pass: what the first lost by rounding is in the mean of the rests.
  double rest = 0, square = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    rest += value - sum / n;
    square += (value - sum / n) * (value - sum / n);
  }
  result.value = sum / n + rest / n;
  result.deviation = std::sqrt(std::max(square - rest * rest / n, 0.0) / (n - 1));
  result.standard_error = result.deviation / std::sqrt(n);
  return result;
}

double mean_half_width(std::uint64_t count, double confidence) {
  const boost::math::students_t_distribution<double, ExactRules> student(static_cast<double>(count - 1));
  return boost::math::quantile(boost::math::complement(student, (1 - confidence) / 2));
}

std::vector<double> sorted_values(std::span<const double> values) {
  std::vector<double> sorted;
  sorted.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(sorted), [](double x) { return std::isfinite(x); });
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Places quantile_places(std::size_t n, double share, double confidence) {
  const Binomial below(static_cast<double>(n), share);
  const double tail = (1 - confidence) / 2;
  const auto last = static_cast<long>(n) - 1;
  // By normal theory, and from there one by one.
  const double middle = static_cast<double>(n) * share,
               away = normal_quantile(1 - tail) * std::sqrt(middle * (1 - share));
  long low = std::clamp(static_cast<long>(middle - away), -1L, last),
       high = std::clamp(static_cast<long>(middle + away), 0L, last + 1);
  // The low place is above the quantile when no more values than it are below: that may happen in the tail alone.
  while (low >= 0 && no_more_below(below, low) > tail) --low;
  while (low < last && no_more_below(below, low + 1) <= tail) ++low;
  while (high <= last && 1 - no_more_below(below, high) > tail) ++high;
  while (high > 0 && 1 - no_more_below(below, high - 1) <= tail) --high;
  Places places;
  if (low >= 0) places.low = static_cast<std::size_t>(low);
  if (high <= last) places.high = static_cast<std::size_t>(high);
  return places;
}

double quantile_place(std::size_t n, double share) {
  const auto count = static_cast<double>(n);
  return std::clamp(share * (count + 1.0 / 3) + 1.0 / 3 - 1, 0.0, count - 1);
}

Quantile quantile_of(std::span<const double> sorted, double share, double confidence) {
  if (sorted.empty()) throw std::invalid_argument("a quantile of no values");
  if (!(share > 0 && share < 1)) throw std::invalid_argument("a quantile beyond 0 and 1");
  const double place = quantile_place(sorted.size(), share);
  const auto before = static_cast<std::size_t>(place);
  const std::size_t after = std::min(before + 1, sorted.size() - 1);
  Quantile result;
  result.value = sorted[before] + (place - static_cast<double>(before)) * (sorted[after] - sorted[before]);
  const Places places = quantile_places(sorted.size(), share, confidence);
  if (places.low) result.low = sorted[*places.low];
  if (places.high) result.high = sorted[*places.high];
  return result;
}

std::optional<double> interval_width(std::span<const double> values, std::optional<double> quantile_share,
                                     double confidence) {
  if (!quantile_share) {
    const auto mean = mean_of(values);
    if (!mean) return std::nullopt;
    return 2 * mean_half_width(mean->count, confidence) * mean->standard_error;
  }
  const std::vector<double> sorted = sorted_values(values);
  if (sorted.empty()) return std::nullopt;
  const Quantile found = quantile_of(sorted, *quantile_share, confidence);
  if (!found.low || !found.high) return std::nullopt;
  return *found.high - *found.low;
}

std::optional<Mean> relative_difference(std::span<const double> first, std::span<const double> second) {
  if (first.size() != second.size()) throw std::invalid_argument("samples of different points");
  std::vector<double> base, differences;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (!std::isfinite(first[i]) || !std::isfinite(second[i])) continue;
    base.push_back(first[i]);
    differences.push_back(second[i] - first[i]);
  }
  const auto mean = mean_of(base);
  auto result = mean_of(differences);
  if (!mean || !result || mean->value == 0) return std::nullopt;
  result->omitted = first.size() - result->count;
  result->value /= mean->value;
  result->standard_error /= std::abs(mean->value);
  result->deviation /= std::abs(mean->value);
  return result;
}

std::vector<Stage> convergence(std::span<const double> values, const std::vector<double>& shares, double confidence) {
  std::vector<Stage> stages;
  for (std::size_t n = 16;; n *= 2) {
    n = std::min(n, values.size());
    Stage stage{n, mean_of(values.first(n)), {}};
    const std::vector<double> sorted = sorted_values(values.first(n));
    for (const double share : shares) {
      if (!sorted.empty()) stage.quantiles.push_back(quantile_of(sorted, share, confidence));
    }
    stages.push_back(std::move(stage));
    if (n == values.size()) return stages;
  }
}

}  // namespace ringfilm::study
