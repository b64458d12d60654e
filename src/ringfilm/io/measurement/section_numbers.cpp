#include "ringfilm/io/measurement/section_numbers.hpp"

#include <cmath>
#include <optional>

namespace ringfilm::io {

std::vector<SectionNumbers> section_numbers(const cycle::SectionValues& section) {
  const models::SectionArea& of = section.area;
  std::vector<SectionNumbers> numbers = {{"area", "m2", {of.area}},
                                         {"centroid", "m", {of.centroid.axial, of.centroid.radial}},
                                         {"second_moments", "m4", {of.axial, of.radial, of.product}},
                                         {"principal_moments", "m4", {section.axes.largest, section.axes.smallest}},
                                         {"principal_angle", "rad", {section.axes.angle}},
                                         {"torsion_constant", "m4", {section.torsion.value}},
                                         {"torsion_bounds", "m4", {section.torsion.lower, section.torsion.upper}},
                                         {"centroid_radius", "m", {section.centroid_radius}},
                                         {"twist_stiffness", "N m/rad", {section.twist_stiffness}}};
  if (section.assembly_couple) numbers.push_back({"assembly_couple", "N", {*section.assembly_couple}});
  if (section.assembly_twist) numbers.push_back({"assembly_twist", "rad", {*section.assembly_twist}});
  return numbers;
}

MeasuredGroup section_group(const cycle::SectionValues& section) {
  MeasuredGroup group{"Section", {}};
  for (const cycle::SectionQuantity& one : cycle::section_quantities()) {
    const std::optional<double> value = one.value(section);
    if (!value) continue;
    group.values.push_back({one.name, one.long_name, one.symbol, one.unit, one.display_unit, *value, std::nan(""), ""});
  }
  return group;
}

}  // namespace ringfilm::io
