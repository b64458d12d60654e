#pragma once
#include <vector>

#include "ringfilm/models/crank_slider.hpp"

/// Gas pressure over the cycle (docs/theory/gas.md).
namespace ringfilm::models {

/// A pressure over the 720 degree cycle: absolute [Pa], linear between samples, periodic. Angles in degrees,
/// 0 = firing TDC (docs/decisions/0002-crank-angle-in-degrees.md).
class CyclePressure {
 public:
  /// Constant.
  explicit CyclePressure(double pressure);
  /// Samples in increasing order spanning at most 720 degrees, any first angle; the last may repeat the first one
  /// cycle later. Positive pressures.
  CyclePressure(std::vector<double> crank_angle_deg, std::vector<double> pressure);

  double pressure(double crank_angle_deg) const;  ///< [Pa], absolute
  /// Largest sample and its angle in [0, 720).
  double peak() const;
  double peak_angle_deg() const;  ///< angle of the highest pressure [degree]

 private:
  std::vector<double> angle_, pressure_;
};

/// Does the trace cover the whole cycle? True if neighbouring samples, wrap included, are kMaxSampleDistanceDeg
/// apart at most (trace_span.hpp).
bool covers_cycle(const std::vector<double>& crank_angle_deg);

/// Joins a trace over part of the cycle (around firing TDC) with constant exhaust and intake pressures by smooth
/// (C1, monotone) blends: trace end -> exhaust pressure at bottom dead centre or 40 degree later if the trace reaches
/// beyond it; exhaust -> intake around gas-exchange TDC (+-20 degree); intake -> trace start.
/// Throws InputError if the trace leaves no room for that.
CyclePressure join_partial_trace(std::vector<double> crank_angle_deg, std::vector<double> pressure,
                                 double intake_pressure, double exhaust_pressure);

/// Single-zone cycle with Wiebe heat release, eq-wiebe. Heat and start of combustion are found so that peak pressure
/// and peak angle are met; throws InputError where that cannot be.
struct WiebeCycle {
  CrankSlider crank;                 ///< gives the volume of the cylinder
  double compression_ratio;          ///< largest over smallest volume [-]
  double peak_pressure;              ///< highest of the cycle, absolute [Pa]
  double peak_angle_deg;             ///< angle of the highest pressure, after firing TDC [degree]
  double burn_duration_deg;          ///< length of the heat release [degree]
  double intake_pressure;            ///< during intake, absolute [Pa]
  double exhaust_pressure;           ///< during exhaust, absolute [Pa]
  double exhaust_valve_opening_deg;  ///< from firing TDC, as the next three [degree]
  double exhaust_valve_closing_deg;  ///< e.g. 375: 15 degree after gas-exchange TDC [degree]
  double intake_valve_opening_deg;   ///< e.g. 345: 15 degree before gas-exchange TDC [degree]
  double intake_valve_closing_deg;   ///< e.g. 590: 50 degree after the dead centre where compression begins [degree]
};
/// The cylinder pressure of that cycle. Throws InputError for peak pressure and angle that no heat release meets.
CyclePressure wiebe_pressure(const WiebeCycle& cycle);

}  // namespace ringfilm::models
