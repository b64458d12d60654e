#pragma once
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "ringfilm/surface/topography/grid_transform.hpp"

namespace ringfilm::surface {

/// How a map continues beyond its edges.
enum class MapEdges {
  periodic,  ///< it repeats: what leaves on the right comes in on the left
  mirrored,  ///< by its mirror images: no steps at the edges
};

/// An even grid of heights, of one row for ridges without end across it.
struct ContactGrid {
  std::size_t points_x = 0;  ///< along a row
  std::size_t points_y = 0;  ///< rows
  double step_x_m = 0.0;     ///< [m]
  double step_y_m = 0.0;     ///< [m]
  MapEdges edges = MapEdges::mirrored;

  std::size_t points() const { return points_x * points_y; }
};

/// Elastic half-space under pressure on an even grid: displacement 2 p/(E* |q|) for each wave q, and none for the mean
/// pressure, whose compression belongs to the bodies; eq-half-space.
class HalfSpace {
 public:
  /// @param E_star contact modulus, 1/E* = sum (1 - nu^2)/E [Pa]
  HalfSpace(const ContactGrid& grid, double E_star);

  /// Displacement of the surface away from the pressure, of zero mean [m].
  void displace(std::span<const double> pressure, std::span<double> displacement);
  /// The pressure of such a displacement; the mean, which has none, is treated as the longest wave.
  void press(std::span<const double> displacement, std::span<double> pressure);

 private:
  enum class Direction { to_displacement, to_pressure };
  void apply(std::span<const double> from, std::span<double> to, Direction direction);

  ContactGrid grid_;
  double stiffness_;               ///< E*/2 [Pa]
  double longest_;                 ///< smallest |q| above 0 [1/m]
  std::vector<double> q_x_, q_y_;  ///< of columns and rows of waves [rad/m]
  std::optional<GridTransform> periodic_;
  std::optional<MirroredTransform> mirrored_;
  std::vector<std::complex<double>> waves_;
};

}  // namespace ringfilm::surface
