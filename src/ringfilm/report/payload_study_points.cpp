#include <algorithm>
#include <cmath>

#include "ringfilm/cycle/result.hpp"
#include "ringfilm/report/payload_numbers.hpp"
#include "ringfilm/report/payload_study.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

constexpr int kDigits = 5;
const std::vector<std::string> kMapped = {"mean_total_friction", "fmep", "min_film_thickness", "mixed_share"};
const std::vector<std::string> kStribeck = {"mean_stribeck_number", "mean_friction_coefficient", "mean_film_parameter"};

std::size_t place_of(const std::string& name) {
  const auto& all = cycle::cycle_quantities();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& q) { return q.name == name; });
  return static_cast<std::size_t>(found - all.begin());
}

/// A factor of the grid of one base, and which of its levels the page carries.
struct Axis {
  std::size_t factor = 0, levels = 0;
  std::vector<std::size_t> kept;
};

std::vector<Axis> axes_of(const study::Plan& plan, std::size_t base) {
  std::vector<Axis> axes;
  const auto& factors = plan.study().factors;
  for (std::size_t j = 0; j < factors.size(); ++j) {
    if (!study::applies(factors[j], base)) continue;
    Axis axis{j, study::n_levels(factors[j].variation), {}};
    for (std::size_t k = 0; k < axis.levels; ++k) axis.kept.push_back(k);
    axes.push_back(std::move(axis));
  }
  const auto points = [&] {
    std::size_t n = 1;
    for (const Axis& axis : axes) n *= axis.kept.size();
    return n;
  };
  // Every other level of the longest axis goes, its ends stay, until the page holds what is left.
  while (!axes.empty() && points() * plan.study().bases.size() > kMostGridPoints) {
    Axis& longest = *std::max_element(axes.begin(), axes.end(),
                                      [](const Axis& a, const Axis& b) { return a.kept.size() < b.kept.size(); });
    if (longest.kept.size() < 4) break;
    std::vector<std::size_t> fewer;
    for (std::size_t k = 0; k < longest.kept.size(); k += 2) fewer.push_back(longest.kept[k]);
    if (fewer.back() != longest.kept.back()) fewer.push_back(longest.kept.back());
    longest.kept = std::move(fewer);
  }
  return axes;
}

/// Points of the grid that are kept, in its own order.
std::vector<std::uint64_t> kept_points(const std::vector<Axis>& axes) {
  std::vector<std::uint64_t> points{0};
  for (const Axis& axis : axes) {
    std::vector<std::uint64_t> longer;
    for (const std::uint64_t point : points) {
      for (const std::size_t k : axis.kept) longer.push_back(point * axis.levels + k);
    }
    points = std::move(longer);
  }
  return points;
}

ordered_json grid_object(const study::Plan& plan, const std::vector<std::vector<double>>& columns) {
  ordered_json bases = ordered_json::array();
  for (std::size_t b = 0; b < plan.study().bases.size(); ++b) {
    const std::vector<Axis> axes = axes_of(plan, b);
    const std::vector<std::uint64_t> points = kept_points(axes);
    ordered_json described = ordered_json::array(), values = ordered_json::object();
    for (const Axis& axis : axes) {
      ordered_json levels = ordered_json::array();
      for (const std::size_t k : axis.kept)
        levels.push_back(rounded(study::level(plan.study().factors[axis.factor].variation, k), 8));
      described.push_back({{"factor", axis.factor}, {"levels", std::move(levels)}, {"of", axis.levels}});
    }
    for (std::size_t q = 0; q < kMapped.size(); ++q) {
      ordered_json list = ordered_json::array();
      for (const std::uint64_t p : points) list.push_back(rounded(columns[q][plan.scenario(b, p)], kDigits));
      values[kMapped[q]] = std::move(list);
    }
    bases.push_back({{"axes", std::move(described)}, {"values", std::move(values)}});
  }
  return {{"quantities", kMapped}, {"bases", std::move(bases)}};
}

/// Every so many of the scenarios that were solved, so that no more than `kMostDrawnPoints` are left.
ordered_json stribeck_object(const io::StudyRows& rows) {
  std::vector<std::vector<double>> columns;
  for (const std::string& name : kStribeck) columns.push_back(rows.values(place_of(name)));
  std::vector<std::uint64_t> solved;
  for (std::uint64_t i = 0; i < rows.plan.size(); ++i) {
    if (std::isfinite(columns[0][i]) && std::isfinite(columns[1][i])) solved.push_back(i);
  }
  const std::size_t n = std::min(solved.size(), kMostDrawnPoints);
  ordered_json scenarios = ordered_json::array(), bases = ordered_json::array();
  std::vector<ordered_json> lists(kStribeck.size(), ordered_json::array());
  for (std::size_t k = 0; k < n; ++k) {
    // In whole numbers, so that the same study shows the same points everywhere.
    const std::uint64_t i = solved[k * solved.size() / n];
    scenarios.push_back(i);
    bases.push_back(rows.plan.base_of(i));
    for (std::size_t q = 0; q < lists.size(); ++q) lists[q].push_back(rounded(columns[q][i], kDigits));
  }
  ordered_json object = {{"of", solved.size()}, {"scenario", std::move(scenarios)}, {"base", std::move(bases)}};
  for (std::size_t q = 0; q < lists.size(); ++q) object[kStribeck[q]] = std::move(lists[q]);
  return object;
}

}  // namespace

void add_study_points(const io::StudyRows& rows, ordered_json& payload) {
  const study::Study& study = rows.plan.study();
  payload["grid"] = nullptr;
  if (study.sampling.method == study::Method::kGrid) {
    std::vector<std::vector<double>> columns;
    for (const std::string& name : kMapped) columns.push_back(rows.values(place_of(name)));
    payload["grid"] = grid_object(rows.plan, columns);
  }
  payload["stribeck"] = stribeck_object(rows);
}

}  // namespace ringfilm::report
