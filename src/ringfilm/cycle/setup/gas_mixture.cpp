#include "ringfilm/cycle/setup/gas_mixture.hpp"

#include <algorithm>
#include <numbers>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::cycle {
namespace {

/// Coldest place of the liner from the TDC position of the ring down to that distance [K].
double coldest_liner(const Case& c, double distance) {
  const std::vector<StrokeValue>& liner = c.thermal.liner;
  if (liner.empty()) {
    return c.operating.oil_temperature > 0 ? c.operating.oil_temperature : c.gas_path.crankcase_temperature;
  }
  double coldest = std::min(along_stroke(liner, 0), along_stroke(liner, distance));
  for (const StrokeValue& point : liner) {
    if (point.distance > 0 && point.distance < distance) coldest = std::min(coldest, point.value);
  }
  return coldest;
}

}  // namespace

models::ChargeMixture charge_mixture(const GasComposition& composition) {
  return {composition.fuel, composition.excess_air_ratio, composition.premixed_share, composition.humidity};
}

models::MixtureProperties gas_properties(const Case& c) {
  const GasPath& path = c.gas_path;
  if (path.properties == GasProperties::kStated || !c.gas.composition.is_stated()) {
    return {path.gas_constant, path.heat_capacity_ratio, path.viscosity};
  }
  const models::ChargeMixture charge = charge_mixture(c.gas.composition);
  return models::mixture_properties(models::mixed(fresh_charge(charge), burnt_gas(charge), path.mixture_burnt_share),
                                    path.mixture_temperature);
}

void put_gas_properties(Case& c) {
  if (c.gas_path.properties == GasProperties::kStated) return;
  const models::MixtureProperties found = gas_properties(c);
  const auto put = [&found](GasPath& path) {
    path.gas_constant = found.gas_constant;
    path.heat_capacity_ratio = found.heat_capacity_ratio;
    path.viscosity = found.viscosity;
  };
  put(c.gas_path);
  for (Case& ring : c.rings) put(ring.gas_path);
}

gas_path::Composition gas_composition(const Case& c) {
  const GasComposition& stated = c.gas.composition;
  const models::ChargeMixture charge = charge_mixture(stated);
  const models::CrankSlider crank = crank_slider(c);
  const models::Burning burning{stated.burn, stated.burn_begin_deg, c.gas.burn_duration_deg, stated.residual_share};
  gas_path::Composition of;
  of.fresh = fresh_charge(charge);
  of.burnt = burnt_gas(charge);
  of.air = models::humid_air(stated.humidity);
  of.fuel = stated.fuel;
  of.ventilation = stated.crankcase_air;
  for (int angle = 0; angle < static_cast<int>(base::kCycleDeg); ++angle) {
    of.burnt_share.push_back(burnt_share(burning, crank, angle));
    of.chamber_wall.push_back(coldest_liner(c, crank.position(angle * std::numbers::pi / 180)));
  }
  of.liner_wall = coldest_liner(c, crank.stroke());
  return of;
}

}  // namespace ringfilm::cycle
