#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "ringfilm/cycle/integration/liner_oil.hpp"

/// How the oil on the liner comes to rest from cycle to cycle (docs/theory/oil-supply.md).
namespace ringfilm::cycle {

class CycleRun;

/// `kPlain`: each cycle begins with what the one before has left. `kMixed`: with a mixture of several, eq-oil-mixing.
enum class OilIteration { kPlain, kMixed };

/// Anderson mixing @cite anderson1965 for the distribution of a quantity over cells that a map leaves fixed,
/// eq-oil-mixing.
class AndersonMixing {
 public:
  /// What all cycles to come move, as a multiple of what the first one moved, if each moves 0.9 of the one before.
  static constexpr double kUnknownApproach = 10;
  /// @param image what the map makes of the argument; at least 0 in all cells, as are the mixtures
  void add(const std::vector<double>& argument, const std::vector<double>& image);

  bool can_mix() const { return history_.size() > 1; }
  /// The argument with which to continue, once there is an image.
  std::vector<double> mixture() const;
  /// What all images to come are expected to move from the last one on, eq-oil-ahead, as a share of all [-]. Of a
  /// single image, whose approach is not known, a multiple of what it moved.
  double ahead() const { return history_.empty() ? 0 : cycles_ahead() * history_.back().share; }
  /// The multiple of what the last image moved that all to come are expected to move [-].
  double cycles_ahead() const;
  /// How much the map still moves, as a norm.
  double moved() const { return history_.empty() ? 0 : history_.back().norm; }

 private:
  struct Pair {
    std::vector<double> image;
    std::vector<double> moved;  ///< integral of image less argument up to each cell
    double norm = 0;            ///< norm of `moved`
    double share = 0;           ///< share of all oil that lies elsewhere in the image than in the argument
  };
  std::vector<Pair> history_;  ///< the latest last
};

/// The oil on a liner over the cycles that its rings need until it repeats.
class OilSettling {
 public:
  explicit OilSettling(OilIteration iteration = OilIteration::kMixed) : iteration_(iteration) {}

  /// The first cycle begins.
  void begin(const LinerFilm& liner) { begin_ = liner.mass_per_area(); }
  /// All rings on the liner have ended a cycle of the oil: compares it with the one before and, where the oil lies
  /// elsewhere, lays that with which the next cycle begins. The oil repeats where neither this cycle moved much nor
  /// all cycles to come are expected to, eq-oil-ahead.
  void begin_next_cycle(LinerFilm& liner, std::span<CycleRun* const> rings);

 private:
  OilIteration iteration_;
  AndersonMixing mixing_;
  std::vector<double> begin_;  ///< oil at the begin of the cycle [kg/m2]
};

}  // namespace ringfilm::cycle
