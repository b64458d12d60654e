#include "ringfilm/cycle/start_of_oil.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "ringfilm/cycle/pack_runs.hpp"

namespace ringfilm::cycle {
namespace {

/// Cells and crank step with which the oil settles first: it moves little more on finer ones. The next ones are for
/// rings whose film the ones before do not find.
struct Coarse {
  int cells;
  double step_deg;
};
constexpr std::array kCoarse = {Coarse{50, 2}, Coarse{100, 2}, Coarse{100, 1}};
/// The oil has settled where a cycle changes each film, in the mean of a stroke, by less than this share of
/// `solver.step_error`, and moves no more than that of the oil [-].
constexpr double kSettled = 0.15;
constexpr int kMaxCoarseCycles = 60;

/// Oil that cycle after cycle is taken from a stretch of the liner, or laid there, as what rings have pushed together
/// at TDC and take away again over hundreds of cycles.
class SlowStretches {
 public:
  /// Moves the oil of a slow stretch by many cycles at once. @param begin oil at the begin of the last cycle [kg/m2]
  /// @returns whether there is one
  bool leap(LinerFilm& liner, const std::vector<double>& begin) {
    std::vector<double> oil = liner.mass_per_area();
    const std::vector<double> before = std::exchange(changes_, changes(begin, oil));
    double all = 0;
    for (const double change : changes_) all += std::abs(change);
    bool leaps = false;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const bool is_slow = std::abs(changes_[i] - before[i]) < kSame * std::abs(before[i]);
      if (std::abs(changes_[i]) < kMinOfChanges * all || !is_slow) continue;
      const auto first = oil.begin() + i * kCells, last = first + std::min<std::ptrdiff_t>(kCells, oil.end() - first);
      const double in_stretch = std::accumulate(first, last, 0.0);
      if (!(in_stretch > 0)) continue;
      const double ratio = changes_[i] / before[i];
      const double cycles = ratio < kSlowest ? ratio / (1 - ratio) : kSlowest / (1 - kSlowest);
      const double share = 1 + cycles * changes_[i] / in_stretch;
      std::transform(first, last, first, [&](double m) { return m * std::clamp(share, kMinShare, kMaxShare); });
      leaps = true;
    }
    if (leaps) {
      liner.replace(std::move(oil));
      changes_.clear();
    }
    return leaps;
  }

 private:
  /// Of the oil in each stretch [kg/m2].
  static std::vector<double> changes(const std::vector<double>& begin, const std::vector<double>& end) {
    std::vector<double> changes((end.size() + kCells - 1) / kCells);
    for (std::size_t c = 0; c < end.size(); ++c) changes[c / kCells] += end[c] - begin[c];
    return changes;
  }

  static constexpr std::ptrdiff_t kCells = 25;  ///< cells of the liner in a stretch
  /// A slow stretch has this share of all changes of the cycle, and the change of the cycle before but for this share.
  /// No stretch settles more slowly than by this ratio from cycle to cycle [-].
  static constexpr double kMinOfChanges = 0.2, kSame = 0.2, kSlowest = 0.98;
  static constexpr double kMinShare = 0.1, kMaxShare = 3;  ///< share of its oil that a stretch has after a leap [-]
  std::vector<double> changes_;                            ///< by the last cycle [kg/m2]; empty: not known
};

/// All rings on coarse cells and steps, or nothing where it does not pay.
std::optional<std::vector<Setup>> on(const Coarse& coarse, std::vector<Setup> rings) {
  for (Setup& ring : rings) {
    Solver& solver = ring.input.solver;
    const bool pays = solver.cells > coarse.cells && solver.crank_step_deg <= coarse.step_deg &&
                      ring.cells == CellsOfFace::kUniform && ring.surfaces == Surfaces::kRigid &&
                      !ring.input.is_unrolled();
    if (!pays) return std::nullopt;
    solver.cells = coarse.cells;
    solver.crank_step_deg = coarse.step_deg;
    solver.crank_step_control = StepControl::kFixed;
    ring.input.output = {};  // nobody reads these cycles
    ring.input.output.crank_angles_deg = {0};
  }
  return rings;
}

/// A cycle of the oil. @returns whether all rings got to its end
bool finish_cycle(PackRuns& pack) {
  do {
    if (!pack.finish_stroke(nullptr)) return false;
  } while (!pack.begins_compression());
  return true;
}

std::optional<LinerFilm> settled(const std::vector<Setup>& rings, const std::vector<double>& below,
                                 const LinerFilm& fresh) {
  PackRuns pack(rings, below, fresh);
  SlowStretches slow;
  OilSettling settling(least_oil(rings.front()) / fresh.cell());
  settling.begin(fresh);
  for (int cycle = 0; cycle < kMaxCoarseCycles; ++cycle) {
    const std::vector<double> begin = pack.liner().mass_per_area();
    if (!finish_cycle(pack)) return std::nullopt;
    const double moved = share_elsewhere(pack.liner().mass_per_area(), begin);
    settling.end_cycle(pack.liner().mass_per_area());
    const bool leaps = slow.leap(pack.liner(), begin);
    double film = moved;
    for (const auto& run : pack.runs()) film = std::max(film, run->film_moved());
    if (!leaps && film <= kSettled * rings.front().input.solver.step_error) break;
    if (!leaps) {
      if (std::optional<std::vector<double>> mixed = settling.mixture()) pack.liner().replace(*std::move(mixed));
    }
    settling.begin(pack.liner());
  }
  return pack.liner();
}

}  // namespace

LinerFilm start_of_oil(const std::vector<Setup>& rings, const std::vector<double>& below) {
  const LinerFilm fresh = fresh_liner(rings.back(), below.back());
  for (const Coarse& coarse : kCoarse) {
    const auto coarser = on(coarse, rings);
    if (!coarser) break;
    if (const auto liner = settled(*coarser, below, fresh)) return *liner;
  }
  return fresh;
}

}  // namespace ringfilm::cycle
