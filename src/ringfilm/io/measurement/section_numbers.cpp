#include "ringfilm/io/measurement/section_numbers.hpp"

#include <cmath>

#include "ringfilm/base/number_text.hpp"

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
  const models::SectionArea& of = section.area;
  MeasuredGroup group{"Section", {}};
  const auto add = [&](const char* name, const char* long_name, const char* symbol, const char* unit,
                       const char* display_unit, double value) {
    group.values.push_back({name, long_name, symbol, unit, display_unit, value, std::nan(""), ""});
  };
  add("section_area", "area of the section", "A", "m2", "mm2", of.area);
  add("section_centroid_axial", "centroid, axial from the chamber side", "a_c", "m", "mm", of.centroid.axial);
  add("section_centroid_radial", "centroid, radial from the face inwards", "rho_c", "m", "mm", of.centroid.radial);
  add("section_second_moment_axial", "second moment of the axial distance", "I_aa", "m4", "mm4", of.axial);
  add("section_second_moment_radial", "second moment of the radial distance", "I_rr", "m4", "mm4", of.radial);
  add("section_second_moment_product", "product of both distances", "I_ar", "m4", "mm4", of.product);
  add("section_torsion_constant", "torsion constant", "J", "m4", "mm4", section.torsion.value);
  group.values.back().remark =
      "between bounds " + number_text(1e6 * (section.torsion.upper / section.torsion.lower - 1)) + " ppm apart";
  add("section_twist_stiffness", "moment per twist of the closed ring", "K", "N m/rad", "N m/rad",
      section.twist_stiffness);
  if (section.assembly_couple) {
    add("section_assembly_couple", "couple per length that would hold the closed ring flat", "m_0", "N", "N",
        *section.assembly_couple);
  }
  if (section.assembly_twist) {
    add("section_assembly_twist", "twist by closing the ring", "vartheta_0", "rad", "degree", *section.assembly_twist);
  }
  return group;
}

}  // namespace ringfilm::io
