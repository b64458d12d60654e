#include "ringfilm/cycle/setup/ring_section.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/models/ring.hpp"

namespace ringfilm::cycle {
namespace {

/// By how much the side clearance grows as the ring moves outwards: sum of the slopes of its inclined flanks [-].
double clearance_slope(const RingSection& section) {
  if (section.form != SectionForm::kKeystone) return 0;
  const double angle = radians(section.keystone_angle_deg);
  return section.keystone_side == models::SectionSide::kBoth ? 2 * std::tan(angle / 2) : std::tan(angle);
}

}  // namespace

double section_height(const Ring& ring) {
  const RingSection& section = ring.section;
  if (section.corners.size() > 2) return models::section_extent(section.corners).height();
  const double step = section.form == SectionForm::kNapier ? section.step_height : 0;
  return section.height.value_or(ring.face_width + step);
}

models::SectionPolygon section_polygon(const Ring& ring) {
  const RingSection& section = ring.section;
  if (!section.corners.empty()) return section.corners;
  if (!ring.radial_thickness) return {};
  const double height = section_height(ring), thickness = *ring.radial_thickness;
  const double taper = radians(section.taper_angle_deg), keystone = radians(section.keystone_angle_deg);
  switch (section.form) {
    case SectionForm::kNone:
      break;
    case SectionForm::kRectangular:
      return models::rectangular_section(height, thickness);
    case SectionForm::kInnerBevel:
      return models::bevelled_section(height, thickness, section.bevel_width, radians(section.bevel_angle_deg),
                                      section.bevel_side);
    case SectionForm::kNapier:
      return models::napier_section(height, thickness, section.step_height, section.step_depth, taper);
    case SectionForm::kTaper:
      return models::tapered_section(height, thickness, taper);
    case SectionForm::kKeystone:
      return models::keystone_section(height, thickness,
                                      section.keystone_side == models::SectionSide::kBoth ? keystone / 2 : keystone,
                                      section.keystone_side);
  }
  return {};
}

std::optional<models::SectionArea> stated_section(const Ring& ring) {
  const models::SectionPolygon polygon = section_polygon(ring);
  if (polygon.empty()) return std::nullopt;
  return models::section_area(polygon);
}

double second_moment_in_plane(const models::SectionArea& section) {
  return section.radial - section.product * section.product / section.axial;
}

std::optional<double> side_clearance(const Ring& ring) {
  std::optional<double> clearance = ring.gas_path.side_clearance;
  if (!clearance && ring.section.groove_height) clearance = *ring.section.groove_height - section_height(ring);
  if (clearance && ring.section.clearance_protrusion) {
    const double moved = ring.gas_path.land_clearance.value_or(0) - *ring.section.clearance_protrusion;
    *clearance += moved * clearance_slope(ring.section);
  }
  return clearance;
}

std::optional<double> stated_tangential_force(const Case& c) {
  const Ring& ring = c.ring;
  if (ring.tangential_force) return ring.tangential_force;
  if (!(ring.face_width > 0)) return std::nullopt;
  if (!ring.elastic_pressure && !ring.expander_force && !ring.free_gap && !ring.free_shape) return std::nullopt;
  return models::tangential_force_from_elastic_pressure(elastic_pressure(c), ring.face_width, c.engine.bore);
}

models::TwistingRing twisting_ring(const Case& c) {
  models::TwistingRingSize size;
  size.section = section_polygon(c.ring);
  size.bore = c.engine.bore;
  size.youngs_modulus = c.ring.youngs_modulus;
  size.tangential_force = stated_tangential_force(c).value_or(0);
  size.face_width = c.ring.face_width;
  size.land_clearance = c.ring.gas_path.land_clearance.value_or(0);
  size.side_clearance = side_clearance(c.ring).value_or(std::numeric_limits<double>::infinity());
  return models::TwistingRing(size);
}

double section_mass(const Case& c) {
  const RingGasPath& gas = c.ring.gas_path;
  if (gas.mass) return *gas.mass;
  if (!gas.density) return 0;
  const models::TwistingRing ring = twisting_ring(c);
  return *gas.density * ring.area().area * 2 * std::numbers::pi * ring.centroid_radius();
}

std::optional<SectionValues> section_values(const Case& c) {
  const models::SectionPolygon polygon = section_polygon(c.ring);
  if (polygon.empty()) return std::nullopt;
  const models::TwistingRing ring = twisting_ring(c);
  SectionValues values;
  values.area = ring.area();
  values.axes = models::principal_axes(ring.area());
  values.torsion = models::torsion_constant(polygon);
  values.centroid_radius = ring.centroid_radius();
  values.twist_stiffness = ring.stiffness();
  if (!stated_tangential_force(c)) return values;
  values.assembly_couple = ring.assembly_couple();
  values.assembly_twist = ring.assembly_twist();
  return values;
}

const std::vector<SectionQuantity>& section_quantities() {
  using V = SectionValues;
  using Value = std::optional<double>;
  static const std::vector<SectionQuantity> table = {
      {{"section_area", "m2", "mm2", "area of the section", "A", "eq-section-area"},
       [](const V& v) -> Value { return v.area.area; }},
      {{"section_centroid_axial", "m", "mm", "centroid, axial from the chamber side", "a_c", "eq-section-area"},
       [](const V& v) -> Value { return v.area.centroid.axial; }},
      {{"section_centroid_radial", "m", "mm", "centroid, radial from the face inwards", "rho_c", "eq-section-area"},
       [](const V& v) -> Value { return v.area.centroid.radial; }},
      {{"section_second_moment_axial", "m4", "mm4", "second moment of the axial distance from the centroid", "I_aa",
        "eq-section-moments"},
       [](const V& v) -> Value { return v.area.axial; }},
      {{"section_second_moment_radial", "m4", "mm4", "second moment of the radial distance from the centroid", "I_rr",
        "eq-section-moments"},
       [](const V& v) -> Value { return v.area.radial; }},
      {{"section_second_moment_product", "m4", "mm4", "product of inertia about the centroid", "I_ar",
        "eq-section-moments"},
       [](const V& v) -> Value { return v.area.product; }},
      {{"section_principal_angle", "rad", "degree", "angle of the long principal axis against the radial one", "beta",
        "eq-section-principal"},
       [](const V& v) -> Value { return v.axes.angle; }},
      {{"section_torsion_constant", "m4", "mm4", "torsion constant", "J", "eq-section-torsion"},
       [](const V& v) -> Value { return v.torsion.value; }},
      {{"section_torsion_lower_bound", "m4", "mm4", "lower bound of the torsion constant", "J_-",
        "eq-section-torsion-lower"},
       [](const V& v) -> Value { return v.torsion.lower; }},
      {{"section_torsion_upper_bound", "m4", "mm4", "upper bound of the torsion constant", "J_+",
        "eq-section-torsion-upper"},
       [](const V& v) -> Value { return v.torsion.upper; }},
      {{"section_twist_stiffness", "N m/rad", "N m/rad", "moment per twist of the closed ring", "K",
        "eq-section-stiffness"},
       [](const V& v) -> Value { return v.twist_stiffness; }},
      {{"section_assembly_couple", "N", "N", "couple per length that would hold the closed ring flat", "m_0",
        "eq-section-assembly-couple"},
       [](const V& v) -> Value { return v.assembly_couple; }},
      {{"section_assembly_twist", "rad", "degree", "twist by closing the ring", "vartheta_0",
        "eq-section-assembly-twist"},
       [](const V& v) -> Value { return v.assembly_twist; }}};
  return table;
}

}  // namespace ringfilm::cycle
