#include "ringfilm/case/conditions.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/display.hpp"

namespace ringfilm::cycle {
namespace {

using base::kZeroCelsius;

// docs/manual/guide/typical-inputs.md has the sources.
/// Computed with data/packs; assumed [m].
constexpr double kOilRingFilm = kOilRingFilms.high, kOilRingReach = 10e-3;

/// Walls of a ring and its liner.
struct Walls {
  double ring;                     ///< [K]
  std::vector<StrokeValue> liner;  ///< [m], [K]
};

Walls walls(Conditions conditions) {
  if (conditions == Conditions::kHotEngine) {  // typical, assumed
    return {190 + kZeroCelsius, {{0, 180 + kZeroCelsius}, {80e-3, 115 + kZeroCelsius}}};
  }
  // Mean around the bore of a car engine at full load, measured; the ring is assumed.
  return {150 + kZeroCelsius, {{0, 127 + kZeroCelsius}, {40e-3, 105 + kZeroCelsius}, {80e-3, 110 + kZeroCelsius}}};
}

}  // namespace

double along_stroke(const std::vector<StrokeValue>& points, double distance) {
  const auto after = std::find_if(points.begin(), points.end(), [&](const auto& p) { return p.distance > distance; });
  if (after == points.begin()) return points.front().value;
  if (after == points.end()) return points.back().value;
  const StrokeValue &low = *(after - 1), &high = *after;
  return low.value + (high.value - low.value) * (distance - low.distance) / (high.distance - low.distance);
}

bool is_engine(Conditions conditions) {
  return conditions == Conditions::kEngine || conditions == Conditions::kHotEngine;
}

void set_conditions(Conditions conditions, Case& c) {
  c.conditions = conditions;
  if (conditions == Conditions::kOfTheCase) return;
  const bool engine = is_engine(conditions);
  c.film.cavitation = engine ? Cavitation::kMassConserving : c.film.cavitation;
  c.film.chamber_edge = c.film.crankcase_edge = engine ? EdgeFluid::kGas : EdgeFluid::kOil;
  c.film.supply = engine ? OilSupply::kFilmOnLiner : OilSupply::kFlooded;
  c.supply = {};
  c.thermal = {};
  if (!engine) return;
  c.supply.film = {{0, kOilRingFilm}};
  c.supply.reach = kOilRingReach;
  Walls hot = walls(conditions);
  c.thermal.ring = hot.ring;
  c.thermal.liner = std::move(hot.liner);
}

bool is_replaced_by(Conditions conditions, std::string_view key) {
  if (key == "operating.oil_temperature" || key == "film.cavitation") return is_engine(conditions);
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
