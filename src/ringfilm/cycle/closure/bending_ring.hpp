#pragma once
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/film/film2d.hpp"
#include "ringfilm/models/conformity/beam_elements.hpp"

namespace ringfilm::cycle {

/// The ring of an unrolled film as a beam in its bore (ring.conformity = "beam").
class BendingRing {
 public:
  /// @param around strips of the film; those of a ring without end gap are half a cell from its ends
  BendingRing(const Case& c, const film::CircumferentialGrid& around);

  film::ElasticRing elastic_ring() const;
  /// Adds what bends the ring at a place on the stroke to `inputs`, whose mean load is that of elastic and gas
  /// pressure.
  /// @param below_tdc of the ring [m] @param crank_angle_deg within a cycle [degree]
  void press(double below_tdc, double crank_angle_deg, film::Film2dInputs& inputs) const;
  /// Radius of the bore at each strip over that of the round one, at a place on the stroke [m].
  std::vector<double> bore_at_strips(double below_tdc, double crank_angle_deg) const;

 private:
  models::FourierSeries bore_at(double below_tdc) const;
  void append_dynamic_forces();

  Case case_;
  models::RingBeam beam_;
  int first_node_;
  models::BeamElements elements_;
  double elastic_load_;                         ///< p_e b [N/m]
  std::vector<double> target_;                  ///< line force that the ring is made for, of each strip, over its mean
  std::vector<double> heights_;                 ///< at which the bore is known, rising; empty: alike at all [m]
  std::vector<std::vector<double>> force_;      ///< force of the bore at each height, at each unknown [N]
  std::vector<models::FourierSeries> dynamic_;  ///< what the cycle adds to the bore, by section [m]
  std::vector<std::vector<double>> dynamic_force_;  ///< force of each of `dynamic_`, at each unknown [N]
};

}  // namespace ringfilm::cycle
