#pragma once
#include <vector>

#include "ringfilm/life/life_run.hpp"
#include "ringfilm/life/pack_gas.hpp"
#include "ringfilm/life/wear/run_in_depth.hpp"
#include "ringfilm/life/wear/worn_face.hpp"
#include "ringfilm/life/wear_integration.hpp"

namespace ringfilm::life {

/// What wears a ring over its duty: asperity pressure and sliding of cycles with the face as it is by then,
/// eq-life-archard.
class DutyWear {
 public:
  /// @param life kept by reference, as are the integrators and the gas
  DutyWear(const Life& life, const CycleIntegrators& integrators, PackGas& gas);

  /// Means over the duty and the spread of tilts.
  WearLoad load(const WornDepths& now);

  /// The level ring with these depths at their running time.
  RingState ring_at(const WornDepths& now) const { return ring_at(now, 0); }
  double roughness_at(const WornDepths& now) const;  ///< sigma [m]
  /// Do roughness or zeta change by more than a jump may contain?
  bool surface_changes_much(const WornDepths& from, const WornDepths& to) const;
  /// Puts the roughness that runs in and the share of the worn volume that this took; without running in it is kept.
  void put_running_in(const WornDepths& now, WornProfile& worn) const;

  const WornFace& face() const { return face_; }
  double area(const std::vector<double>& worn) const;  ///< area of the cross-section that is lost [m2]
  double tilt_spacing() const;                         ///< between neighbouring samples; 0: a level ring [rad]

  std::size_t n_liner() const;  ///< places along the stroke; 0: the liner is not followed
  const std::vector<double>& liner_position() const { return liner_position_; }  ///< after the first load [m]
  long cycles() const { return cycles_; }                                        ///< integrated so far

 private:
  RunInDepth run_in_at(const WornDepths& now) const;
  double run_in_roughness_at(const WornDepths& now) const;
  RingState surface_at(const WornDepths& now) const;
  cycle::Case with_surface(const WornDepths& now) const { return with_ring_state(base_, surface_at(now)); }
  RingState ring_at(const WornDepths& now, double tilt) const;
  std::vector<CycleRequest> requests(const WornDepths& now);
  /// A face that has lost depths at its nodes, and its tilt against the liner [m, rad].
  struct TiltedFace {
    const std::vector<double>& depth;
    double tilt;
  };
  void add_cycle(const CycleRequest& request, const TiltedFace& worn, const cycle::CycleResult& result, double weight,
                 WearLoad& load) const;
  void weight_edges(WearLoad& load) const;

  const Life& life_;
  const CycleIntegrators& integrators_;
  PackGas& gas_;
  const cycle::Case& base_;
  std::size_t n_points_;
  WornFace face_;
  std::vector<double> tilts_;
  std::vector<double> liner_position_;
  long cycles_ = 0;
};

}  // namespace ringfilm::life
