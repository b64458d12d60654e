#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <random>

#include "../tests/unit/gas_path/pack_cases.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"

/// Solves the gas of many seeded random packs, half of them with rings that move, and counts what goes wrong: an
/// integration that stops, a pressure that is not positive, a mass that is not kept. Motions that do not repeat from
/// cycle to cycle are counted apart.
namespace ringfilm::gas_path {
namespace {

constexpr double kMassDefect = 1e-12;

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0; }
  /// Evenly in the logarithm, or zero now and then.
  double size(double share_of_zeros, double low, double high) {
    if (between(0, 1) < share_of_zeros) return 0;
    return low * std::pow(high / low, between(0, 1));
  }

 private:
  std::mt19937 engine_;
};

/// Every third pack has ranges far beyond engines, where volumes follow their neighbours in an instant.
Pack random_pack(unsigned seed) {
  Draw draw(seed);
  const bool is_wide = seed % 3 == 0;
  Pack pack = two_ring_pack();
  pack.ring_motion = seed % 2 == 0 ? RingMotion::kSeated : RingMotion::kAxial;
  pack.speed = draw.between(is_wide ? 100 : 300, 9000) * std::numbers::pi / 30;
  pack.gas.choking_smoothing = draw.size(0, 1e-6, 0.1);
  if (is_wide) {
    pack.gas.viscosity = draw.size(0, 1e-6, 1e-3);
    pack.gas.gas_constant = draw.size(0, 100, 5000);
    pack.chamber_temperature = draw.between(150, 3000);
  }
  const double smallest = is_wide ? 1e-12 : 1e-10;
  for (Ring& ring : pack.rings) {
    const double gap = is_wide ? draw.size(0, 1e-12, 1e-5) : draw.between(0, 1e-6);
    ring.gap_area = draw.between(0, 1) < 0.15 ? 0 : gap;
    ring.volume_below = draw.size(0.2, smallest, 1e-5);
    ring.groove_volume = draw.size(0.2, smallest, 1e-5);
    ring.mass = draw.size(0, 5e-4, 0.1);
    ring.side_clearance = is_wide ? draw.size(0, 1e-6, 2e-3) : draw.size(0, 1e-5, 2e-4);
    ring.bore_friction_coefficient = draw.between(0, 0.2);
    if (is_wide) {
      ring.temperature_below = draw.between(150, 1500);
      ring.groove_temperature = draw.between(150, 1500);
    }
  }
  if (draw.between(0, 1) < 0.3) pack.rings.pop_back();
  pack.rings.back().volume_below = 0;
  return pack;
}

struct Counts {
  int stopped = 0, not_positive = 0, mass_lost = 0, not_periodic = 0, sub_harmonic = 0;
  double largest_defect = 0;
};

void solve_one(unsigned seed, Counts& counts) {
  try {
    const GasPathResult result = solve_gas_path(random_pack(seed));
    const bool positive = std::ranges::all_of(
        result.pressure, [](const auto& pressures) { return *std::ranges::min_element(pressures) > 0; });
    if (!positive) std::printf("%u: a pressure is not positive\n", seed);
    if (result.mass_defect > kMassDefect) std::printf("%u: mass defect %g\n", seed, result.mass_defect);
    counts.not_positive += !positive;
    counts.mass_lost += result.mass_defect > kMassDefect;
    counts.not_periodic += !result.repeats;
    counts.sub_harmonic += !result.repeats && result.period > 1;
    if (!result.repeats) std::printf("%u: repeats every %d cycles (0: never)\n", seed, result.period);
    counts.largest_defect = std::max(counts.largest_defect, result.mass_defect);
  } catch (const std::exception& error) {
    std::printf("%u: %s\n", seed, error.what());
    ++counts.stopped;
  }
}

}  // namespace
}  // namespace ringfilm::gas_path

int main(int argc, char** argv) {
  using namespace ringfilm::gas_path;
  CLI::App app("Solves the gas of random ring packs and counts what goes wrong.");
  unsigned count = 20000, first = 0;
  app.add_option("--count", count, "packs")->capture_default_str();
  app.add_option("--first", first, "index of the first one")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  Counts counts;
  const auto begin = std::chrono::steady_clock::now();
  for (unsigned n = first; n < first + count; ++n) solve_one(n, counts);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::printf(
      "%u packs in %.0f s: %d stopped, %d not positive, %d lose mass (largest defect %.2g), %d do not repeat from "
      "cycle "
      "to cycle, %d of them after several\n",
      count, seconds, counts.stopped, counts.not_positive, counts.mass_lost, counts.largest_defect, counts.not_periodic,
      counts.sub_harmonic);
  return counts.stopped + counts.not_positive + counts.mass_lost > 0;
}
