#include "sampled_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "processor.hpp"

namespace ringfilm::benchmarks {
namespace {

constexpr int kStepsPerCycle = 720;
constexpr int kStart = 270;  // mid exhaust stroke, as of any integration

/// Over-relaxation factors that are tried: 2 - factor falls by a quarter each time.
const std::vector<double> kFactors = {1.7,  1.775, 1.831, 1.873, 1.905, 1.929, 1.947,
                                      1.96, 1.97,  1.978, 1.983, 1.987, 1.99};

}  // namespace

/// Keeps what one step in `every` started from.
class SampledSteps::Sampler : public cycle::StepObserver {
 public:
  Sampler(std::vector<Step>& steps, int every) : steps_(steps), every_(every) {}
  void before_step(cycle::TimeIntegration& integration, double, double) override { start_ = integration.state(); }
  void after_step(const cycle::TimeIntegration& integration) override {
    const auto at = integration.instant();
    if (taken_++ % every_ == 0 && taken_ > 1) {
      Step step{at.at.inputs, *at.previous, start_, *at.state};
      step.guess.h_m = start_.h_m * start_.h_m / before_h_m_;  // extrapolated, as the integration does
      steps_.push_back(step);
    }
    before_h_m_ = start_.h_m;
  }

 private:
  std::vector<Step>& steps_;
  int every_;
  int taken_ = 0;
  film::FilmState start_;
  double before_h_m_ = 0;
};

SampledSteps::SampledSteps(const Scenarios& scenarios, int every)
    : setup_(std::make_unique<cycle::Setup>(scenarios.setup(0))),
      integration_(std::make_unique<cycle::TimeIntegration>(*setup_)) {
  Sampler sampler(steps_, every);
  integration_->start(kStart);
  for (int k = 0; k < kStepsPerCycle; ++k) integration_->advance(sampler);
}

MethodCost SampledSteps::cost(film::RelaxationWorkspace workspace) const {
  MethodCost cost;
  film::FilmState state;
  for (const Step& step : steps_) {
    state = step.guess;
    const double start = processor_seconds();
    const auto report =
        film::solve_by_point_relaxation(integration_->problem(), step.inputs, step.previous, state, workspace);
    cost.seconds_per_cycle += processor_seconds() - start;
    cost.effort_per_step += static_cast<double>(report.sweeps);
    cost.failed += !report.converged;
    if (report.converged) cost.difference = std::max(cost.difference, std::abs(state.h_m / step.solution.h_m - 1));
  }
  const auto n_steps = static_cast<double>(steps_.size());
  cost.seconds_per_cycle *= kStepsPerCycle / n_steps;
  cost.effort_per_step /= n_steps;
  return cost;
}

std::optional<double> SampledSteps::best_factor() const {
  double fewest = std::numeric_limits<double>::infinity();
  std::optional<double> best;
  for (const double factor : kFactors) {
    const MethodCost now = cost(film::RelaxationWorkspace({factor}));
    if (now.failed > 0 || now.effort_per_step >= fewest) continue;
    fewest = now.effort_per_step;
    best = factor;
  }
  return best;
}

}  // namespace ringfilm::benchmarks
