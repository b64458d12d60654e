#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "ringfilm/gas_path/network.hpp"
#include "ringfilm/gas_path/radau.hpp"

namespace ringfilm::gas_path {

/// Where a ring is in its groove.
enum class Contact { kLowerFlank, kFree, kUpperFlank };

/// Gas and rings at one crank angle.
struct PackState {
  std::vector<double> pressure;  ///< pressures of the regions between chamber and crankcase, in units of kPressureUnit
  std::vector<double> position;  ///< position of each ring, in units of its side clearance
  std::vector<double> velocity;  ///< velocity of each ring, in units of its side clearance over a degree
  std::vector<Contact> contact;  ///< contact of each ring with its groove
};

/// The equations of gas and free rings over the crank angle in degrees: unknowns are the pressures of the regions in
/// between, then position and velocity of each free ring.
class PackSystem : public OdeSystem {
 public:
  static constexpr double kPressureUnit = 1e5;  ///< [Pa]

  explicit PackSystem(const Network& network);

  /// The rings that are free are unknowns; the others stay where they are.
  void set_contacts(const PackState& state);

  std::size_t size() const override { return n_inner_ + 2 * free_.size(); }
  void rates(double angle, std::span<const double> y, std::span<double> f) override;
  void jacobian(double angle, std::span<const double> y, std::span<double> J) override;
  void limit(std::span<const double> y, std::span<double> change) const override;

  /// The unknowns of a state, and back.
  void unknowns(const PackState& state, std::vector<double>& y) const;
  void take(std::span<const double> y, PackState& state) const;

  /// Pressures of all regions [Pa] and flows along all paths [kg/s] with these unknowns.
  void flows(double angle, std::span<const double> y, std::span<double> pressure, std::span<double> flow) const;

  /// Slope of the flow along each path over the pressure at one of its ends, the steeper one [kg/(s Pa)].
  void conductances(double angle, std::span<const double> y, std::span<double> conductance);

  /// Acceleration that a ring would have if nothing supported it [side clearance/degree2].
  double acceleration(std::size_t ring, double angle, std::span<const double> y);

  const Network& network() const { return network_; }
  const std::vector<std::size_t>& free_rings() const { return free_; }
  std::size_t n_inner() const { return n_inner_; }  ///< regions between chamber and crankcase
  /// Is its pressure an unknown? Chamber and crankcase have given pressures; a ring below a piston land of no volume
  /// may have the crankcase on both sides.
  bool is_inner(std::size_t region) const { return network_.is_inner(region); }
  double seconds_per_degree() const { return seconds_per_degree_; }
  /// Place of a free ring's position among the unknowns; its velocity follows. @param k index in free_rings()
  std::size_t place(std::size_t k) const { return n_inner_ + 2 * k; }

 private:
  /// Derivatives of a flow by the pressures at its ends [kg/(s Pa)] and the position of its ring [kg/s].
  struct FlowSlopes {
    double from, to, position;
    double groove = 0;  ///< slope of kFace over the pressure behind its ring
  };

  double position(std::size_t ring, std::span<const double> y) const;
  void fill_pressures(double angle, std::span<const double> y, std::span<double> pressure) const;
  /// Where the ring of a path is [side clearance], or how far its face is open [m].
  double place_of(const Path& path, double angle, std::span<const double> y, std::span<const double> pressure) const;
  double flow(const Path& path, double p_from, double p_to, double at) const;
  FlowSlopes slopes(const Path& path, double position) const;
  void add_to_jacobian(const Path& path, const FlowSlopes& slope, std::span<double> J) const;
  void add_ring_to_jacobian(std::size_t ring, double angle, std::span<double> J);
  double acceleration_of(std::size_t ring, double angle, std::span<const double> pressure) const;

  static constexpr std::size_t kNotFree = static_cast<std::size_t>(-1);

  const Network& network_;
  std::size_t n_inner_;
  double seconds_per_degree_;
  std::vector<std::size_t> free_;       ///< rings
  std::vector<std::size_t> place_;      ///< index of each ring's position among the unknowns, or kNotFree
  std::vector<double> fixed_position_;  ///< position of each ring that is not free [side clearance]
  std::vector<double> pressure_;        ///< workspace: of all regions [Pa]
};

}  // namespace ringfilm::gas_path
