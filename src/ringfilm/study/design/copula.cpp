#include "ringfilm/study/design/copula.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ringfilm::study {

bool applies(const FactorGroup& group, const Study& study, std::size_t base) {
  return std::any_of(group.factors.begin(), group.factors.end(),
                     [&](std::size_t j) { return applies(study.factors[j], base); });
}

std::vector<FactorGroup> factor_groups(const Study& study) {
  const std::size_t n = study.factors.size();
  std::vector<std::size_t> first(n);  // factor of the group of each
  std::iota(first.begin(), first.end(), std::size_t{0});
  for (const Correlation& one : study.correlations) {
    const std::size_t a = first[one.first], b = first[one.second];
    std::replace(first.begin(), first.end(), std::max(a, b), std::min(a, b));
  }
  std::vector<FactorGroup> groups;
  for (std::size_t i = 0; i < n; ++i) {
    if (first[i] != i) continue;
    FactorGroup group;
    for (std::size_t j = i; j < n; ++j) {
      if (first[j] != i) continue;
      if (!group.name.empty()) group.name.append(" and ");
      group.name.append(study.factors[j].name);
      group.factors.push_back(j);
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<double> correlation_matrix(const Study& study, const FactorGroup& group) {
  const std::size_t n = group.factors.size();
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 1;
  const auto place = [&group](std::size_t factor) {
    const auto found = std::find(group.factors.begin(), group.factors.end(), factor);
    return static_cast<std::size_t>(found - group.factors.begin());
  };
  for (const Correlation& one : study.correlations) {
    const std::size_t i = place(one.first), j = place(one.second);
    if (i == n || j == n) continue;
    matrix[i * n + j] = one.value;
    matrix[j * n + i] = one.value;
  }
  return matrix;
}

Triangle triangle(std::size_t n, const std::vector<double>& matrix) {
  // A dozen lines of our own, because a message must name the factor at which it fails, and libraries do not.
  constexpr double kRounding = 1e-10;  // tolerance relative to the diagonal, which is 1
  Triangle result{n, std::vector<double>(n * n, 0.0), std::nullopt};
  auto& L = result.entries;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix[i * n + j];
      for (std::size_t k = 0; k < j; ++k) rest -= L[i * n + k] * L[j * n + k];
      if (i == j && !(rest > kRounding)) {
        result.failed_row = i;
        return result;
      }
      L[i * n + j] = i == j ? std::sqrt(rest) : rest / L[j * n + j];
    }
  }
  return result;
}

Copula::Copula(const Study& study) {
  for (const FactorGroup& group : factor_groups(study)) {
    if (group.factors.size() == 1) continue;
    blocks_.push_back({group.factors, triangle(group.factors.size(), correlation_matrix(study, group))});
  }
}

void Copula::correlate(std::vector<double>& shares) const {
  for (const auto& [factors, triangle] : blocks_) {
    const std::size_t n = factors.size();
    std::vector<double> z(n);
    for (std::size_t i = 0; i < n; ++i) z[i] = normal_quantile(shares[factors[i]]);
    for (std::size_t i = 0; i < n; ++i) {
      double score = 0;
      for (std::size_t j = 0; j <= i; ++j) score += triangle.entries[i * n + j] * z[j];
      // Scores beyond 8 are rounded to 1 by the probability, and no quantile is there.
      shares[factors[i]] = std::clamp(normal_probability(score), 0x1.0p-53, 1 - 0x1.0p-53);
    }
  }
}

}  // namespace ringfilm::study
