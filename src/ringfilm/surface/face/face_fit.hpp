#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/surface/face/face_polynomial.hpp"
#include "ringfilm/surface/face/face_spline.hpp"
#include "ringfilm/surface/topography/topography.hpp"

/// A measured trace over a ring face to the shape that a case requires (docs/theory/face.md).
namespace ringfilm::surface {

/// Which way the heights of a trace count.
enum class HeightSense {
  kMaterial,  ///< heights count away from the ring, as a stylus has them: the running surface is high
  kGap        ///< heights are the gap to a straight liner, as in a case: the running surface is low
};

/// How the tilt of the holder is removed.
enum class FaceLevelling {
  kNone,           ///< as measured
  kStated,         ///< the stated tilt is removed
  kRunningSurface  ///< the line through the running surface is made level
};

/// Which end of the face is x = 0.
enum class FaceDirection {
  kAsMeasured,  ///< the one where the trace begins
  kTurned       ///< the one where it ends
};

/// Where the face has its height zero.
enum class FaceZero {
  kMinPoint,   ///< at the lowest point of the smoothed gap
  kAsMeasured  ///< where the trace has it
};

/// What a trace does not show, and what may be stated about its fit.
struct FaceRule {
  HeightSense sense{};            ///< which way the heights of the trace count
  double width_m = 0;             ///< width of the face, b [m]
  std::optional<double> start_m;  ///< where the face begins in the trace [m]; absent: where its mean gap is least
  FaceDirection direction = FaceDirection::kAsMeasured;      ///< which end of the trace becomes x = 0
  FaceLevelling levelling = FaceLevelling::kRunningSurface;  ///< how the tilt of the holder is removed
  double tilt = 0;                                           ///< slope of the gap to remove, of kStated [-]
  FaceZero zero = FaceZero::kMinPoint;                       ///< zero of the heights; the film does not depend on it
  double running_surface_height_m = 1e-6;  ///< the running surface is where the gap is at most this above its least [m]
  /// Points that lie deeper than the spline by more than this are pores and omitted [m]; absent: none is.
  std::optional<double> pore_depth_m;
  std::optional<double> spline_cutoff_m;  ///< stiffness of the spline [m]; absent: a tenth of the width
  int degree = 6;                         ///< degree of the polynomial
};

/// Residuals of a fit: trace less fit.
struct FaceResidual {
  double rms_m = 0;         ///< over the points [m]
  double largest_m = 0;     ///< largest either way, positive where the trace has the wider gap [m]
  double largest_at_m = 0;  ///< x of it [m]
};

/// Why a shape counts as invented.
enum class InventionReason {
  kDeparts,             ///< polynomial and trace lie apart by more than the noise
  kTurnNotInTrace,      ///< the polynomial's gap falls there, that of the trace does not
  kFallsTowardsTheEdge  ///< both fall towards the edge, as no worn ring against a straight liner does
};

/// A stretch where the polynomial has a shape that the trace has not.
struct FitArtifact {
  double from_m = 0;         ///< x where it begins [m]
  double to_m = 0;           ///< x where it ends [m]
  InventionReason reason{};  ///< what gives it away
  double size_m = 0;         ///< largest distance, or fall [m]

  std::string words() const;  ///< description of the artifact as a sentence
};

/// A face: polynomial and spline through a trace, and how far they are from it.
struct FaceFit {
  std::vector<double> x_m;              ///< from 0 to the width [m]
  std::vector<double> gap_m;            ///< face profile of the trace, levelled and aligned [m]
  double start_m = 0;                   ///< place in the trace that became x = 0, or x = b where turned
  double tilt = 0;                      ///< removed [-]
  double running_surface_from_m = 0;    ///< x where the running surface begins [m]
  double running_surface_to_m = 0;      ///< x where it ends [m]
  FacePolynomial polynomial;            ///< least-squares polynomial of `gap_m` over `x_m`
  std::vector<double> spline_m;         ///< smoothed gap at x_m [m]
  double spline_cutoff_m = 0;           ///< wavelength of which the spline lets half the amplitude through [m]
  FaceResidual polynomial_residual;     ///< trace less polynomial
  FaceResidual spline_residual;         ///< trace less spline
  double polynomial_minimum_m = 0;      ///< least gap of the polynomial, counted like `gap_m` [m]
  double polynomial_minimum_at_m = 0;   ///< x of it [m]
  double spline_minimum_m = 0;          ///< least gap of the spline, counted like `gap_m` [m]
  double spline_minimum_at_m = 0;       ///< x of it [m]
  double polynomial_end_m[2] = {0, 0};  ///< polynomial at x = 0 and b, above its minimum [m]
  double spline_end_m[2] = {0, 0};      ///< spline at x = 0 and b, above its minimum [m]
  double noise_m = 0;                   ///< rms of what neither polynomial nor spline follows [m]
  std::vector<FitArtifact> invented;    ///< from x = 0 on; empty: the polynomial has nothing that the trace has not
  double pore_share = 0;                ///< share of the points that are omitted as pores [-]
  int averaged = 1;                     ///< neighbouring points of the trace that were averaged into one
};

/// Throws InputError for a trace that does not cover the width, places that do not rise, NaN, too few points, and
/// stiffness or degree out of range.
FaceFit fit_face(const Trace& trace, const FaceRule& rule);

}  // namespace ringfilm::surface
