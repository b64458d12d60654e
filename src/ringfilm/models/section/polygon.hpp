#pragma once
#include <cstddef>
#include <optional>
#include <vector>

/// The section of a ring as a polygon (docs/theory/ring-section.md).
namespace ringfilm::models {

/// A corner of the section: axial from the chamber side, radial from the face inwards.
struct SectionPoint {
  double axial = 0;   ///< a [m]
  double radial = 0;  ///< rho [m]
  friend bool operator==(const SectionPoint&, const SectionPoint&) = default;
};
using SectionPolygon = std::vector<SectionPoint>;

/// Area, centroid and second moments of a section, eq-section-area and eq-section-moments.
struct SectionArea {
  double area = 0;        ///< A [m2]
  SectionPoint centroid;  ///< [m]
  double axial = 0;       ///< I_aa, of the squared axial distance from the centroid [m4]
  double radial = 0;      ///< I_rr, of the squared radial distance [m4]
  double product = 0;     ///< I_ar, of the product of both distances [m4]
};

/// @param section a simple polygon, in either sense
SectionArea section_area(const SectionPolygon& section);

/// Principal axes of a section about its centroid, eq-section-principal.
struct PrincipalAxes {
  double largest = 0;   ///< larger principal second moment [m4]
  double smallest = 0;  ///< smaller one [m4]
  double angle = 0;     ///< from the radial axis to the axis along which the section is longest, -pi/2 to pi/2 [rad]
};
PrincipalAxes principal_axes(const SectionArea& section);

/// Extent of a section from the smallest to the largest coordinates of its corners.
struct SectionExtent {
  SectionPoint low, high;                                        ///< [m]
  double height() const { return high.axial - low.axial; }       ///< along the axis of the bore [m]
  double thickness() const { return high.radial - low.radial; }  ///< radial thickness t [m]
};
SectionExtent section_extent(const SectionPolygon& section);

/// Why a polygon is not a section.
enum class PolygonFault {
  kFewCorners,      ///< fewer than three
  kRepeatedCorner,  ///< two corners in a row, or the last and the first, are the same
  kNoArea,          ///< all corners lie on a line
  kOverlaps         ///< two sides cross or touch
};
struct FaultOfPolygon {
  PolygonFault fault{};
  std::size_t first = 0, second = 0;  ///< corners, or first corners of the sides that it is about, from 0
};
/// The first fault of a polygon; nothing: it is simple and has an area.
std::optional<FaultOfPolygon> polygon_fault(const SectionPolygon& section);

/// The polygon from the first corner on, its area positive in (axial, radial), without corners on straight sides.
SectionPolygon normalized(const SectionPolygon& section);

}  // namespace ringfilm::models
