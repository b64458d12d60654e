#include "ringfilm/study/ensemble/batch.hpp"

#include <atomic>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <type_traits>
#include <utility>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/cycle_values.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/study/ensemble/threads.hpp"
#include "ringfilm/study/statistics/shares.hpp"

namespace ringfilm::study {
namespace {

/// Cases that are read ahead for each thread.
constexpr std::size_t kAhead = 64;

/// A case with its place in the batch.
struct Numbered {
  std::size_t index;
  cycle::Case input;
};

/// Where threads take their cases and hand in what became of them; one at a time.
class WorkQueue {
 public:
  WorkQueue(const CaseSource& next, const std::function<void(Ending)>& ended) : next_(next), ended_(ended) {}

  /// Reads ahead; a batch that ends within is shared out. @returns threads that have something to do
  int open(int n_threads, int width) {
    std::vector<cycle::Case> ahead;
    while (ahead.size() < kAhead * n_threads) {
      std::optional<cycle::Case> one = next_();
      if (!one) break;
      ahead.push_back(std::move(*one));
    }
    const bool is_all = ahead.size() < kAhead * n_threads;
    if (is_all) {
      const auto parts = shares(ahead, n_threads, width);
      for (const auto& part : parts) {
        auto& share = shares_.emplace_back();
        for (const std::size_t i : part) share.push_back({i, std::move(ahead[i])});
      }
      return static_cast<int>(parts.size());
    }
    n_read_ = ahead.size();
    for (std::size_t i = 0; i < ahead.size(); ++i) waiting_.push_back({i, std::move(ahead[i])});
    return n_threads;
  }

  /// The next case for a thread. Throws what ended the batch.
  std::optional<Numbered> take(int thread) {
    const std::lock_guard lock(mutex_);
    if (failure_ != nullptr) std::rethrow_exception(failure_);
    auto& from = shares_.empty() ? waiting_ : shares_[thread];
    if (!from.empty()) {
      Numbered one = std::move(from.front());
      from.pop_front();
      return one;
    }
    if (!shares_.empty() || is_dry_) return std::nullopt;
    std::optional<cycle::Case> one = call([&] { return next_(); });
    is_dry_ = !one;
    if (is_dry_) return std::nullopt;
    return Numbered{n_read_++, std::move(*one)};
  }

  /// Throws what ended the batch.
  void hand_in(Ending ending) {
    const std::lock_guard lock(mutex_);
    if (failure_ != nullptr) std::rethrow_exception(failure_);
    call([&] { ended_(std::move(ending)); });
  }

  /// Ends the batch.
  void fail(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (failure_ == nullptr) failure_ = std::move(failure);
    has_failed_ = true;
  }

  /// Throws what ended the batch, for a thread that is in the midst of its integrations.
  void look() {
    if (!has_failed_) return;
    const std::lock_guard lock(mutex_);
    std::rethrow_exception(failure_);
  }

 private:
  /// Calls back under the lock; what it throws ends the batch before another thread can call.
  template <class Callback>
  std::invoke_result_t<Callback> call(const Callback& callback) {
    try {
      return callback();
    } catch (...) {
      failure_ = std::current_exception();
      has_failed_ = true;
      throw;
    }
  }

  const CaseSource& next_;
  const std::function<void(Ending)>& ended_;
  std::mutex mutex_;
  std::vector<std::deque<Numbered>> shares_;  ///< cases of each thread, if the batch is a small one
  std::deque<Numbered> waiting_;
  std::size_t n_read_ = 0;
  bool is_dry_ = false;
  std::exception_ptr failure_;
  std::atomic<bool> has_failed_ = false;
};

Ending refused(std::size_t index, const InputError& refusal) {
  Ending ending{index, {}, std::nullopt, refusal};
  ending.result.values = cycle::no_cycle_values();
  ending.result.complete = false;
  return ending;
}

/// All that one thread does.
cycle::LaneEffort serve(WorkQueue& desk, int thread, const BatchOptions& options) {
  std::map<std::size_t, std::size_t> index;  // in the batch, of scenarios on their way, by their number on this thread
  std::size_t n_begun = 0;
  const auto setup = [&]() -> std::optional<cycle::Setup> {
    while (std::optional<Numbered> one = desk.take(thread)) {
      try {
        check_rules(one->input);
        cycle::Setup ready = options.prepare ? options.prepare(one->input) : cycle::prepare(one->input);
        index[n_begun++] = one->index;
        return ready;
      } catch (const InputError& refusal) {
        desk.hand_in(refused(one->index, refusal));
      }
    }
    return std::nullopt;
  };
  const auto finished = [&](cycle::BatchOutcome outcome) {
    desk.hand_in(
        {index.extract(outcome.index).mapped(), std::move(outcome.result), std::move(outcome.stop), std::nullopt});
  };
  const auto pulse = [&] {
    desk.look();
    if (options.pulse) options.pulse();
  };
  return cycle::simulate_batch(setup, finished, pulse);
}

}  // namespace

void check_rules(const cycle::Case& c) {
  std::vector<Fault> faults;
  for (cycle::RuleBreach& breach : cycle::broken_rules(c)) {
    faults.push_back({{}, std::move(breach.message), std::move(breach.remedy)});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

std::string reason_of(const InputError& refusal) {
  std::string reason;
  for (const Fault& fault : refusal.faults()) reason.append(reason.empty() ? "" : "; ").append(fault.message);
  return reason;
}

std::string Ending::reason() const {
  if (stop) return stop->message;
  return refusal ? reason_of(*refusal) : "";
}

void add(const cycle::LaneEffort& part, cycle::LaneEffort& all) {
  all.sweeps += part.sweeps;
  all.lane_sweeps += part.lane_sweeps;
  all.node_sweeps += part.node_sweeps;
  all.single_solves += part.single_solves;
}

BatchEffort simulate_cases(const CaseSource& next, const std::function<void(Ending)>& ended,
                           const BatchOptions& options) {
  WorkQueue desk(next, ended);
  const int n = desk.open(n_threads(options.threads), film::kernels().width);
  std::vector<cycle::LaneEffort> parts(n);
  on_threads(n, [&](int thread) {
    try {
      parts[thread] = serve(desk, thread, options);
    } catch (...) {
      desk.fail(std::current_exception());
      throw;
    }
  });
  BatchEffort effort;
  effort.threads = n;
  for (const cycle::LaneEffort& part : parts) add(part, effort.lanes);
  return effort;
}

std::vector<Ending> endings(const std::vector<cycle::Case>& cases, const Progress& progress,
                            const BatchOptions& options) {
  std::vector<Ending> all(cases.size());
  std::size_t n_given = 0;
  int n_ended = 0;
  const auto next = [&]() -> std::optional<cycle::Case> {
    if (n_given == cases.size()) return std::nullopt;
    return cases[n_given++];
  };
  simulate_cases(
      next,
      [&](Ending ending) {
        const std::size_t index = ending.index;
        all[index] = std::move(ending);
        if (progress) progress(++n_ended, static_cast<int>(cases.size()));
      },
      options);
  return all;
}

}  // namespace ringfilm::study
