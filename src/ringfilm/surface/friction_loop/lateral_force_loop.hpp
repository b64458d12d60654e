#pragma once
#include <cstddef>
#include <vector>

/// Friction loops of a lateral force microscope: what the tip felt on its way there and back.
namespace ringfilm::surface {

/// One line scanned there (trace) and back (retrace) at one normal load. The load is in volts of the normal signal or
/// in newtons, the same for all loops that meet in one calibration.
struct FrictionLoop {
  double load = 0;                 ///< [V] or [N]
  std::vector<double> position_m;  ///< along the line, rising; the same for both ways [m]
  std::vector<double> trace_V;     ///< lateral signal on the way there [V]
  std::vector<double> retrace_V;   ///< on the way back, at the same positions [V]

  bool operator==(const FrictionLoop&) const = default;
};

/// One loop a line of a scan at one load, from the two lateral channels of an instrument: row after row, both ways
/// at the same places. Lines with a value that is not a number are omitted.
/// Throws InputError for sizes that do not fit, a step that is not a length, and where no line is left.
std::vector<FrictionLoop> loops_of_scan(double load, std::size_t points_x, double step_m,
                                        const std::vector<double>& trace_V, const std::vector<double>& retrace_V);

/// A loop without its turn-around ends, eq-friction-loop.
struct LoopFriction {
  double tmr_V = 0;               ///< half the mean of trace minus retrace: the friction signal [V]
  double tmr_deviation_V = 0;     ///< its standard error from the scatter along the line [V]
  double offset_V = 0;            ///< half the mean of trace plus retrace: slope of the sample, cross-talk, zero [V]
  double offset_deviation_V = 0;  ///< its standard error [V]
  int points = 0;                 ///< positions that were kept
};

/// @param end_share share of the scan length that is cut off at each end [-], from 0 to below 0.5: there the lever
/// turns over, and the signal is not yet that of sliding.
/// Neighbouring points are correlated, so that the scatter is divided by the number of independent points.
/// Throws InputError for lists of different lengths, positions that do not rise, NaN, and less than 8 points kept.
LoopFriction loop_friction(const FrictionLoop& loop, double end_share);

/// All loops of one load.
struct LoadFriction {
  double load = 0;             ///< [V] or [N]
  double load_deviation = 0;   ///< standard deviation of the load as stated [V] or [N]; 0: taken as exact
  double tmr_V = 0;            ///< mean over the loops [V]
  double tmr_scatter_V = 0;    ///< standard deviation between the loops of this load; 0 for a single one [V]
  double tmr_deviation_V = 0;  ///< standard error of the mean [V]; 0: not known
  double offset_V = 0;
  double offset_deviation_V = 0;
  int loops = 0;
};

/// The friction signal of each load, in rising order. With two or more loops at some load the standard errors come from
/// the scatter between the loops of equal load, pooled over the loads; with one loop a load from the scatter along it.
/// Throws InputError as loop_friction, and for a load that is not a number.
std::vector<LoadFriction> friction_of_loads(const std::vector<FrictionLoop>& loops, double end_share,
                                            double load_deviation);

/// How many of n points that are correlated count as independent: n over the integrated autocorrelation, which is
/// summed up to its first value below zero; between 1 and n.
double independent_points(const std::vector<double>& values);

}  // namespace ringfilm::surface
