#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Screening after Morris @cite morris1991: which factors matter at all, by few runs.
namespace ringfilm::study {

/// Trajectories through a grid of levels: from a random point on, each step moves one factor, every factor once. Point
/// i is the (i mod (k + 1))-th of trajectory i / (k + 1), k factors; it depends on nothing else.
class MorrisTrajectories {
 public:
  MorrisTrajectories() = default;
  /// @param n_levels even, at least 2
  MorrisTrajectories(std::size_t n_factors, std::size_t n_levels, std::uint64_t seed);

  std::size_t points_per_trajectory() const { return n_factors_ + 1; }

  /// Coordinates of a point, each one of 0, 1/(levels - 1), ... 1.
  std::vector<double> point(std::uint64_t i) const;

  /// The factor that a step of a trajectory moves, and by how much [-]; eq-elementary-effect.
  struct Step {
    std::size_t factor;
    double change;  ///< plus or minus levels/(2 (levels - 1))
  };
  /// The step to point i from the one before it; nothing at the beginning of a trajectory.
  std::optional<Step> step_to(std::uint64_t i) const;

 private:
  struct Trajectory;
  Trajectory trajectory(std::uint64_t i) const;

  std::size_t n_factors_ = 0, n_levels_ = 0;
  std::uint64_t seed_ = 0;
};

/// What the elementary effects of one factor are like [unit of the value over the whole range of the factor].
struct MorrisEffect {
  double mean = 0;                       ///< mu: effects of both signs cancel
  double mean_absolute = 0;              ///< mu* of @cite campolongo2007: what ranks the factors
  double mean_absolute_error = 0;        ///< its standard error
  double deviation = 0;                  ///< sigma: large where the factor acts nonlinearly or through others
  std::uint64_t count = 0, omitted = 0;  ///< steps with a value at both ends, and others
};

/// Effects of all factors on a value, from its values at points 0, 1, ...; eq-morris. A trajectory at the end that is
/// not complete counts as far as it goes. A value that is not finite (a scenario that was not solved) invalidates both
/// steps that touch it. @returns for each factor its effect; nothing where there are fewer than two
std::vector<std::optional<MorrisEffect>> morris_effects(const MorrisTrajectories& trajectories,
                                                        std::span<const double> values);

}  // namespace ringfilm::study
