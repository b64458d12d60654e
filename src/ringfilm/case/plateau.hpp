#pragma once
#include <optional>

namespace ringfilm::cycle {

/// The keys under `contact.plateau`: a liner made in two steps, whose plateau carries (docs/theory/contact.md).
struct Plateau {
  // exactly one of: Rpq, Rvq and Rmq | Rk, Rpk, Rvk and Mr2
  std::optional<double> Rpq;  ///< rms of the plateau [m]
  std::optional<double> Rvq;  ///< rms of the valleys [m]
  std::optional<double> Rmq;  ///< material ratio at which both lines meet, 0 to 1 [-]
  std::optional<double> Rk;   ///< height of the core [m]
  std::optional<double> Rpk;  ///< height of the reduced peaks [m]
  std::optional<double> Rvk;  ///< depth of the reduced valleys [m]
  std::optional<double> Mr2;  ///< material ratio at which the valleys begin, 0 to 1 [-]
  double ring_roughness = 0;  ///< rms height of the ring's face [m]
  // measured of a whole liner; absent: those of the curve
  std::optional<double> surface_roughness;  ///< rms height with the valleys [m]
  std::optional<double> offset;             ///< mean plane of the plateau above that of the whole liner [m]

  bool has_core() const { return Rk || Rpk || Rvk || Mr2; }           ///< are values of the core stated?
  bool is_stated() const { return Rpq || Rvq || Rmq || has_core(); }  ///< is the curve?
  bool operator==(const Plateau&) const = default;                    ///< do both state the same?
};

}  // namespace ringfilm::cycle
