#pragma once
#include <type_traits>
#include <variant>

#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/io/result/pack_gas.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"

/// What a result file holds of the gas of a pack: a part of the description in result_file_layout.hpp.
namespace ringfilm::io {

/// A column for each quantity, `dimension`_name. A file of an earlier version may lack some.
template <class File, class Quantities, class Rows>
void exchange_gas_columns(File& file, const char* dimension, const Quantities& quantities, Rows& rows) {
  for (const auto& quantity : quantities) {
    cycle::Quantity variable = quantity;
    variable.name = dimension + ("_" + quantity.name);
    if constexpr (File::kReads) {
      if (!file.has_variable(variable.name)) continue;
    }
    std::visit([&](auto member) { file.column(dimension, variable, rows, member); }, quantity.value);
  }
}

/// The values of the gas as a whole; a number that is absent is not in the file.
template <class File, class Sums>
void exchange_gas_sums(File& file, Sums& sums) {
  const auto exchange = [&file](const cycle::Quantity& variable, auto& value) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
      file.scalar(variable, value);
    } else if constexpr (File::kReads) {
      if (!file.has_variable(variable.name)) return;
      double number = 0;
      file.scalar(variable, number);
      value = static_cast<typename std::remove_cvref_t<decltype(value)>::value_type>(number);
    } else if (value) {
      file.scalar(variable, static_cast<double>(*value));
    }
  };
  for (const auto& quantity : cycle::gas_sum_quantities()) {
    cycle::Quantity variable = quantity;
    if (!variable.name.starts_with("blow_by")) variable.name.insert(0, "gas_");
    std::visit([&](auto member) { exchange(variable, sums.*member); }, quantity.value);
  }
}

/// The number of cylinders, where the case states it.
template <class File, class Number>
void exchange_cylinders(File& file, Number& cylinders) {
  const cycle::Quantity variable = count("gas_cylinders", "cylinders of the engine");
  if constexpr (File::kReads) {
    if (!file.has_variable(variable.name)) return;
    file.scalar(variable, cylinders.emplace());
  } else if (cylinders) {
    file.scalar(variable, *cylinders);
  }
}

template <class File, class Gas>
void exchange_gas_tables(File& file, Gas& gas) {
  file.rows("gas_region", gas.regions);
  file.column("gas_region", text("gas_region_name", "region of gas, from the chamber to the crankcase"), gas.regions,
              &gas_path::RegionValues::name);
  exchange_gas_columns(file, "gas_region", cycle::gas_region_quantities(), gas.regions);
  file.rows("gas_path", gas.paths);
  file.column("gas_path", text("gas_path_name", "path of the gas"), gas.paths, &gas_path::PathValues::name);
  exchange_gas_columns(file, "gas_path", cycle::gas_path_quantities(), gas.paths);
  file.rows("gas_scalar", gas.scalars);
  file.column("gas_scalar", text("gas_scalar_name", "gas or species that the gas carries"), gas.scalars,
              &gas_path::ScalarValues::name);
  exchange_gas_columns(file, "gas_scalar", cycle::gas_scalar_quantities(), gas.scalars);
  file.rows("gas_event", gas.events);
  file.column("gas_event", count("gas_event_ring", "ring that changes the contact with its flanks, from 1"), gas.events,
              &PackGas::Event::ring);
  file.column("gas_event", described("gas_event_crank_angle", "degree", "crank angle of the change"), gas.events,
              &PackGas::Event::crank_angle_deg);
  file.column("gas_event", text("gas_event_name", "what the ring does"), gas.events, &PackGas::Event::event);
  file.rows("gas_ring", gas.rings);
  file.column("gas_ring", count("gas_ring", "compression ring, from 1"), gas.rings, &PackGas::Ring::number);
  if constexpr (File::kReads) {
    if (!file.has_variable("gas_ring_flutters")) return;
    file.rows("gas_ring", gas.motion);
  }
  if (!gas.motion.empty()) exchange_gas_columns(file, "gas_ring", cycle::gas_ring_quantities(), gas.motion);
}

/// Nothing of a pack whose pressures are given.
template <class File, class Document>
void exchange_pack_gas(File& file, Document& document) {
  if constexpr (File::kReads) {
    if (!file.has_variable("gas_region_pressure")) return;
    document.gas.emplace();
  }
  if (!document.gas) return;
  auto& gas = *document.gas;
  exchange_gas_tables(file, gas);
  file.numbers({"gas_crank_angle"}, described("gas_crank_angle", "degree", "crank angle of the gas, 0 = firing TDC"),
               gas.crank_angle_deg);
  file.numbers({"gas_crank_angle", "gas_region"},
               described("gas_region_pressure", "Pa", "pressure of the region, absolute", "p", "eq-gas-region"),
               gas.pressure);
  file.numbers({"gas_crank_angle", "gas_path"},
               described("gas_path_flow", "kg/s", "mass flow along the path, positive to the crankcase", "m'",
                         "eq-orifice-flow"),
               gas.flow);
  file.numbers({"gas_crank_angle", "gas_ring"},
               described("ring_position", "m", "position of the ring above the lower flank of its groove", "z",
                         "eq-ring-acceleration"),
               gas.position);
  exchange_present(
      file, {"gas_crank_angle", "gas_region", "gas_scalar"},
      described("gas_region_share", "1", "mass share of the scalar in the region", "Y", "eq-scalar-balance"),
      gas.share);
  exchange_gas_sums(file, gas.sums);
  exchange_cylinders(file, gas.cylinders);
}

}  // namespace ringfilm::io
