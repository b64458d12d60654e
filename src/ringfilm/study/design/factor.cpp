#include "ringfilm/study/design/factor.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ringfilm::study {
namespace {

double in_span(const Span& span, double share) {
  if (span.spacing == Spacing::kLinear) return span.low + share * (span.high - span.low);
  return std::clamp(span.low * std::pow(span.high / span.low, share), std::min(span.low, span.high),
                    std::max(span.low, span.high));
}

std::size_t part_of(double share, std::size_t n) {
  return std::min(static_cast<std::size_t>(share * static_cast<double>(n)), n - 1);
}

struct LevelCount {
  std::size_t operator()(const Levels& levels) const { return levels.values.size(); }
  std::size_t operator()(const Choices& choices) const { return choices.values.size(); }
  std::size_t operator()(const Span& span) const { return span.points; }
  std::size_t operator()(const Distribution&) const { return 0; }
  std::size_t operator()(const Listed&) const { return 0; }
};

}  // namespace

bool applies(const Factor& factor, std::size_t base) {
  return std::any_of(factor.targets.begin(), factor.targets.end(),
                     [base](const Target& target) { return !target.base || *target.base == base; });
}

std::size_t n_levels(const Variation& variation) { return std::visit(LevelCount{}, variation); }

double level(const Variation& variation, std::size_t i) {
  if (i >= n_levels(variation)) throw std::logic_error("a level that the factor does not have");
  if (const auto* levels = std::get_if<Levels>(&variation)) return levels->values[i];
  const auto* span = std::get_if<Span>(&variation);
  if (span == nullptr) return static_cast<double>(i);
  if (i + 1 == span->points) return span->high;
  return i == 0 ? span->low : in_span(*span, static_cast<double>(i) / static_cast<double>(span->points - 1));
}

double value_at(const Variation& variation, double share) {
  if (const auto* distribution = std::get_if<Distribution>(&variation)) return quantile(*distribution, share);
  if (const auto* span = std::get_if<Span>(&variation)) return in_span(*span, share);
  const std::size_t n = n_levels(variation);
  if (n == 0) throw std::logic_error("a factor without values cannot be drawn");
  return level(variation, part_of(share, n));
}

std::string called(const Factor& factor) { return "factor \"" + factor.name + "\""; }

}  // namespace ringfilm::study
