#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/surface/face/face_fit.hpp"
#include "ringfilm/surface/friction_loop/lateral_force.hpp"

/// Pieces of a case file that measurements make; a case reads them with include = ["surface.toml"]. Names of keys come
/// from the table of keys, values are written in the units people use with 8 digits, and the case reader reads them.
namespace ringfilm::io {

/// N, beta and sigma of a pair of surfaces with how they were measured.
struct PairOfSurfaces {
  double asperity_density = 0;  ///< [1/m2]
  double asperity_radius = 0;   ///< [m]
  double roughness = 0;         ///< [m]
  cycle::RoughnessMeasure roughness_measure = cycle::RoughnessMeasure::kAsGiven;
  std::optional<cycle::Plateau> plateau;  ///< in place of the roughness, of ring and plateau
  std::optional<double> hardness;         ///< with which the law counts from the summits, which flow [Pa]
  cycle::MeasuredContact measured;        ///< without the shear strength, which another fragment brings
};

/// `[contact]` asperity_density, asperity_radius, roughness, roughness_measure and `[contact.measured]`; with a
/// hardness the law of new cases, too: model, asperity, summit_plane, hardness; with a plateau `[contact.plateau]` in
/// place of the roughness.
/// @param heading what people should know, put in front as comments, line by line
std::string contact_fragment(const PairOfSurfaces& pair, const std::vector<std::string>& heading);

/// `[contact.plateau]` Rpq, Rvq, Rmq, surface_roughness and offset of one surface.
std::string plateau_fragment(const cycle::Plateau& plateau, const std::vector<std::string>& heading);

/// `[contact]` model = "table" and law, with the flow through the same gap in `[film]`.
/// @param law_name file of the law, relative to the fragment
std::string contact_law_fragment(const std::string& law_name, const std::vector<std::string>& heading);

/// `[ring.face]` as a polynomial, with `[ring.face.measured]`.
/// @param trace_name file of the trace, for the record
std::string face_polynomial_fragment(const surface::FaceFit& fit, const surface::FaceRule& rule,
                                     const std::string& trace_name, const std::vector<std::string>& heading);

/// `[ring.face]` as points of the spline, which are in `points_file`, relative to the fragment.
std::string face_points_fragment(const surface::FaceFit& fit, const surface::FaceRule& rule,
                                 const std::string& trace_name, const std::string& points_file,
                                 const std::vector<std::string>& heading);

/// The spline of a face as the CSV file that `ring.face.file` names: x [mm],height [um].
std::string face_points_csv(const surface::FaceFit& fit);

/// `[contact]` boundary_shear_strength_coefficient and `[contact.measured.shear_strength]`.
/// @param calibration_name one name for all samples that were measured with it
std::string shear_strength_fragment(const surface::ShearStrength& strength, const std::string& loops_name,
                                    surface::CalibrationMethod method, const std::string& calibration_name,
                                    const std::vector<std::string>& heading);

}  // namespace ringfilm::io
