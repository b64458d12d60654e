#include "ringfilm/cycle/setup/free_ring.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "ringfilm/cycle/setup/ring_section.hpp"

namespace ringfilm::cycle {

models::RingBeamSize beam_size(const Case& c) {
  models::RingBeamSize size;
  size.bore = c.engine.bore;
  size.face_width = c.ring.face_width;
  size.radial_thickness = c.ring.thickness().value();
  size.youngs_modulus = c.ring.youngs_modulus;
  size.end_gap = c.ring.end_gap.value_or(0);
  const models::SectionPolygon polygon = section_polygon(c.ring);
  if (polygon.empty()) return size;
  const models::SectionArea section = models::section_area(polygon);
  size.section_centroid = section.centroid.radial - models::section_extent(polygon).low.radial;
  size.section_second_moment = second_moment_in_plane(section);
  return size;
}

int orders_of_free_ring(const Case& c) {
  constexpr int kMany = 10000;
  constexpr double kRounding = 1e-9;
  const double circumference = std::numbers::pi * (c.engine.bore - c.ring.thickness().value());
  return static_cast<int>(std::fmin(kMany, circumference / c.ring.free_shape_smoothing * (1 + kRounding)));
}

models::FreeShapeFit free_ring(const Case& c) {
  std::vector<models::ShapePoint> points;
  for (std::size_t i = 0; i < c.ring.free_ring->radius.size(); ++i) {
    const double angle = c.ring.free_ring->angle_deg[i] * std::numbers::pi / 180, r = c.ring.free_ring->radius[i];
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return models::target_of_free_shape(beam_size(c), points, orders_of_free_ring(c));
}

}  // namespace ringfilm::cycle
