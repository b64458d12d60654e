#include "ringfilm/study/design/idle_factors.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "ringfilm/study/sampling/hash.hpp"

namespace ringfilm::study {
namespace {

/// Pairs of scenarios and factors that are remembered, to a factor of about one: 6 MB. Of longer plans every so-and-so
/// set of other numbers is looked at, with all scenarios that have it.
constexpr std::uint64_t kMaxRemembered = std::uint64_t{1} << 16;

std::uint64_t bits(const std::optional<double>& number) {
  return std::bit_cast<std::uint64_t>(number.value_or(std::numeric_limits<double>::quiet_NaN()));
}

std::uint64_t hash_of(std::span<const double> values) {
  std::uint64_t all = 0;
  for (const double value : values) all = hash(all, std::bit_cast<std::uint64_t>(value));
  return all;
}

}  // namespace

bool has_pairs(const Sampling& sampling) {
  return sampling.method != Method::kLatinHypercube &&
         (sampling.method != Method::kSobol || sampling.indices != Indices::kNone);
}

std::uint64_t hash_without(const Point& point, std::size_t factor) {
  std::uint64_t others = hash(point.base, 0);
  for (std::size_t j = 0; j < point.values.size(); ++j) {
    if (j != factor) others = hash(others, bits(point.values[j]));
  }
  return others;
}

std::uint64_t thinning_of_pairs(const Plan& plan) {
  return std::max<std::uint64_t>(plan.size() * plan.study().factors.size() / kMaxRemembered, 1);
}

IdleFactors::IdleFactors(const Plan& plan)
    : plan_(plan),
      has_pairs_(has_pairs(plan.study().sampling)),
      thinning_(thinning_of_pairs(plan)),
      factors_(plan.study().factors.size()),
      bases_(plan.study().bases.size()) {}

void IdleFactors::add(std::uint64_t scenario, std::span<const double> values) {
  if (is_decided() || values.empty() || std::isnan(values.front())) return;
  const std::uint64_t of_values = hash_of(values);
  BaseValues& base = bases_.at(plan_.base_of(scenario));
  if (base.n++ == 0) base.values = of_values;
  base.differ = base.differ || base.values != of_values;
  if (!has_pairs_) return;
  const Point point = plan_.point(scenario);
  for (std::size_t j = 0; j < factors_.size(); ++j) {
    if (!factors_[j].has_effect && applies(plan_.study().factors[j], point.base)) look_for_pair(j, point, of_values);
  }
}

void IdleFactors::look_for_pair(std::size_t factor, const Point& point, std::uint64_t values) {
  const std::uint64_t others = hash_without(point, factor);
  if (others % thinning_ != 0) return;
  Watched& watched = factors_[factor];
  const double number = std::bit_cast<double>(bits(point.values[factor]));
  const auto [seen, is_first] = watched.by_others.try_emplace(others, Seen{number, values});
  if (is_first || std::bit_cast<std::uint64_t>(seen->second.number) == bits(point.values[factor])) return;
  ++watched.n_pairs;
  if (seen->second.values == values) return;
  watched.has_effect = true;
  watched.by_others.clear();
}

bool IdleFactors::is_decided() const {
  if (has_pairs_) return std::all_of(factors_.begin(), factors_.end(), [](const Watched& w) { return w.has_effect; });
  return std::all_of(bases_.begin(), bases_.end(), [](const BaseValues& base) { return base.differ; });
}

std::vector<std::string> IdleFactors::notes() const {
  std::vector<std::string> notes;
  const Study& study = plan_.study();
  for (std::size_t j = 0; j < factors_.size(); ++j) {
    if (!is_idle(j)) continue;
    notes.push_back(called(study.factors[j]) +
                    " changes no value of the cycle: " + std::to_string(factors_[j].n_pairs) +
                    (factors_[j].n_pairs == 1 ? " scenario differs" : " scenarios differ") +
                    " from others in it alone, and in no result");
  }
  // Scenarios of a list may differ in several factors throughout.
  const bool is_about_bases = !has_pairs_ || (is_listed(study.sampling.method) && notes.empty());
  for (std::size_t b = 0; b < bases_.size() && is_about_bases; ++b) {
    if (bases_[b].differ || bases_[b].n < 2) continue;
    notes.push_back("no factor changes a value of base \"" + study.bases[b].name + "\": its " +
                    std::to_string(bases_[b].n) + " solved scenarios have the same values of the cycle");
  }
  return notes;
}

}  // namespace ringfilm::study
