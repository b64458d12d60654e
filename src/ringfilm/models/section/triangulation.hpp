#pragma once
#include <array>
#include <vector>

#include "ringfilm/models/section/polygon.hpp"

namespace ringfilm::models {

/// Triangles that fill a section, corner to corner.
struct SectionMesh {
  std::vector<SectionPoint> nodes;            ///< corners of the polygon first [m]
  std::vector<std::array<int, 3>> triangles;  ///< their corners, all in the sense of the polygon
  /// Of each node the share of an edge at which it is cut next to the node, 1/2 elsewhere; below 1/2 at corners where
  /// stresses are not smooth.
  std::vector<double> cut;
};

/// Triangles between the corners of a normalized polygon, by cutting ears and turning edges.
SectionMesh coarse_mesh(const SectionPolygon& section);

/// Each triangle cut into four; near corners where stresses are not smooth the parts become smaller than elsewhere.
SectionMesh refined(const SectionMesh& mesh);

}  // namespace ringfilm::models
