#pragma once
#include <vector>

#include "ringfilm/case/case.hpp"

/// Zeros of the traces of a case (docs/theory/gas.md).
namespace ringfilm::cycle {

/// Between these angles the valves are closed and combustion has not begun; assumed [degree].
inline constexpr double kPegFromDeg = -90, kPegToDeg = -45;

/// What is added to the crank angles of all traces, by gas.angle_zero [degree].
double turn_of_traces_deg(const Gas& gas);

/// What is added to the pressures of all traces, by gas.pressure_reference [Pa].
double rise_of_traces(const Gas& gas);

/// Crank angle of an angle of the cylinder's trace, gas.angle_offset included, 0 = firing TDC, in [-360, 360) [degree].
double from_firing_deg(const Gas& gas, double trace_angle_deg);

/// What is added to the cylinder's trace by pegging, beyond gas.pressure_reference and gas.pressure_offset, eq-pegging
/// [Pa]; 0 without pegging. Throws InputError where the trace has no samples that show it.
double pegging_shift(const Case& c);

/// All that is added to the pressures of the cylinder's trace [Pa].
double rise_of_cylinder_trace(const Case& c);

/// Mean pressure that the gas exerts on the piston over the cycle, the integral of p dV over the displacement,
/// eq-imep [Pa]. @param angle_deg crank angles from firing TDC over a whole cycle, in their order
double indicated_mean_pressure(const Engine& engine, const std::vector<double>& crank_angle_deg,
                               const std::vector<double>& pressure);

}  // namespace ringfilm::cycle
