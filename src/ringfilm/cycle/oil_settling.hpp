#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
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
  /// @param least of the quantity in a cell and all before it that counts
  explicit AndersonMixing(double least = 0) : least_(least) {}

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
  /// What the last image moved, as a share of all [-].
  double moved_share() const { return history_.empty() ? 0 : history_.back().share; }
  /// How much the map still moves, as a norm.
  double moved() const { return history_.empty() ? 0 : history_.back().norm; }

 private:
  struct Pair {
    std::vector<double> image;
    std::vector<double> moved;  ///< integral of image less argument up to each cell
    double norm = 0;            ///< norm of `moved` in its own weights
    double share = 0;           ///< share of all oil that lies elsewhere in the image than in the argument
  };
  /// Of the integrals of two changes up to each cell, over what the last image has up to there.
  double product(const std::vector<double>& a, const std::vector<double>& b) const;

  double least_;
  std::vector<Pair> history_;   ///< the latest last
  std::vector<double> weight_;  ///< by cell, of squares
};

/// The oil on a liner over the cycles that its rings need until it repeats.
class OilSettling {
 public:
  /// @param least_per_cell oil of which the rings notice no more, in one cell [kg/m2]
  explicit OilSettling(double least_per_cell, OilIteration iteration = OilIteration::kMixed)
      : iteration_(iteration), mixing_(least_per_cell) {}

  /// The first cycle begins.
  void begin(const LinerFilm& liner) { begin(liner.mass_per_area()); }
  void begin(std::vector<double> oil) { begin_ = std::move(oil); }
  /// All rings on the liner have ended a cycle of the oil: compares it with the one before and, where the oil lies
  /// elsewhere, lays that with which the next cycle begins. The oil repeats where neither this cycle moved much nor
  /// all cycles to come are expected to, eq-oil-ahead.
  void begin_next_cycle(LinerFilm& liner, std::span<CycleRun* const> rings);
  /// A cycle has ended with this oil, as of begin().
  void end_cycle(const std::vector<double>& oil);
  /// What all cycles to come are expected to move, as a share of the oil on the liner [-].
  double ahead() const { return mixing_.ahead(); }
  /// What the last cycle moved, as such a share [-].
  double moved() const { return mixing_.moved_share(); }
  /// The multiple of what the last cycle moved that all to come are expected to move [-].
  double cycles_ahead() const { return mixing_.cycles_ahead(); }
  /// The oil with which the next cycle is to begin where that is not what the last one has left.
  std::optional<std::vector<double>> mixture() const;

 private:
  OilIteration iteration_;
  AndersonMixing mixing_;
  double moved_before_ = 0;    ///< by the cycle before the last one, as a norm
  std::vector<double> begin_;  ///< oil at the begin of the cycle [kg/m2]
};

}  // namespace ringfilm::cycle
