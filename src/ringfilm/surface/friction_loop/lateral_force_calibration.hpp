#pragma once
#include <string>
#include <vector>

#include "ringfilm/surface/friction_loop/lateral_force_line.hpp"

/// From the slope of a friction-load line to a coefficient: zeta = psi m.
namespace ringfilm::surface {

/// A value and its standard deviation.
struct Uncertain {
  double value = 0;
  double deviation = 0;
};

/// Coefficient of friction of silicon after Ahimou et al. @cite ahimou2007. Its 0.1 is taken as a standard deviation.
inline constexpr Uncertain kSiliconAhimou{0.19, 0.1};
/// Coefficient of friction of silicon after Warmack et al. @cite warmack1994.
inline constexpr Uncertain kSiliconWarmack{0.18, 0.03};

/// What the loads of loops are counted in; calibration and sample must agree.
enum class LoadUnit { kVolt, kNewton };

enum class CalibrationMethod { kSilicon, kGeometry, kWedge };

/// "silicon", "geometry", "wedge".
std::string name_of(CalibrationMethod method);

/// The calibration factor psi with what makes it uncertain. Common to all samples that were measured with it.
struct Calibration {
  CalibrationMethod method{};
  LoadUnit load_unit{};
  double psi = 0;  ///< [1] for loads in volts, [N/V] for loads in newtons
  /// Standard deviation of psi by the calibration's own lines and lever data [as psi].
  double measurement_deviation = 0;
  /// Standard deviation of psi by adopted values: coefficient of silicon, angles [as psi].
  double reference_deviation = 0;
  double degrees_of_freedom = 0;  ///< degrees of freedom of the measurement; infinite where it is stated
  std::vector<LineFit> lines{};   ///< friction signal against load that psi follows from; none of a lever

  double deviation() const;
};

/// psi = reference / slope, eq-psi-silicon: the way for any lever, V-shaped ones too. Throws InputError for a slope
/// that is not positive.
Calibration calibrate_on_silicon(const LineFit& silicon, LoadUnit load_unit, Uncertain reference);

enum class LeverShape { kRectangular, kVShaped };

/// Data of a lever for eqs of styles2014. The height of the tip counts from the middle of the lever's
/// thickness, about which it turns.
struct Lever {
  LeverShape shape{};
  Uncertain length_m, tip_height_m, poissons_ratio;
  Uncertain sensitivity_ratio{1, 0};  ///< S_N/S_T of the photodiode [-]; 1 for one with four equal quadrants
  // for loads in newtons only
  Uncertain youngs_modulus_Pa, width_m, thickness_m;
  Uncertain torsional_sensitivity_V_per_m;  ///< S_T
};

/// k_N = E W T^3/(4 L^3), eq-lever-normal [N/m]. Rectangular levers only: InputError.
double normal_stiffness(const Lever& lever);
/// k_T = G W T^3/(3 L R^2) at the tip, eq-lever-torsion [N/m]. Rectangular levers only: InputError.
double torsional_stiffness(const Lever& lever);

/// psi from the shape of the lever: eq-psi-lever for loads in volts, eq-psi-lever-newton for loads in newtons. Throws
/// InputError for a V-shaped lever, to which the formulas do not apply, and for sizes that are not above zero.
Calibration calibrate_by_geometry(const Lever& lever, LoadUnit load_unit);

/// One facet of a calibration grating: its slope and the lines of half width and offset of its loops against load.
struct WedgeFacet {
  Uncertain angle_rad;  ///< between facet and base, positive where the tip climbs on the trace
  LineFit half_width;   ///< TMR against load
  LineFit offset;
};

struct WedgeCalibration {
  Calibration calibration;
  Uncertain friction_coefficient;  ///< coefficient of friction between tip and grating
  double width_mismatch = 0;       ///< measured ratio of the facets' widths over the one that theory gives, less 1 [-]
};

/// Two facets of one material at unlike angles @cite ogletree1996, eq-wedge-width to eq-wedge-ratio; one may be flat
/// @cite varenberg2003. Only slopes over load enter, so that adhesion, as long as it does not change with load, and the
/// zero of the lateral signal drop out; cross-talk of the normal signal drops out in the difference of the offsets.
/// The angles' share is contained in reference_deviation. Throws InputError where the angles are one, or no
/// coefficient of friction below 1 explains the lines.
WedgeCalibration calibrate_on_wedge(const WedgeFacet& first, const WedgeFacet& second, LoadUnit load_unit);

}  // namespace ringfilm::surface
