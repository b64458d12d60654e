#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/surface/asperity/asperities.hpp"
#include "ringfilm/surface/topography/material_ratio.hpp"
#include "ringfilm/surface/topography/preparation.hpp"
#include "ringfilm/surface/topography/regions.hpp"

namespace ringfilm::instrument {

/// Which parts of a map are measured each by itself; the whole map where nothing is chosen.
struct RegionChoice {
  std::vector<std::array<double, 4>> rectangles_m;  ///< x, y, width, height [m]
  std::size_t across = 0;                           ///< parts along x of a grid of equal ones; 0: no grid
  std::size_t down = 0;                             ///< its parts along y
  std::size_t prominent = 0;                        ///< so many of `size_m`, those that stand out most
  double size_m = 0;                                ///< side of these squares [m]
};

/// What carries of the liner of a pair.
enum class CarryingPart {
  kWhole,   ///< the whole surface, as a Gaussian one
  kPlateau  ///< the plateau of a surface made in two steps
};

/// Which of the surfaces of ISO 25178-2 a map is reported on, beside the one after the stated form and filters.
enum class StandardSurfaces {
  kSfAndSl,  ///< the S-F and the S-L surface
  kNone      ///< neither
};

/// What is asked of a measured surface beside its form and filters.
struct SurfaceAnalysis {
  surface::Preparation preparation;  ///< form and filters that come before
  RegionChoice regions;              ///< what is measured by itself; as it is: the whole map
  /// Lines along which slopes and curvatures of a map are taken.
  surface::MomentDirection direction = surface::MomentDirection::mean;
  /// How they are made of neighbouring heights.
  surface::DifferenceScheme scheme = surface::DifferenceScheme::neighbours;
  surface::SigmaRule sigma_rule = surface::SigmaRule::ra;  ///< is Ra (Sa) or Rq (Sq) used as sigma?
  std::optional<double> angle_rad;            ///< slopes and curvatures of a map at this angle to x are reported, too
  std::optional<double> hardness;             ///< hardness of the softer face of a pair, for the law of its case [Pa]
  CarryingPart liner = CarryingPart::kWhole;  ///< what carries of the liner of a pair
  std::optional<double> ratio_depth_m;        ///< depth of the material ratio Rmr below that at 5 %; absent: 1 um
  StandardSurfaces standard_surfaces = StandardSurfaces::kSfAndSl;  ///< reported of a map
  std::optional<double> cavity_depth_m;  ///< what lies deeper below the median is a cavity; absent: 3 sigma rule
};

/// A surface file after form and filters.
struct PreparedSurface {
  SurfaceOrigin origin;           ///< file, channel, and what the user stated
  std::string plausibility_line;  ///< plausibility of the map as it was read
  surface::HeightMap map;         ///< form removed, filtered
  surface::HeightMap middle;      ///< part of it, form removed, not filtered: for what is worked out again and again
  surface::Prepared prepared;     ///< what was removed, and with which filters
  std::vector<surface::Region> regions;  ///< empty: the whole map
};

/// Level and filtered as the analysis states.
PreparedSurface prepare_surface(const SurfaceFile& file, const SurfaceAnalysis& analysis);

/// Measures of each region of a prepared surface, or of the whole map, less the moments of the instrument's noise.
/// @param noise moments of a flat that was prepared as the surface; nullptr: none
std::vector<surface::SurfaceMeasures> measures_of_regions(const PreparedSurface& surface,
                                                          const SurfaceAnalysis& analysis,
                                                          const surface::SpectralMoments* noise);

/// A surface made in two steps: the lines of its material ratio curve, and what its plateau brings into a pair.
struct PlateauMeasures {
  surface::ProbabilityRoughness curve;  ///< both lines
  double Sq_m = 0;                      ///< rms of the whole surface [m]
  double offset_m = 0;                  ///< mean plane of the plateau above that of the whole surface [m]
  surface::SpectralMoments moments;     ///< spectral moments of what lies above the meeting of both lines
};

/// Plateau of one map with these lines of its material ratio curve. @param noise as of measures_of_regions()
PlateauMeasures plateau_measures(const surface::HeightMap& map, const surface::ProbabilityRoughness& curve,
                                 const SurfaceAnalysis& analysis, const surface::SpectralMoments* noise);

/// Plateaus of the regions of a prepared surface, or of the whole map. Throws InputError where one has none.
/// @param noise as of measures_of_regions()
std::vector<PlateauMeasures> plateaus_of_regions(const PreparedSurface& surface, const SurfaceAnalysis& analysis,
                                                 const surface::SpectralMoments* noise);

/// Moments of a flat after the same form and filters; in place of a cylinder its tilt comes off. Throws InputError
/// where its step differs from the surface's.
surface::SpectralMoments noise_moments(const SurfaceFile& flat, const PreparedSurface& surface,
                                       const SurfaceAnalysis& analysis);

/// Lines that state where a map came from: file, format, channel, plausibility, digest, what the user stated.
std::vector<std::string> source_lines(const PreparedSurface& surface);

/// Which filter and pixel the numbers hold for, e.g. "S-filter 2.5 um; pixel 0.5 um".
std::string measured_with(const PreparedSurface& surface);
/// The same of any map. @param prepared what was done with the map
std::string measured_with(const surface::Prepared& prepared, const surface::HeightMap& map);

/// Everything that is reported of one surface. Throws InputError where the analysis refuses it.
/// @param flat the instrument's noise; nullptr: not removed
io::Measurement surface_measurement(const SurfaceFile& file, const SurfaceAnalysis& analysis, const SurfaceFile* flat);

/// Mean and covariance of N, beta and sigma over files and regions of one surface; two files or more.
io::Measurement surfaces_measurement(const std::vector<SurfaceFile>& files, const SurfaceAnalysis& analysis,
                                     const SurfaceFile* flat);

/// N, beta and sigma of two surfaces in contact with their scatter, and the fragment for a case. Each side may have
/// several files, each of them several regions. Throws InputError also for sigma made of Ra with a hardness or a
/// plateau, and for a liner without the plateau that was asked for.
io::Measurement pair_measurement(const std::vector<SurfaceFile>& ring, const std::vector<SurfaceFile>& liner,
                                 const SurfaceAnalysis& analysis, const SurfaceFile* flat);

}  // namespace ringfilm::instrument
