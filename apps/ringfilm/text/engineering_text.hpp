#pragma once
#include <string>

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

 private:
  io::Units units_;
};

/// The entry of cycle::cycle_quantities() of that name; a name that is not there is a bug.
const cycle::CycleQuantity& cycle_quantity(const std::string& name);

/// What the cylinder pressure is, e.g. "SYNTHETIC trace cylinder_pressure.csv".
std::string pressure_origin(const cycle::Gas& gas);

}  // namespace ringfilm::app
