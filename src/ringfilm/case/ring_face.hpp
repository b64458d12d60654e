#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case_choices.hpp"

/// The running face of a ring as a case states it.
namespace ringfilm::cycle {

/// Where a face came from; recorded, and not used by any model.
struct MeasuredFace {
  std::optional<std::string> trace;         ///< file of the trace
  std::optional<double> width;              ///< that the face was fitted over; the ring must have it [m]
  std::optional<std::string> levelling;     ///< how its tilt was removed
  std::optional<double> residual_rms;       ///< rms distance of trace and face [m]
  std::optional<double> largest_residual;   ///< largest distance of trace and face [m]
  std::optional<std::string> fit_artifact;  ///< where the face has what the trace has not
};

/// Shape of a face by a formula: the keys that `ring.face` and `pad.face` share.
struct FaceShape {
  FaceForm form{};  ///< how h_s(x), the gap to a straight surface, is given
  // form = "polynomial": height [height_unit] = sum of coefficients[k] x^(n-1-k), x in [length_unit]
  std::vector<double> coefficients = {};  ///< highest power first
  double length_unit = 0;                 ///< unit of x in the polynomial [m]
  double height_unit = 0;                 ///< unit of the height in the polynomial [m]
  // form = "parabola" or "cosine"
  double crown_height = 0;  ///< rise of the parabola at the farther edge, of the cosine to its highest point [m]
  double apex = 0.5;        ///< place of the lowest point, fraction of the way from x = 0 to the other edge [-]
};

/// The keys under `ring.face`, with the points that they name.
struct RingFace : FaceShape {
  HeightZero height_zero = HeightZero::kMinimum;      ///< zero of the stored heights; the film has the true gap in both
  Orientation orientation = Orientation::kX0Chamber;  ///< the edge at x = 0: a ring-fixed one, or the leading one
  // form = "points"
  std::string points_file;     ///< CSV of measured points, as named
  std::vector<double> x;       ///< [m], increasing, covers 0 to the face width
  std::vector<double> height;  ///< h_s at x, low where the ring comes next to the liner [m]
  MeasuredFace measured;       ///< measurement behind a face that was fitted to a trace
};

/// What covers the face of the ring. Contact spots are far smaller than usual coatings are thick.
struct Coating {
  std::optional<double> youngs_modulus;  ///< [Pa]; absent: no coating
  double poissons_ratio = 0;             ///< Poisson's ratio of the coating [-]
  std::optional<double> thickness;       ///< coating thickness; absent: not known, and no note on what lies below [m]
  ContactModulus contact_modulus = ContactModulus::kCoating;  ///< whose modulus the contact spots feel
};

}  // namespace ringfilm::cycle
