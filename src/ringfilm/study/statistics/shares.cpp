#include "ringfilm/study/statistics/shares.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::study {
namespace {

/// Cases of one kind, integrated side by side.
using Kind = std::tuple<bool, cycle::Method, cycle::Cavitation, cycle::Properties, unsigned>;

Kind kind_of(const cycle::Case& c) {
  // A block of lanes (cycle/integration/side_by_side.cpp) has room for a power of two in cells, too.
  return {c.is_unrolled(), c.solver.method, c.film.cavitation, c.solver.properties,
          std::bit_ceil(static_cast<unsigned>(c.solver.cells))};
}

/// Nodes that its integration visits, to a factor.
double work(const cycle::Case& c) {
  const double around = c.is_unrolled() ? c.solver.cells_y : 1;
  return around * c.solver.cells * cycle::steps_per_cycle(c.solver);
}

/// Cases that integrate side by side on one thread.
struct Pack {
  std::vector<std::size_t> members;
  double time = 0;  ///< work of the longest member, plus the part of each member that is done lane by lane
};

}  // namespace

std::vector<std::vector<std::size_t>> shares(const std::vector<cycle::Case>& cases, int n_threads, int width) {
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return std::tuple(kind_of(cases[i]), -work(cases[i]), i); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });

  const std::size_t n_even = (cases.size() + n_threads - 1) / n_threads;
  const std::size_t n_pack = std::clamp<std::size_t>(n_even, 1, width);
  std::vector<Pack> packs;
  for (const std::size_t i : order) {
    const bool joins = !cases[i].is_unrolled() && !packs.empty() && packs.back().members.size() < n_pack &&
                       kind_of(cases[packs.back().members.front()]) == kind_of(cases[i]);
    if (!joins) packs.emplace_back();
    Pack& pack = packs.back();
    pack.time += work(cases[i]) * (pack.members.empty() ? 1 + 1.0 / width : 1.0 / width);
    pack.members.push_back(i);
  }

  // The longest first, each to the thread that would end it first.
  std::stable_sort(packs.begin(), packs.end(), [](const Pack& a, const Pack& b) { return a.time > b.time; });
  std::vector<Pack> threads(std::min<std::size_t>(n_threads, packs.size()));
  for (const Pack& pack : packs) {
    Pack& least =
        *std::min_element(threads.begin(), threads.end(), [](const Pack& a, const Pack& b) { return a.time < b.time; });
    least.time += pack.time;
    least.members.insert(least.members.end(), pack.members.begin(), pack.members.end());
  }
  std::vector<std::vector<std::size_t>> shares;
  for (Pack& thread : threads) shares.push_back(std::move(thread.members));
  return shares;
}

}  // namespace ringfilm::study
