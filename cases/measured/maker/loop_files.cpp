#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "measured_chain.hpp"
#include "measured_files.hpp"
#include "ringfilm/surface/friction_loop/lateral_force_line.hpp"
#include "ringfilm/surface/synthetic/random_numbers.hpp"

namespace ringfilm::measured_files {
namespace {

using surface::FrictionLoop;

constexpr int kLoads = 8, kLoops = 3, kPositions = 50;
constexpr double kLoadStep_nN = 5;
constexpr double kLength_um = 1.0;
constexpr double kTurn_um = 0.012;     // how fast the lever turns over at the ends
constexpr double kPsi_nN_per_mV = 2;   // of the imagined lever
constexpr double kAdhesion_nN = 6;     // friction at load zero is that of this load
constexpr double kNoise_mV = 0.05;     // of a point
constexpr double kLoopScatter = 0.02;  // of a loop's friction, relative
constexpr double kRelief_mV = 0.4;     // the sample's slopes, alike on both ways
constexpr std::uint64_t kSiliconSeed = 20160;
constexpr int kCorrections = 6;

double rounded(double value, double step) { return std::round(value / step) * step; }

/// Loops whose friction rises by `slope` with load, as the file rounds them.
std::vector<FrictionLoop> loops_with(double slope_mV_per_nN, std::uint64_t seed) {
  surface::RandomNumbers random(seed);
  std::vector<FrictionLoop> loops;
  for (int load = 1; load <= kLoads; ++load) {
    for (int number = 0; number < kLoops; ++number) {
      FrictionLoop loop;
      loop.load = kLoadStep_nN * load;
      const double friction = slope_mV_per_nN * (loop.load + kAdhesion_nN) * (1 + kLoopScatter * random.normal());
      for (int k = 0; k < kPositions; ++k) {
        const double x = rounded(kLength_um * k / (kPositions - 1), 1e-3);
        const double relief = kRelief_mV * std::sin(15 * x + 2);
        const double there = friction * (1 - 2 * std::exp(-x / kTurn_um));
        const double back = -friction * (1 - 2 * std::exp(-(kLength_um - x) / kTurn_um));
        loop.position_m.push_back(x);
        loop.trace_V.push_back(rounded(relief + there + kNoise_mV * random.normal(), 1e-4));
        loop.retrace_V.push_back(rounded(relief + back + kNoise_mV * random.normal(), 1e-4));
      }
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

/// The slope that the chain finds [mV/nN].
double measured_slope(const std::vector<FrictionLoop>& loops) {
  const instrument::ForceRule rule = app::chain::force_rule();
  return friction_load_line(surface::friction_of_loads(loops, rule.end_share, 0), rule.deviations).slope;
}

GeneratedFile loop_file(const std::string& name, const std::string& sample, double target_slope, std::uint64_t seed) {
  double slope = target_slope;
  std::vector<FrictionLoop> loops = loops_with(slope, seed);
  for (int k = 0; k < kCorrections; ++k) {
    slope *= target_slope / measured_slope(loops);
    loops = loops_with(slope, seed);
  }
  std::string text = fmt::format(
      "# SYNTHETIC friction loops on {}, made by ringfilm (cases/measured), seed {}\n# sample: {}\n"
      "load [nN],loop,position [um],trace [mV],retrace [mV]\n",
      sample, seed, sample);
  int number = 0;
  for (const FrictionLoop& loop : loops) {
    number = number % kLoops + 1;
    for (std::size_t k = 0; k < loop.position_m.size(); ++k) {
      text += fmt::format("{:g},{},{:.3f},{:.4f},{:.4f}\n", loop.load, number, loop.position_m[k], loop.trace_V[k],
                          loop.retrace_V[k]);
    }
  }
  return {name, text};
}

}  // namespace

std::vector<GeneratedFile> loop_files(const std::vector<TargetRing>& rings) {
  std::uint64_t seed = kSiliconSeed;
  std::vector<GeneratedFile> files = {
      loop_file("loops_silicon.csv", "silicon", app::chain::silicon_reference().value / kPsi_nN_per_mV, seed)};
  for (const TargetRing& ring : rings) {
    files.push_back(loop_file("loops_" + ring.name + ".csv", ring.name, ring.shear_strength / kPsi_nN_per_mV, ++seed));
  }
  return files;
}

}  // namespace ringfilm::measured_files
