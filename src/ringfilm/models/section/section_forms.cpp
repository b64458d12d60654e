#include "ringfilm/models/section/section_forms.hpp"

#include <cmath>

namespace ringfilm::models {

SectionPolygon rectangular_section(double height, double thickness) {
  return {{0, 0}, {height, 0}, {height, thickness}, {0, thickness}};
}

SectionPolygon bevelled_section(double height, double thickness, double width, double angle, SectionSide side) {
  const double depth = width * std::tan(angle);
  SectionPolygon section{{0, 0}, {height, 0}};
  if (side == SectionSide::kChamber) {
    section.push_back({height, thickness});
  } else {
    section.push_back({height, thickness - width});
    section.push_back({height - depth, thickness});
  }
  if (side == SectionSide::kCrankcase) {
    section.push_back({0, thickness});
  } else {
    section.push_back({depth, thickness});
    section.push_back({0, thickness - width});
  }
  return section;
}

SectionPolygon napier_section(double height, double thickness, double step_height, double step_depth, double taper) {
  const double face = height - step_height;
  return {{0, face * std::tan(taper)}, {face, 0},           {face, step_depth},
          {height, step_depth},        {height, thickness}, {0, thickness}};
}

SectionPolygon tapered_section(double height, double thickness, double taper) {
  return {{0, height * std::tan(taper)}, {height, 0}, {height, thickness}, {0, thickness}};
}

SectionPolygon keystone_section(double height, double thickness, double angle, SectionSide side) {
  const double rise = thickness * std::tan(angle);
  const double upper = side == SectionSide::kCrankcase ? 0 : rise, lower = side == SectionSide::kChamber ? 0 : rise;
  return {{0, 0}, {height, 0}, {height - lower, thickness}, {upper, thickness}};
}

}  // namespace ringfilm::models
