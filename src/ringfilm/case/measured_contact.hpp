#pragma once
#include <optional>
#include <string>

/// Where the asperities and the boundary shear strength of a Case come from.
namespace ringfilm::cycle {

/// How zeta was measured: standard deviations by origin. The last two are common to all samples of one calibration.
struct MeasuredShearStrength {
  std::optional<std::string> loops;             ///< file and sample
  std::optional<std::string> method;            ///< "silicon", "geometry", "wedge"
  std::optional<std::string> calibration;       ///< its name; cases that share it are correlated
  std::optional<double> slope_deviation;        ///< standard deviation of zeta, by the sample's own line [-]
  std::optional<double> calibration_deviation;  ///< standard deviation of zeta, by the calibration [-]
  std::optional<double> reference_deviation;    ///< standard deviation of zeta, by the reference value [-]
};

/// How N, beta and sigma were measured, and their scatter between the regions. The models do not use it; the numbers of
/// a study of uncertainty start here.
struct MeasuredContact {
  std::optional<std::string> ring_surface;           ///< file, channel, region
  std::optional<std::string> liner_surface;          ///< file, channel, region
  std::optional<std::string> filter;                 ///< what was removed before, as text
  std::optional<double> long_cutoff;                 ///< longest wavelength that was kept [m]
  std::optional<double> short_cutoff;                ///< shortest wavelength that was kept; N and beta depend on it [m]
  std::optional<double> step;                        ///< distance of points; N and beta depend on it [m]
  std::optional<std::string> roughness_rule;         ///< how sigma was made of both surfaces, in words
  std::optional<std::string> difference_scheme;      ///< how slopes and curvatures were made of heights, in words
  std::optional<double> regions;                     ///< how many were measured [-]
  std::optional<double> asperity_density_deviation;  ///< standard deviation of N between regions [1/m2]
  std::optional<double> asperity_radius_deviation;   ///< standard deviation of beta between regions [m]
  std::optional<double> roughness_deviation;         ///< standard deviation of sigma between regions [m]
  std::optional<double> density_radius_correlation;  ///< correlation of N and beta over the regions [-]
  std::optional<double> density_roughness_correlation;  ///< correlation of N and sigma over the regions [-]
  std::optional<double> radius_roughness_correlation;   ///< correlation of beta and sigma over the regions [-]
  MeasuredShearStrength shear_strength;                 ///< where zeta comes from
};

}  // namespace ringfilm::cycle
