#include "ringfilm/study/ensemble/cycle_integrators.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/study/ensemble/threads.hpp"

namespace ringfilm::study {
namespace {

/// How many cycles have ended, of those that were requested so far.
class Count {
 public:
  explicit Count(Progress progress) : progress_(std::move(progress)) {}

  void begins(std::size_t n) { total_ += static_cast<int>(n); }
  void one_ended() {
    const std::lock_guard lock(mutex_);
    ++ended_;
    if (progress_) progress_(ended_, total_);
  }

 private:
  Progress progress_;
  std::mutex mutex_;
  int ended_ = 0, total_ = 0;
};

InputError named(const life::CycleRequest& request, const InputError& refusal) {
  std::vector<Fault> faults = refusal.faults();
  for (Fault& fault : faults) fault.message = request.name + ": " + fault.message;
  return InputError(std::move(faults));
}

cycle::CycleResult simulated(const life::CycleRequest& request) {
  try {
    check_rules(request.input);
    return cycle::simulate(cycle::prepare(request.input));
  } catch (const cycle::StoppedCycle& stop) {
    throw ConvergenceError(request.name + ": " + stop.what(), stop.crank_angle_deg());
  } catch (const InputError& refusal) {
    throw named(request, refusal);
  }
}

std::vector<cycle::CycleResult> each_alone(const std::vector<life::CycleRequest>& requests, const BatchOptions& options,
                                           Count& count) {
  std::vector<cycle::CycleResult> results(requests.size());
  count.begins(requests.size());
  std::atomic<std::size_t> next = 0;
  const int n = std::min(n_threads(options.threads), static_cast<int>(requests.size()));
  on_threads(n, [&](int) {
    for (std::size_t i = next++; i < requests.size(); i = next++) {
      if (options.pulse) options.pulse();
      results[i] = simulated(requests[i]);
      count.one_ended();
    }
  });
  return results;
}

std::vector<cycle::CycleResult> all_in_a_batch(const std::vector<life::CycleRequest>& requests,
                                               const BatchOptions& options, Count& count) {
  std::vector<cycle::Case> cases;
  for (const life::CycleRequest& request : requests) cases.push_back(request.input);
  count.begins(requests.size());
  std::vector<Ending> ended = endings(
      cases, [&count](int, int) { count.one_ended(); }, options);
  std::vector<cycle::CycleResult> results;
  for (std::size_t i = 0; i < ended.size(); ++i) {
    if (ended[i].refusal) throw named(requests[i], *ended[i].refusal);
    if (ended[i].stop) {
      throw ConvergenceError(requests[i].name + ": " + ended[i].stop->message, ended[i].stop->crank_angle_deg);
    }
    results.push_back(std::move(ended[i].result));
  }
  return results;
}

}  // namespace

life::CycleIntegrators cycle_integrators(const BatchOptions& options, const Progress& progress) {
  const auto count = std::make_shared<Count>(progress);
  return {[options, count](const auto& requests) { return each_alone(requests, options, *count); },
          [options, count](const auto& requests) { return all_in_a_batch(requests, options, *count); }};
}

}  // namespace ringfilm::study
