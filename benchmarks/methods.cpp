#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "marched_case.hpp"
#include "ringfilm/cycle/march.hpp"
#include "ringfilm/film/method.hpp"

/// The three methods of solution side by side: processor time per cycle, effort per step and their growth with the
/// number of cells. Every method solves the same steps from the same guess to the same tolerance, one step in ten of a
/// marched cycle (steps of 1 degree), of which the state before comes from the coupled Newton.
namespace ringfilm {
namespace {

constexpr int kSampleEvery = 10;
constexpr double kStepsPerCycle = 720;
constexpr int kRepetitions = 5;         // of which the fastest counts
constexpr int kMostRelaxedCells = 400;  // point relaxation grows too fast for more
const std::vector<int> kCells = {100, 200, 400, 800};
/// Over-relaxation factors that are tried: 2 - factor falls by a quarter each time.
const std::vector<double> kFactors = {1.7, 1.775, 1.831, 1.873, 1.905, 1.929, 1.947, 1.96, 1.97};

struct Step {
  film::FilmInputs inputs;
  film::FilmState previous, guess, solution;
};

/// Keeps what every tenth step started from.
class Sampler : public cycle::Waypoints {
 public:
  void before_step(cycle::March& march, double, double) override { start_ = march.state(); }
  void after_step(const cycle::March& march) override {
    const auto at = march.instant();
    if (steps_taken_++ % kSampleEvery == 0 && steps_taken_ > 1) {
      Step step{at.inputs, *at.previous, start_, *at.state};
      step.guess.h_m = start_.h_m * start_.h_m / before_h_m_;  // extrapolated, as the march does
      steps.push_back(step);
    }
    before_h_m_ = start_.h_m;
  }
  std::vector<Step> steps;

 private:
  film::FilmState start_;
  double before_h_m_ = 0;
  int steps_taken_ = 0;
};

/// One method on all sampled steps.
struct Cost {
  double ms_per_cycle = std::numeric_limits<double>::infinity();
  double effort_per_step = 0;  ///< Newton iterations, or sweeps
  double films_per_step = 0;   ///< films solved at one h_m each; 0: no such loop
  int failed = 0;              ///< steps without convergence
  double difference = 0;       ///< largest relative one of h_m from the coupled Newton's
};

Cost measured(const film::FilmProblem& problem, const std::vector<Step>& steps, film::MethodWorkspace workspace,
              int repetitions) {
  Cost cost;
  film::FilmState state;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    Cost now;
    now.ms_per_cycle = 0;
    for (const Step& step : steps) {
      state = step.guess;
      const std::clock_t start = std::clock();
      const auto report = film::solve_film(problem, step.inputs, step.previous, state, workspace);
      now.ms_per_cycle += 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      now.effort_per_step += static_cast<double>(report.iterations + report.sweeps);
      now.films_per_step += report.outer_iterations;
      now.failed += !report.converged;
      if (report.converged) now.difference = std::max(now.difference, std::abs(state.h_m / step.solution.h_m - 1));
    }
    const auto n_steps = static_cast<double>(steps.size());
    now.ms_per_cycle *= kStepsPerCycle / n_steps;
    now.effort_per_step /= n_steps;
    now.films_per_step /= n_steps;
    if (now.ms_per_cycle < cost.ms_per_cycle) cost = now;
  }
  return cost;
}

struct Row {
  int cells;
  std::string method;
  Cost cost;
};

/// The fixed factor that needs the least time and leaves no step unsolved.
Row best_relaxation(const film::FilmProblem& problem, const std::vector<Step>& steps) {
  double fastest = std::numeric_limits<double>::infinity();
  std::optional<double> best;
  for (const double factor : kFactors) {
    const Cost cost = measured(problem, steps, film::RelaxationWorkspace({factor}), 1);
    if (cost.failed > 0 || cost.ms_per_cycle >= fastest) continue;
    fastest = cost.ms_per_cycle;
    best = factor;
  }
  if (!best) return {problem.grid.n_cells(), "no factor converges everywhere", {}};
  char name[64];
  std::snprintf(name, sizeof name, "point-relaxation, best factor %.3f", *best);
  return {problem.grid.n_cells(), name, measured(problem, steps, film::RelaxationWorkspace({*best}), kRepetitions)};
}

std::vector<Row> rows_at(int cells, cycle::Cavitation cavitation) {
  const cycle::Setup setup = cycle::prepare(case_to_march(cells, cavitation));
  cycle::March march(setup);
  Sampler sampler;
  march.start(270);
  for (int k = 0; k < static_cast<int>(kStepsPerCycle); ++k) march.advance(sampler);
  const auto& problem = march.problem();
  const auto& steps = sampler.steps;
  std::vector<Row> rows = {
      {cells, "coupled-newton", measured(problem, steps, film::FilmWorkspace(problem), kRepetitions)},
      {cells, "nested-secant", measured(problem, steps, film::SecantWorkspace(problem), kRepetitions)}};
  if (cells > kMostRelaxedCells) return rows;
  rows.push_back(
      {cells, "point-relaxation, factor adapted", measured(problem, steps, film::RelaxationWorkspace(), kRepetitions)});
  rows.push_back(best_relaxation(problem, steps));
  return rows;
}

void print_table(const char* model, const std::vector<std::vector<Row>>& by_cells) {
  std::printf("\n%s, new ring, 1500 rpm\n", model);
  std::printf("%6s  %-36s %12s %9s %12s %12s %9s %12s %7s\n", "cells", "method", "ms per cycle", "ratio", "iterations",
              "films/step", "growth", "difference", "failed");
  for (std::size_t c = 0; c < by_cells.size(); ++c) {
    for (std::size_t m = 0; m < by_cells[c].size(); ++m) {
      const auto& [cells, method, cost] = by_cells[c][m];
      std::printf("%6d  %-36s %12.2f %9.2f %12.1f %12.2f", cells, method.c_str(), cost.ms_per_cycle,
                  cost.ms_per_cycle / by_cells[c][0].cost.ms_per_cycle, cost.effort_per_step, cost.films_per_step);
      if (c > 0) {
        const Row& before = by_cells[c - 1][m];
        std::printf("    N^%.2f", std::log(cost.ms_per_cycle / before.cost.ms_per_cycle) /
                                      std::log(static_cast<double>(cells) / before.cells));
      } else {
        std::printf("%10s", "");
      }
      std::printf(" %12.1e %7d\n", cost.difference, cost.failed);
    }
  }
}

}  // namespace
}  // namespace ringfilm

int main() {
  using ringfilm::cycle::Cavitation;
  std::printf(
      "methods of solution side by side: one step in %d of a cycle of 720, each from the coupled Newton's state "
      "before\n"
      "it and the same guess, to tolerance 1e-8; processor time, times 720 over the steps solved.\n"
      "point relaxation stops at |dp| <= 1e-8 (p_e + p_g) per sweep, adaptive load relaxation; best factor of %zu\n"
      "between %.3g and %.3g. With reynolds-exit that is the yardstick. iterations: Newton iterations or sweeps a "
      "step;\n"
      "growth: of time with the number of cells; difference: largest relative one in h_m from the coupled Newton.\n",
      ringfilm::kSampleEvery, ringfilm::kFactors.size(), ringfilm::kFactors.front(), ringfilm::kFactors.back());
  for (const auto& [model, cavitation] : {std::pair{"reynolds-exit", Cavitation::kReynoldsExit},
                                          std::pair{"mass-conserving", Cavitation::kMassConserving}}) {
    std::vector<std::vector<ringfilm::Row>> by_cells;
    for (const int cells : ringfilm::kCells) by_cells.push_back(ringfilm::rows_at(cells, cavitation));
    ringfilm::print_table(model, by_cells);
  }
}
