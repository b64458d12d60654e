#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "../tests/scenarios/usual_engine.hpp"
#include "ringfilm/cycle/cycle_values.hpp"
#include "ringfilm/cycle/simulate_batch.hpp"

// usage: scenario_accuracy [--quick] [scenarios] [first seed]
// How near the values of a cycle come to those of much finer cells and steps, and what it costs: a work-precision table
// over random engines, of one thread of the batched engine.
namespace {

using namespace ringfilm;

constexpr int kFinestCells = 1600;
constexpr double kFinestStepDeg = 0.125;
constexpr std::array kLimits = {0.05, 0.01, 0.005, 0.001};

cycle::Case engine(std::uint64_t seed) {
  scenarios::RepeatableNumbers draw(seed);
  cycle::Case c = scenarios::usual_engine(draw, 300, 9000);
  c.output.crank_angles_deg = {0};
  return c;
}

struct Outcome {
  std::vector<cycle::CycleValues> values;    ///< NaN of a scenario that stopped
  double ms = 0, steps = 0, iterations = 0;  ///< of a scenario
};

Outcome integrate(const std::vector<cycle::Case>& engines, const cycle::Solver& solver) {
  std::vector<cycle::Setup> setups;
  for (cycle::Case c : engines) {
    c.solver = solver;
    setups.push_back(cycle::prepare(c));
  }
  const double n = static_cast<double>(engines.size());
  Outcome outcome;
  outcome.values.resize(engines.size());
  std::size_t next = 0;
  const std::clock_t begin = std::clock();
  cycle::simulate_batch(
      [&]() -> std::optional<cycle::Setup> {
        if (next == setups.size()) return std::nullopt;
        return std::move(setups[next++]);
      },
      [&](const cycle::BatchOutcome& o) {
        outcome.values[o.index] = o.stop ? cycle::no_cycle_values() : o.result.values;
        outcome.steps += static_cast<double>(o.result.effort.crank_steps) / n;
        outcome.iterations += static_cast<double>(o.result.effort.newton_iterations) / n;
      });
  outcome.ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / n;
  return outcome;
}

bool is_angle(const std::string& name) { return name.ends_with("_angle"); }

/// Differences from the finest, relative to it; of the net flow to the mean of its modulus.
std::vector<double> errors(const Outcome& outcome, const Outcome& finest, const cycle::CycleQuantity& quantity) {
  std::vector<double> list;
  for (std::size_t i = 0; i < finest.values.size(); ++i) {
    const cycle::CycleValues& fine = finest.values[i];
    const double want = fine.*quantity.value, is = outcome.values[i].*quantity.value;
    if (std::isnan(want) || (want == 0 && is == 0)) continue;
    const double scale = quantity.value == &cycle::CycleValues::net_oil_flow ? fine.mean_absolute_oil_flow : want;
    list.push_back(std::isnan(is) ? 1 : std::abs((is - want) / scale));
  }
  std::sort(list.begin(), list.end());
  return list;
}

struct Way {
  std::string name;
  cycle::Solver solver;
};

std::vector<Way> ways() {
  cycle::Solver fixed;
  fixed.crank_step_control = cycle::StepControl::kFixed;
  std::vector<Way> list = {{"200 cells, fixed 1 degree, Euler", fixed}, {"200 cells, adaptive, Euler", {}}};
  cycle::Solver second;
  second.time_scheme = cycle::TimeScheme::kBdf2;
  list.push_back({"200 cells, adaptive, BDF2", second});
  second.cell_lengths = cycle::CellLengths::kByGap;
  list.push_back({"the same, cells by gap", second});
  for (const double accuracy : kLimits) {
    cycle::Solver solver;
    solver.accuracy = 100 * accuracy;
    char name[32];
    std::snprintf(name, sizeof name, "accuracy %.3g %%", 100 * accuracy);
    list.push_back({name, solver});
  }
  return list;
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  const int first = quick ? 2 : 1;
  const int n = argc > first ? std::atoi(argv[first]) : quick ? 16 : 96;
  const int seed = argc > first + 1 ? std::atoi(argv[first + 1]) : 1;
  std::vector<cycle::Case> engines;
  for (int i = 0; i < n; ++i) engines.push_back(engine(static_cast<std::uint64_t>(seed + i)));
  cycle::Solver finest_solver;
  finest_solver.cells = kFinestCells;
  finest_solver.crank_step_deg = kFinestStepDeg;
  finest_solver.crank_step_control = cycle::StepControl::kFixed;
  finest_solver.time_scheme = cycle::TimeScheme::kBdf2;
  const Outcome finest = integrate(engines, finest_solver);
  std::printf(
      "Accuracy and cost of %d random engines, values of the cycle without angles against %d cells and %g degree\n", n,
      kFinestCells, kFinestStepDeg);
  std::printf("(%.0f ms); share of the values within 5, 1, 0.5 and 0.1 %%; processor time of one thread\n\n",
              finest.ms);
  std::printf("| %-32s | ms/scenario | times as fast | steps | iterations | 5 %% | 1 %% | 0.5 %% | 0.1 %% |\n", "way");
  std::printf("|:%s-|---:|---:|---:|---:|---:|---:|---:|---:|\n", std::string(32, '-').c_str());
  std::vector<Outcome> outcomes;
  for (const Way& way : ways()) {
    const Outcome& outcome = outcomes.emplace_back(integrate(engines, way.solver));
    std::array<long, kLimits.size()> within{};
    long all = 0;
    for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
      if (is_angle(quantity.name)) continue;
      for (const double error : errors(outcome, finest, quantity)) {
        ++all;
        for (std::size_t k = 0; k < kLimits.size(); ++k) within[k] += error <= kLimits[k];
      }
    }
    const auto share = [&](std::size_t k) { return 100 * static_cast<double>(within[k]) / static_cast<double>(all); };
    std::printf("| %-32s | %.2f | %.1f | %.0f | %.0f | %.1f %% | %.1f %% | %.1f %% | %.1f %% |\n", way.name.c_str(),
                outcome.ms, outcomes.front().ms / outcome.ms, outcome.steps, outcome.iterations, share(0), share(1),
                share(2), share(3));
  }
  std::printf("\n95 %% quantile of the error, value by value\n\n| %-34s |", "value");
  for (const Way& way : ways()) std::printf(" %s |", way.name.c_str());
  std::printf("\n|:---|");
  for (std::size_t k = 0; k < outcomes.size(); ++k) std::printf("---:|");
  std::printf("\n");
  for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
    if (is_angle(quantity.name) || errors(finest, finest, quantity).empty()) continue;
    std::printf("| %-34s |", quantity.name.c_str());
    for (const Outcome& outcome : outcomes) {
      const std::vector<double> list = errors(outcome, finest, quantity);
      std::printf(" %.2g |", list[list.size() * 95 / 100]);
    }
    std::printf("\n");
  }
}
