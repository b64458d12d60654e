#include "engineering_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ringfilm::app {

std::string EngineeringText::operator()(const cycle::Quantity& quantity, double si_value) const {
  const double value = units_.scale(quantity.display_unit, quantity.unit).from_si(si_value);
  // From here on four significant digits reach the units; a point after them would promise more.
  constexpr double kNoFraction = 999.95;
  const std::string number = quantity.display_unit == "degree" ? fmt::format("{:.1f}", value)
                             : std::abs(value) >= kNoFraction  ? fmt::format("{:.0f}", value)
                                                               : fmt::format("{:#.4g}", value);
  return quantity.display_unit == "1" ? number : number + " " + quantity.display_unit;
}

std::string EngineeringText::operator()(const std::string& cycle_quantity, double si_value) const {
  return (*this)(app::cycle_quantity(cycle_quantity), si_value);
}

const cycle::CycleQuantity& cycle_quantity(const std::string& name) {
  const auto& quantities = cycle::cycle_quantities();
  const auto found = std::find_if(quantities.begin(), quantities.end(), [&](const auto& q) { return q.name == name; });
  if (found == quantities.end()) throw std::logic_error("no cycle value is called " + name);
  return *found;
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
