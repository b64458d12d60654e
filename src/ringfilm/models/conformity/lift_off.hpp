#pragma once
#include <memory>
#include <vector>

#include "ringfilm/models/conformity/ring_beam.hpp"

namespace ringfilm::models {

/// A ring next to a rigid frictionless wall (docs/theory/conformity.md). Angles phi count from the middle of the gap.
class RingAtWall {
 public:
  /// @param bore deviation of the bore's radius over phi [m] @param gas force of the gas on the ring, outwards [N/rad]
  RingAtWall(const RingBeam& beam, const FourierSeries& bore, double gas);

  const RingBeam& beam() const { return beam_; }
  const FourierSeries& bore() const { return bore_; }
  double gas() const { return gas_; }
  double start() const { return beam_.half_gap(); }  ///< angle of the first end of the ring [rad]
  double end() const;                                ///< angle of the second end of the ring [rad]

  /// Force of the wall where the ring touches all along, eq-closure-complementarity; where it is negative, the ring
  /// cannot touch [N/rad].
  double force_in_contact(double phi) const { return force_(phi); }
  double moment_in_contact(double phi) const;        ///< eq-closure-complementarity [N m]
  double moment_slope_in_contact(double phi) const;  ///< over phi [N m/rad]
  /// Change of the ring's shape by the bore, (delta + delta'')/r at most, times k, over the moment that closes [-].
  double roundness_defect() const;

 private:
  RingBeam beam_;
  FourierSeries bore_;
  double gas_;
  FourierSeries force_;
  FourierSeries bending_;  ///< k (delta + delta'') [N m]
};

/// Clearance c and what the ring's bending adds to it, m = c + c'' = (M - M_c)/k.
struct LiftOffState {
  double c = 0, slope = 0;                ///< [m], [m/rad]
  double bending = 0, bending_slope = 0;  ///< m [m], m' [m/rad]
};

/// What holds the ring at the end of a part that does not touch.
enum class SpanEnd {
  kContact,     ///< a contact next to it: no clearance, no slope
  kFreeTip,     ///< the ring ends, with clearance
  kContactTip,  ///< the ring ends and touches
};

/// A part of the ring that does not touch, between two angles: the solution of eq-closure-lift-off in closed form,
/// driven by quadratures.
class LiftOff {
 public:
  LiftOff(std::shared_ptr<const RingAtWall> ring, double from, SpanEnd from_end, double to, SpanEnd to_end);

  double from() const { return from_; }
  double to() const { return to_; }
  const LiftOffState& first() const { return states_.front(); }  ///< at from()
  const LiftOffState& last() const { return states_.back(); }    ///< at to()
  LiftOffState at(double phi) const;
  double moment(double phi) const;  ///< bending moment of the ring, closing positive [N m]

  struct Extreme {
    double phi;
    double clearance;
  };
  Extreme largest() const;   ///< clearance
  Extreme smallest() const;  ///< clearance, the ends counted where the ring does not touch there
  double area() const;       ///< integral of the clearance over the angle [m rad]

 private:
  LiftOffState carried(const LiftOffState& state, double from, double to) const;
  Extreme extreme(double sign) const;

  std::shared_ptr<const RingAtWall> ring_;
  double from_, to_;
  std::vector<double> ends_;          ///< ends of the panels [rad]
  std::vector<LiftOffState> states_;  ///< states at the ends of the panels
};

}  // namespace ringfilm::models
