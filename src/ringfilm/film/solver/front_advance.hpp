#pragma once
#include <algorithm>
#include <cstdlib>
#include <vector>

namespace ringfilm::film {

/// By how many cells a film front that only advances, a cell an iteration, is moved further (docs/theory/film.md). The
/// stride doubles from iteration to iteration; where a front came back it is halved, in the end to nothing.
class FrontAdvance {
 public:
  void restart() { *this = {}; }

  /// The cells by which fronts advance after this iteration; 0: not at all.
  /// @param only_advanced nodes went from cavity to film in this iteration, and not a single one went back
  int cells(bool only_advanced) {
    if (!only_advanced) {
      if (reach_ > 0) largest_reach_ = --retreats_left_ > 0 ? std::max(reach_ / 2, 1) : 0;
      reach_ = advances_ = 0;
      return 0;
    }
    if (++advances_ < kAfter || largest_reach_ == 0) return 0;
    return reach_ = std::min(std::max(2 * reach_, 1), largest_reach_);
  }

 private:
  static constexpr int kAfter = 3;  ///< iterations in a row in which fronts only advanced
  static constexpr int kRetreats = 6;

  int reach_ = 0;  ///< in the last iteration
  int largest_reach_ = 1 << 20;
  int retreats_left_ = kRetreats;
  int advances_ = 0;
};

/// Moves the fronts of one strip by up to `cells`: nodes next to one that the iteration has just put beyond the kink,
/// at z = `beyond`, become film as well. @param z of node i, as a reference @param n_cells of the strip
template <class Z>
void advance_fronts_of_strip(const Z& z, int n_cells, double beyond, int cells) {
  std::vector<int> entered;
  for (int i = 1; i < n_cells; ++i) {
    if (z(i) == beyond) entered.push_back(i);
  }
  for (const int i : entered) {
    for (const int way : {-1, 1}) {
      for (int next = i + way; std::abs(next - i) <= cells && next > 0 && next < n_cells && !(z(next) > 0);
           next += way) {
        z(next) = beyond;
      }
    }
  }
}

}  // namespace ringfilm::film
