#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../tests/scenarios/engine_scenario.hpp"
#include "../tests/scenarios/usual_engine.hpp"
#include "ringfilm/cycle/cycle_values.hpp"
#include "ringfilm/cycle/simulate_batch.hpp"
#include "ringfilm/film/kernels/kernels.hpp"

// usage: scenario_accuracy [--quick] [--oil-on-liner] [--json FILE] [scenarios] [first seed]
// How near the values of a cycle come to those of much finer cells and steps, and what it costs: a work-precision table
// over random engines, of one thread of the batched engine. The file has what docs/figures/performance_charts.py draws.
namespace {

using namespace ringfilm;

/// With oil on the liner: eight times the cells by gap and steps that are as good as 1 %.
struct Finest {
  int cells;
  double step_deg;
};
constexpr Finest kFinest{1600, 0.125}, kFinestOnLiner{800, 0.25};
constexpr std::array kLimits = {0.05, 0.01, 0.005, 0.001};

/// What the film enters from.
enum class Supply { kFlooded, kOilOnLiner };

cycle::Case engine(std::uint64_t seed, Supply supply) {
  scenarios::RepeatableNumbers draw(seed);
  cycle::Case c =
      supply == Supply::kFlooded ? scenarios::usual_engine(draw, 300, 9000) : scenarios::usual_engine(draw, 500, 8000);
  if (supply == Supply::kOilOnLiner) {
    cycle::testing::put_gas_at_edges(c);
    cycle::testing::lay_oil_on_liner(static_cast<int>(seed), c);
    if (draw.one_of(2) == 1) c.ring.face.orientation = cycle::Orientation::kX0Crankcase;
  }
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

cycle::Solver fixed_steps(int cells, double crank_step_deg, cycle::TimeScheme scheme) {
  cycle::Solver solver;
  solver.cells = cells;
  solver.crank_step_deg = crank_step_deg;
  solver.crank_step_control = cycle::StepControl::kFixed;
  solver.time_scheme = scheme;
  return solver;
}

/// Differences from the finest, relative to it; of the net flow to the mean of its modulus, of regimes to the cycle.
std::vector<double> errors(const Outcome& outcome, const Outcome& finest, const cycle::CycleQuantity& quantity) {
  std::vector<double> list;
  for (std::size_t i = 0; i < finest.values.size(); ++i) {
    const cycle::CycleValues& fine = finest.values[i];
    const double want = fine.*quantity.value, is = outcome.values[i].*quantity.value;
    if (std::isnan(want) || (want == 0 && is == 0)) continue;
    const double scale = quantity.value == &cycle::CycleValues::net_oil_flow ? fine.mean_absolute_oil_flow
                         : cycle::is_regime_share(quantity)                  ? 1
                                                                             : want;
    list.push_back(std::isnan(is) ? 1 : std::abs((is - want) / scale));
  }
  std::sort(list.begin(), list.end());
  return list;
}

double quantile_95(const std::vector<double>& sorted) { return sorted[sorted.size() * 95 / 100]; }

/// Values of the cycle that the finest integration has, without crank angles.
std::vector<cycle::CycleQuantity> compared_quantities(const Outcome& finest) {
  std::vector<cycle::CycleQuantity> list;
  for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
    if (!is_angle(quantity.name) && !errors(finest, finest, quantity).empty()) list.push_back(quantity);
  }
  return list;
}

enum class Use { kTables, kDiagram };  ///< the diagram has the ways of the tables, too

struct Way {
  std::string name;
  std::string family;  ///< of a line of the diagram
  cycle::Solver solver;
  Use use = Use::kTables;
  Outcome outcome = {};
};

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, numbers...);
  return buffer;
}

/// Cells, fixed steps and films between menisci, for oil on the liner.
std::vector<Way> ways_on_liner() {
  const auto bdf2 = cycle::TimeScheme::kBdf2;
  std::vector<Way> list = {{"200 cells, adaptive, BDF2", "adaptive", {}}};
  for (const auto& [cells, step] : {std::pair{48, 2.0},
                                    {72, 2.0},
                                    {72, 1.0},
                                    {100, 1.0},
                                    {150, 1.0},
                                    {150, 0.5},
                                    {200, 0.5},
                                    {300, 0.5},
                                    {300, 0.25},
                                    {400, 0.25}}) {
    cycle::Solver solver = fixed_steps(cells, step, bdf2);
    solver.cell_lengths = cycle::CellLengths::kByGap;
    list.push_back({text("%d by gap, fixed %g degree", cells, step), "fixed", solver});
  }
  for (const double step_error : {1e-2, 3e-3, 1e-3, 3e-4}) {
    cycle::Solver solver;
    solver.method = cycle::Method::kMenisci;
    solver.step_error = step_error;
    list.push_back({text("menisci, step_error %g", step_error), "menisci", solver});
  }
  for (const double percent : {5.0, 1.0, 0.5}) {
    cycle::Solver solver;
    solver.accuracy = percent;
    list.push_back({text("accuracy %.3g %%", percent), "accuracy", solver});
  }
  return list;
}

std::vector<Way> ways() {
  const auto euler = cycle::TimeScheme::kBackwardEuler;
  cycle::Solver first;
  first.time_scheme = euler;
  std::vector<Way> list = {{"200 cells, fixed 1 degree, Euler", "fixed, first order", fixed_steps(200, 1, euler)},
                           {"200 cells, adaptive, Euler", "adaptive, first order", first}};
  cycle::Solver second;
  list.push_back({"200 cells, adaptive, BDF2", "adaptive, second order", second});
  second.cell_lengths = cycle::CellLengths::kByGap;
  list.push_back({"the same, cells by gap", "adaptive, second order, cells by gap", second});
  const auto add_accuracy = [&](double percent, Use use) {
    cycle::Solver solver;
    solver.accuracy = percent;
    list.push_back({text("accuracy %.3g %%", percent), "accuracy", solver, use});
  };
  for (const double accuracy : kLimits) add_accuracy(100 * accuracy, Use::kTables);
  for (const double percent : {2.0, 0.2}) add_accuracy(percent, Use::kDiagram);
  for (const auto& [cells, step] : {std::pair{50, 4.0}, {100, 2.0}, {400, 0.5}}) {
    list.push_back({text("%d cells, fixed %g degree, Euler", cells, step), "fixed, first order",
                    fixed_steps(cells, step, euler), Use::kDiagram});
  }
  for (const auto scheme : {euler, cycle::TimeScheme::kBdf2}) {
    for (const double factor : {4.0, 0.25}) {
      cycle::Solver solver;
      solver.time_scheme = scheme;
      solver.step_error *= factor;
      const bool is_first = scheme == euler;
      list.push_back({text("200 cells, step_error %g, %s", solver.step_error, is_first ? "Euler" : "BDF2"),
                      is_first ? "adaptive, first order" : "adaptive, second order", solver, Use::kDiagram});
    }
  }
  return list;
}

void print_shares(const std::vector<Way>& ways, const Outcome& finest) {
  std::printf("| %-34s | ms/scenario | times as fast | steps | iterations | 5 %% | 1 %% | 0.5 %% | 0.1 %% |\n", "way");
  std::printf("|:%s-|---:|---:|---:|---:|---:|---:|---:|---:|\n", std::string(34, '-').c_str());
  for (const Way& way : ways) {
    std::array<long, kLimits.size()> within{};
    long all = 0;
    for (const cycle::CycleQuantity& quantity : compared_quantities(finest)) {
      for (const double error : errors(way.outcome, finest, quantity)) {
        ++all;
        for (std::size_t k = 0; k < kLimits.size(); ++k) within[k] += error <= kLimits[k];
      }
    }
    const auto share = [&](std::size_t k) { return 100 * static_cast<double>(within[k]) / static_cast<double>(all); };
    std::printf("| %-34s | %.2f | %.1f | %.0f | %.0f | %.1f %% | %.1f %% | %.1f %% | %.1f %% |\n", way.name.c_str(),
                way.outcome.ms, ways.front().outcome.ms / way.outcome.ms, way.outcome.steps, way.outcome.iterations,
                share(0), share(1), share(2), share(3));
  }
}

void print_quantiles(const std::vector<Way>& ways, const Outcome& finest) {
  std::printf("\n95 %% quantile of the error, value by value\n\n| %-34s |", "value");
  for (const Way& way : ways) {
    if (way.use == Use::kTables) std::printf(" %s |", way.name.c_str());
  }
  std::printf("\n|:---|");
  for (const Way& way : ways) {
    if (way.use == Use::kTables) std::printf("---:|");
  }
  std::printf("\n");
  for (const cycle::CycleQuantity& quantity : compared_quantities(finest)) {
    std::printf("| %-34s |", quantity.name.c_str());
    for (const Way& way : ways) {
      if (way.use == Use::kTables) std::printf(" %.2g |", quantile_95(errors(way.outcome, finest, quantity)));
    }
    std::printf("\n");
  }
}

nlohmann::ordered_json as_json(const Way& way, const Outcome& finest) {
  nlohmann::ordered_json entry{{"name", way.name}, {"family", way.family}};
  if (way.solver.accuracy) entry["accuracy_percent"] = *way.solver.accuracy;
  entry["ms_per_scenario"] = way.outcome.ms;
  entry["steps_per_scenario"] = way.outcome.steps;
  entry["iterations_per_scenario"] = way.outcome.iterations;
  for (const cycle::CycleQuantity& quantity : compared_quantities(finest)) {
    entry["error_quantile_95"][quantity.name] = quantile_95(errors(way.outcome, finest, quantity));
  }
  return entry;
}

}  // namespace

int main(int argc, char** argv) {
  bool quick = false, oil_on_liner = false;
  std::string json;
  std::optional<int> scenarios;
  int seed = 1;
  CLI::App app("Accuracy and cost of the values of a cycle over random engines");
  app.add_flag("--quick", quick, "16 scenarios where their number is not stated, in place of 96");
  app.add_flag("--oil-on-liner", oil_on_liner, "films between gases, with 0.3 to 20 um on the liner");
  app.add_option("--json", json, "integrates the ways of the work-precision diagram, too, and writes all to this file");
  app.add_option("scenarios", scenarios, "their number")->check(CLI::Range(1, 100'000));
  app.add_option("seed", seed, "of the first scenario")->check(CLI::NonNegativeNumber)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const int n = scenarios.value_or(quick ? 16 : 96);
  std::ofstream file;
  if (!json.empty()) {
    file.open(json);
    if (!file) {
      std::fprintf(stderr, "scenario_accuracy: cannot write %s\n", json.c_str());
      return 5;
    }
  }

  const Supply supply = oil_on_liner ? Supply::kOilOnLiner : Supply::kFlooded;
  const Finest& fine = oil_on_liner ? kFinestOnLiner : kFinest;
  std::vector<cycle::Case> engines;
  for (int i = 0; i < n; ++i) engines.push_back(engine(static_cast<std::uint64_t>(seed + i), supply));
  const Outcome finest = integrate(engines, fixed_steps(fine.cells, fine.step_deg, cycle::TimeScheme::kBdf2));
  std::printf(
      "Accuracy and cost of %d random engines, values of the cycle without angles against %d cells and %g degree\n", n,
      fine.cells, fine.step_deg);
  std::printf("(%.0f ms); share of the values within 5, 1, 0.5 and 0.1 %%; processor time of one thread\n\n",
              finest.ms);
  std::vector<Way> list = oil_on_liner ? ways_on_liner() : ways();
  if (json.empty()) std::erase_if(list, [](const Way& way) { return way.use == Use::kDiagram; });
  for (Way& way : list) way.outcome = integrate(engines, way.solver);
  print_shares(list, finest);
  print_quantiles(list, finest);
  if (json.empty()) return 0;

  nlohmann::ordered_json document{{"scenarios", n},
                                  {"first_seed", seed},
                                  {"kernels", std::string(film::kernels().name)},
                                  {"reference_cells", fine.cells},
                                  {"reference_crank_step_deg", fine.step_deg},
                                  {"reference_ms_per_scenario", finest.ms}};
  for (const Way& way : list) document["ways"].push_back(as_json(way, finest));
  file << document.dump(2) << '\n';
  file.close();
  if (!file) {
    std::fprintf(stderr, "scenario_accuracy: cannot write %s\n", json.c_str());
    return 5;
  }
  std::printf("\n%s is written: %zu ways\n", json.c_str(), list.size());
}
