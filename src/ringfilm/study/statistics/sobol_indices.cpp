#include "ringfilm/study/statistics/sobol_indices.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/study/sampling/hash.hpp"
#include "ringfilm/study/statistics/statistics.hpp"

namespace ringfilm::study {
namespace {

constexpr std::uint64_t kMinRows = 8, kMaxBlocks = 4096;

/// Sums over rows from which all indices follow: number of rows, f(A) + f(B), the squares of both, and for each group
/// f(B) (f(A_B) - f(A)) and (f(A) - f(A_B))^2, all less the mean.
using Sums = std::vector<double>;

struct GroupIndices {
  std::vector<double> first, total;
  double variance = 0;
};

GroupIndices indices_of(const Sums& sums, std::size_t n_groups) {
  const double n = sums[0], mean = sums[1] / (2 * n);
  GroupIndices result;
  result.variance = sums[2] / (2 * n) - mean * mean;
  for (std::size_t g = 0; g < n_groups; ++g) {
    result.first.push_back(sums[3 + 2 * g] / n / result.variance);
    result.total.push_back(sums[4 + 2 * g] / (2 * n) / result.variance);
  }
  return result;
}

/// The rows that can be used.
struct Rows {
  std::size_t width;
  std::vector<const double*> begins;
  std::uint64_t omitted = 0;
};

Rows usable_rows(std::span<const double> values, std::size_t n_groups) {
  Rows rows{n_groups + 2, {}, 0};
  for (std::size_t at = 0; at + rows.width <= values.size(); at += rows.width) {
    const auto row = values.subspan(at, rows.width);
    if (std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); })) {
      rows.begins.push_back(row.data());
    } else {
      ++rows.omitted;
    }
  }
  return rows;
}

double mean_of_both(const Rows& rows) {
  // About the first value, so that a small scatter about a large mean is not lost.
  const double origin = rows.begins.front()[0];
  double sum = 0;
  for (const double* row : rows.begins) sum += (row[0] - origin) + (row[1] - origin);
  return origin + sum / (2 * static_cast<double>(rows.begins.size()));
}

std::vector<Sums> block_sums(const Rows& rows, double mean) {
  const std::size_t n_groups = rows.width - 2;
  std::vector<Sums> blocks(std::min<std::size_t>(rows.begins.size(), kMaxBlocks), Sums(3 + 2 * n_groups, 0.0));
  for (std::size_t i = 0; i < rows.begins.size(); ++i) {
    const double* row = rows.begins[i];
    const double a = row[0] - mean, b = row[1] - mean;
    Sums& sums = blocks[i % blocks.size()];
    sums[0] += 1;
    sums[1] += a + b;
    sums[2] += a * a + b * b;
    for (std::size_t g = 0; g < n_groups; ++g) {
      const double change = row[2 + g] - row[0];
      sums[3 + 2 * g] += b * change;
      sums[4 + 2 * g] += change * change;
    }
  }
  return blocks;
}

void add(const Sums& part, Sums& all) {
  for (std::size_t i = 0; i < all.size(); ++i) all[i] += part[i];
}

Interval interval_of(double value, const std::vector<double>& resampled, double confidence) {
  const std::vector<double> sorted = sorted_values(resampled);
  if (sorted.empty()) return {value, value, value};
  const double tail = (1 - confidence) / 2;
  return {value, quantile_of(sorted, tail).value, quantile_of(sorted, 1 - tail).value};
}

}  // namespace

std::optional<SobolIndices> sobol_indices(std::span<const double> values, std::size_t n_groups,
                                          const IndexOptions& options) {
  const Rows rows = usable_rows(values, n_groups);
  if (rows.begins.size() < kMinRows) return std::nullopt;
  const double mean = mean_of_both(rows);
  const std::vector<Sums> blocks = block_sums(rows, mean);
  Sums all(3 + 2 * n_groups, 0.0);
  for (const Sums& block : blocks) add(block, all);
  const GroupIndices estimate = indices_of(all, n_groups);
  // Below this the values differ by their last digits alone.
  constexpr double kRounding = 1e-13;
  if (!(estimate.variance > kRounding * kRounding * mean * mean)) return std::nullopt;

  std::vector<std::vector<double>> first(n_groups), total(n_groups);
  for (std::uint64_t r = 0; r < options.resamples; ++r) {
    Sums drawn(all.size(), 0.0);
    for (std::uint64_t i = 0; i < blocks.size(); ++i)
      add(blocks[below(blocks.size(), hash(options.seed, r, i))], drawn);
    const GroupIndices one = indices_of(drawn, n_groups);
    for (std::size_t g = 0; g < n_groups; ++g) {
      first[g].push_back(one.first[g]);
      total[g].push_back(one.total[g]);
    }
  }
  SobolIndices result;
  result.mean = mean;
  result.variance = estimate.variance;
  result.rows = rows.begins.size();
  result.omitted = rows.omitted;
  for (std::size_t g = 0; g < n_groups; ++g) {
    result.first.push_back(interval_of(estimate.first[g], first[g], options.confidence));
    result.total.push_back(interval_of(estimate.total[g], total[g], options.confidence));
  }
  return result;
}

}  // namespace ringfilm::study
