#pragma once
#include "ringfilm/base/constants.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/models/crank_slider.hpp"

/// The four-stroke cycle in time: angles in degrees, 0 = firing TDC.
namespace ringfilm::cycle {

using base::kCycleDeg;

double radians(double angle_deg);

/// The angle brought into [0, 720).
double wrapped(double crank_angle_deg);

/// The stroke in which a crank angle lies: 0 power, 1 exhaust, 2 intake, 3 compression; dead centres begin one.
int stroke_at(double crank_angle_deg);

/// Crank steps in one cycle; the case's step divides it (checked by `broken_rules`).
int steps_per_cycle(const Solver& solver);

/// Sense of the piston's motion; at a dead centre that of the stroke that ends there.
enum class Motion { kTowardsTdc, kTowardsCrankcase };
Motion motion(double crank_angle_deg);

/// Path of the ring on the liner since firing TDC [m]; eq-sliding-distance. @param below_tdc where the ring is [m]
double sliding_distance(const models::CrankSlider& crank, double crank_angle_deg, double below_tdc);

}  // namespace ringfilm::cycle
