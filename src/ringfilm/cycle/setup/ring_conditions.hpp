#pragma once
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/film/film_state.hpp"

namespace ringfilm::cycle {

/// Which way the film's own x points.
enum class Axis {
  kFromChamber,   ///< x = 0 at the chamber edge
  kFromCrankcase  ///< x = 0 at the crankcase edge (only with orientation = "leading-edge", moving down)
};

/// What the gas presses on the back of a ring, absolute, eq-pressure-behind-ring [Pa]: below + share (above - below).
/// @param above @param below pressures at the edges of its face [Pa]
double pressure_behind_ring(const Gas& gas, double above, double below);

/// What acts on a ring at one crank angle.
struct RingConditions {
  film::FilmInputs inputs;  ///< speed, edges, oil and load of its film
  Axis axis = Axis::kFromChamber;
  double piston_velocity = 0;      ///< positive towards TDC [m/s]
  double crank_angle_deg = 0;      ///< within [0, 720) [degree]
  double below_tdc = 0;            ///< where the ring is on its stroke [m]
  double film_temperature = 0;     ///< [K]
  models::ForceOnRing on_section;  ///< gas and inertia on a section that turns
  double oil_ahead = 0;            ///< on the liner ahead of an inlet that is not flooded; 0: flooded [kg/m2]
  /// By how far gas holds the ring off the liner beyond the reach of asperities; nothing: film and asperities carry
  /// [m].
  std::optional<double> off_liner = std::nullopt;
};

/// How the film of the step before heated itself; zero where the case does not heat its film (`Thermal::is_heated`).
struct HeatBefore {
  double rise = 0;       ///< rise of the film's temperature above that of its walls [K]
  double viscosity = 0;  ///< viscosity of the film's oil at atmospheric pressure [Pa s]
};

/// Up to this rise the oil serves a film that its own shear heats [K]. It covers starts at -30 degC.
inline constexpr double kServedRise = 60;

/// @param crank_angle_deg any [degree] @param time_step that leads there; film::kSteady [s]
RingConditions ring_conditions(const Setup& setup, double crank_angle_deg, double time_step,
                               const HeatBefore& before = {});

}  // namespace ringfilm::cycle
