#pragma once
#include <nlohmann/json.hpp>

#include "ringfilm/cycle/result/result.hpp"

namespace ringfilm::report {

/// A quantity as a page reads it: name, units, meaning, symbol and equation.
inline nlohmann::ordered_json described_object(const cycle::Quantity& quantity) {
  return {{"name", quantity.name},           {"unit", quantity.unit},     {"display_unit", quantity.display_unit},
          {"long_name", quantity.long_name}, {"symbol", quantity.symbol}, {"equation", quantity.equation}};
}

/// The quantities of a table as a page reads them.
template <class Quantities>
nlohmann::ordered_json described_all(const Quantities& quantities) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const cycle::Quantity& quantity : quantities) list.push_back(described_object(quantity));
  return list;
}

}  // namespace ringfilm::report
