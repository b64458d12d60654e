#include "ringfilm/models/section/torsion.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "ringfilm/models/section/triangulation.hpp"

namespace ringfilm::models {
namespace {

/// Triangles beyond which a mesh is not refined again.
constexpr std::size_t kMaxTriangles = 20'000;

/// A triangle with its three corners and the middles of its sides 01, 12, 20.
using Element = std::array<int, 6>;

/// Mesh with the middles of its edges, in units of the section's size about its centroid.
struct QuadraticMesh {
  std::vector<Eigen::Vector2d> nodes;
  std::vector<Element> elements;
  std::vector<bool> is_on_boundary;
};

QuadraticMesh quadratic(const SectionMesh& mesh, const SectionPoint& origin, double size) {
  QuadraticMesh of;
  for (const SectionPoint& node : mesh.nodes) {
    of.nodes.emplace_back((node.axial - origin.axial) / size, (node.radial - origin.radial) / size);
  }
  std::map<std::pair<int, int>, std::pair<int, int>> middles;  // node in the middle of an edge, triangles there
  for (const auto& triangle : mesh.triangles) {
    Element element{triangle[0], triangle[1], triangle[2], 0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangle[k], b = triangle[(k + 1) % 3];
      const auto [found, is_new] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(of.nodes.size()), 0);
      if (is_new) of.nodes.emplace_back(0.5 * (of.nodes[a] + of.nodes[b]));
      ++found->second.second;
      element[3 + k] = found->second.first;
    }
    of.elements.push_back(element);
  }
  of.is_on_boundary.assign(of.nodes.size(), false);
  for (const auto& [edge, middle] : middles) {
    if (middle.second > 1) continue;
    for (const int node : {edge.first, edge.second, middle.first}) of.is_on_boundary[node] = true;
  }
  return of;
}

/// Shape functions of the second order at a place of a triangle, and their slopes.
struct Shape {
  Eigen::Matrix<double, 6, 1> value;
  Eigen::Matrix<double, 6, 2> slope;
};

/// A place in a triangle by its barycentric coordinates, with its weight in integrals over the triangle.
struct Place {
  std::array<double, 3> at;
  double weight;
};

/// Exact for polynomials of degree 4 (Dunavant).
std::array<Place, 6> places_of_triangle() {
  constexpr double a = 0.445948490915965, b = 0.091576213509771;
  constexpr double of_a = 0.223381589678011, of_b = 0.109951743655322;
  return {{{{1 - 2 * a, a, a}, of_a},
           {{a, 1 - 2 * a, a}, of_a},
           {{a, a, 1 - 2 * a}, of_a},
           {{1 - 2 * b, b, b}, of_b},
           {{b, 1 - 2 * b, b}, of_b},
           {{b, b, 1 - 2 * b}, of_b}}};
}

Shape shape_at(const std::array<double, 3>& at, const Eigen::Matrix<double, 3, 2>& slopes) {
  Shape shape;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    shape.value(k) = at[k] * (2 * at[k] - 1);
    shape.slope.row(k) = (4 * at[k] - 1) * slopes.row(k);
    shape.value(3 + k) = 4 * at[k] * at[next];
    shape.slope.row(3 + k) = 4 * (at[k] * slopes.row(next) + at[next] * slopes.row(k));
  }
  return shape;
}

/// Both problems of torsion have the same matrix.
struct Assembled {
  std::vector<Eigen::Triplet<double>> matrix;
  Eigen::VectorXd of_stress;   ///< right-hand side of the stress function: 2 times the integral of each shape function
  Eigen::VectorXd of_warping;  ///< right-hand side of the warping function: integral of slope times (r, -a)
  double polar = 0;            ///< polar second moment
};

Assembled assembled(const QuadraticMesh& mesh) {
  const auto places = places_of_triangle();
  const auto n = static_cast<Eigen::Index>(mesh.nodes.size());
  Assembled all{{}, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
  all.matrix.reserve(36 * mesh.elements.size());
  for (const Element& element : mesh.elements) {
    const Eigen::Vector2d &p = mesh.nodes[element[0]], &q = mesh.nodes[element[1]], &s = mesh.nodes[element[2]];
    const double twice = (q - p).x() * (s - p).y() - (q - p).y() * (s - p).x();
    Eigen::Matrix<double, 3, 2> slopes;
    slopes << q.y() - s.y(), s.x() - q.x(), s.y() - p.y(), p.x() - s.x(), p.y() - q.y(), q.x() - p.x();
    slopes /= twice;
    Eigen::Matrix<double, 6, 6> local = Eigen::Matrix<double, 6, 6>::Zero();
    for (const Place& place : places) {
      const Shape shape = shape_at(place.at, slopes);
      const Eigen::Vector2d x = place.at[0] * p + place.at[1] * q + place.at[2] * s;
      const double weight = 0.5 * twice * place.weight;
      local += weight * shape.slope * shape.slope.transpose();
      all.polar += weight * x.squaredNorm();
      const Eigen::Matrix<double, 6, 1> turning = shape.slope * Eigen::Vector2d(x.y(), -x.x());
      for (int i = 0; i < 6; ++i) {
        all.of_stress(element[i]) += 2 * weight * shape.value(i);
        all.of_warping(element[i]) += weight * turning(i);
      }
    }
    for (int i = 0; i < 6; ++i) {
      for (int k = 0; k < 6; ++k) all.matrix.emplace_back(element[i], element[k], local(i, k));
    }
  }
  return all;
}

/// Twice the energy that the right-hand side does in the solution whose held nodes are zero: f' K^-1 f.
double energy(const Assembled& all, const Eigen::VectorXd& right, const std::vector<bool>& is_held) {
  std::vector<int> unknown(is_held.size(), -1);
  int n = 0;
  for (std::size_t i = 0; i < is_held.size(); ++i) {
    if (!is_held[i]) unknown[i] = n++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(all.matrix.size());
  for (const auto& entry : all.matrix) {
    const int row = unknown[entry.row()], column = unknown[entry.col()];
    if (row >= 0 && column >= 0) entries.emplace_back(row, column, entry.value());
  }
  Eigen::VectorXd load(n);
  for (std::size_t i = 0; i < is_held.size(); ++i) {
    if (unknown[i] >= 0) load(unknown[i]) = right(static_cast<Eigen::Index>(i));
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  return load.dot(factors.solve(load));
}

TorsionConstant bounds_on(const QuadraticMesh& mesh) {
  const Assembled all = assembled(mesh);
  std::vector<bool> one_node(mesh.nodes.size(), false);
  one_node[0] = true;  // warping is known but for a constant
  TorsionConstant of;
  of.lower = energy(all, all.of_stress, mesh.is_on_boundary);
  of.upper = all.polar - energy(all, all.of_warping, one_node);
  of.value = 0.5 * (of.lower + of.upper);
  return of;
}

}  // namespace

TorsionConstant torsion_constant(const SectionPolygon& section) {
  const SectionPolygon corners = normalized(section);
  const SectionExtent extent = section_extent(corners);
  const double size = std::max(extent.height(), extent.thickness());
  const SectionPoint origin = section_area(corners).centroid;
  SectionMesh mesh = refined(refined(coarse_mesh(corners)));
  TorsionConstant of;
  for (;;) {
    of = bounds_on(quadratic(mesh, origin, size));
    if (of.upper - of.lower <= kTorsionTolerance * of.value || 4 * mesh.triangles.size() > kMaxTriangles) break;
    mesh = refined(mesh);
  }
  const double scale = size * size * size * size;
  return {scale * of.value, scale * of.lower, scale * of.upper};
}

}  // namespace ringfilm::models
