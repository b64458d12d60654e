#include "ringfilm/io/text/empirical_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "ringfilm/base/display.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Vickers hardness of Rockwell C hardness, ASTM E140, table 1.
struct HardnessPair {
  double HRC, HV;
};
constexpr std::array<HardnessPair, 11> kHardnessPairs{{{20, 238},
                                                       {25, 266},
                                                       {30, 302},
                                                       {35, 345},
                                                       {40, 392},
                                                       {45, 446},
                                                       {50, 513},
                                                       {55, 595},
                                                       {60, 697},
                                                       {65, 832},
                                                       {68, 940}}};

double pressure_of_rockwell(double HRC) {
  const auto above = std::find_if(kHardnessPairs.begin() + 1, kHardnessPairs.end() - 1,
                                  [HRC](const HardnessPair& pair) { return pair.HRC >= HRC; });
  const HardnessPair low = *std::prev(above), high = *above;
  return (low.HV + (HRC - low.HRC) / (high.HRC - low.HRC) * (high.HV - low.HV)) * kVickersUnit;
}

/// Saybolt universal seconds at 100 degF of a viscosity in mm2/s, ASTM D2161.
double saybolt_seconds(double nu) {
  return 4.6324 * nu + (1 + 0.03264 * nu) / (0.03930200 + nu * (0.002627 + nu * (0.0002397 + nu * 0.00001646)));
}

double viscosity_of_saybolt(double seconds) {
  double low = 0.5, high = seconds / 4.6;  // rises in between
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (saybolt_seconds(middle) < seconds ? low : high) = middle;
  }
  return kSquareMillimetrePerSecond.scale.to_si(0.5 * (low + high));
}

/// Formula of Ubbelohde, in mm2/s: 7.31 E - 6.31/E.
double viscosity_of_engler(double E) { return kSquareMillimetrePerSecond.scale.to_si(7.31 * E - 6.31 / E); }

struct EmpiricalUnit {
  const char* name;
  const char* si_unit;
  double lowest, highest;  ///< range of the conversion
  double (*to_si)(double value);
  const char* source;
};
constexpr std::array<EmpiricalUnit, 5> kEmpiricalUnits{
    {{"HRC", "Pa", 20, 68, pressure_of_rockwell, "ASTM E140, of steels"},
     {"SUS", "m2/s", 32, kInfinity, viscosity_of_saybolt, "ASTM D2161"},
     {"SSU", "m2/s", 32, kInfinity, viscosity_of_saybolt, "ASTM D2161"},
     {"degE", "m2/s", 1.2, kInfinity, viscosity_of_engler, "the formula of Ubbelohde"},
     {"degreeE", "m2/s", 1.2, kInfinity, viscosity_of_engler, "the formula of Ubbelohde"}}};

}  // namespace

bool is_empirical_unit(const std::string& unit) {
  return std::any_of(kEmpiricalUnits.begin(), kEmpiricalUnits.end(),
                     [&unit](const EmpiricalUnit& one) { return unit == one.name; });
}

std::optional<double> empirical_quantity(double value, const std::string& unit, const std::string& si_unit) {
  const auto found = std::find_if(kEmpiricalUnits.begin(), kEmpiricalUnits.end(),
                                  [&](const EmpiricalUnit& one) { return unit == one.name && si_unit == one.si_unit; });
  if (found == kEmpiricalUnits.end()) return std::nullopt;
  if (!(value >= found->lowest && value <= found->highest)) {
    const std::string range = std::isinf(found->highest)
                                  ? fmt::format("from {:g} on", found->lowest)
                                  : fmt::format("from {:g} to {:g}", found->lowest, found->highest);
    throw UnitError(
        fmt::format("is outside the range of {}: {} converts {} {}", found->name, found->source, range, found->name),
        si_unit == "Pa" ? "write HV, HB or GPa" : "write mm2/s");
  }
  return found->to_si(value);
}

}  // namespace ringfilm::io
