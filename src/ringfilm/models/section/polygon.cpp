#include "ringfilm/models/section/polygon.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::models {
namespace {

/// Twice the area of a triangle over the square of the section's size below which its corners lie on a line [-].
constexpr double kOnALine = 1e-12;
/// Product of inertia over the mean second moment that rounding leaves [-].
constexpr double kRoundedProduct = 1e-12;

/// Twice the signed area of a triangle [m2].
double cross(const SectionPoint& a, const SectionPoint& b, const SectionPoint& c) {
  return (b.axial - a.axial) * (c.radial - a.radial) - (b.radial - a.radial) * (c.axial - a.axial);
}

double squared_size(const SectionPolygon& section) {
  const SectionExtent extent = section_extent(section);
  return extent.height() * extent.height() + extent.thickness() * extent.thickness();
}

int side_of(double twice_area, double scale) { return std::abs(twice_area) <= scale ? 0 : (twice_area > 0 ? 1 : -1); }

/// Does c, on the line of a and b, lie between them?
bool is_between(const SectionPoint& a, const SectionPoint& b, const SectionPoint& c) {
  return std::min(a.axial, b.axial) <= c.axial && c.axial <= std::max(a.axial, b.axial) &&
         std::min(a.radial, b.radial) <= c.radial && c.radial <= std::max(a.radial, b.radial);
}

bool meet(const SectionPoint& a, const SectionPoint& b, const SectionPoint& c, const SectionPoint& d, double scale) {
  const int c_of_ab = side_of(cross(a, b, c), scale), d_of_ab = side_of(cross(a, b, d), scale);
  const int a_of_cd = side_of(cross(c, d, a), scale), b_of_cd = side_of(cross(c, d, b), scale);
  if (c_of_ab * d_of_ab < 0 && a_of_cd * b_of_cd < 0) return true;
  return (c_of_ab == 0 && is_between(a, b, c)) || (d_of_ab == 0 && is_between(a, b, d)) ||
         (a_of_cd == 0 && is_between(c, d, a)) || (b_of_cd == 0 && is_between(c, d, b));
}

}  // namespace

SectionArea section_area(const SectionPolygon& section) {
  SectionArea of;
  const SectionPoint origin = section.front();  // so that nothing is lost where the polygon lies far from zero
  double twice = 0, first_a = 0, first_r = 0, second_a = 0, second_r = 0, mixed = 0;
  for (std::size_t i = 0; i < section.size(); ++i) {
    const SectionPoint& p = section[i];
    const SectionPoint& q = section[(i + 1) % section.size()];
    const double a = p.axial - origin.axial, r = p.radial - origin.radial;
    const double b = q.axial - origin.axial, s = q.radial - origin.radial;
    const double part = a * s - b * r;
    twice += part;
    first_a += part * (a + b);
    first_r += part * (r + s);
    second_a += part * (a * a + a * b + b * b);
    second_r += part * (r * r + r * s + s * s);
    mixed += part * (a * s + 2 * a * r + 2 * b * s + b * r);
  }
  const double sense = twice < 0 ? -1 : 1, area = 0.5 * twice;
  const double a = first_a / (6 * area), r = first_r / (6 * area);
  of.area = sense * area;
  of.centroid = {origin.axial + a, origin.radial + r};
  of.axial = sense * second_a / 12 - of.area * a * a;
  of.radial = sense * second_r / 12 - of.area * r * r;
  of.product = sense * mixed / 24 - of.area * a * r;
  // What rounding leaves of a symmetrical section is not a product of inertia.
  if (std::abs(of.product) < kRoundedProduct * std::sqrt(of.axial * of.radial)) of.product = 0;
  return of;
}

PrincipalAxes principal_axes(const SectionArea& section) {
  const double mean = 0.5 * (section.axial + section.radial), half = 0.5 * (section.radial - section.axial);
  const double radius = std::hypot(half, section.product);
  return {mean + radius, mean - radius, radius > 0 ? 0.5 * std::atan2(section.product, half) : 0};
}

SectionExtent section_extent(const SectionPolygon& section) {
  SectionExtent extent{section.front(), section.front()};
  for (const SectionPoint& corner : section) {
    extent.low = {std::min(extent.low.axial, corner.axial), std::min(extent.low.radial, corner.radial)};
    extent.high = {std::max(extent.high.axial, corner.axial), std::max(extent.high.radial, corner.radial)};
  }
  return extent;
}

std::optional<FaultOfPolygon> polygon_fault(const SectionPolygon& section) {
  const std::size_t n = section.size();
  if (n < 3) return FaultOfPolygon{PolygonFault::kFewCorners};
  for (std::size_t i = 0; i < n; ++i) {
    if (section[i] == section[(i + 1) % n]) return FaultOfPolygon{PolygonFault::kRepeatedCorner, i, (i + 1) % n};
  }
  const double scale = kOnALine * squared_size(section);
  double largest = 0;
  for (const SectionPoint& corner : section) {
    largest = std::max(largest, std::abs(cross(section[0], section[1], corner)));
  }
  if (largest <= scale) return FaultOfPolygon{PolygonFault::kNoArea};
  for (std::size_t i = 0; i < n; ++i) {
    const SectionPoint &from = section[i], &to = section[(i + 1) % n];
    // The next side turns back onto this one.
    const SectionPoint& next = section[(i + 2) % n];
    const double along =
        (to.axial - from.axial) * (next.axial - to.axial) + (to.radial - from.radial) * (next.radial - to.radial);
    if (side_of(cross(from, to, next), scale) == 0 && along < 0) {
      return FaultOfPolygon{PolygonFault::kOverlaps, i, (i + 1) % n};
    }
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k + 1 == n) continue;  // these two are neighbours
      if (meet(from, to, section[k], section[(k + 1) % n], scale)) return FaultOfPolygon{PolygonFault::kOverlaps, i, k};
    }
  }
  return std::nullopt;
}

SectionPolygon normalized(const SectionPolygon& section) {
  const double scale = kOnALine * squared_size(section);
  const std::size_t n = section.size();
  SectionPolygon corners;
  double twice = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const SectionPoint &before = section[(i + n - 1) % n], &at = section[i], &next = section[(i + 1) % n];
    twice += cross(section[0], at, next);
    if (side_of(cross(before, at, next), scale) != 0) corners.push_back(at);
  }
  if (twice < 0) std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace ringfilm::models
