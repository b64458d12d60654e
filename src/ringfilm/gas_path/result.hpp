#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/gas_path/network.hpp"

namespace ringfilm::gas_path {

/// What a ring does at a flank of its groove.
enum class FlankEvent { kLeavesLower, kLandsUpper, kLeavesUpper, kLandsLower };

/// "leaves-lower", "lands-upper", "leaves-upper", "lands-lower"
const char* event_name(FlankEvent event);

/// A change of flank contact.
struct RingEvent {
  std::size_t ring = 0;        ///< from 1, the one next to the chamber
  double crank_angle_deg = 0;  ///< 0 to 720 [degree]
  FlankEvent event{};
};

/// A region over the cycle.
struct RegionValues {
  std::string name;
  double peak_pressure = 0;            ///< highest, absolute [Pa]
  double peak_pressure_angle_deg = 0;  ///< 0 to 720 [degree]
  double mean_pressure = 0;            ///< over time [Pa]
  // water in the gas, eq-dew-point; nothing without Pack::composition
  std::optional<double> peak_dew_point{};     ///< highest dew point; nothing where it is below 0 degC [K]
  std::optional<double> wall_temperature{};   ///< lowest temperature of its walls [K]
  std::optional<double> condensing_share{};   ///< share of the cycle in which the dew point is above the wall [-]
  std::optional<double> condensable_water{};  ///< largest mass of water above saturation at the wall [kg]
};

/// A scalar that the gas carries: a gas, or a species of it.
struct ScalarValues {
  std::string name;                 ///< "fresh charge", "burnt gas", "air", "water" or that of the fuel
  double crankcase_flow = 0;        ///< net flow out of the pack into the crankcase [kg/s]
  double crankcase_per_cycle = 0;   ///< net mass of it in a cycle [kg]
  double chamber_per_cycle = 0;     ///< mass that returns out of the pack to the chamber in a cycle [kg]
  double crankcase_mass_share = 0;  ///< mass share in the crankcase [-]
  double crankcase_mole_share = 0;  ///< mole share in the crankcase [-]
};

/// Places of the scalars in CompositionResult.
inline constexpr std::size_t kFreshScalar = 0, kBurntScalar = 1, kAirScalar = 2, kFuelScalar = 3, kWaterScalar = 4;

/// Composition of the gas over the cycle.
struct CompositionResult {
  std::vector<ScalarValues> scalars;
  /// Mass share of each scalar in each region at each degree of crank angle: scalars of the first region at 0 degree,
  /// those of the second one, ... [-]
  std::vector<double> share;
  double condensate_flow = 0;  ///< water above saturation at the temperature of the crankcase, in what leaves it [kg/s]
  double defect = 0;           ///< ScalarCycle::defect [-]
};

/// How often a ring changes the flank that it lies on.
struct RingMotionValues {
  bool has_groove = false;  ///< a compression ring; the others do not move
  long departures = 0;      ///< from its lower flank in a cycle
  bool flutters = false;    ///< leaves its lower flank more than once in a stroke
  // static criterion of flutter, eq-seating-force
  double least_seating_force = 0;            ///< that presses it on its lower flank, if it lay there [N]
  double least_seating_force_angle_deg = 0;  ///< crank angle of it [degree]
  double unseated_share = 0;                 ///< share of the cycle in which that force is negative [-]
  /// Largest by its size while that force is positive, eq-static-twist; nothing without a face width [rad].
  std::optional<double> largest_static_twist;
  std::optional<double> largest_static_twist_angle_deg;  ///< crank angle of it [degree]
  std::optional<double> twisted_share;  ///< share of the cycle in which the flank does not hold the ring flat [-]
  double off_liner_share = 0;     ///< share of the cycle in which gas presses it off the liner, eq-radial-collapse [-]
  double farthest_off_liner = 0;  ///< [m]
};

/// The gas over one cycle that repeats itself.
struct GasPathResult {
  std::vector<RegionValues> regions;  ///< the chamber first, the crankcase last
  std::vector<Path> paths;            ///< in the order of `flow`
  // at each degree of crank angle, 0 to 719
  std::vector<std::vector<double>> pressure;     ///< pressure of each region [Pa]
  std::vector<std::vector<double>> flow;         ///< along each path [kg/s]
  std::vector<std::vector<double>> position;     ///< position of each ring above its lower flank [m]
  std::vector<RingEvent> events;                 ///< by crank angle; RingMotion::kAxial
  std::vector<RingMotionValues> motion;          ///< motion of each ring; RingMotion::kAxial
  std::vector<double> transported;               ///< net mass along each path in the cycle [kg]
  std::optional<CompositionResult> composition;  ///< where Pack::composition is stated
  std::vector<double> back;                      ///< mass along each path against its direction, positive [kg]
  double trapped_mass = 0;                       ///< Pack::trapped_mass [kg]
  double blow_by = 0;                            ///< net mass that enters the crankcase in the cycle [kg]
  double duration = 0;                           ///< duration of the cycle [s]
  double mass_defect =
      0;  ///< mass that enters less that which leaves and remains, over all that passes the chamber [-]
  /// Largest relative change of a pressure from one cycle to the next, or from one period to the next [-].
  double periodicity = 0;
  bool repeats = false;  ///< do the pressures repeat from cycle to cycle?
  /// Cycles after which gas and rings repeat; 0: never within those that were followed. Where it is above 1 the blow-by
  /// is the mean of that many cycles, and all else that of the last.
  int period = 0;
  int cycles = 0;  ///< that were integrated
};

/// The gas of the crankcase at 25 degC and standard atmosphere, in which blow-by is stated.
inline constexpr double kBlowByTemperature = 298.15;  ///< [K]

/// Blow-by as a volume flow at kBlowByTemperature and base::kAtmosphere [m3/s]. @param gas_constant [J/(kg K)]
double volume_flow(const GasPathResult& result, double gas_constant);

/// The gas of one cylinder as a whole. A file of an earlier version lacks what is optional.
struct GasSums {
  double blow_by_per_cycle = 0;  ///< GasPathResult::blow_by [kg]
  double blow_by_flow = 0;       ///< volume_flow() [m3/s]
  /// Gas that passes the first ring towards the chamber, by all its paths from below it, eq-reverse-blow-by [kg].
  std::optional<double> reverse_blow_by_per_cycle;
  std::optional<double> reverse_blow_by_charge_share;   ///< that mass over the trapped mass; 0: that is not known [-]
  std::optional<double> returned_to_chamber_per_cycle;  ///< gas that enters the chamber out of the pack [kg]
  std::optional<double> returned_from_crankcase_per_cycle;  ///< gas that enters the pack out of the crankcase [kg]
  std::optional<double> trapped_mass;                       ///< GasPathResult::trapped_mass [kg]
  double mass_defect = 0;                                   ///< GasPathResult::mass_defect [-]
  double periodicity_error = 0;                             ///< GasPathResult::periodicity [-]
  std::optional<double> fuel_to_crankcase;        ///< flow of fuel into the crankcase, eq-crankcase-shares [kg/s]
  std::optional<double> water_to_crankcase;       ///< flow of water into the crankcase [kg/s]
  std::optional<double> crankcase_fuel_share;     ///< mole share of fuel in the crankcase [-]
  std::optional<double> condensate_in_crankcase;  ///< CompositionResult::condensate_flow [kg/s]
  std::optional<double> composition_defect;       ///< CompositionResult::defect [-]
  std::optional<long> cycles_integrated;          ///< GasPathResult::cycles
  std::optional<bool> periodic;                   ///< GasPathResult::repeats
  std::optional<long> period_in_cycles;           ///< GasPathResult::period
};

/// A path over the cycle. A file of an earlier version lacks what is optional.
struct PathValues {
  std::string name;                              ///< path_name()
  double mass_per_cycle = 0;                     ///< net mass in its direction [kg]
  std::optional<double> mass_forward_per_cycle;  ///< mass in its direction [kg]
  std::optional<double> mass_back_per_cycle;     ///< mass against its direction, positive [kg]
};

/// Mass that leaves a ring towards the chamber in the cycle, out of the region below it: through its end gap, its film
/// and its lower side clearance [kg]. @param ring index in Pack::rings
double reverse_blow_by(const GasPathResult& result, std::size_t ring);

/// @param gas_constant [J/(kg K)]
GasSums gas_sums(const GasPathResult& result, double gas_constant);

/// In the order of GasPathResult::paths.
std::vector<PathValues> path_values(const GasPathResult& result);

}  // namespace ringfilm::gas_path
