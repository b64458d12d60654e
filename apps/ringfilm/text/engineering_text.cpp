#include "text/engineering_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ringfilm::app {

std::string EngineeringText::operator()(const cycle::Quantity& quantity, double value_si) const {
  const double value = units_.scale(quantity.display_unit, quantity.unit).from_si(value_si);
  // From here on four significant digits reach the units; a point after them would promise more.
  constexpr double kNoFraction = 999.95, kTooLongToRead = 1e9;
  const std::string number = quantity.display_unit == "degree"   ? fmt::format("{:.1f}", value)
                             : std::abs(value) >= kTooLongToRead ? fmt::format("{:.3e}", value)
                             : std::abs(value) >= kNoFraction    ? fmt::format("{:.0f}", value)
                                                                 : fmt::format("{:#.4g}", value);
  return quantity.display_unit == "1" ? number : number + " " + quantity.display_unit;
}

std::string EngineeringText::operator()(const std::string& cycle_quantity, double value_si) const {
  return (*this)(app::cycle_quantity(cycle_quantity), value_si);
}

std::string EngineeringText::operator()(const std::string& name, double value_si, double error_si) const {
  const cycle::CycleQuantity& quantity = app::cycle_quantity(name);
  const Scale scale = units_.scale(quantity.display_unit, quantity.unit);
  const double value = scale.from_si(value_si);
  const double error = scale.from_si(error_si) - scale.from_si(0);
  if (!(error > 0) || !std::isfinite(value) || !std::isfinite(error)) return (*this)(quantity, value_si);
  constexpr double kAnotherPeak = 30;  // [degree], farther than a peak itself moves
  if (quantity.display_unit == "degree" && error > kAnotherPeak) {
    return fmt::format("{:.0f} degree, on other grids up to {:.0f} degree away", value, std::ceil(error));
  }
  constexpr int kMaxDigits = 7;  // beyond them the unit is not worth the ink
  const int first_place = static_cast<int>(std::floor(std::log10(error)));
  const bool starts_with_one = error < 2 * std::pow(10, first_place);
  int decimals = starts_with_one ? 1 - first_place : -first_place;
  if (value != 0)
    decimals = std::min(decimals, kMaxDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
  if (quantity.display_unit == "degree") decimals = std::max(decimals, 0);
  const double place = std::pow(10, -decimals);
  const double shown_error = std::ceil(error / place * (1 - 1e-9)) * place;  // 0.02 is not more than 0.02
  const double shown_value = std::round(value / place) * place;
  const std::string number =
      fmt::format("{:.{}f} +- {:.{}f}", shown_value, std::max(decimals, 0), shown_error, std::max(decimals, 0));
  return quantity.display_unit == "1" ? number : number + " " + quantity.display_unit;
}

const cycle::CycleQuantity& cycle_quantity(const std::string& name) {
  const std::optional<std::size_t> found = cycle::cycle_quantity_index(name);
  if (!found) throw std::logic_error("no cycle value is called " + name);
  return cycle::cycle_quantities()[*found];
}

std::string pressure_origin(const cycle::Gas& gas) {
  if (gas.model == cycle::GasModel::kWiebe) return "Wiebe model, no measurement";
  switch (gas.trace_origin) {
    case cycle::TraceOrigin::kSynthetic:
      return "SYNTHETIC trace " + gas.cylinder_pressure_file;
    case cycle::TraceOrigin::kMeasured:
      return "measured trace " + gas.cylinder_pressure_file;
    case cycle::TraceOrigin::kComputed:
      return "computed trace " + gas.cylinder_pressure_file;
    case cycle::TraceOrigin::kNotStated:
      break;
  }
  return "trace " + gas.cylinder_pressure_file + ", origin not stated";
}

}  // namespace ringfilm::app
