#pragma once
#include <vector>

#include "ringfilm/models/conformity/ring_beam.hpp"

namespace ringfilm::models {

/// A ring cut into beam elements between nodes, cubic in the radial displacement (eq-ring-elements). Unknowns are, node
/// by node, the displacement [m] and its slope times the mean length of the elements beside the node [m].
class BeamElements {
 public:
  static constexpr int kWidth = 4;  ///< an unknown is coupled to itself and the three after it

  /// @param phi nodes from one end of the ring to the other, from the middle of the gap, rising [rad]
  BeamElements(const RingBeam& beam, std::vector<double> phi);

  int n_nodes() const { return static_cast<int>(phi_.size()); }
  const std::vector<double>& phi() const { return phi_; }
  /// Angle that scales the slope unknown of a node [rad].
  double slope_length(int node) const { return length_[node]; }

  /// Upper band of the symmetric stiffness, kWidth entries an unknown: the force along one unknown of another [N/m].
  const std::vector<double>& stiffness() const { return stiffness_; }
  /// Force along each unknown by which a ring of this shape pushes outwards against its own [N].
  /// @param deviation of the radius over phi [m]
  std::vector<double> force_of_shape(const FourierSeries& deviation) const;

 private:
  /// The four unknowns of an element, their functions with curvature added, u + u'', at s in [0, 1].
  struct Shapes {
    double value[4];
  };
  Shapes bending(int element, double s) const;

  std::vector<double> phi_, length_;
  double rigidity_;  ///< k/r [N/m]
  std::vector<double> stiffness_;
};

}  // namespace ringfilm::models
