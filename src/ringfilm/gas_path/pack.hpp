#pragma once
#include <optional>
#include <vector>

#include "ringfilm/models/crank_slider.hpp"
#include "ringfilm/models/gas/charge_mixture.hpp"
#include "ringfilm/models/gas/gas.hpp"
#include "ringfilm/models/radial_collapse.hpp"
#include "ringfilm/models/section/twisting_ring.hpp"

/// The gas path of a ring pack (docs/theory/gas-path.md): volumes at stated temperatures between the rings, end gaps
/// and side clearances between them, and the axial motion of the rings in their grooves.
namespace ringfilm::gas_path {

/// What a ring of the pack is to the gas.
enum class RingKind {
  kCompression,  ///< an end gap, and a groove with a side clearance
  kOil           ///< an end gap alone
};

/// `gas_path.ring_motion`: where the rings are in their grooves.
enum class RingMotion {
  kSeated,  ///< on their lower flanks
  kAxial    ///< where gas, inertia and friction move them
};

/// A ring as the gas meets it. Of an oil ring only the first four members count, and face_opening.
struct Ring {
  RingKind kind = RingKind::kCompression;
  double gap_area = 0;            ///< area of the end gap, as the gas passes it [m2]
  double volume_below = 0;        ///< volume of the piston land below; 0: the region below it [m3]
  double temperature_below = 0;   ///< temperature of the gas at the piston land below [K]
  double groove_volume = 0;       ///< behind and above the ring, filled with gas [m3]
  double groove_temperature = 0;  ///< temperature of the gas in the groove [K]
  double side_clearance = 0;      ///< clearance of the ring in its groove, along the bore's axis [m]
  double land_clearance = 0;      ///< radial, between piston lands and bore [m]
  double radial_thickness = 0;    ///< radial thickness of the ring [m]
  double face_width = 0;          ///< b; RingMotion::kAxial, and for the static twist [m]
  double youngs_modulus = 0;      ///< Young's modulus of the ring, for the static twist [Pa]
  /// Pressure of the ring on the bore by its tension, p_e; for RingMotion::kAxial and the static twist [Pa]
  double elastic_pressure = 0;
  double mass = 0;  ///< mass of the ring, for RingMotion::kAxial and the static twist [kg]
  /// Coefficient of friction of the ring on the bore, for RingMotion::kAxial and the static twist [-]
  double bore_friction_coefficient = 0;
  /// Gap over the face that gas passes all around, at each degree of crank angle; empty: none. Counts of oil rings,
  /// too, as does face_width [m].
  std::vector<double> face_opening;
  models::RadialCollapse collapse;  ///< what a compression ring does that gas presses off the liner
  bool leaves_liner = false;        ///< does it do so? solve_gas_path() finds it out
  /// Section of the ring with its tension; nothing: a rectangle of face width and thickness without assembly twist.
  std::optional<models::TwistingRing> section = {};
};

/// The gas and how it flows.
struct Gas {
  double gas_constant = 0;           ///< R [J/(kg K)]
  double heat_capacity_ratio = 0;    ///< gamma [-]
  double viscosity = 0;              ///< mu [Pa s]
  double discharge_coefficient = 0;  ///< C, of the end gaps [-]
  double choking_smoothing = 0;      ///< see models::OrificeLaw [-]
};

/// What the gas consists of: three gases that the flow carries unchanged through the pack, and the walls on which their
/// water may condense.
struct Composition {
  std::vector<double> burnt_share;   ///< mass share of burnt gas in the chamber, at each degree of crank angle [-]
  models::Shares fresh{}, burnt{};   ///< fresh charge and burnt gas, by mass [-]
  models::Shares air{};              ///< air that enters the crankcase, by mass [-]
  models::Fuel fuel{};               ///< fuel of the fresh charge
  double ventilation = 0;            ///< flow of that air [kg/s]
  std::vector<double> chamber_wall;  ///< coldest wall of the chamber, at each degree of crank angle [K]
  double liner_wall = 0;             ///< coldest place of the liner [K]
};

/// A pack of rings between combustion chamber and crankcase.
struct Pack {
  double bore = 0;                       ///< [m]
  models::CrankSlider crank{};           ///< that moves the piston
  double speed = 0;                      ///< speed of the crankshaft [rad/s]
  models::CyclePressure chamber{1e5};    ///< pressure in the combustion chamber
  models::CyclePressure crankcase{1e5};  ///< pressure in the crankcase
  double chamber_temperature = 0;        ///< temperature of the gas in the chamber [K]
  double crankcase_temperature = 0;      ///< temperature of the gas in the crankcase [K]
  Gas gas;
  RingMotion ring_motion = RingMotion::kSeated;
  double sliding_smoothing_speed = 0;        ///< U_0; RingMotion::kAxial [m/s]
  double trapped_mass = 0;                   ///< charge of the cylinder, for shares of it; 0: not known [kg]
  std::optional<Composition> composition{};  ///< absent: the gas has no composition
  std::vector<Ring> rings;                   ///< from the chamber to the crankcase
};

/// A groove or piston land of less volume is taken to have this one [m3].
inline constexpr double kMinVolume = 1e-11;

}  // namespace ringfilm::gas_path
