#pragma once
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/case/case.hpp"

/// What measured faces alone state about wear: bounds under "material only disappears" (docs/theory/life.md).
namespace ringfilm::life {

/// Heights of a face at places over its width, above its lowest point.
struct FaceHeights {
  std::vector<double> x;       ///< from 0 to the width, increasing [m]
  std::vector<double> height;  ///< gap to a straight line [m]

  double width() const { return x.back(); }
};

/// The face of a case as installed (leading-edge: as given), at places that all faces of one width have in common.
/// @param zero of the heights: the lowest point, or that of the input
FaceHeights face_heights(const cycle::Case& c, cycle::HeightZero zero = cycle::HeightZero::kMinimum);

/// Where a face gained most material since another of the same datum.
struct Gain {
  double x = 0;       ///< [m]
  double height = 0;  ///< [m]; not above 0: nowhere
};
Gain largest_gain(const FaceHeights& earlier, const FaceHeights& later);

FaceHeights turned(const FaceHeights& face);  ///< x -> b - x

/// May the later face be tilted against the earlier one? A scan does not keep the direction of the ring.
enum class Tilt { kNone, kFree };

/// Area below heights or depths at increasing places, by the trapezoidal rule [m2].
double area_under(const std::vector<double>& x, const std::vector<double>& y);

/// Worn area that counts as nothing, 1e-6 um mm: below the round-off of a bound [m2].
inline constexpr double kNegligibleArea = 1e-15;

/// The least wear between two faces of which no place gained material, eq-life-bound.
struct WearBound {
  double margin = 0;           ///< margin at each edge of the face that is not trusted [m]
  double depth_at_middle = 0;  ///< least worn depth at the middle of the face [m]
  double largest_depth = 0;    ///< largest worn depth of the trusted part [m]
  double area = 0;             ///< worn area over the trusted part [m2]
  double tilt = 0;             ///< tilt of the later face, about the middle [rad]
};

/// The members of a bound, as all outputs have them.
constexpr auto members(const WearBound*) {
  return std::tuple{
      Member{"untrusted_margin", "m", "margin at each edge that is not trusted", &WearBound::margin},
      Member{"depth_at_middle", "m", "least worn depth at the middle of the face", &WearBound::depth_at_middle},
      Member{"largest_worn_depth", "m", "largest worn depth of the trusted part", &WearBound::largest_depth},
      Member{"worn_area", "m2", "least worn area of the trusted part", &WearBound::area},
      Member{"tilt", "rad", "tilt of the later face", &WearBound::tilt}};
}

/// @param margin at each edge that is not trusted, below half of the width [m]
WearBound least_wear(const FaceHeights& earlier, const FaceHeights& later, double margin, Tilt tilt);

/// Shares of the width at each edge that bounds do not use, from nothing to the outer quarter: chamfers and the ends of
/// polynomials lie there.
const std::vector<double>& trusted_margins();

/// A stretch that no straight liner touches at any tilt: the face lies above its lower convex hull there.
struct ConcaveStretch {
  double from = 0, to = 0;  ///< [m]
  double height = 0;        ///< largest above the hull [m]
};
/// Those of at least `least` [m] above the hull, from x = 0 on.
std::vector<ConcaveStretch> concave_stretches(const FaceHeights& face, double least);

}  // namespace ringfilm::life
