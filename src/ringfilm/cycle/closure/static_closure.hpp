#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/ring_section.hpp"
#include "ringfilm/models/conformity/free_shape.hpp"
#include "ringfilm/models/conformity/ring_closure.hpp"

/// The ring of a case in its bore without film (docs/theory/conformity.md).
namespace ringfilm::cycle {

/// What a static closure sums up to. Angles count from the middle of the gap in the direction of theta.
struct ClosureValues {
  double max_clearance = 0;        ///< between ring and bore [m]
  double max_clearance_angle = 0;  ///< where it is [degree]
  double open_area = 0;            ///< clearance times B/2 over the angle, without the end gap [m2]
  double contact_angle = 0;        ///< sum of the angles of all contact arcs [degree]
  double mean_wall_force = 0;      ///< all force of the wall over 2 pi [N/rad]
  double share_in_points = 0;      ///< share of the wall's force in point forces [-]
  double moment_at_back = 0;       ///< opposite the gap, closing positive [N m]
  double tangential_force = 0;     ///< F_t = p h B/2 with the mean target pressure p [N]
  double second_moment = 0;        ///< second moment of area of the section, I [m4]
  double free_gap = 0;             ///< opening of the free ring less the end gap, to first order [m]
  double projection = 0;           ///< term of order 1 that balances the target pressure, over its mean [-]
  double unbalanced_share = 0;     ///< unbalanced force of wall and gas over the tangential force [-]
};

/// A value of a static closure and where `ClosureValues` has it.
struct ClosureQuantity : Quantity {
  double ClosureValues::*value;  ///< the member that holds it
};
const std::vector<ClosureQuantity>& closure_quantities();  ///< in the order of files and tables

/// Where a ring touches its bore at rest, and with which pressure.
struct StaticClosure {
  models::RingClosure ring;                        ///< angles from the middle of the gap [rad]
  ClosureValues values;                            ///< clearances, pressures and open areas
  std::optional<models::FreeShapeFit> free_shape;  ///< where ring.free_shape is stated
  std::vector<std::string> notes;                  ///< on models used outside their range
  std::optional<SectionValues> section = {};       ///< where the section is stated
};

/// Deviation of the bore's radius around the bore, all its parts together [m over rad]. @param height along the stroke;
/// without a meaning where the bore does not change [m]. Throws InputError where the bore is not known.
models::FourierSeries bore_deviation(const Case& c, std::optional<double> height);

/// What the cycle adds to it at each crank angle of liner.dynamic_distortion, all of the same orders; empty where that
/// is not stated [m over rad].
std::vector<models::FourierSeries> dynamic_deviations(const Case& c);

/// Heights of the sections by which the bore is known, rising; empty where it does not change [m].
std::vector<double> bore_heights(const Case& c);

/// The ring as a beam; with the target pressure of its free shape, where that is stated.
models::RingBeam ring_beam(const Case& c);

/// Solves the contact of ring and bore. Of a pack the first ring. Throws InputError, ConvergenceError.
StaticClosure static_closure(const Case& c);

}  // namespace ringfilm::cycle
