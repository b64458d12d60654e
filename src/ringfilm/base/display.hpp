#pragma once
#include <numbers>
#include <string>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/number_text.hpp"

/// The units in which engineers write and read: for keys of the case and for all messages, notes and tables as text.
namespace ringfilm {

/// The line from a unit to SI: SI = value * factor / divisor + offset. Decimal prefixes are whole factors or divisors,
/// so that they round once: "82.5 mm" is 0.0825 to the last bit or the one before.
struct Scale {
  double factor = 1;   ///< [SI unit/unit], with the divisor
  double divisor = 1;  ///< [-]
  double offset = 0;   ///< SI value of the zero of the unit, e.g. 273.15 for degC [SI unit]

  constexpr double to_si(double value) const { return value * factor / divisor + offset; }      ///< value in SI
  constexpr double from_si(double value) const { return (value - offset) * divisor / factor; }  ///< value in this unit
};

/// Unit in which a quantity is displayed.
struct DisplayUnit {
  const char* si;    ///< SI unit of the quantity, e.g. "m"
  const char* name;  ///< name as printed, e.g. "um"
  Scale scale;
};

/// SI unit in which a quantity is displayed, too.
constexpr DisplayUnit si_unit(const char* name) { return {name, name, {}}; }

inline constexpr DisplayUnit kPlainNumber = si_unit("1");
inline constexpr DisplayUnit kNanometre{"m", "nm", {1, 1e9}}, kMicrometre{"m", "um", {1, 1e6}},
    kMillimetre{"m", "mm", {1, 1e3}};
inline constexpr DisplayUnit kSquareMillimetre{"m2", "mm2", {1, 1e6}}, kWornArea{"m2", "um mm", {1, 1e9}},
    kCubicMillimetre{"m3", "mm3", {1, 1e9}}, kPerSquareMicrometre{"m-2", "um-2", {1e12}};
inline constexpr DisplayUnit kBar{"Pa", "bar", {1e5}}, kKilopascal{"Pa", "kPa", {1e3}}, kMegapascal{"Pa", "MPa", {1e6}},
    kGigapascal{"Pa", "GPa", {1e9}};
inline constexpr DisplayUnit kGramPerKilogram{"1", "g/kg", {1, 1e3}};
inline constexpr DisplayUnit kKilowatt{"W", "kW", {1e3}};
inline constexpr DisplayUnit kNanonewton{"N", "nN", {1, 1e9}}, kNewtonPerMillimetre{"N/m", "N/mm", {1e3}};
inline constexpr DisplayUnit kGram{"kg", "g", {1, 1e3}}, kMilligram{"kg", "mg", {1, 1e6}},
    kGramPerMole{"kg/mol", "g/mol", {1, 1e3}}, kKilogramPerHour{"kg/s", "kg/h", {1, 3600}},
    kGramPerHour{"kg/s", "g/h", {1, 3.6e6}}, kGramPerKilowattHour{"kg/J", "g/(kW h)", {1, 3.6e9}},
    kMilligramPerSecond{"kg/s", "mg/s", {1, 1e6}}, kLitrePerMinute{"m3/s", "l/min", {1, 60e3}};
inline constexpr DisplayUnit kMillipascalSecond{"Pa s", "mPa s", {1, 1e3}},
    kSquareMillimetrePerSecond{"m2/s", "mm2/s", {1, 1e6}};
inline constexpr DisplayUnit kCelsius{"K", "degC", {1, 1, base::kZeroCelsius}};
inline constexpr DisplayUnit kDegree{"rad", "degree", {std::numbers::pi, 180}},
    kArcMinute{"rad", "arcminute", {std::numbers::pi, 180 * 60}}, kMilliradian{"rad", "mrad", {1, 1e3}},
    kRpm{"rad/s", "rpm", {std::numbers::pi, 30}};
inline constexpr DisplayUnit kMegabyte{"byte", "MB", {1e6}}, kGigabyte{"byte", "GB", {1e9}};

/// The number of a value [unit.si] in a unit.
constexpr double number_in(double value, const DisplayUnit& unit) { return unit.scale.from_si(value); }

/// A value [unit.si] in a unit with its name: "1.2 um". @param digits at the most
inline std::string text_in(double value, const DisplayUnit& unit, int digits = 6) {
  return number_text(number_in(value, unit), digits) + " " + unit.name;
}

/// Two values [unit.si] in a unit: "0 to 1.2 um". @param digits at the most
inline std::string range_in(double low, double high, const DisplayUnit& unit, int digits = 6) {
  return number_text(number_in(low, unit), digits) + " to " + text_in(high, unit, digits);
}

}  // namespace ringfilm
