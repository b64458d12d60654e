#include "ringfilm/study/statistics/flat_factors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <variant>

namespace ringfilm::study {
namespace {

constexpr const char* kMeasured[] = {"fmep", "min_film_thickness", "blow_by_per_cycle"};
/// Listed numbers that a part of a range has at least.
constexpr std::size_t kMinOfPart = 3;
/// More different numbers are those of a sample, not listed.
constexpr std::size_t kMaxListed = 64;

/// Largest difference of values between two numbers of the factor, over the largest value; nothing where fewer than
/// two scenarios are between them.
std::optional<double> spread(const std::map<double, std::vector<double>>& curve, std::size_t value, double low,
                             double high) {
  double least = INFINITY, most = -INFINITY, size = 0;
  int n = 0;
  for (auto at = curve.lower_bound(low); at != curve.end() && at->first <= high; ++at, ++n) {
    const double v = at->second[value];
    least = std::min(least, v);
    most = std::max(most, v);
    size = std::max(size, std::abs(v));
  }
  if (n < 2) return std::nullopt;
  return size > 0 ? (most - least) / size : 0;
}

}  // namespace

FlatFactors::FlatFactors(const Plan& plan, double tolerance)
    : plan_(plan), tolerance_(tolerance), thinning_(thinning_of_pairs(plan)), curves_(plan.study().factors.size()) {
  if (!has_pairs(plan.study().sampling)) return;
  for (const char* name : kMeasured) {
    if (const auto index = plan.values().index(name)) watched_.push_back(*index);
  }
}

void FlatFactors::add(std::uint64_t scenario, std::span<const double> values) {
  if (std::ranges::any_of(values, [](double v) { return std::isnan(v); })) return;
  const Point point = plan_.point(scenario);
  for (std::size_t j = 0; j < curves_.size(); ++j) {
    const Factor& factor = plan_.study().factors[j];
    if (!point.values[j] || std::holds_alternative<Choices>(factor.variation) || !applies(factor, point.base)) continue;
    const std::uint64_t others = hash_without(point, j);
    if (others % thinning_ == 0)
      curves_[j][others].emplace(*point.values[j], std::vector(values.begin(), values.end()));
  }
}

bool FlatFactors::is_flat(const Curves& curves, std::size_t value, double low, double high) const {
  bool any = false;
  for (const auto& [others, curve] : curves) {
    const std::optional<double> here = spread(curve, value, low, high);
    if (here && *here > tolerance_) return false;
    any = any || here;
  }
  return any;
}

void FlatFactors::append_ranges(std::size_t factor, std::size_t value, std::vector<FlatRange>& ranges) const {
  const Curves& curves = curves_[factor];
  std::set<double> numbers;
  for (const auto& [others, curve] : curves) {
    for (const auto& [number, values] : curve) numbers.insert(number);
  }
  if (numbers.size() < 2) return;
  const auto append = [&](bool is_whole, double low, double high) {
    ranges.push_back({factor, watched_[value], is_whole, low, high});
  };
  const double first = *numbers.begin(), last = *numbers.rbegin();
  if (is_flat(curves, value, first, last)) return append(true, first, last);
  if (numbers.size() > kMaxListed) return;
  const std::vector<double> listed(numbers.begin(), numbers.end());
  for (std::size_t k = 1; k + kMinOfPart <= listed.size(); ++k) {
    if (is_flat(curves, value, listed[k], last)) return append(false, listed[k], last);
  }
  for (std::size_t k = listed.size() - 1; k-- >= kMinOfPart;) {
    if (is_flat(curves, value, first, listed[k])) return append(false, first, listed[k]);
  }
}

std::vector<FlatRange> FlatFactors::ranges(const IdleFactors& idle) const {
  std::vector<FlatRange> ranges;
  for (std::size_t j = 0; j < curves_.size(); ++j) {
    if (idle.is_idle(j)) continue;
    for (std::size_t v = 0; v < watched_.size(); ++v) append_ranges(j, v, ranges);
  }
  return ranges;
}

}  // namespace ringfilm::study
