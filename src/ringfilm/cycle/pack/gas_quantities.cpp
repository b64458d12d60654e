#include "ringfilm/cycle/pack/gas_quantities.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace ringfilm::cycle {

const std::vector<GasSumQuantity>& gas_sum_quantities() {
  using gas_path::GasSums;
  static const std::vector<GasSumQuantity> table = {
      {{"blow_by_per_cycle", "kg", "mg", "blow-by per cylinder: net mass of gas into the crankcase in a cycle", "m_b",
        "eq-blow-by"},
       &GasSums::blow_by_per_cycle},
      {{"blow_by_flow", "m3/s", "l/min", "blow-by per cylinder as a volume flow at 1.01325 bar and 25 degC", "",
        "eq-blow-by"},
       &GasSums::blow_by_flow},
      {{"reverse_blow_by_per_cycle", "kg", "mg",
        "reverse blow-by per cylinder: mass of gas that passes the first ring towards the chamber in a cycle", "m_r",
        "eq-reverse-blow-by"},
       &GasSums::reverse_blow_by_per_cycle},
      {{"reverse_blow_by_charge_share", "1", "%", "reverse blow-by as a share of the trapped mass", "",
        "eq-trapped-mass"},
       &GasSums::reverse_blow_by_charge_share},
      {{"returned_to_chamber_per_cycle", "kg", "mg",
        "mass of gas that enters the chamber out of the ring pack in a cycle, that of the grooves included", "",
        "eq-reverse-blow-by"},
       &GasSums::returned_to_chamber_per_cycle},
      {{"returned_from_crankcase_per_cycle", "kg", "mg",
        "mass of gas that enters the ring pack out of the crankcase in a cycle", "", "eq-reverse-blow-by"},
       &GasSums::returned_from_crankcase_per_cycle},
      {{"trapped_mass", "kg", "mg", "mass of the charge when the intake valve closes", "m_t", "eq-trapped-mass"},
       &GasSums::trapped_mass},
      {{"fuel_to_crankcase", "kg/s", "g/h", "fuel that the gas carries into the crankcase", "", "eq-crankcase-shares"},
       &GasSums::fuel_to_crankcase},
      {{"water_to_crankcase", "kg/s", "g/h", "water that the gas carries into the crankcase", "",
        "eq-crankcase-shares"},
       &GasSums::water_to_crankcase},
      {{"crankcase_fuel_share", "1", "%", "mole share of fuel in the gas of the crankcase", "x", "eq-crankcase-shares"},
       &GasSums::crankcase_fuel_share},
      {{"condensate_in_crankcase", "kg/s", "g/h",
        "water above saturation in the gas that leaves the crankcase, at its temperature", "", "eq-condensable-water"},
       &GasSums::condensate_in_crankcase},
      {{"composition_defect", "1", "1", "mass that the balance of a scalar misses, relative to the gas that passes", "",
        "eq-scalar-step"},
       &GasSums::composition_defect},
      {{"mass_defect", "1", "1", "mass that the balance of the gas misses, relative to what passes", "",
        "eq-balance-closure"},
       &GasSums::mass_defect},
      {{"cycles_integrated", "1", "1", "cycles integrated for the gas", "", ""}, &GasSums::cycles_integrated},
      {{"periodicity_error", "1", "1", "largest relative change of a pressure between cycles, or between periods", "",
        ""},
       &GasSums::periodicity_error},
      {{"periodic", "1", "1", "1 where gas and rings repeat from cycle to cycle", "", ""}, &GasSums::periodic},
      {{"period_in_cycles", "1", "1", "cycles after which gas and rings repeat, 0: never", "", ""},
       &GasSums::period_in_cycles}};
  return table;
}

const std::vector<GasRegionQuantity>& gas_region_quantities() {
  using gas_path::RegionValues;
  static const std::vector<GasRegionQuantity> table = {
      {{"peak_pressure", "Pa", "bar", "highest pressure, absolute", "p", "eq-gas-region"},
       &RegionValues::peak_pressure},
      {{"peak_pressure_angle", "degree", "degree", "crank angle of the highest pressure", "", ""},
       &RegionValues::peak_pressure_angle_deg},
      {{"mean_pressure", "Pa", "bar", "pressure, absolute, mean over time", "p", "eq-gas-region"},
       &RegionValues::mean_pressure},
      {{"peak_dew_point", "K", "degC", "highest dew point of the water in the gas", "T_d", "eq-dew-point"},
       &RegionValues::peak_dew_point},
      {{"wall_temperature", "K", "degC", "lowest temperature of the walls", "T_w", "eq-dew-point"},
       &RegionValues::wall_temperature},
      {{"condensing_share", "1", "%", "share of the cycle in which the dew point is above the wall", "",
        "eq-dew-point"},
       &RegionValues::condensing_share},
      {{"condensable_water", "kg", "mg", "largest mass of water above saturation at the wall", "m_c",
        "eq-condensable-water"},
       &RegionValues::condensable_water}};
  return table;
}

const std::vector<GasPathQuantity>& gas_path_quantities() {
  using gas_path::PathValues;
  static const std::vector<GasPathQuantity> table = {
      {{"mass_per_cycle", "kg", "mg", "net mass along the path in a cycle", "", "eq-gas-region"},
       &PathValues::mass_per_cycle},
      {{"mass_forward_per_cycle", "kg", "mg", "mass towards the crankcase in a cycle", "", "eq-gas-region"},
       &PathValues::mass_forward_per_cycle},
      {{"mass_back_per_cycle", "kg", "mg", "mass back towards the chamber in a cycle", "", "eq-gas-region"},
       &PathValues::mass_back_per_cycle}};
  return table;
}

const std::vector<GasScalarQuantity>& gas_scalar_quantities() {
  using gas_path::ScalarValues;
  static const std::vector<GasScalarQuantity> table = {
      {{"crankcase_flow", "kg/s", "g/h", "net flow out of the ring pack into the crankcase", "", "eq-crankcase-shares"},
       &ScalarValues::crankcase_flow},
      {{"crankcase_per_cycle", "kg", "mg", "net mass out of the ring pack into the crankcase in a cycle", "",
        "eq-scalar-balance"},
       &ScalarValues::crankcase_per_cycle},
      {{"chamber_per_cycle", "kg", "mg", "mass that returns out of the ring pack to the chamber in a cycle", "",
        "eq-scalar-balance"},
       &ScalarValues::chamber_per_cycle},
      {{"crankcase_mass_share", "1", "%", "mass share in the crankcase", "Y", "eq-crankcase-shares"},
       &ScalarValues::crankcase_mass_share},
      {{"crankcase_mole_share", "1", "%", "mole share in the crankcase", "x", "eq-crankcase-shares"},
       &ScalarValues::crankcase_mole_share}};
  return table;
}

const std::vector<GasRingQuantity>& gas_ring_quantities() {
  using gas_path::RingMotionValues;
  static const std::vector<GasRingQuantity> table = {
      {{"departures_from_lower_flank", "1", "1", "departures from the lower flank in a cycle", "",
        "eq-ring-acceleration"},
       &RingMotionValues::departures},
      {{"flutters", "1", "1", "1 where the ring leaves its lower flank more than once in a stroke", "",
        "eq-ring-acceleration"},
       &RingMotionValues::flutters},
      {{"least_seating_force", "N", "N", "least force on the lower flank, if the ring lay there", "F_s",
        "eq-seating-force"},
       &RingMotionValues::least_seating_force},
      {{"least_seating_force_angle", "degree", "degree", "crank angle of the least force on the lower flank", "",
        "eq-seating-force"},
       &RingMotionValues::least_seating_force_angle_deg},
      {{"unseated_share", "1", "%", "share of the cycle with a negative force on the lower flank", "",
        "eq-seating-force"},
       &RingMotionValues::unseated_share},
      {{"largest_static_twist", "rad", "degree", "largest static twist", "vartheta", "eq-static-twist"},
       &RingMotionValues::largest_static_twist},
      {{"largest_static_twist_angle", "degree", "degree", "crank angle of the largest static twist", "",
        "eq-static-twist"},
       &RingMotionValues::largest_static_twist_angle_deg},
      {{"twisted_share", "1", "%", "share of the cycle with a static twist", "", "eq-static-twist"},
       &RingMotionValues::twisted_share},
      {{"off_liner_share", "1", "%", "share of the cycle in which gas holds the ring off the liner", "",
        "eq-radial-collapse"},
       &RingMotionValues::off_liner_share},
      {{"farthest_off_liner", "m", "um", "largest distance at which gas holds the ring off the liner", "a",
        "eq-radial-collapse"},
       &RingMotionValues::farthest_off_liner}};
  return table;
}

const GasSumQuantity& gas_sum_quantity(const char* name) {
  const auto& table = gas_sum_quantities();
  const auto found =
      std::find_if(table.begin(), table.end(), [name](const GasSumQuantity& one) { return one.name == name; });
  if (found == table.end()) throw std::logic_error(std::string("the gas has no value ") + name);
  return *found;
}

const GasSumQuantity& leading_gas_sum() { return gas_sum_quantity("blow_by_flow"); }

bool needs_composition(const GasSumQuantity& quantity) {
  constexpr std::array kNames{"fuel_to_crankcase", "water_to_crankcase", "crankcase_fuel_share",
                              "condensate_in_crankcase", "composition_defect"};
  return std::find(kNames.begin(), kNames.end(), quantity.name) != kNames.end();
}

bool is_gas_sum(const std::string& name) {
  const auto& table = gas_sum_quantities();
  return std::any_of(table.begin(), table.end(), [&](const GasSumQuantity& one) { return one.name == name; });
}

}  // namespace ringfilm::cycle
