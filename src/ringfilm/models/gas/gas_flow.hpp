#pragma once

/// Steady flow of an ideal gas through orifices and narrow channels (docs/theory/gas-path.md).
namespace ringfilm::models {

/// Pressure ratio below which the flow of an isentropic orifice is choked; eq-critical-ratio [-].
/// @param heat_capacity_ratio gamma, above 1 [-]
double critical_pressure_ratio(double heat_capacity_ratio);

/// Isentropic flow through an orifice, subsonic or choked; eq-orifice-flow.
class OrificeLaw {
 public:
  /// @param heat_capacity_ratio gamma, above 1 [-]
  /// @param choking_smoothing above the pressure ratio of 1 less this share the flow function is a straight line to
  /// zero, so that its slope is finite; above 0, below 1 less the critical ratio [-]
  OrificeLaw(double heat_capacity_ratio, double choking_smoothing);

  /// Flow function psi(p_d/p_u), eq-flow-function [-]. @param ratio of the pressures downstream and upstream, 0 to 1
  double flow_function(double ratio) const;

  /// Critical ratio of the downstream to the upstream pressure [-].
  double critical_ratio() const { return critical_; }

 private:
  double unsmoothed(double ratio) const;

  double gamma_, critical_, choked_, line_begin_, line_value_;
};

/// A region of gas at one pressure and temperature.
struct GasState {
  double pressure = 0;     ///< absolute [Pa]
  double temperature = 0;  ///< [K]
};

/// Mass flow from a to b through an orifice [kg/s]; negative from b to a. The gas has the temperature of the upstream
/// side. @param area times the discharge coefficient [m2] @param gas_constant of the gas [J/(kg K)]
double orifice_flow(const OrificeLaw& law, double area, double gas_constant, const GasState& a, const GasState& b);

/// Laminar flow of gas between parallel flanks at one temperature; eq-channel-flow.
struct GasChannel {
  double length = 0;        ///< across the flow, around the ring [m]
  double width = 0;         ///< along the flow [m]
  double viscosity = 0;     ///< viscosity of the gas [Pa s]
  double gas_constant = 0;  ///< specific gas constant [J/(kg K)]
  double temperature = 0;   ///< temperature of the gas [K]

  /// Mass flow from a to b [kg/s]. @param clearance between the flanks [m] @param p_a @param p_b absolute [Pa]
  double flow(double clearance, double p_a, double p_b) const;

  /// Slope of that flow over the pressure at one end, near equal pressures [kg/(s Pa)]. @param pressure [Pa]
  double slope(double clearance, double pressure) const;

  /// Flow limited by the orifice at the mouth of the channel; eq-limited-channel-flow [kg/s].
  double limited_flow(const OrificeLaw& law, double clearance, double p_a, double p_b) const;
};

/// Mean pressure of the gas along such a channel between its ends, eq-channel-mean-pressure [Pa].
/// @param p_a @param p_b at its ends, absolute, not both zero [Pa]
double mean_channel_pressure(double p_a, double p_b);

}  // namespace ringfilm::models
