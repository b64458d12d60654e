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

  /// Sum over the points of a pressure times its own displacement, by Parseval's theorem [Pa m].
  double work(std::span<const double> pressure);

 private:
  template <class Factor>
  void apply(std::span<const double> from, std::span<double> to, const Factor& factor);

  ContactGrid grid_;
  std::vector<double> stiffness_;            ///< E* |q|/2 of each wave [Pa/m]
  double longest_;                           ///< the smallest above 0 [Pa/m]
  std::vector<double> images_x_, images_y_;  ///< how many waves of the whole spectrum each stands for
  std::optional<GridTransform> periodic_;
  std::optional<MirroredTransform> mirrored_;
  std::vector<std::complex<double>> periodic_waves_;
  std::vector<double> mirrored_waves_;
};

}  // namespace ringfilm::surface
