#include "ringfilm/cycle/setup/kinematics.hpp"

#include <cmath>
#include <numbers>

namespace ringfilm::cycle {

double radians(double angle_deg) { return angle_deg * (std::numbers::pi / 180); }

int stroke_at(double crank_angle_deg) { return static_cast<int>(wrapped(crank_angle_deg) / 180); }

double wrapped(double crank_angle_deg) {
  if (crank_angle_deg >= 0 && crank_angle_deg < kCycleDeg) return crank_angle_deg;
  const double angle = std::fmod(crank_angle_deg, kCycleDeg);
  return angle < 0 ? angle + kCycleDeg : angle;
}

int steps_per_cycle(const Solver& solver) { return static_cast<int>(std::lround(kCycleDeg / solver.crank_step_deg)); }

Motion motion(double crank_angle_deg) {
  const double angle = wrapped(crank_angle_deg);
  const double in_turn = angle < 360 ? angle : angle - 360;
  return in_turn > 0 && in_turn <= 180 ? Motion::kTowardsCrankcase : Motion::kTowardsTdc;
}

double sliding_distance(const models::CrankSlider& crank, double crank_angle_deg, double below_tdc) {
  const double angle = wrapped(crank_angle_deg);
  const double strokes_done = std::floor(angle / 180);
  const bool downwards = std::fmod(strokes_done, 2.0) == 0;
  return strokes_done * crank.stroke() + (downwards ? below_tdc : crank.stroke() - below_tdc);
}

}  // namespace ringfilm::cycle
