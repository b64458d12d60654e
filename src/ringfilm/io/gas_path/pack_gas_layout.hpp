#pragma once
#include <optional>
#include <vector>

#include "ringfilm/io/gas_path/pack_gas.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"

/// What a result file holds of the gas of a pack: a part of the description in result_file_layout.hpp.
namespace ringfilm::io {

template <class File, class Gas>
void exchange_gas_tables(File& file, Gas& gas) {
  using gas_path::RegionValues;
  file.rows("gas_region", gas.regions);
  file.column("gas_region", text("gas_region_name", "region of gas, from the chamber to the crankcase"), gas.regions,
              &RegionValues::name);
  file.column("gas_region", described("gas_region_peak_pressure", "Pa", "highest pressure, absolute", "p"), gas.regions,
              &RegionValues::peak_pressure);
  file.column("gas_region", described("gas_region_peak_pressure_angle", "degree", "crank angle of it"), gas.regions,
              &RegionValues::peak_pressure_angle_deg);
  file.column("gas_region", described("gas_region_mean_pressure", "Pa", "mean over time, absolute"), gas.regions,
              &RegionValues::mean_pressure);
  file.rows("gas_path", gas.paths);
  file.column("gas_path", text("gas_path_name", "path of the gas"), gas.paths, &PackGas::Path::name);
  file.column("gas_path", described("gas_path_mass_per_cycle", "kg", "net mass along the path in a cycle"), gas.paths,
              &PackGas::Path::mass_per_cycle);
  file.rows("gas_event", gas.events);
  file.column("gas_event", count("gas_event_ring", "ring that changes the contact with its flanks, from 1"), gas.events,
              &PackGas::Event::ring);
  file.column("gas_event", described("gas_event_crank_angle", "degree", "crank angle of the change"), gas.events,
              &PackGas::Event::crank_angle_deg);
  file.column("gas_event", text("gas_event_name", "what the ring does"), gas.events, &PackGas::Event::event);
  file.rows("gas_ring", gas.rings);
  file.column("gas_ring", count("gas_ring", "compression ring, from 1"), gas.rings, &PackGas::Ring::number);
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
               described("gas_path_flow", "kg s-1", "mass flow along the path, positive to the crankcase", "m'",
                         "eq-orifice-flow"),
               gas.flow);
  file.numbers({"gas_crank_angle", "gas_ring"},
               described("ring_position", "m", "position of the ring above the lower flank of its groove", "z",
                         "eq-ring-acceleration"),
               gas.position);
  file.scalar(described("blow_by_per_cycle", "kg", "net mass into the crankcase in a cycle", "m_b", "eq-blow-by"),
              gas.blow_by_per_cycle);
  file.scalar(described("blow_by_flow", "m3 s-1", "the same at 1.01325 bar and 25 degC"), gas.blow_by_flow);
  file.scalar(described("gas_mass_defect", "1", "mass that the balance of the gas misses"), gas.mass_defect);
  file.scalar(described("gas_periodicity_error", "1", "largest relative change of a pressure between cycles"),
              gas.periodicity_error);
}

}  // namespace ringfilm::io
