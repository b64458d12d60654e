#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/gas_path/result.hpp"

/// Names, units and meaning of the values of the gas between the rings: JSON, result files, pages, studies and Python
/// walk these tables.
namespace ringfilm::cycle {

/// A value of the gas and the member of `Row` that holds it, of one of the types `Values`.
template <class Row, class... Values>
struct GasQuantity : Quantity {
  std::variant<Values Row::*...> value;  ///< the member that holds it
};

using GasSumQuantity =
    GasQuantity<gas_path::GasSums, double, std::optional<double>, std::optional<long>, std::optional<bool>>;
using GasRegionQuantity = GasQuantity<gas_path::RegionValues, double, std::optional<double>>;
using GasPathQuantity = GasQuantity<gas_path::PathValues, double, std::optional<double>>;
using GasScalarQuantity = GasQuantity<gas_path::ScalarValues, double>;
using GasRingQuantity = GasQuantity<gas_path::RingMotionValues, double, std::optional<double>, long, bool>;

const std::vector<GasSumQuantity>& gas_sum_quantities();        ///< quantities of one cylinder
const std::vector<GasRegionQuantity>& gas_region_quantities();  ///< quantities of each region
const std::vector<GasPathQuantity>& gas_path_quantities();      ///< quantities of each path
const std::vector<GasScalarQuantity>& gas_scalar_quantities();  ///< quantities of each scalar that the gas carries
const std::vector<GasRingQuantity>& gas_ring_quantities();      ///< quantities of each ring in a groove

/// One of gas_sum_quantities() by its name.
const GasSumQuantity& gas_sum_quantity(const char* name);

/// The one of gas_sum_quantities() that texts and pages lead with: the volume flow of the blow-by.
const GasSumQuantity& leading_gas_sum();

/// Is it the name of one of gas_sum_quantities()?
bool is_gas_sum(const std::string& name);

/// Does a quantity need the composition of the gas?
bool needs_composition(const GasSumQuantity& quantity);

/// The value of a row as a number, a truth as 0 or 1; nothing where a file of an earlier version lacks it.
template <class Row, class... Values>
std::optional<double> number_of(const GasQuantity<Row, Values...>& quantity, const Row& row) {
  const auto number = [](const auto& value) -> std::optional<double> {
    if constexpr (requires { value.has_value(); }) {
      return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
    } else {
      return static_cast<double>(value);
    }
  };
  return std::visit([&](auto member) { return number(row.*member); }, quantity.value);
}

}  // namespace ringfilm::cycle
