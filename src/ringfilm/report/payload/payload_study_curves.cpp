#include <algorithm>
#include <cmath>

#include "ringfilm/io/study/study_curves.hpp"
#include "ringfilm/report/payload/described.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"
#include "ringfilm/report/payload/payload_study.hpp"
#include "ringfilm/report/payload/study_groups.hpp"
#include "ringfilm/study/statistics/values_of_base.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

constexpr int kBandDigits = 5;
/// A chart has hardly more pixels across.
constexpr std::size_t kMaxAngles = 720;

ordered_json every(const std::vector<double>& values, std::size_t stride) {
  ordered_json list = ordered_json::array();
  for (std::size_t k = 0; k < values.size(); k += stride) list.push_back(rounded(values[k], kBandDigits));
  return list;
}

/// Curves of single scenarios, evenly picked with the first and the last of those that were solved; null of a sample
/// and of many scenarios, of which bands show more.
ordered_json scenario_curves(const io::StudyRows& rows, std::size_t n_curves, std::size_t n_angles, std::size_t stride,
                             const io::Units& units) {
  const study::Plan& plan = rows.plan;
  if (study::has_sample(plan) || plan.size() > kFewScenarios) return nullptr;
  const std::vector<double> solved = rows.values(*plan.values().index(plan.values().main.front()));
  std::vector<std::uint64_t> scenarios;
  for (std::uint64_t i = 0; i < plan.size(); ++i) {
    if (std::isfinite(solved[i])) scenarios.push_back(i);
  }
  const std::uint64_t n = scenarios.size(), n_drawn = std::min(n, kMaxDrawnCurves);
  ordered_json list = ordered_json::array();
  for (std::uint64_t k = 0; k < n_drawn; ++k) {
    const std::uint64_t i = scenarios[n_drawn == 1 ? 0 : k * (n - 1) / (n_drawn - 1)];
    ordered_json values = ordered_json::array();
    for (std::size_t q = 0; q < n_curves; ++q) {
      const std::vector<float> curve = rows.curve(q, 0, n_angles, {i, i + 1});
      values.push_back(every({curve.begin(), curve.end()}, stride));
    }
    list.push_back({{"name", scenario_name(plan, i, units)}, {"base", plan.base_of(i)}, {"values", std::move(values)}});
  }
  return {{"of", n}, {"list", std::move(list)}};
}

}  // namespace

void add_study_curves(const io::StudyRows& rows, const io::Units& units, ordered_json& payload) {
  payload["curves"] = nullptr;
  const std::vector<io::CurveBand> bands = io::curve_bands(rows);
  if (bands.empty()) return;
  const std::vector<double> angles = io::kept_angles(rows.plan.study().keep);
  const std::size_t stride = (angles.size() + kMaxAngles - 1) / kMaxAngles;
  ordered_json described = ordered_json::array(), list = ordered_json::array();
  for (const io::CurveBand& band : bands) {
    if (band.curve == described.size()) {
      described.push_back(described_object(band.quantity));
    }
    ordered_json values = ordered_json::array();
    for (const std::vector<double>& curve : band.values) values.push_back(every(curve, stride));
    list.push_back({{"base", band.base}, {"quantity", band.curve}, {"values", std::move(values)}});
  }
  const std::size_t n_curves = described.size();
  payload["curves"] = {{"angles", every(angles, stride)},
                       {"shares", bands.front().shares},
                       {"quantities", std::move(described)},
                       {"scenarios", scenario_curves(rows, n_curves, angles.size(), stride, units)},
                       {"bands", std::move(list)}};
}

}  // namespace ringfilm::report
