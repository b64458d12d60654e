#include "ringfilm/life/pack_gas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/pack/gas_of_pack.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"

namespace ringfilm::life {
namespace {

/// Cycles of gas that are kept; all those of one running time are fewer, and each takes 0.1 MB.
constexpr std::size_t kMaxKept = 200;

cycle::Ring& worn_ring(cycle::Case& pack, std::size_t ring) {
  return pack.is_pack() ? pack.rings[ring - 1].ring : pack.ring;
}

/// The pack at an operating point with its end gap as worn.
gas_path::Pack pack_at(const RingPack& pack, const cycle::Case& point, double growth) {
  cycle::Case c = pack.input;
  c.operating.speed = point.operating.speed;
  c.gas = point.gas;
  cycle::Ring& ring = worn_ring(c, pack.ring);
  ring.end_gap = ring.end_gap.value() + growth;
  return cycle::gas_pack(c);
}

/// Shares of the gas that passes an end gap while the ring is in each of n equal parts of the stroke, from TDC.
std::vector<double> shares_along_stroke(const gas_path::Pack& pack, const gas_path::GasPathResult& result,
                                        std::size_t ring, std::size_t n) {
  const auto is_gap = [ring](const gas_path::Path& path) {
    return path.kind == gas_path::PathKind::kEndGap && path.ring == ring;
  };
  const auto gap = std::find_if(result.paths.begin(), result.paths.end(), is_gap);
  if (gap == result.paths.end()) throw std::logic_error("no gas passes the end gap of the worn ring");
  const auto path = static_cast<std::size_t>(gap - result.paths.begin());
  std::vector<double> shares(n, 0.0);
  for (std::size_t k = 0; k < result.flow.size(); ++k) {
    const double angle = static_cast<double>(k) * std::numbers::pi / 180;
    const double place = pack.crank.position(angle) / pack.crank.stroke();
    const std::size_t part = std::min(n - 1, static_cast<std::size_t>(std::max(0.0, place) * static_cast<double>(n)));
    shares[part] += std::abs(result.flow[k][path]);
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share = sum > 0 ? share / sum : 1 / static_cast<double>(n);
  return shares;
}

}  // namespace

double end_gap_growth(double depth) { return 2 * std::numbers::pi * depth; }

const PackGas::PointGas& PackGas::gas(std::size_t point, double growth) {
  const auto key = std::pair{point, growth};
  if (const auto known = computed_.find(key); known != computed_.end()) return known->second;
  const OperatingPoint& at = life_.points[point];
  PointGas gas{pack_at(*life_.pack, at.input, growth), {}};
  try {
    gas.result = gas_path::solve_gas_path(gas.pack);
  } catch (const ConvergenceError& stopped) {
    throw ConvergenceError("the gas of the pack, " + at.name + ", end gap opened by " + text_in(growth, kMillimetre) +
                               ": " + stopped.what(),
                           stopped.crank_angle_deg());
  }
  if (!gas.result.repeats) ++n_not_periodic_;
  if (computed_.size() >= kMaxKept) computed_.clear();
  return computed_.emplace(key, std::move(gas)).first->second;
}

double PackGas::growth(std::size_t point, const EndGapWear& gap) {
  double depth = gap.ring_depth;
  if (!gap.liner_depth.empty()) {
    liner_weights_.resize(life_.points.size());
    std::vector<double>& weights = liner_weights_[point];
    if (weights.empty()) {
      const PointGas& unworn = gas(point, 0);
      weights = shares_along_stroke(unworn.pack, unworn.result, life_.pack->ring - 1, gap.liner_depth.size());
    }
    depth += std::inner_product(weights.begin(), weights.end(), gap.liner_depth.begin(), 0.0);
  }
  return end_gap_growth(depth);
}

cycle::Case PackGas::with_pressures(cycle::Case c, std::size_t point, const EndGapWear& gap) {
  if (!life_.pack || life_.pack->pressures == RingPressures::kGiven) return c;
  const PointGas& now = gas(point, growth(point, gap));
  cycle::put_gas_pressures(c.ring, now.pack, now.result, life_.pack->ring - 1);
  return c;
}

std::vector<gas_path::GasSums> PackGas::sums(const EndGapWear& gap) {
  std::vector<gas_path::GasSums> of_points;
  if (!life_.pack) return of_points;
  for (std::size_t i = 0; i < life_.points.size(); ++i) {
    const PointGas& now = gas(i, growth(i, gap));
    of_points.push_back(gas_path::gas_sums(now.result, now.pack.gas.gas_constant));
  }
  return of_points;
}

void PackGas::put_blow_by(WornProfile& worn) {
  if (!life_.pack) return;
  const std::vector<gas_path::GasSums> of_points = sums({worn.largest_depth, worn.liner_depth});
  double& mean = worn.blow_by.emplace(0);
  for (std::size_t i = 0; i < of_points.size(); ++i) {
    mean += life_.points[i].share * cycle::number_of(cycle::leading_gas_sum(), of_points[i]).value();
  }
}

std::vector<cycle::Note> PackGas::notes() {
  std::vector<cycle::Note> notes;
  for (std::size_t i = 0; life_.pack && i < life_.points.size(); ++i) {
    const PointGas& unworn = gas(i, 0);
    for (cycle::Note& note : cycle::ring_motion_notes(life_.pack->input, unworn.pack, unworn.result)) {
      note.message = "the gas of the pack, " + life_.points[i].name + ": " + note.message;
      notes.push_back(std::move(note));
    }
  }
  if (n_not_periodic_ > 0) {
    notes.push_back(
        {"gas-path-not-periodic",
         "the gas of the pack does not repeat from cycle to cycle at some of the operating points and end gaps",
         n_not_periodic_});
  }
  return notes;
}

}  // namespace ringfilm::life
