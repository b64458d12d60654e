#pragma once
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/gas_path/pack.hpp"
#include "ringfilm/gas_path/result.hpp"
#include "ringfilm/life/life.hpp"
#include "ringfilm/life/life_result.hpp"
#include "ringfilm/life/ring_state.hpp"

namespace ringfilm::life {

/// The gas of the pack that a ring belongs to, with the end gap of the ring as it is worn, eq-life-gap. Without a pack
/// it leaves everything as it is.
class PackGas {
 public:
  /// @param life kept by reference: its pack, and the speeds and gas pressures of its operating points
  explicit PackGas(const Life& life) : life_(life) {}

  /// The case of a ring at an operating point, with RingPressures::kComputed the pressures of the gas next to and
  /// behind it.
  cycle::Case with_pressures(cycle::Case c, std::size_t point, const EndGapWear& gap);

  /// At each operating point; empty without a pack.
  std::vector<gas_path::GasSums> sums(const EndGapWear& gap);

  /// The blow-by of a ring that has lost that, mean over the duty. @param worn its largest depth and that of the liner
  /// open the gap
  void put_blow_by(WornProfile& worn);

  std::vector<cycle::Note> notes();  ///< on the gas that was computed, and on the rings before they are worn

 private:
  /// At an operating point with one end gap.
  struct PointGas {
    gas_path::Pack pack;
    gas_path::GasPathResult result;
  };

  /// Good until the next call.
  const PointGas& gas(std::size_t point, double growth);
  double growth(std::size_t point, const EndGapWear& gap);

  const Life& life_;
  std::map<std::pair<std::size_t, double>, PointGas> computed_;  ///< by operating point and growth of the gap [m]
  long n_not_periodic_ = 0;                                      ///< cycles of gas that do not repeat
  std::vector<std::vector<double>> liner_weights_;  ///< shares of the gas along the stroke at each operating point
};

/// By how much wear of the radius opens the end gap of a ring [m]. @param depth of ring and liner together [m]
double end_gap_growth(double depth);

}  // namespace ringfilm::life
