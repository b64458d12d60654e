#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "ringfilm/surface/friction_loop/lateral_force.hpp"

/// Friction loops with known slopes.
namespace ringfilm::surface {

/// Normal numbers that any library gives alike.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : bits_(seed) {}
  double operator()() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  double uniform() { return (static_cast<double>(bits_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 bits_;
};

struct LoopPlan {
  double slope = 0.08;          ///< TMR over load [V/V]
  double offset_V = 0.01;       ///< adhesion
  double tilt_V = 0.3;          ///< offset of the loops
  double point_noise_V = 0.01;  ///< along the line
  double loop_noise_V = 0.002;  ///< from loop to loop
  double load_noise = 0.0;      ///< true load less the one set
  int loads = 8, loops = 3, points = 40;
  double load_step = 0.25;
};

inline FrictionLoop friction_loop(const LoopPlan& plan, double load_set, double load, Normal& normal) {
  FrictionLoop loop;
  loop.load = load_set;
  const double tmr = plan.offset_V + plan.slope * load + plan.loop_noise_V * normal();
  for (int i = 0; i < plan.points; ++i) {
    const double share = (i + 0.5) / plan.points;
    // The lever turns over within the first tenth of each way.
    const double forth = std::min(1.0, share / 0.1 * 2 - 1), back = std::min(1.0, (1 - share) / 0.1 * 2 - 1);
    loop.position_m.push_back(5e-6 * share);
    loop.trace_V.push_back(plan.tilt_V + 0.05 * share + tmr * forth + plan.point_noise_V * normal());
    loop.retrace_V.push_back(plan.tilt_V + 0.05 * share - tmr * back + plan.point_noise_V * normal());
  }
  return loop;
}

inline std::vector<FrictionLoop> friction_loops(const LoopPlan& plan, Normal& normal) {
  std::vector<FrictionLoop> loops;
  for (int l = 1; l <= plan.loads; ++l) {
    const double set = plan.load_step * l, load = set + plan.load_noise * normal();
    for (int k = 0; k < plan.loops; ++k) loops.push_back(friction_loop(plan, set, load, normal));
  }
  return loops;
}

inline LineFit line_of_loops(const LoopPlan& plan, Normal& normal) {
  return friction_load_line(friction_of_loads(friction_loops(plan, normal), 0.12, plan.load_noise),
                            DeviationScale::kFromResiduals);
}

}  // namespace ringfilm::surface
