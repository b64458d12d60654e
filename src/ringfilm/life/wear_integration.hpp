#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "ringfilm/life/life.hpp"

/// Archard wear over the running time, whatever presses and slides (docs/theory/life.md).
namespace ringfilm::life {

/// Asperity pressure times sliding speed, its mean over time.
struct WearLoad {
  std::vector<double> face;   ///< at each place of the face, weighted with the edge zones [Pa m/s]
  std::vector<double> liner;  ///< along the stroke, per length of circumference [Pa m/s]; empty: not followed
  double balance_error = 0;   ///< difference of its integral over the face from asperity load times speed, relative [-]
};

/// Depths at a running time.
struct WornDepths {
  double time = 0;            ///< [s]
  std::vector<double> face;   ///< [m]
  std::vector<double> liner;  ///< [m]
};

/// What wears where these depths are lost.
using WearLoadOf = std::function<WearLoad(const WornDepths& now)>;

/// What an integration took.
struct WearEffort {
  int jumps = 0;                  ///< taken
  int rejected_jumps = 0;         ///< taken again, shorter
  double stage_difference = 0;    ///< largest of the two stages of a jump that was taken [m]; 0 for Euler
  bool lacks_last_stage = false;  ///< Heun: the jump through the coating has its first stage alone
  double balance_error = 0;       ///< largest WearLoad::balance_error [-]
  /// Depth of the jumps to the end of the coating, where it lasts to no later time that is reported [m].
  std::optional<double> coarse_depth;
};

/// When an integration ends before the last time, and what of it is known.
struct WearLimits {
  std::optional<double> deepest;  ///< depth at which it ends: the coating is worn through [m]
  /// Within which a waviness of the face decays; stated, the end of a coating that lasts to no reported time is found
  /// by jumps of a share of its thickness, eq-life-coarse [m].
  std::optional<double> decay_depth = {};
  std::function<bool()> is_enough = {};  ///< asked after each jump that was chosen: does it end there? Empty: never
  /// Is a jump too long for what else changes, from the present depths to those of its first stage? Empty: never.
  std::function<bool(const WornDepths& from, const WornDepths& to)> is_too_long = {};
  /// Receives the depths after each jump; after that through the coating those where it ends.
  std::function<void(const WornDepths&)> after_jump = {};
};

/// Depths at each of the times, fewer where it ended early.
struct WearHistory {
  std::vector<WornDepths> states;
  WearEffort effort;
  std::optional<WornDepths> worn_through;  ///< as the largest depth reached the limit
};

/// eq-life-coefficient: integral of the wear coefficient of the face over time [m2 s/N].
double coefficient_integral(const Wear& wear, double from, double to);

/// Integrates eq-life-archard from 0 to each of the increasing times by the scheme of `wear`.
/// @param n_face places of the face @param n_liner places of the liner
/// Throws ConvergenceError where jumps become too short or too many, with time and depth.
WearHistory integrate_wear(const Wear& wear, const std::vector<double>& times, std::size_t n_face, std::size_t n_liner,
                           const WearLoadOf& load, const WearLimits& limits = {});

}  // namespace ringfilm::life
