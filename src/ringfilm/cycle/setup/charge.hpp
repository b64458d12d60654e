#pragma once
#include "ringfilm/case/case.hpp"
#include "ringfilm/models/crank_slider.hpp"
#include "ringfilm/models/gas/gas.hpp"

namespace ringfilm::cycle {

/// The charge of the cylinder as an ideal gas in one zone, eq-trapped-mass and eq-gas-temperature
/// (docs/theory/oil-consumption.md). Angles with 0 = firing TDC.
class Charge {
 public:
  /// Throws InputError where the cylinder pressure of the case cannot be used.
  explicit Charge(const Case& c);

  double mass() const { return mass_; }  ///< trapped when the intake valve closes [kg]
  double pressure(double angle_deg) const { return pressure_.pressure(angle_deg); }  ///< [Pa]
  double temperature(double angle_deg) const;                                        ///< mean over the cylinder [K]
  /// Between gas and liner, after evaporation.heat_transfer [W/(m2 K)].
  double heat_transfer_coefficient(double angle_deg) const;

 private:
  double volume(double angle_deg) const;   ///< volume of the cylinder [m3]
  bool is_closed(double angle_deg) const;  ///< are both valves closed?

  models::CrankSlider crank_;
  models::CyclePressure pressure_;
  double bore_, clearance_volume_;  ///< [m], [m3]
  double mean_piston_speed_;        ///< [m/s]
  double gas_constant_, heat_capacity_ratio_;
  double intake_closes_deg_, exhaust_opens_deg_;
  double charge_temperature_;  ///< when the intake valve closes [K]
  double mass_;
};

}  // namespace ringfilm::cycle
