#pragma once
#include <optional>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/models/section/torsion.hpp"
#include "ringfilm/models/section/twisting_ring.hpp"

namespace ringfilm::cycle {

/// Height of the section along the bore's axis: that of its corners, as stated, or of the face and the step below it
/// [m].
double section_height(const Ring& ring);

/// The section of a ring as a polygon; empty where it is not stated, or lacks the radial thickness.
models::SectionPolygon section_polygon(const Ring& ring);

/// Area and moments of the section of a ring that states it; nothing: a rectangle of face width and thickness.
std::optional<models::SectionArea> stated_section(const Ring& ring);

/// Second moment for bending in the plane of a ring that is free to twist, eq-section-effective [m4].
double second_moment_in_plane(const models::SectionArea& section);

/// Side clearance of a ring as it is in the bore: as stated, or what the groove is higher than the section; of a
/// keystone ring larger by how far it comes out from where it was measured, eq-section-keystone. Nothing: not known
/// [m].
std::optional<double> side_clearance(const Ring& ring);

/// Tangential force that closes a ring; nothing: neither it nor what it follows from is stated [N].
std::optional<double> stated_tangential_force(const Case& c);

/// The ring of a case with a section as a body that twists; without a stated tension as if it had none.
models::TwistingRing twisting_ring(const Case& c);

/// Mass of a ring of this section: as stated, or that of its density; 0 where neither is stated [kg].
double section_mass(const Case& c);

/// Topic of the note on a section whose face does not turn in the film.
inline constexpr const char* kRingTwistOmitted = "ring-twist-omitted";

/// What outputs report of the section of a ring, in SI.
struct SectionValues {
  models::SectionArea area;
  models::PrincipalAxes axes;
  models::TorsionConstant torsion;
  double centroid_radius = 0;             ///< radius of the centroid of the ring in the bore [m]
  double twist_stiffness = 0;             ///< K of the closed ring [N m/rad]
  std::optional<double> assembly_couple;  ///< per length, that would hold the closed ring flat; nothing: no tension [N]
  std::optional<double> assembly_twist;   ///< twist by closing the ring; nothing: no tension is stated [rad]
};
/// Of a ring that states its section; nothing otherwise.
std::optional<SectionValues> section_values(const Case& c);

/// A value of a section and where `SectionValues` has it; nothing: it is not known.
struct SectionQuantity : Quantity {
  std::optional<double> (*value)(const SectionValues&);
};
const std::vector<SectionQuantity>& section_quantities();  ///< in the order of tables

}  // namespace ringfilm::cycle
