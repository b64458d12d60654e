#pragma once
#include <vector>

#include "ringfilm/film/film2d.hpp"
#include "ringfilm/film/kernels/film2d_kernels.hpp"

namespace ringfilm::film {

/// Strips of a system and the part of the length in y that is theirs.
struct StripPlaces {
  Ends ends = Ends::kOpen;
  double length = 0;           ///< [m]
  std::vector<double> centre;  ///< [m]
  std::vector<double> share;   ///< [m]

  int n_strips() const { return static_cast<int>(centre.size()); }
  /// From strip s-1 to strip s, 0 <= s <= n_strips: to the ends where they are open, round where they are joined [m].
  double distance(int s) const;
};

/// Solves a system of strips approximately, for a Krylov method: one sawtooth cycle of a multigrid that joins strips in
/// pairs, down to a few, where they lie close, and relaxes each two-dimensional film once, even strips first, every
/// strip solved along its length.
///
/// A coarse two-dimensional film stands for the slow changes in y of the pressure: its nodes are those where at least
/// one strip of the pair has a film. Balances are summed over the pair; couplings between pairs and corrections between
/// their places follow from the resistances to flow in y in series, so that a step of the gap is a step on all
/// two-dimensional films.
class StripMultigrid {
 public:
  /// @param system whose couplings are those of the pressure where `is_film` > 0
  /// @param width of the strips: those that lie farther apart than they are wide need no coarser two-dimensional film
  /// [m]
  StripMultigrid(const Film2dKernels& kernels, const StripSystem& system, StripPlaces places, double width);
  StripMultigrid(StripMultigrid&&) noexcept = default;
  StripMultigrid& operator=(StripMultigrid&&) noexcept = default;

  /// For the numbers that the system holds now. @param z > 0 where there is a film
  void prepare(const double* z);
  /// For the same on the finest two-dimensional film alone: the coarser ones stay as they were prepared.
  void prepare_finest();

  /// x = about A^-1 rhs. Slots without a strip stay as they are in `x`: 0.
  void solve(const double* rhs, double* x);

  /// Copies what strips beside joined ends see of each other.
  static void join_ends(const ZebraShape& shape, Ends ends, double* x);

 private:
  struct Level {
    StripPlaces places;
    StripSystem system;
    std::vector<double> memory;
    double *film = nullptr, *rhs = nullptr, *x = nullptr;
    // To the coarser two-dimensional film, if there is one: of each strip
    std::vector<double> share;  ///< weight of the strip in its pair [-]
    // and of each node
    std::vector<double> to_coarse;  ///< weights of its row in that of the coarse node
    /// Weights of its own pair and of the pair beside in the corrections of an odd strip
    std::vector<double> of_own, of_beside;
  };
  /// Strips next to each other that are close enough to need coarser two-dimensional films.
  struct Run {
    std::size_t offset = 0;     ///< index of the run's first number in the whole system
    std::vector<Level> levels;  ///< the first is a part of the given system, without memory of its own
  };
  static Level part_of(const Level& whole, int begin, int end);
  static Level coarser(Level& fine);
  static void coarsen(Level& fine, Level& coarse);
  /// Sets the ends of an odd number of joined strips, where the first and the last are neighbours and both even.
  static void start_ends(const Level& coarse, const Level& fine, double* x);
  void solve_level(Run& run, std::size_t level, const double* rhs, double* x);
  /// What the coarser two-dimensional films make of a right-hand side, in the odd strips of x.
  void correct(Run& run, std::size_t level, const double* rhs, double* x);
  void relax(const Level& of, const double* rhs, double* x);

  const Film2dKernels* kernels_;
  Level finest_;  ///< the given system, without memory of its own but for `film`
  std::vector<Run> runs_;
};

}  // namespace ringfilm::film
