#include "ringfilm/cycle/pack/oil_consumption.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "ringfilm/base/display.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/cycle/pack/liner_evaporation.hpp"
#include "ringfilm/cycle/setup/charge.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/setup/oil_setup.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/models/gas/heat_transfer.hpp"

namespace ringfilm::cycle {
namespace {

constexpr const char* kRate = "kg/s";
constexpr const char *kEvaporation = "evaporation", *kScrapedUp = "scraped_up", *kCarriedByGas = "carried_by_gas",
                     *kThrownOff = "thrown_off";

/// What all parts use.
struct Cylinder {
  const Case& first;         ///< case of the first ring
  const CycleResult& top;    ///< its result
  double density;            ///< density of the oil [kg/m3]
  double cycles_per_second;  ///< [1/s]
};

/// Temperature of the liner at a place; without wall temperatures that of the ring or of the oil [K].
double liner_temperature(const Case& c, double place) {
  if (!c.thermal.liner.empty()) return along_stroke(c.thermal.liner, place);
  return c.thermal.ring.value_or(c.operating.oil_temperature);
}

/// A value as the case states it, or the default with its band.
OilTransport::Band band(const Case& c, const char* key, double value, const OilTransport::Band& of_default) {
  return c.stated.contains(key) ? OilTransport::Band{value, value} : of_default;
}

std::string origin(const Case& c, const char* key) { return c.stated.contains(key) ? "as stated" : "typical, assumed"; }

/// Oil under the rings, per length of circumference: their widths times the mean of their lowest and their highest
/// film, assumed [kg/m].
double carried_oil(const Case& c, std::span<const CycleResult* const> rings, double density) {
  double carried = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const double width = c.is_pack() ? c.rings[i].ring.face_width : c.ring.face_width;
    const CycleValues& values = rings[i]->values;
    carried += density * width * 0.5 * (values.min_film_thickness + values.max_film_thickness);
  }
  return carried;
}

std::function<double(double)> mass_transfer(const Case& c) {
  const Evaporation& evaporation = c.evaporation;
  if (const auto& stated = evaporation.mass_transfer_coefficient) return [beta = *stated](double) { return beta; };
  const double gamma = c.gas_path.heat_capacity_ratio, R = c.gas_path.gas_constant;
  return [charge = Charge(c), alpha = evaporation.heat_transfer_coefficient, R, Le = evaporation.lewis_number,
          heat_capacity = gamma * R / (gamma - 1)](double angle_deg) {
    constexpr double kWall = 1;  // [K]; the density next to the wall goes with the inverse of its temperature
    const double density = charge.pressure(angle_deg) / (R * kWall);
    return models::mass_transfer_coefficient(alpha ? *alpha : charge.heat_transfer_coefficient(angle_deg), density,
                                             heat_capacity, Le);
  };
}

OilLoss evaporation(const Case& c, std::span<const CycleResult* const> rings, const Cylinder& cylinder) {
  const Case& first = cylinder.first;
  if (!first.lubricant.evaporates()) {
    return {kEvaporation, kRate, 0, 0, 0, "not computed: lubricant.distillation and lubricant.noack are not stated"};
  }
  EvaporatingLiner liner;
  liner.crank = crank_slider(first);
  liner.speed = first.operating.speed;
  liner.bore = first.engine.bore;
  liner.fractions = first.lubricant.fractions();
  liner.temperature = [&first](double place) { return liner_temperature(first, place); };
  liner.mass_transfer = mass_transfer(first);
  liner.wall_temperature_power = first.evaporation.mass_transfer_coefficient ? 0 : 1;
  constexpr std::size_t kPower = 0, kIntake = 2;
  const StrokeProfile& stroke = cylinder.top.stroke;
  for (std::size_t b = 0; b < stroke.liner_position.size(); ++b) {
    liner.film.push_back(cylinder.density * 0.5 * (stroke.film_behind[kPower][b] + stroke.film_behind[kIntake][b]));
  }
  liner.carried = carried_oil(c, rings, cylinder.density);
  liner.reach = first.supply.reach.value_or(0);
  const EvaporatedOil oil = evaporated_oil(liner);
  return {kEvaporation,
          kRate,
          std::min(oil.within_reach, oil.rate),
          oil.rate,
          std::max(oil.of_fresh_oil, oil.rate),
          "low: only the liner that gets fresh oil in each cycle, below supply.reach; value: light fractions are used "
          "up between the passes of the rings, which carry fresh oil upwards; high: the film has the composition of "
          "fresh oil at all times"};
}

OilLoss scraped_up(const Cylinder& cylinder) {
  const char* key = "oil_transport.scraped_share";
  const OilTransport& transport = cylinder.first.oil_transport;
  const auto [low, high] = band(cylinder.first, key, transport.scraped_share, OilTransport::kScrapedShare);
  const double left = cylinder.top.values.oil_scraped_up * cylinder.cycles_per_second;
  return {kScrapedUp,
          kRate,
          low * left,
          transport.scraped_share * left,
          high * left,
          "share " + number_text(low) + ", " + number_text(transport.scraped_share) + " and " + number_text(high) +
              " of the oil that the first ring leaves above it at TDC does not come back; " +
              origin(cylinder.first, key)};
}

OilLoss carried_by_gas(const Cylinder& cylinder, const std::optional<gas_path::GasPathResult>& gas) {
  const char* key = "oil_transport.gas_load";
  if (!gas) return {kCarriedByGas, kRate, 0, 0, 0, "not computed: the gas between the rings is not computed"};
  const OilTransport& transport = cylinder.first.oil_transport;
  const auto [low, high] = band(cylinder.first, key, transport.gas_load, OilTransport::kGasLoad);
  const double back = gas_path::reverse_blow_by(*gas, 0) * cylinder.cycles_per_second;
  return {kCarriedByGas,
          kRate,
          low * back,
          transport.gas_load * back,
          high * back,
          "gas that passes the first ring towards the chamber carries " +
              number_text(number_in(low, kGramPerKilogram)) + ", " +
              number_text(number_in(transport.gas_load, kGramPerKilogram)) + " and " + text_in(high, kGramPerKilogram) +
              " of oil; " + origin(cylinder.first, key)};
}

OilLoss thrown_off(const Cylinder& cylinder) {
  const char* key = "oil_transport.land_film";
  const Case& c = cylinder.first;
  const OilTransport& transport = c.oil_transport;
  const double T = c.thermal.ring.value_or(liner_temperature(c, 0));
  const double viscosity =
      viscosity_without_shear(c.lubricant, T).value_or(cylinder.top.derived.find("oil_viscosity")->second);
  const auto rate = [&](double film) {
    if (!(film > 0)) return 0.0;
    const double moved = thrown_distance(crank_slider(c), c.operating.speed, film, viscosity / cylinder.density);
    constexpr double kTdcs = 2;
    return kTdcs * cylinder.cycles_per_second * cylinder.density * std::numbers::pi * c.engine.bore * film *
           std::min(moved, transport.top_land_height);
  };
  const auto [low, high] = band(c, key, transport.land_film, OilTransport::kLandFilm);
  return {kThrownOff,
          kRate,
          rate(low),
          rate(transport.land_film),
          rate(high),
          "oil film on the top piston land of " + number_text(number_in(low, kMicrometre)) + ", " +
              number_text(number_in(transport.land_film, kMicrometre)) + " and " + text_in(high, kMicrometre) + ", " +
              origin(c, key) + "; it is renewed from below as fast as it is thrown"};
}

OilLoss scaled(const OilLoss& loss, const char* name, const char* unit, double factor, std::string assumption) {
  return {name, unit, factor * loss.low, factor * loss.value, factor * loss.high, std::move(assumption)};
}

/// A part without a band has no input that narrows it.
OilLoss narrowed_by(const char* input, OilLoss loss) {
  if (loss.high > loss.low) loss.input = input;
  return loss;
}

/// All parts added up, and what that is for the engine.
void append_sums(const Case& c, std::vector<OilLoss>& losses) {
  OilLoss total{kTotalOilLoss,
                kRate,
                0,
                0,
                0,
                "sums of the lower ends, of the values and of the upper ends: each end with all of its assumptions at "
                "once"};
  for (const OilLoss& part : losses) {
    total.low += part.low;
    total.value += part.value;
    total.high += part.high;
  }
  losses.push_back(total);
  if (!c.engine.cylinders) return;
  const OilLoss engine =
      scaled(total, kEngineOilLoss, kRate, *c.engine.cylinders, "all cylinders alike; the ring packs alone");
  losses.push_back(engine);
  if (c.operating.brake_power) {
    losses.push_back(scaled(engine, kSpecificOilLoss, "kg/J", 1 / *c.operating.brake_power,
                            "oil of the engine over its brake power"));
  }
  if (c.operating.fuel_rate) {
    losses.push_back(
        scaled(engine, kFuelShareOfOil, "1", 1 / *c.operating.fuel_rate, "oil of the engine over its fuel"));
  }
}

}  // namespace

double thrown_distance(const models::CrankSlider& crank, double speed, double film, double kinematic_viscosity) {
  constexpr double kStepDeg = 0.25, kHalfTurnDeg = 180;
  const double rate = 3 * kinematic_viscosity / (film * film);  // with which the film comes to rest [1/s]
  const double step = radians(kStepDeg) / speed, decay = std::exp(-rate * step), lost = -std::expm1(-rate * step);
  double moved = 0, velocity = 0;
  for (double angle = -kHalfTurnDeg + kStepDeg / 2; angle < kHalfTurnDeg; angle += kStepDeg) {
    const double driven = -crank.acceleration(radians(angle), speed);  // towards the crown, relative to the piston
    const bool rests = !(velocity > 0);
    if (rests && driven <= 0) continue;
    const double terminal = driven / rate;
    moved += std::max(terminal * step + (velocity - terminal) * lost / rate, 0.0);
    velocity = std::max(velocity * decay + terminal * lost, 0.0);
  }
  return moved;
}

std::vector<NarrowedBand> narrowed_bands(const std::vector<OilLoss>& losses) {
  const auto total =
      std::find_if(losses.begin(), losses.end(), [](const OilLoss& loss) { return loss.name == kTotalOilLoss; });
  std::vector<NarrowedBand> bands;
  if (total == losses.end()) return bands;
  for (auto part = losses.begin(); part != total; ++part) {
    if (part->input.empty()) continue;
    bands.push_back({part->name, part->input, total->low - part->low + part->value,
                     total->high - part->high + part->value, (part->high - part->low) / (total->high - total->low)});
  }
  std::stable_sort(bands.begin(), bands.end(),
                   [](const NarrowedBand& a, const NarrowedBand& b) { return a.band_share > b.band_share; });
  return bands;
}

const std::vector<OilLossQuantity>& oil_loss_quantities() {
  constexpr const char *kPerHour = "g/h", *kEquation = "eq-oil-consumption", *kCylinders = "engine.cylinders";
  static const std::vector<OilLossQuantity> table = {
      {{"oil_consumption", kRate, kPerHour, "oil consumption of one cylinder, estimated", "", kEquation},
       kTotalOilLoss,
       &OilLoss::value,
       nullptr},
      {{"oil_consumption_low", kRate, kPerHour, "oil consumption of one cylinder, lower end", "", kEquation},
       kTotalOilLoss,
       &OilLoss::low,
       nullptr},
      {{"oil_consumption_high", kRate, kPerHour, "oil consumption of one cylinder, upper end", "", kEquation},
       kTotalOilLoss,
       &OilLoss::high,
       nullptr},
      {{"oil_evaporation", kRate, kPerHour, "oil that evaporates from the liner, one cylinder", "", "eq-renewal"},
       kEvaporation,
       &OilLoss::value,
       nullptr},
      {{"oil_evaporation_high", kRate, kPerHour, "oil that evaporates where the film stays fresh, one cylinder", "",
        "eq-fresh-rate"},
       kEvaporation,
       &OilLoss::high,
       nullptr},
      {{"oil_loss_scraped_up", kRate, kPerHour, "oil that the first ring scrapes up and that does not come back", "",
        "eq-scraped-up"},
       kScrapedUp,
       &OilLoss::value,
       nullptr},
      {{"oil_carried_by_gas", kRate, kPerHour, "oil that gas carries back past the first ring, one cylinder", "",
        "eq-gas-load"},
       kCarriedByGas,
       &OilLoss::value,
       nullptr},
      {{"oil_thrown_off", kRate, kPerHour, "oil that inertia throws off the top piston land, one cylinder", "",
        "eq-thrown-off"},
       kThrownOff,
       &OilLoss::value,
       nullptr},
      {{"oil_consumption_engine", kRate, kPerHour, "oil consumption of all cylinders, estimated", "", kEquation},
       kEngineOilLoss,
       &OilLoss::value,
       kCylinders},
      {{"oil_consumption_brake_specific", "kg/J", "g/(kW h)", "oil consumption of the engine over its brake power", "",
        kEquation},
       kSpecificOilLoss,
       &OilLoss::value,
       "operating.brake_power"},
      {{"oil_consumption_fuel_share", "1", "%", "oil consumption of the engine over its fuel", "", kEquation},
       kFuelShareOfOil,
       &OilLoss::value,
       "operating.fuel_rate"}};
  return table;
}

std::vector<OilLoss> oil_losses(const Case& c, std::span<const CycleResult* const> rings,
                                const std::optional<gas_path::GasPathResult>& gas) {
  const Case& first = c.is_pack() ? c.rings.front() : c;
  const auto is_complete = [](const CycleResult* ring) { return ring->complete; };
  if (!first.follows_oil() || rings.empty() || !std::all_of(rings.begin(), rings.end(), is_complete)) return {};
  const CycleResult& top = *rings.front();
  const auto density = top.derived.find("oil_density");
  if (density == top.derived.end() || top.stroke.film_behind.front().empty()) return {};
  const Cylinder cylinder{first, top, density->second, first.operating.speed / radians(kCycleDeg)};
  std::vector<OilLoss> losses{narrowed_by("supply.reach", evaporation(c, rings, cylinder)),
                              narrowed_by("oil_transport.scraped_share", scraped_up(cylinder)),
                              narrowed_by("oil_transport.gas_load", carried_by_gas(cylinder, gas)),
                              narrowed_by("oil_transport.land_film", thrown_off(cylinder))};
  append_sums(first, losses);
  return losses;
}

}  // namespace ringfilm::cycle
