#include "ringfilm/models/section/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace ringfilm::models {
namespace {

using Triangle = std::array<int, 3>;
using Edge = std::pair<int, int>;

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

double twice_area(const std::vector<SectionPoint>& at, int a, int b, int c) {
  return (at[b].axial - at[a].axial) * (at[c].radial - at[a].radial) -
         (at[b].radial - at[a].radial) * (at[c].axial - at[a].axial);
}

double squared_distance(const SectionPoint& a, const SectionPoint& b) {
  return (a.axial - b.axial) * (a.axial - b.axial) + (a.radial - b.radial) * (a.radial - b.radial);
}

/// Cosine of the angle at c in the triangle a, b, c.
double cosine_at(const std::vector<SectionPoint>& at, int a, int b, int c) {
  const double ca = squared_distance(at[c], at[a]), cb = squared_distance(at[c], at[b]);
  return (ca + cb - squared_distance(at[a], at[b])) / (2 * std::sqrt(ca * cb));
}

bool holds_a_corner(const std::vector<SectionPoint>& at, const std::vector<int>& left, int a, int b, int c) {
  return std::any_of(left.begin(), left.end(), [&](int k) {
    return k != a && k != b && k != c && twice_area(at, a, b, k) >= 0 && twice_area(at, b, c, k) >= 0 &&
           twice_area(at, c, a, k) >= 0;
  });
}

/// The ear with the widest smallest angle; nothing: rounding leaves none.
std::optional<std::size_t> best_ear(const std::vector<SectionPoint>& at, const std::vector<int>& left) {
  std::optional<std::size_t> best;
  double best_cosine = 2;
  const std::size_t n = left.size();
  for (std::size_t i = 0; i < n; ++i) {
    const int a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
    if (twice_area(at, a, b, c) <= 0 || holds_a_corner(at, left, a, b, c)) continue;
    const double cosine = std::max({cosine_at(at, a, b, c), cosine_at(at, b, c, a), cosine_at(at, c, a, b)});
    if (cosine >= best_cosine) continue;
    best_cosine = cosine;
    best = i;
  }
  return best;
}

/// Turns edges between two triangles where that makes the angles wider (Delaunay), once over all; did one turn?
bool turn_edges(const std::vector<SectionPoint>& at, std::vector<Triangle>& triangles) {
  std::map<Edge, std::pair<std::size_t, int>> owner;  // triangle and its corner across the edge
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = triangles[t][k], b = triangles[t][(k + 1) % 3], apex = triangles[t][(k + 2) % 3];
      const auto [found, is_first] = owner.try_emplace(edge_of(a, b), t, apex);
      if (is_first) continue;
      const auto [other, far] = found->second;
      if (cosine_at(at, a, b, apex) + cosine_at(at, a, b, far) >= -1e-9) continue;  // angles sum to less than pi
      if (twice_area(at, apex, a, far) <= 0 || twice_area(at, far, b, apex) <= 0) continue;
      triangles[t] = {apex, a, far};
      triangles[other] = {far, b, apex};
      return true;
    }
  }
  return false;
}

/// Share at which edges are cut next to a corner of this angle, so that the parts grow with the distance as the
/// singular part of the stress function, of the order pi/angle, asks for [-].
double cut_at(double angle) {
  const double order = std::numbers::pi / angle;
  return order < 2 ? std::exp2(-2 / order) : 0.5;
}

SectionPoint place_on_edge(const SectionPoint& a, const SectionPoint& b, double share) {
  return {a.axial + share * (b.axial - a.axial), a.radial + share * (b.radial - a.radial)};
}

}  // namespace

SectionMesh coarse_mesh(const SectionPolygon& section) {
  SectionMesh mesh;
  mesh.nodes = section;
  std::vector<int> left(section.size());
  std::iota(left.begin(), left.end(), 0);
  while (left.size() > 3) {
    const std::optional<std::size_t> ear = best_ear(mesh.nodes, left);
    const std::size_t i = ear.value_or(0), n = left.size();
    if (ear) mesh.triangles.push_back({left[(i + n - 1) % n], left[i], left[(i + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  }
  mesh.triangles.push_back({left[0], left[1], left[2]});
  const std::size_t most = section.size() * section.size();
  for (std::size_t turned = 0; turned < most && turn_edges(mesh.nodes, mesh.triangles); ++turned) {
  }
  const int n = static_cast<int>(section.size());
  for (int i = 0; i < n; ++i) {
    const int before = (i + n - 1) % n, next = (i + 1) % n;
    const double inner = std::acos(std::clamp(cosine_at(mesh.nodes, before, next, i), -1.0, 1.0));
    const bool is_convex = twice_area(mesh.nodes, before, i, next) > 0;
    mesh.cut.push_back(cut_at(is_convex ? inner : 2 * std::numbers::pi - inner));
  }
  return mesh;
}

SectionMesh refined(const SectionMesh& mesh) {
  SectionMesh fine{mesh.nodes, {}, mesh.cut};
  std::map<Edge, int> cut_node;
  const auto node_between = [&](int a, int b) {
    const auto [found, is_new] = cut_node.try_emplace(edge_of(a, b), static_cast<int>(fine.nodes.size()));
    if (!is_new) return found->second;
    // Between two such corners the edge is cut in the middle first.
    const double at_a = mesh.cut[a], at_b = mesh.cut[b];
    const double share = at_a < 0.5 && at_b < 0.5 ? 0.5 : (at_a < 0.5 ? at_a : 1 - at_b);
    fine.nodes.push_back(place_on_edge(mesh.nodes[a], mesh.nodes[b], share));
    fine.cut.push_back(0.5);
    return found->second;
  };
  for (const Triangle& of : mesh.triangles) {
    const int ab = node_between(of[0], of[1]), bc = node_between(of[1], of[2]), ca = node_between(of[2], of[0]);
    for (const Triangle& part :
         {Triangle{of[0], ab, ca}, Triangle{of[1], bc, ab}, Triangle{of[2], ca, bc}, Triangle{ab, bc, ca}}) {
      fine.triangles.push_back(part);
    }
  }
  return fine;
}

}  // namespace ringfilm::models
