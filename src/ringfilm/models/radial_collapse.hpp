#pragma once
#include <algorithm>
#include <cmath>

namespace ringfilm::models {

/// A ring that gas presses off the liner closes against its own tension until its ends meet, eq-radial-collapse.
struct RadialCollapse {
  double share_above = 0.5;  ///< share of the face on which the pressure above the ring acts [-]
  double stiffness = 0;      ///< rise of the ring's pressure on the bore over the distance [Pa/m]; 0: it never closes
  double farthest = 0;       ///< distance from the liner at which its ends meet [m]

  bool is_possible() const { return stiffness > 0; }
  /// Pressure that is left to press the ring off the liner [Pa]. @param pressing by tension and the gas behind it [Pa]
  double excess(double above, double below, double pressing) const {
    return share_above * above + (1 - share_above) * below - pressing;
  }
  /// Distance from the liner at which tension takes up that pressure [m].
  double distance(double excess) const { return std::clamp(excess / stiffness, 0.0, farthest); }
};

/// dp_e/da = E t^3/(18 r^4): the gap of the ring closes by 2 pi a, eq-elastic-pressure-gap [Pa/m].
inline double radial_stiffness(double radial_thickness, double E, double bore) {
  return E * std::pow(radial_thickness, 3) / (18 * std::pow(bore / 2, 4));
}

}  // namespace ringfilm::models
