#include "ringfilm/case/conditions.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "ringfilm/base/constants.hpp"

namespace ringfilm::cycle {
namespace {

using base::kZeroCelsius;

// Typical, assumed (docs/manual/guide/typical-inputs.md): full load.
constexpr double kOilRingFilm = 2e-6, kOilRingReach = 10e-3;                       // [m]
constexpr double kRing = 190 + kZeroCelsius, kLinerAtTdc = 180 + kZeroCelsius;     // [K]
constexpr double kLinerBelow = 115 + kZeroCelsius, kDistanceOfLinerBelow = 80e-3;  // [K], [m]

}  // namespace

double along_stroke(const std::vector<StrokeValue>& points, double distance) {
  const auto after = std::find_if(points.begin(), points.end(), [&](const auto& p) { return p.distance > distance; });
  if (after == points.begin()) return points.front().value;
  if (after == points.end()) return points.back().value;
  const StrokeValue &low = *(after - 1), &high = *after;
  return low.value + (high.value - low.value) * (distance - low.distance) / (high.distance - low.distance);
}

void set_conditions(Conditions conditions, Case& c) {
  c.conditions = conditions;
  if (conditions == Conditions::kOfTheCase) return;
  const bool engine = conditions == Conditions::kEngine;
  c.film.cavitation = engine ? Cavitation::kMassConserving : c.film.cavitation;
  c.film.chamber_edge = c.film.crankcase_edge = engine ? EdgeFluid::kGas : EdgeFluid::kOil;
  c.film.supply = engine ? OilSupply::kFilmOnLiner : OilSupply::kFlooded;
  c.supply = {};
  c.thermal = {};
  if (!engine) return;
  c.supply.film = {{0, kOilRingFilm}};
  c.supply.reach = kOilRingReach;
  c.thermal.ring = kRing;
  c.thermal.liner = {{0, kLinerAtTdc}, {kDistanceOfLinerBelow, kLinerBelow}};
}

bool is_replaced_by(Conditions conditions, std::string_view key) {
  if (key == "operating.oil_temperature" || key == "film.cavitation") return conditions == Conditions::kEngine;
  constexpr std::array kKeys{"film.chamber_edge", "film.crankcase_edge", "film.supply",
                             "thermal.ring",      "thermal.liner",       "thermal.film"};
  return key.starts_with("supply.") || std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

void replace_conditions(Case& c) {
  std::erase_if(c.stated, [&c](const std::string& key) { return is_replaced_by(c.conditions, key); });
  set_conditions(c.conditions, c);
  keep_own_temperature(c);
}

void keep_own_temperature(Case& c) {
  if (!c.stated.contains("operating.oil_temperature")) return;
  if (!c.stated.contains("thermal.ring")) c.thermal.ring.reset();
  if (!c.stated.contains("thermal.liner")) c.thermal.liner.clear();
}

}  // namespace ringfilm::cycle
