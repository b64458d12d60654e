#pragma once
#include <optional>

#include "ringfilm/models/section/section_forms.hpp"

namespace ringfilm::cycle {

/// `ring.section_form`: sections by name (docs/theory/ring-section.md).
enum class SectionForm {
  kNone,         ///< not stated, or by its corners
  kRectangular,  ///< as high as the face is wide, unless stated otherwise
  kInnerBevel,   ///< without an inner corner
  kNapier,       ///< with a step below the face
  kTaper,        ///< with an inclined face
  kKeystone      ///< lower at the back than at the face
};

/// `ring.twist`: does the section turn over the cycle?
enum class RingTwist {
  kNone,        ///< it does not
  kQuasiStatic  ///< by the balance of moments in each step, and the face with it
};

/// The keys under `ring` that state its section.
struct RingSection {
  models::SectionPolygon corners;         ///< corners of a polygon; empty: by its form, or not stated [m]
  SectionForm form = SectionForm::kNone;  ///< form of the section, in place of corners
  std::optional<double> height;           ///< along the bore's axis; absent: the face and what is below it [m]
  // form = kInnerBevel
  double bevel_width = 0;                                          ///< along the flank [m]
  double bevel_angle_deg = 45;                                     ///< against the flank; usual, assumed [degree]
  models::SectionSide bevel_side = models::SectionSide::kChamber;  ///< corner that is cut off
  // form = kNapier
  double step_height = 0;  ///< along the bore's axis [m]
  double step_depth = 0;   ///< radial [m]
  // form = kTaper and kNapier
  double taper_angle_deg = 0;  ///< angle of the face against the bore's axis [degree]
  // form = kKeystone
  double keystone_angle_deg = 0;                                   ///< between both flanks [degree]
  models::SectionSide keystone_side = models::SectionSide::kBoth;  ///< inclined flanks

  RingTwist twist = RingTwist::kQuasiStatic;  ///< used where the section is stated
  std::optional<double> groove_height;        ///< height of the groove; absent: not known [m]
  /// How far the face stood out of the piston land where the side clearance of a keystone ring was measured; absent:
  /// as far as in the bore [m].
  std::optional<double> clearance_protrusion;

  bool is_stated() const { return !corners.empty() || form != SectionForm::kNone; }  ///< by corners or by its form
};

}  // namespace ringfilm::cycle
