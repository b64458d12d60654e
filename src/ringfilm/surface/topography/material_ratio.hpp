#pragma once
#include <optional>
#include <span>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// Heights of core, reduced peaks and valleys after @cite iso13565_2; eq-surface-core.
struct CoreRoughness {
  double Rk_m = 0.0;     ///< height of the core [m]
  double Rpk_m = 0.0;    ///< height of the peaks above the core, reduced to a triangle [m]
  double Rvk_m = 0.0;    ///< depth of the valleys below the core, reduced to a triangle [m]
  double Mr1 = 0.0;      ///< material ratio where the core begins, 0 to 1
  double Mr2 = 0.0;      ///< where it ends
  double upper_m = 0.0;  ///< height of the line of the core at 0 [m]
  double lower_m = 0.0;  ///< and at 1
};

/// The line through the 40 % of the curve with the least fall (the first of equals), by least squares along the height;
/// the areas above and below the core as triangles of equal area.
/// @param falling_heights_m material ratio curve, 20 points or more [m]
CoreRoughness core_roughness(std::span<const double> falling_heights_m);

/// Roughness of a surface made in two steps after @cite iso13565_3, eq-surface-probability.
struct ProbabilityRoughness {
  double Rpq_m = 0.0;      ///< slope of the plateau part: rms of the plateau [m]
  double Rvq_m = 0.0;      ///< slope of the valley part [m]
  double Rmq = 0.0;        ///< material ratio where both lines meet, 0 to 1
  double plateau_m = 0.0;  ///< height of the line of the plateau at one half: its mean plane [m]
  double meet_m = 0.0;     ///< height where both lines meet [m]
};

/// Two straight lines of least squares on the curve over normal probability from -3 to 3 standard deviations, their
/// parting where both together leave least; the standard finds the parting with a fitted conic. Nothing where one line
/// is as good, a surface made in one step, or where both do not meet on the curve.
/// @param falling_heights_m material ratio curve, 100 points or more [m]
std::optional<ProbabilityRoughness> probability_roughness(std::span<const double> falling_heights_m);

/// Volumes between the surface and planes at two material ratios, per nominal area, @cite iso25178_2;
/// eq-surface-volumes.
struct VolumeParameters {
  double Vmp_m = 0.0;  ///< material above the first plane [m]
  double Vmc_m = 0.0;  ///< material between both [m]
  double Vvc_m = 0.0;  ///< void between both [m]
  double Vvv_m = 0.0;  ///< void below the second plane [m]
};

/// @param falling_heights_m material ratio curve, 20 points or more [m]
/// @param first material ratio of the first plane @param second of the second, above it; the usual ones of the standard
VolumeParameters volume_parameters(std::span<const double> falling_heights_m, double first = 0.1, double second = 0.8);

/// Material ratio Rmr (Smr) at a depth below the height at a reference ratio, 0 to 1; eq-surface-material-ratio.
/// @param depth_m positive downwards [m]
double material_ratio_at_depth(std::span<const double> falling_heights_m, double reference_ratio, double depth_m);

/// Oil that the valleys can hold, per nominal area: the triangle below the core, Rvk (1 - Mr2)/2 [m].
double oil_retention_volume(const CoreRoughness& core);

/// Which points count as cavities (pores, grooves).
enum class CavityRule {
  below_depth,    ///< deeper than a stated depth below the median height
  below_plateau,  ///< deeper than 3 standard deviations of the plateau below the median; these are 1.4826 times the
                  ///< median distance of the points above the median from it
  below_core,     ///< below the core of the material ratio curve: a share of 1 - Mr2
};

/// Cavities of a surface: what lies below a threshold.
struct Cavities {
  double area_share = 0.0;    ///< share of the measured points that are cavities, 0 to 1
  double threshold_m = 0.0;   ///< height below which a point counts [m]
  double mean_depth_m = 0.0;  ///< mean depth of the cavities below the median height [m]
  double volume_m = 0.0;      ///< below the threshold, per nominal area [m]
};

/// Share of the area that are cavities, eq-surface-cavities.
/// @param depth_m for below_depth alone [m]
Cavities cavities(std::span<const double> falling_heights_m, CavityRule rule, double depth_m = 0.0);

}  // namespace ringfilm::surface
