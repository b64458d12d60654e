#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/result_file.hpp"

/// Accuracy against cost of the steps in time where mass is conserved and the front of a re-forming film runs across
/// the face after a dead centre: fixed steps against steps that follow film and oil content, both against fixed steps
/// of 0.02 degree on the same grid. Steps and iterations are per cycle and the same on any machine.
namespace ringfilm {
namespace {

constexpr double kReferenceStepDeg = 0.02;
constexpr double kRadPerSecondPerRpm = 0.10471975511965977;

struct RingAtSpeed {
  const char* ring;
  double speed_rpm;
};

struct Steps {
  cycle::TimeScheme scheme;
  cycle::StepControl control;
  double size;  ///< crank step [degree] of fixed steps, else solver.step_error
};

struct Integrated {
  cycle::CycleResult result;
  double milliseconds;  ///< of processor time per cycle
};

Integrated integrated(const RingAtSpeed& at, const Steps& steps) {
  auto c = io::read_case(std::string(RINGFILM_SOURCE_FOLDER) + "/cases/styles2014/" + at.ring + ".toml");
  c.operating.speed = at.speed_rpm * kRadPerSecondPerRpm;
  c.film.cavitation = cycle::Cavitation::kMassConserving;
  c.solver.crank_step_control = steps.control;
  c.solver.time_scheme = steps.scheme;
  if (steps.control == cycle::StepControl::kFixed) {
    c.solver.crank_step_deg = steps.size;
  } else {
    c.solver.step_error = steps.size;
  }
  const cycle::Setup setup = cycle::prepare(c);
  const std::clock_t start = std::clock();
  Integrated out{cycle::simulate(setup), 0};
  out.milliseconds =
      1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / out.result.effort.cycles_integrated;
  return out;
}

void print_row(const Steps& steps, const Integrated& integration, const cycle::CycleResult& reference) {
  double worst = 0;
  double worst_at = 0;
  double sum = 0;
  double worst_friction = 0;
  for (std::size_t i = 0; i < reference.samples.size(); ++i) {
    const cycle::Sample& exact = reference.samples[i];
    const cycle::Sample& got = integration.result.samples[i];
    const double error = std::abs(std::log(got.min_film_thickness / exact.min_film_thickness));
    sum += error;
    worst_friction = std::max(worst_friction, std::abs(got.friction_coefficient - exact.friction_coefficient));
    if (error > worst) worst_at = exact.crank_angle_deg;
    worst = std::max(worst, error);
  }
  const auto per_cycle = [&](long count) {
    return static_cast<double>(count) / integration.result.effort.cycles_integrated;
  };
  const bool fixed = steps.control == cycle::StepControl::kFixed;
  std::printf("  %-6s %-10s %-12g %9.2f %% %8.0f %10.3f %% %10.4f %12.3f %% %8.0f %8.0f %8.0f\n",
              steps.scheme == cycle::TimeScheme::kBdf2 ? "BDF2" : "Euler", fixed ? "fixed" : "adaptive", steps.size,
              100 * worst, worst_at, 100 * sum / static_cast<double>(reference.samples.size()), worst_friction,
              100 * (integration.result.values.fmep / reference.values.fmep - 1),
              per_cycle(integration.result.effort.crank_steps), per_cycle(integration.result.effort.newton_iterations),
              integration.milliseconds);
}

void print_ring(const RingAtSpeed& at) {
  std::printf("\n%s ring, %g rpm, mass-conserving, 200 cells\n", at.ring, at.speed_rpm);
  std::printf("  %-6s %-10s %-12s %11s %8s %12s %10s %14s %8s %8s %8s\n", "scheme", "steps", "degree/error",
              "worst film", "at deg", "mean film", "worst mu", "FMEP", "steps", "Newton", "ms");
  const cycle::CycleResult reference =
      integrated(at, {cycle::TimeScheme::kBdf2, cycle::StepControl::kFixed, kReferenceStepDeg}).result;
  for (const cycle::TimeScheme scheme : {cycle::TimeScheme::kBackwardEuler, cycle::TimeScheme::kBdf2}) {
    for (const double step_deg : {1.0, 0.5, 0.25, 0.125}) {
      const Steps steps{scheme, cycle::StepControl::kFixed, step_deg};
      print_row(steps, integrated(at, steps), reference);
    }
    for (const double error : {4e-3, 1e-3, 2.5e-4}) {
      const Steps steps{scheme, cycle::StepControl::kAdaptive, error};
      print_row(steps, integrated(at, steps), reference);
    }
  }
}

}  // namespace
}  // namespace ringfilm

int main() {
  std::printf("error of the film in time against fixed steps of 0.02 degree\n");
  for (const ringfilm::RingAtSpeed& at : {ringfilm::RingAtSpeed{"embedded", 1500}, ringfilm::RingAtSpeed{"new", 1500},
                                          ringfilm::RingAtSpeed{"run-in", 3000}, ringfilm::RingAtSpeed{"new", 6000}}) {
    ringfilm::print_ring(at);
  }
}
