#include "ringfilm/cycle/checks/case_rules_oil.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/oil_setup.hpp"
#include "ringfilm/models/oil/dilution.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"
#include "ringfilm/models/oil/shear_thinning.hpp"
#include "ringfilm/models/oil/viscosity_index.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;

/// Increasing temperatures; `falling`: values that fall with them.
enum class Trend { kAny, kFalling };

void check_points(const std::string& key, const std::vector<TemperatureValue>& points, Trend trend,
                  Breaches& breaches) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].temperature == points[i - 1].temperature) {
      breaches.push_back(
          {key, key + " has two values at " + text_in(points[i].temperature, kCelsius), "keep one of them"});
    } else if (trend == Trend::kFalling && points[i].value >= points[i - 1].value) {
      breaches.push_back(
          {key, key + " does not fall from " + range_in(points[i - 1].temperature, points[i].temperature, kCelsius),
           "the viscosity of an oil falls with temperature; are two values exchanged?"});
    }
  }
}

void check_density(const Lubricant& oil, Breaches& breaches) {
  const auto refuse_unless_oil = [&breaches](double density) {
    if (is_oil_density(density)) return;
    breaches.push_back({"lubricant.density", "lubricant.density = " + number_text(density) + " kg/m3 is out of range",
                        kAllowedOilDensity});
  };
  if (oil.constant_density) refuse_unless_oil(*oil.constant_density);
  for (const TemperatureValue& point : oil.density) refuse_unless_oil(point.value);
}

void check_viscosity_index(const Lubricant& oil, Breaches& breaches) {
  if (!oil.viscosity_index || oil.kinematic_viscosity.empty()) return;
  const std::string index = "lubricant.viscosity_index = " + number_text(*oil.viscosity_index);
  const auto& nu = oil.kinematic_viscosity;
  if (nu.size() > 1) {
    breaches.push_back({"lubricant.viscosity_index",
                        index + " is stated with viscosities at " + std::to_string(nu.size()) + " temperatures",
                        "omit the index, which follows from them, or state one viscosity, at 40 or 100 degC"});
    return;
  }
  if (oil.viscosities().size() > 1) return;
  const double T = nu.front().temperature;
  const bool is_of_index =
      std::abs(T - models::kLowIndexTemperature) < 0.01 || std::abs(T - models::kHighIndexTemperature) < 0.01;
  breaches.push_back({"lubricant.viscosity_index",
                      index + (is_of_index ? " and " + text_in(nu.front().value, kSquareMillimetrePerSecond) + " at " +
                                                 text_in(T, kCelsius) + " give no viscosity at the other temperature"
                                           : " is stated with a viscosity at " + text_in(T, kCelsius)),
                      is_of_index
                          ? "ASTM D2270 begins at 2 mm2/s at 100 degC: state the viscosity at a second temperature"
                          : "the index (ASTM D2270) relates the viscosities at 40 and 100 degC: state one of these"});
}

void check_dilution(const Lubricant& oil, Breaches& breaches) {
  if (oil.fuel + oil.water > 1) {
    breaches.push_back({"lubricant.water",
                        "lubricant.fuel = " + number_text(oil.fuel) +
                            " and lubricant.water = " + number_text(oil.water) + " add up to more than the whole oil",
                        "state both as shares of the mass"});
  }
  if (oil.fuel == 0) return;
  if (oil.fuel_viscosity.size() < 2) {
    breaches.push_back({"lubricant.fuel_viscosity",
                        "lubricant.fuel_viscosity has one value; the Walther line needs two or more",
                        "add the viscosity at another temperature, for example 100 degC"});
  }
  check_points("lubricant.fuel_viscosity", oil.fuel_viscosity, Trend::kFalling, breaches);
  for (const TemperatureValue& point : oil.viscosities()) {
    if (point.value > models::kMinBlendedViscosity) continue;
    breaches.push_back({"lubricant.kinematic_viscosity",
                        "lubricant.kinematic_viscosity = " + text_in(point.value, kSquareMillimetrePerSecond) +
                            " cannot be blended with fuel: the rule ends at 0.3 mm2/s",
                        "check its unit, or state fuel = 0"});
  }
}

/// Where the laws of an oil give more they are taken as continued below its pour point: chosen well above the 60 Pa s
/// at which an engine oil must still be pumped (SAE J300) [Pa s].
constexpr double kNoLongerFlows = 1000;

/// Has it laws that continue below its measured points, and all that these need?
bool has_laws(const Lubricant& oil) {
  return !oil.table_file && !oil.kinematic_viscosity.empty() && (oil.constant_density || !oil.density.empty());
}

void check_coldest_film(const Case& c, Breaches& breaches) {
  const bool has_temperature = c.thermal.is_stated() || c.operating.oil_temperature > 0;
  if (!has_laws(c.lubricant) || !has_temperature) return;
  const auto walls = wall_temperatures(c.thermal);
  const double coldest = walls ? walls->film_range().low : c.operating.oil_temperature;
  const auto viscosity = viscosity_without_shear(c.lubricant, coldest);
  if (!viscosity || !(*viscosity > kNoLongerFlows)) return;
  const std::string of_wall = c.thermal.film == FilmTemperature::kRing ? "thermal.ring" : "thermal.liner";
  breaches.push_back(
      {walls ? of_wall : "operating.oil_temperature",
       "the film is as cold as " + text_in(coldest, kCelsius) + ", where this oil has " + number_text(*viscosity) +
           " Pa s: it does not flow",
       "above " + number_text(kNoLongerFlows) + " Pa s it is taken to be below its pour point; check the " +
           (walls ? "temperatures in [thermal]" : "temperature") + " and lubricant.kinematic_viscosity"});
}

void check_hths(const Lubricant& oil, Breaches& breaches) {
  if (!oil.thins() || oil.critical_shear_rate || !oil.hths_viscosity) return;
  const std::optional<double> without_shear = fresh_viscosity_without_shear(oil, models::kHthsTemperature);
  if (!without_shear) return;
  const auto written = [](double eta) { return text_in(eta, kMillipascalSecond); };
  const std::string hths = "lubricant.hths_viscosity = " + written(*oil.hths_viscosity);
  const std::string viscosity = "viscosity of the oil without shear at 150 degC, " + written(*without_shear);
  const double ratio = *oil.hths_viscosity / *without_shear;
  if (ratio >= 1) {
    breaches.push_back({"lubricant.hths_viscosity", hths + " is not below the " + viscosity,
                        "the viscosity falls with the shear rate; check hths_viscosity, kinematic_viscosity and "
                        "density, or state shear_thinning = \"none\""});
  } else if (ratio <= oil.second_newtonian_ratio) {
    breaches.push_back({"lubricant.hths_viscosity",
                        hths + " is not above lubricant.second_newtonian_ratio = " +
                            number_text(oil.second_newtonian_ratio) + " times the " + viscosity,
                        "at the highest shear rates the oil keeps that share; state a smaller ratio"});
  }
}

}  // namespace

void append_stroke_breaches(const std::string& key, const std::vector<StrokeValue>& points,
                            std::vector<RuleBreach>& breaches) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = points[i].distance;
    if (distance >= 0 && (i == 0 || distance > points[i - 1].distance)) continue;
    breaches.push_back({key,
                        key + " has the distance " + text_in(distance, kMillimetre) + " " +
                            (distance < 0 ? "above the TDC position of the ring"
                                          : "after " + text_in(points[i - 1].distance, kMillimetre)),
                        "distances count downwards from the TDC position of the ring and increase"});
  }
}

void append_thermal_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  const Thermal& thermal = c.thermal;
  if (!thermal.is_stated()) return;
  const std::string film = find_field("thermal.film")->key;
  const bool takes_ring = thermal.film != FilmTemperature::kLiner;
  const bool takes_liner = thermal.film != FilmTemperature::kRing;
  const std::string both = thermal.film == FilmTemperature::kMeanOfWalls ? "the mean of ring and liner" : "that wall's";
  if (takes_ring && !thermal.ring) {
    breaches.push_back({"thermal.ring", "the film has " + both + " temperature, and thermal.ring is not stated",
                        "state it, for example ring = \"190 degC\" in [thermal], or " + film + " = \"liner\"",
                        RuleBreach::By::kMissingKey});
  }
  if (takes_liner && thermal.liner.empty()) {
    breaches.push_back({"thermal.liner", "the film has " + both + " temperature, and thermal.liner is not stated",
                        "state it, for example liner = \"150 degC\" in [thermal], or " + film + " = \"ring\"",
                        RuleBreach::By::kMissingKey});
  }
  append_stroke_breaches("thermal.liner", thermal.liner, breaches);
  if (c.problem == Problem::kPad && thermal.liner.size() > 1) {
    breaches.push_back({"thermal.liner", "thermal.liner has several temperatures, and a pad is at one place",
                        "state one temperature of the flat surface, for example liner = \"150 degC\""});
  }
}

void append_oil_law_breaches(const Lubricant& oil, std::vector<RuleBreach>& breaches) {
  check_density(oil, breaches);
  check_viscosity_index(oil, breaches);
  const std::vector<TemperatureValue> nu = oil.viscosities();
  const bool houpert = oil.viscosity_temperature == ViscosityTemperature::kHoupert;
  if (nu.size() == 1 && !houpert) {
    if (oil.viscosity_index) return;  // reported by check_viscosity_index()
    breaches.push_back(
        {"lubricant.kinematic_viscosity",
         "lubricant.kinematic_viscosity has one value; the Walther line needs two or more",
         "add the viscosity at another temperature, for example 100 degC, or lubricant.viscosity_index"});
  } else if (nu.size() == 1 && nu.front().temperature != oil.reference_temperature) {
    breaches.push_back({"lubricant.kinematic_viscosity",
                        "lubricant.kinematic_viscosity has one value, and it is not at lubricant.reference_temperature",
                        "state the value at the reference temperature, or two values"});
  }
  check_points("lubricant.kinematic_viscosity", nu, Trend::kFalling, breaches);
  check_points("lubricant.density", oil.density, Trend::kAny, breaches);
  check_dilution(oil, breaches);
}

void append_viscosity_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  check_coldest_film(c, breaches);
  check_hths(c.lubricant, breaches);
}

}  // namespace ringfilm::cycle
