#pragma once
#include <numbers>
#include <string>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::app {

/// Numbers in the units of an engineer, as text.
class EngineeringText {
 public:
  /// Four significant digits and the display unit, e.g. "19.09 kPa"; dimensionless ones bare.
  std::string operator()(const cycle::Quantity& quantity, double value_si) const;

  /// A cycle value by its name, in four significant digits and its display unit.
  std::string operator()(const std::string& cycle_quantity, double value_si) const;

  /// With its error, e.g. "19.09 +- 0.02 kPa": the error rounded up to one digit (two where the first is 1), the value
  /// to the same place. The angle of a peak that is another peak on another grid is marked so. Without an error (NaN,
  /// or 0 as of an input) the value alone.
  std::string operator()(const std::string& cycle_quantity, double value_si, double error_si) const;

  /// A value of `unit` with so many significant digits and its display unit.
  std::string operator()(double value_si, const std::string& unit, const std::string& display_unit, int digits) const;

 private:
  io::Units units_;
};

// Values in the units of printed tables.
constexpr double in_um(double length) { return length * 1e6; }        ///< length [m] in um
constexpr double in_mm(double length) { return length * 1e3; }        ///< length [m] in mm
constexpr double in_um_mm(double area) { return area * 1e9; }         ///< worn area [m2] in um mm
constexpr double in_mg(double mass) { return mass * 1e6; }            ///< mass [kg] in mg, or flow [kg/s] in mg/s
constexpr double in_bar(double pressure) { return pressure * 1e-5; }  ///< pressure [Pa] in bar
constexpr double in_kpa(double pressure) { return pressure / 1e3; }   ///< pressure [Pa] in kPa
constexpr double in_degc(double temperature) { return temperature - base::kZeroCelsius; }  ///< temperature [K] in degC
constexpr double in_rpm(double speed) { return speed * 30 / std::numbers::pi; }            ///< speed [rad/s] in rpm
constexpr double in_degree(double angle) { return angle * 180 / std::numbers::pi; }        ///< angle [rad] in degree

/// The entry of cycle::cycle_quantities() of that name; a name that is not there is a bug.
const cycle::CycleQuantity& cycle_quantity(const std::string& name);

/// What the cylinder pressure is, e.g. "SYNTHETIC trace cylinder_pressure.csv".
std::string pressure_origin(const cycle::Gas& gas);

}  // namespace ringfilm::app
