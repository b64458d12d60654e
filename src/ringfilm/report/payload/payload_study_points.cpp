#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "ringfilm/cycle/regimes.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/report/payload/described.hpp"
#include "ringfilm/report/payload/even_pick.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"
#include "ringfilm/report/payload/payload_study.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

constexpr int kPointDigits = 5;
const std::vector<std::string> kMapped = {"mean_total_friction", "fmep", "min_film_thickness",
                                          "boundary_regime_energy_share", "full_film_energy_share"};
const std::vector<std::string> kStribeck = {"mean_stribeck_number", "mean_friction_coefficient", "mean_lambda_ratio"};
/// Not a value of the cycle: the ratio of two of them.
const cycle::Quantity kBoundaryPowerShare = {
    "boundary_power_share", "1", "%", "share of boundary friction in the friction power", "", "eq-mean"};

std::vector<double> values_of(const io::StudyRows& rows, const std::string& name) {
  return rows.values(*rows.plan.values().index(name));
}

/// Share of boundary friction in the friction power of each scenario; NaN where one was not solved.
std::vector<double> boundary_power_shares(const io::StudyRows& rows) {
  std::vector<double> shares = values_of(rows, "mean_boundary_power");
  const std::vector<double> power = values_of(rows, "mean_power_loss");
  for (std::size_t i = 0; i < shares.size(); ++i) shares[i] /= power[i];
  return shares;
}

/// Names of the predominant regimes of some scenarios.
std::vector<std::string_view> regimes(const io::StudyRows& rows, const std::vector<std::uint64_t>& scenarios) {
  std::vector<cycle::CycleValues> values(scenarios.size());
  for (const char* name :
       {"boundary_regime_energy_share", "full_film_energy_share", "mean_boundary_power", "mean_power_loss"}) {
    const cycle::CycleQuantity& quantity = cycle::cycle_quantities()[*cycle::cycle_quantity_index(name)];
    const std::vector<double> all = values_of(rows, name);
    for (std::size_t k = 0; k < values.size(); ++k) values[k].*quantity.value = all[scenarios[k]];
  }
  std::vector<std::string_view> names;
  for (const cycle::CycleValues& one : values) names.push_back(cycle::regime_name(cycle::predominant_regime(one)));
  return names;
}

/// A factor of the grid of one base, and which of its levels the page carries.
struct Axis {
  std::size_t factor = 0, levels = 0;
  std::vector<std::size_t> kept;
};

/// Nothing where the page cannot hold the grid with two levels of each axis.
std::optional<std::vector<Axis>> axes_of(const study::Plan& plan, std::size_t base) {
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
  while (!axes.empty() && points() * plan.study().bases.size() > kMaxGridPoints) {
    Axis& longest = *std::max_element(axes.begin(), axes.end(),
                                      [](const Axis& a, const Axis& b) { return a.kept.size() < b.kept.size(); });
    if (longest.kept.size() < 3) return std::nullopt;
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

/// Null where one of the bases has more points than the page can hold.
ordered_json grid_object(const io::StudyRows& rows) {
  const study::Plan& plan = rows.plan;
  std::vector<std::vector<Axis>> all_axes;
  for (std::size_t b = 0; b < plan.study().bases.size(); ++b) {
    auto axes = axes_of(plan, b);
    if (!axes) return nullptr;
    all_axes.push_back(std::move(*axes));
  }
  std::vector<std::string> mapped = plan.values().has_cycle ? kMapped : plan.values().main;
  std::vector<std::vector<double>> columns;
  for (const std::string& name : mapped) columns.push_back(values_of(rows, name));
  if (plan.values().has_cycle) {
    mapped.push_back(kBoundaryPowerShare.name);
    columns.push_back(boundary_power_shares(rows));
  }
  ordered_json bases = ordered_json::array();
  for (std::size_t b = 0; b < plan.study().bases.size(); ++b) {
    const std::vector<Axis>& axes = all_axes[b];
    const std::vector<std::uint64_t> points = kept_points(axes);
    ordered_json described = ordered_json::array(), values = ordered_json::object();
    for (const Axis& axis : axes) {
      ordered_json levels = ordered_json::array();
      for (const std::size_t k : axis.kept)
        levels.push_back(rounded(study::level(plan.study().factors[axis.factor].variation, k), 8));
      described.push_back({{"factor", axis.factor}, {"levels", std::move(levels)}, {"of", axis.levels}});
    }
    for (std::size_t q = 0; q < mapped.size(); ++q) {
      ordered_json list = ordered_json::array();
      for (const std::uint64_t p : points) list.push_back(rounded(columns[q][plan.scenario(b, p)], kPointDigits));
      values[mapped[q]] = std::move(list);
    }
    bases.push_back({{"axes", std::move(described)}, {"values", std::move(values)}});
  }
  return {{"quantities", mapped}, {"bases", std::move(bases)}};
}

/// Scenarios that are drawn, by their number: each base's share of `kMaxDrawnPoints`, evenly picked among its
/// scenarios that were solved.
std::vector<std::uint64_t> drawn_scenarios(const study::Plan& plan, const std::vector<bool>& is_solved) {
  const std::size_t n_bases = plan.study().bases.size();
  std::vector<std::uint64_t> solved(n_bases), seen(n_bases);
  std::uint64_t n_solved = 0;
  for (std::uint64_t i = 0; i < is_solved.size(); ++i) {
    if (!is_solved[i]) continue;
    ++solved[plan.base_of(i)];
    ++n_solved;
  }
  std::vector<std::vector<std::uint64_t>> picked(n_bases);
  for (std::size_t b = 0; b < n_bases; ++b) {
    const std::uint64_t most =
        n_solved <= kMaxDrawnPoints ? solved[b] : std::max<std::uint64_t>(1, kMaxDrawnPoints * solved[b] / n_solved);
    picked[b] = evenly_picked(solved[b], most);
  }
  std::vector<std::size_t> next(n_bases);
  std::vector<std::uint64_t> drawn;
  for (std::uint64_t i = 0; i < is_solved.size(); ++i) {
    if (!is_solved[i]) continue;
    const std::size_t b = plan.base_of(i);
    const std::uint64_t place = seen[b]++;
    if (next[b] == picked[b].size() || picked[b][next[b]] != place) continue;
    drawn.push_back(i);
    ++next[b];
  }
  return drawn;
}

/// Null where the values are not those of one film.
ordered_json stribeck_object(const io::StudyRows& rows) {
  if (!rows.plan.values().has_cycle) return nullptr;
  std::vector<bool> is_solved(rows.plan.size(), true);
  for (const std::size_t q : {0, 1}) {
    const std::vector<double> values = values_of(rows, kStribeck[q]);
    for (std::uint64_t i = 0; i < values.size(); ++i) is_solved[i] = is_solved[i] && std::isfinite(values[i]);
  }
  const std::vector<std::uint64_t> drawn = drawn_scenarios(rows.plan, is_solved);
  ordered_json bases = ordered_json::array();
  for (const std::uint64_t i : drawn) bases.push_back(rows.plan.base_of(i));
  ordered_json object = {
      {"of", std::count(is_solved.begin(), is_solved.end(), true)}, {"scenario", drawn}, {"base", std::move(bases)}};
  const auto of_drawn = [&drawn](const std::vector<double>& all) {
    std::vector<double> values;
    for (const std::uint64_t i : drawn) values.push_back(all[i]);
    return rounded_list(values, kPointDigits);
  };
  for (const std::string& name : kStribeck) object[name] = of_drawn(values_of(rows, name));
  object[kBoundaryPowerShare.name] = of_drawn(boundary_power_shares(rows));
  object["regime"] = regimes(rows, drawn);
  return object;
}

}  // namespace

void add_study_points(const io::StudyRows& rows, ordered_json& payload) {
  const bool is_grid = rows.plan.study().sampling.method == study::Method::kGrid;
  payload["grid"] = is_grid ? grid_object(rows) : ordered_json(nullptr);
  payload["stribeck"] = stribeck_object(rows);
  payload["page_quantities"] = described_all(std::vector{kBoundaryPowerShare});
}

}  // namespace ringfilm::report
