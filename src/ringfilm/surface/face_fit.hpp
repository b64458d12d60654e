#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/surface/face_polynomial.hpp"
#include "ringfilm/surface/face_spline.hpp"
#include "ringfilm/surface/topography.hpp"

/// A measured trace over a ring face to the shape that a case wants (docs/theory/face.md).
namespace ringfilm::surface {

/// Which way the heights of a trace count.
enum class HeightSense {
  kMaterial,  ///< heights count away from the ring, as a stylus has them: the land is high
  kGap        ///< heights are the gap to a straight liner, as in a case: the land is low
};

/// How the tilt of the holder is taken off.
enum class FaceLevelling {
  kNone,    ///< as measured
  kStated,  ///< the stated tilt is taken off
  kLand     ///< the line through the land is made level
};

enum class FaceDirection { kAsMeasured, kTurned };  ///< turned: x = 0 is the end of the trace
enum class FaceZero { kLowestPoint, kAsMeasured };  ///< where the face has its height zero

/// What a trace does not tell, and what may be stated about its fit.
struct FaceRule {
  HeightSense sense{};
  double width_m = 0;             ///< of the face, b [m]
  std::optional<double> start_m;  ///< where the face begins in the trace [m]; absent: where its mean gap is least
  FaceDirection direction = FaceDirection::kAsMeasured;
  FaceLevelling levelling = FaceLevelling::kLand;
  double tilt = 0;  ///< slope of the gap to take off, of kStated [-]
  FaceZero zero = FaceZero::kLowestPoint;
  double land_height_m = 1e-6;  ///< the land is where the gap is at most this above its least [m]
  /// Points that lie deeper than the spline by more than this are pores and left out [m]; absent: none is.
  std::optional<double> pore_depth_m;
  std::optional<double> spline_cutoff_m;  ///< stiffness of the spline [m]; absent: a tenth of the width
  int degree = 6;
};

/// Residuals of a fit: trace less fit.
struct FaceResidual {
  double rms_m = 0, largest_m = 0, largest_at_m = 0;
};

/// Why a shape counts as invented.
enum class InventionReason {
  kDeparts,             ///< polynomial and trace lie apart by more than the noise
  kTurnNotInTrace,      ///< the polynomial's gap falls there, that of the trace does not
  kFallsTowardsTheEdge  ///< both fall towards the edge, as no worn ring against a straight liner does
};

/// A stretch where the polynomial has a shape that the trace has not.
struct InventedShape {
  double from_m = 0, to_m = 0;
  InventionReason reason{};
  double size_m = 0;  ///< largest distance, or fall [m]

  std::string words() const;  ///< the same as a sentence
};

/// A face: polynomial and spline through a trace, and how far they are from it.
struct FaceFit {
  std::vector<double> x_m;    ///< from 0 to the width [m]
  std::vector<double> gap_m;  ///< of the trace, levelled and aligned [m]
  double start_m = 0;         ///< place in the trace that became x = 0, or x = b where turned
  double tilt = 0;            ///< taken off [-]
  double land_from_m = 0, land_to_m = 0;
  FacePolynomial polynomial;
  std::vector<double> spline_m;  ///< at x_m
  double spline_cutoff_m = 0;
  FaceResidual polynomial_residual, spline_residual;
  double polynomial_minimum_m = 0, polynomial_minimum_at_m = 0;
  double spline_minimum_m = 0, spline_minimum_at_m = 0;
  double polynomial_end_m[2] = {0, 0}, spline_end_m[2] = {0, 0};  ///< at x = 0 and b, above the minimum of each [m]
  double noise_m = 0;  ///< rms of what neither polynomial nor spline follows [m]
  std::vector<InventedShape> invented;
  double pore_share = 0;  ///< of the points, left out as pores [-]
  int averaged = 1;       ///< neighbouring points of the trace that were averaged into one
};

/// Throws InputError for a trace that does not cover the width, places that do not rise, NaN, too few points, and
/// stiffness or degree out of range.
FaceFit fit_face(const Trace& trace, const FaceRule& rule);

}  // namespace ringfilm::surface
