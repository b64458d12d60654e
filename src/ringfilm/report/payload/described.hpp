#pragma once
#include <nlohmann/json.hpp>

#include "ringfilm/cycle/result/result.hpp"

namespace ringfilm::report {

/// The quantities of a table as a page reads them: name, units, meaning, symbol and equation of each.
template <class Quantities>
nlohmann::ordered_json described_all(const Quantities& quantities) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const cycle::Quantity& q : quantities) {
    list.push_back({{"name", q.name},
                    {"unit", q.unit},
                    {"display_unit", q.display_unit},
                    {"long_name", q.long_name},
                    {"symbol", q.symbol},
                    {"equation", q.equation}});
  }
  return list;
}

}  // namespace ringfilm::report
