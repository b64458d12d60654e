#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ringfilm/gas_path/pack.hpp"
#include "ringfilm/models/gas/gas_flow.hpp"

namespace ringfilm::gas_path {

/// A space of gas at one pressure.
struct Region {
  std::string name;        ///< "chamber", "groove 1", "land 2", ..., "crankcase"
  double temperature = 0;  ///< [K]
  double capacity = 0;     ///< mass of gas over its pressure; 0 where that is given [kg/Pa]
  /// Pressure of chamber and crankcase, and of piston lands where it is stated
  const models::CyclePressure* given = nullptr;
};

/// Pressures below the rings of a pack where they are stated, one entry for each ring; empty: all are computed.
using GivenPressures = std::vector<std::optional<models::CyclePressure>>;

/// Where gas passes a ring.
enum class PathKind {
  kEndGap,     ///< end gap of the ring
  kAboveRing,  ///< side clearance between the upper flanks of groove and ring
  kBelowRing,  ///< side clearance between the lower flanks of groove and ring
  kFace        ///< gap over the face, Ring::face_opening
};

/// A connection of two regions; flow is positive from `from` to `to`.
struct Path {
  PathKind kind{};
  std::size_t ring = 0;          ///< index in Pack::rings
  std::size_t from = 0, to = 0;  ///< indices of regions
};

/// Name of a path: "end gap 1", "above ring 1", "below ring 1", "face of ring 1".
std::string path_name(const Path& path);

/// What borders a ring, a compression ring also in its groove: indices of regions.
struct RingBorders {
  std::size_t above = 0, groove = 0, below = 0;
};

/// Regions and paths of a pack, from the chamber to the crankcase, and the laws of what flows along the paths and moves
/// the rings.
class Network {
 public:
  explicit Network(const Pack& pack, GivenPressures below = {});
  Network(const Network&) = delete;  // regions point to its given pressures
  Network& operator=(const Network&) = delete;

  const Pack& pack() const { return pack_; }
  const std::vector<Region>& regions() const { return regions_; }  ///< the chamber first, the crankcase last
  const std::vector<Path>& paths() const { return paths_; }
  std::size_t n_regions() const { return regions_.size(); }
  /// The regions whose pressures are unknown, in their order.
  const std::vector<std::size_t>& inner() const { return inner_; }
  bool is_inner(std::size_t region) const { return regions_[region].given == nullptr; }
  /// Place of an inner region in inner().
  std::size_t unknown(std::size_t region) const { return unknown_[region]; }
  /// Borders of the ring with that index; an oil ring has no groove.
  const RingBorders& borders(std::size_t ring) const { return borders_[ring]; }
  bool has_groove(std::size_t ring) const { return pack_.rings[ring].kind == RingKind::kCompression; }

  /// Mass flow along that path [kg/s]. @param p_from @param p_to [Pa]
  /// @param position of the ring above its lower flank; of kFace its opening [m]
  double flow(const Path& path, double p_from, double p_to, double position) const;

  /// Gap over the face of a ring that gas passes at a crank angle, 0 where it is sealed [m]. @param angle [degree]
  /// @param pressure of all regions [Pa]
  double face_opening(std::size_t ring, double angle, std::span<const double> pressure) const;

  /// Pressure that presses a ring off the liner, negative while it is pressed on, eq-radial-collapse [Pa].
  double pressure_off_liner(std::size_t ring, std::span<const double> pressure) const;
  /// Slopes of the distance from the liner over the pressures above, below and behind a ring; 0 where it is on the bore
  /// or its ends meet [m/Pa].
  struct CollapseSlopes {
    double above = 0, below = 0, behind = 0;
  };
  CollapseSlopes collapse_slopes(std::size_t ring, std::span<const double> pressure) const;

  /// Force of gas, friction on the bore and inertia on a ring towards the chamber, eq-seating-force [N]. Without a
  /// stated mass or friction that of the gas alone. @param as of acceleration()
  double axial_force(std::size_t ring, double crank_angle, double p_above, double p_groove, double p_below,
                     double p_crankcase) const;

  /// Friction of the bore on a ring, towards the chamber; 0 without a stated coefficient [N]. @param as of
  /// axial_force()
  double friction_on_bore(std::size_t ring, double crank_angle, double p_groove, double p_crankcase) const;

  /// Acceleration of a ring relative to its groove, where nothing supports it, eq-ring-acceleration [m/s2].
  /// @param ring of RingMotion::kAxial @param crank_angle 0 = firing TDC [rad] @param p_above @param p_groove
  /// @param p_below @param p_crankcase pressures [Pa]
  double acceleration(std::size_t ring, double crank_angle, double p_above, double p_groove, double p_below,
                      double p_crankcase) const;

 private:
  double stated_opening(std::size_t ring, double angle) const;
  /// Force of the gas and friction on a ring, without inertia [N].
  double gas_and_friction(std::size_t ring, double crank_angle, double p_above, double p_groove, double p_below,
                          double p_crankcase) const;
  void add_ring(std::size_t ring, std::size_t above, std::size_t below);
  void narrow_quick_clearances();

  const Pack& pack_;
  GivenPressures given_;
  models::OrificeLaw law_;
  std::vector<Region> regions_;
  std::vector<std::size_t> inner_, unknown_;
  std::vector<Path> paths_;
  std::vector<RingBorders> borders_;          ///< one for each ring
  std::vector<double> seated_clearance_;      ///< side clearance of each ring in RingMotion::kSeated [m]
  std::vector<models::GasChannel> channels_;  ///< channels of the side clearance of each ring, unused for oil rings
  std::vector<models::GasChannel> faces_;     ///< over the face of each ring
};

}  // namespace ringfilm::gas_path
