#include "ringfilm/report/payload/study_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "ringfilm/study/statistics/values_of_base.hpp"

namespace ringfilm::report {
namespace {

constexpr std::size_t kMaxGroups = 30;
/// Factors in the name of a scenario.
constexpr std::size_t kMaxNamed = 4;

bool is_choice(const study::Factor& factor) { return std::holds_alternative<study::Choices>(factor.variation); }

/// "sae-30" of "../../data/lubricants/sae-30.toml": the rest is the same for all, as a rule.
std::string short_name(const std::string& text) {
  const std::size_t slash = text.find_last_of("/\\");
  const std::string last = slash == std::string::npos ? text : text.substr(slash + 1);
  const std::size_t dot = last.rfind(".toml");
  return dot == std::string::npos ? last : last.substr(0, dot);
}

/// Places of the choices of a point; -1 where it leaves the base as it is.
std::vector<int> choices_of(const study::Study& study, const study::Point& point) {
  std::vector<int> choices;
  for (std::size_t j = 0; j < study.factors.size(); ++j) {
    if (is_choice(study.factors[j])) choices.push_back(point.values[j] ? static_cast<int>(*point.values[j]) : -1);
  }
  return choices;
}

std::string group_name(const study::Study& study, std::size_t base, const study::Point& point) {
  std::string name;
  const auto append = [&name](const std::string& part) { name.append(name.empty() ? "" : ", ").append(part); };
  if (study.bases.size() > 1) append(study.bases[base].name);
  for (std::size_t j = 0; j < study.factors.size(); ++j) {
    const auto* choices = std::get_if<study::Choices>(&study.factors[j].variation);
    if (choices == nullptr || !point.values[j]) continue;
    append(short_name(choices->values.at(static_cast<std::size_t>(*point.values[j])).text));
  }
  return name.empty() ? study.bases[base].name : name;
}

std::string shown_value(const study::Factor& factor, double value, const io::Units& units) {
  if (const auto* choices = std::get_if<study::Choices>(&factor.variation))
    return short_name(choices->values.at(static_cast<std::size_t>(value)).text);
  return units.shown(value, factor.unit, factor.display_unit, 4);
}

bool is_paired(const study::Plan& plan, const ComparisonGroup& first, const ComparisonGroup& other) {
  if (first.scenarios.size() != other.scenarios.size()) return false;
  // Enough to decide: points of a plan pair all or hardly any.
  const std::size_t n = std::min<std::size_t>(first.scenarios.size(), 64);
  for (std::size_t k = 0; k < n; ++k) {
    const study::Point a = plan.point(first.scenarios[k]), b = plan.point(other.scenarios[k]);
    for (std::size_t j = 0; j < plan.study().factors.size(); ++j) {
      const study::Factor& factor = plan.study().factors[j];
      const bool in_both = study::applies(factor, first.base) && study::applies(factor, other.base);
      if (!is_choice(factor) && in_both && a.values[j] != b.values[j]) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<std::pair<std::uint64_t, std::uint64_t>> extreme_scenarios(const study::Plan& plan,
                                                                         const std::vector<double>& all,
                                                                         std::size_t base) {
  std::optional<std::pair<std::uint64_t, std::uint64_t>> extremes;
  for (std::uint64_t p = 0; p < plan.n_points(base); ++p) {
    const std::uint64_t i = plan.scenario(base, p);
    if (!std::isfinite(all[i])) continue;
    if (!extremes) extremes.emplace(i, i);
    if (all[i] < all[extremes->first]) extremes->first = i;
    if (all[i] > all[extremes->second]) extremes->second = i;
  }
  return extremes;
}

std::vector<ComparisonGroup> comparison_groups(const study::Plan& plan, const io::Units& units) {
  const study::Study& study = plan.study();
  const bool has_choice = std::any_of(study.factors.begin(), study.factors.end(), is_choice);
  const bool each_alone =
      !has_choice && !study::has_sample(plan) && study.bases.size() == 1 && plan.size() <= kMaxGroups;
  if (!has_choice && study.bases.size() == 1 && !each_alone) return {};
  std::vector<ComparisonGroup> groups;
  std::map<std::pair<std::size_t, std::vector<int>>, std::size_t> known;
  for (std::size_t b = 0; b < study.bases.size(); ++b) {
    for (std::uint64_t p = 0; p < plan.n_points(b); ++p) {
      if (study::has_sample(plan) && !plan.is_sample(p)) continue;
      const std::uint64_t i = plan.scenario(b, p);
      if (each_alone) {
        groups.push_back({scenario_name(plan, i, units), b, {i}, false});
        continue;
      }
      std::pair<std::size_t, std::vector<int>> key{b, {}};
      std::optional<study::Point> point;
      if (has_choice) {
        point = plan.point(i);
        key.second = choices_of(study, *point);
      }
      const auto [found, is_first] = known.try_emplace(std::move(key), groups.size());
      if (is_first) {
        if (groups.size() == kMaxGroups) return {};
        const study::Point here = point ? *point : plan.point(i);
        groups.push_back({group_name(study, b, here), b, {}, false});
      }
      groups[found->second].scenarios.push_back(i);
    }
  }
  if (groups.size() < 2) return {};
  for (ComparisonGroup& group : groups) group.pairs_with_first = is_paired(plan, groups.front(), group);
  return groups;
}

std::string scenario_name(const study::Plan& plan, std::uint64_t scenario, const io::Units& units) {
  const study::Study& study = plan.study();
  const std::uint64_t p = plan.point_of(scenario);
  if (study.sampling.method == study::Method::kOperatingPoints) return study.sampling.points.at(p).name;
  const study::Point point = plan.point(scenario);
  std::optional<study::Point> start;
  if (study.sampling.method == study::Method::kOneAtATime && p > 0) start = plan.point(plan.scenario(point.base, 0));
  std::vector<std::string> parts;
  for (std::size_t j = 0; j < study.factors.size(); ++j) {
    if (!point.values[j] || (start && point.values[j] == start->values[j])) continue;
    parts.push_back(study.factors[j].name + " " + shown_value(study.factors[j], *point.values[j], units));
  }
  if (parts.size() > kMaxNamed) return "scenario " + std::to_string(scenario);
  return parts.empty() ? "base" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace ringfilm::report
