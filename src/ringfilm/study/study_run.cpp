#include "ringfilm/study/study_run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <map>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "ringfilm/base/append_new.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/design/kept_curves.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/ensemble/threads.hpp"
#include "ringfilm/study/pack_scenario.hpp"

namespace ringfilm::study {
namespace {

/// Ends a batch from within.
struct Stopped {};

/// The curves of a block [bytes].
constexpr std::size_t kMaxCurves = std::size_t{1} << 24;

ScenarioRow row_of(const cycle::CycleResult& result, const OutputSelection& keep) {
  ScenarioRow row;
  for (const auto& quantity : cycle::cycle_quantities()) row.values.push_back(result.values.*quantity.value);
  row.curves = kept_numbers(keep, result.samples);
  add_topics(result.notes, row);
  return row;
}

ScenarioRow unsolved_row(std::string reason, const Plan& plan) {
  while (!reason.empty() && reason.back() == '\n') reason.pop_back();
  return {std::vector<double>(plan.values().quantities.size(), std::numeric_limits<double>::quiet_NaN()),
          reason.empty() ? "not solved" : std::move(reason), no_kept_numbers(plan.study())};
}

std::uint64_t rows_in_block(const Study& study, std::uint64_t most_rows) {
  const std::size_t row = sizeof(float) * kept_curves(study).size() * kept_angles(study.keep).size();
  return row == 0 ? most_rows : std::min<std::uint64_t>(most_rows, std::max<std::size_t>(kMaxCurves / row, 1));
}

/// Takes rows as they end and hands them over in blocks: when one is full, and after a time what there is.
class Collector {
 public:
  Collector(std::uint64_t first, bool has_cycle, const std::function<Continuation(const ScenarioBlock&)>& finished,
            const StudyRunOptions& options)
      : next_(first), has_cycle_(has_cycle), finished_(finished), options_(options) {
    for (const ScenarioRange& range : options.there) there_.emplace(range.first, range.end);
    step_over();
    clock_ = std::jthread([this](const std::stop_token& stop) { hand_over_by_time(stop); });
  }

  /// Throws what ended the run.
  void put(std::uint64_t scenario, ScenarioRow row) {
    const std::lock_guard lock(mutex_);
    look();
    rows_.emplace(scenario, std::move(row));
    step_over();
    if (n_ready_ >= options_.most_rows) unless_it_throws([this] { hand_over_ready(); });
  }

  /// Throws what ended the run, for a thread that is in the midst of its scenario.
  void look() const {
    if (has_ended_) std::rethrow_exception(failure_);
  }

  /// Hands over all rows that are left. Throws what ended the run.
  void finish() {
    clock_ = {};
    look();
    hand_over_ready();
  }

  /// Hands over the rows of a stopped run, including those that wait for others.
  void keep_waiting() {
    clock_ = {};
    hand_over_waiting();
  }

  std::uint64_t next() const { return next_; }

 private:
  void hand_over_by_time(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    for (int n = 1;; ++n) {
      pause_.wait_for(lock, stop, std::chrono::duration<double>(options_.longest_wait), [] { return false; });
      if (stop.stop_requested() || has_ended_) return;
      try {
        unless_it_throws([&] {
          hand_over_ready();
          if (options_.order == RowOrder::kAsFinished && n % kWaitsOutOfTurn == 0) hand_over_waiting();
          if (is_enough_) throw Stopped{};
        });
      } catch (...) {
        return;  // the threads that compute meet it
      }
    }
  }

  /// What is thrown ends the run for all threads.
  template <class Work>
  void unless_it_throws(const Work& work) {
    try {
      work();
    } catch (...) {
      failure_ = std::current_exception();
      has_ended_ = true;
      throw;
    }
  }

  /// Throws Stopped if no more rows are requested.
  void hand_over_ready() {
    while (n_ready_ > 0) {
      const std::uint64_t n = std::min(n_ready_, options_.most_rows);
      hand_over(next_, n);
      next_ += n;
      n_ready_ -= n;
      step_over();
      if (is_enough_) throw Stopped{};
    }
  }

  void hand_over_waiting() {
    while (!rows_.empty()) {
      const std::uint64_t first = rows_.begin()->first;
      std::uint64_t n = 1;
      while (n < options_.most_rows && rows_.contains(first + n)) ++n;
      hand_over(first, n);
      there_.emplace(first, first + n);
    }
    n_ready_ = 0;
    step_over();
  }

  void hand_over(std::uint64_t first, std::uint64_t n) {
    ScenarioBlock block{first, {}, has_cycle_};
    while (block.rows.size() < n) block.rows.push_back(std::move(rows_.extract(first + block.rows.size()).mapped()));
    if (finished_(block) == Continuation::kNo) is_enough_ = true;
  }

  /// Passes rows that exist, and counts those that follow.
  void step_over() {
    for (auto range = there_.find(next_); n_ready_ == 0 && range != there_.end(); range = there_.find(next_))
      next_ = there_.extract(range).mapped();
    while (n_ready_ < rows_.size() && rows_.contains(next_ + n_ready_)) ++n_ready_;
  }

  std::uint64_t next_;         ///< first that is not handed over
  bool has_cycle_;             ///< ScenarioBlock::has_cycle of the blocks
  bool is_enough_ = false;     ///< no more rows are requested
  std::uint64_t n_ready_ = 0;  ///< from there on without a gap
  std::map<std::uint64_t, ScenarioRow> rows_;
  std::map<std::uint64_t, std::uint64_t> there_;  ///< from its first scenario the end of each range beyond `next_`
  const std::function<Continuation(const ScenarioBlock&)>& finished_;
  StudyRunOptions options_;
  std::mutex mutex_;
  std::condition_variable_any pause_;
  std::exception_ptr failure_;
  std::atomic<bool> has_ended_ = false;
  std::jthread clock_;  ///< last: it uses the others until it ends
};

/// Which cases are run, by numbers from `range`.
struct Cases {
  ScenarioRange range;
  std::function<cycle::Case(std::uint64_t)> at;  ///< throws InputError where there is none
  std::vector<ScenarioRange> there = {};         ///< not run; in order

  bool has_row(std::uint64_t i) const {
    const auto after = std::upper_bound(there.begin(), there.end(), i,
                                        [](std::uint64_t row, const ScenarioRange& one) { return row < one.first; });
    return after != there.begin() && i < std::prev(after)->end;
  }
};

/// Takes the rows as they end, never two at a time.
using Put = std::function<void(std::uint64_t, ScenarioRow)>;

/// Ring packs and their gas: each scenario by itself, several at a time.
void run_one_by_one(const Plan& plan, const Cases& cases, const Put& put, const BatchOptions& options) {
  std::mutex mutex;
  std::atomic<std::uint64_t> next = cases.range.first;
  std::atomic<bool> has_ended = false;
  const auto row = [&](std::uint64_t i) {
    try {
      return pack_row(cases.at(i), plan.study(), plan.values());
    } catch (const InputError& refusal) {
      return unsolved_row(reason_of(refusal), plan);
    } catch (const ConvergenceError& stop) {
      return unsolved_row(stop.what(), plan);
    }
  };
  const auto work = [&](int) {
    try {
      for (std::uint64_t i = next++; i < cases.range.end && !has_ended; i = next++) {
        if (cases.has_row(i)) continue;
        if (options.pulse) options.pulse();
        ScenarioRow one = row(i);
        const std::lock_guard lock(mutex);
        if (!has_ended) put(i, std::move(one));
      }
    } catch (...) {
      has_ended = true;
      throw;
    }
  };
  on_threads(n_threads(options.threads), work);
}

/// Single films, in the lanes of a batch.
void run_in_lanes(const Plan& plan, const Cases& cases, const OutputSelection& keep, const Put& put,
                  const BatchOptions& options) {
  std::map<std::size_t, std::uint64_t> number_of;  // numbers of the cases in progress, by their place in the batch
  std::size_t n_given = 0;
  std::uint64_t next = cases.range.first;
  const auto source = [&]() -> std::optional<cycle::Case> {
    while (next < cases.range.end) {
      const std::uint64_t i = next++;
      if (cases.has_row(i)) continue;
      try {
        cycle::Case one = cases.at(i);
        number_of[n_given++] = i;
        return one;
      } catch (const InputError& refusal) {
        put(i, unsolved_row(reason_of(refusal), plan));
      }
    }
    return std::nullopt;
  };
  const auto ended = [&](const Ending& ending) {
    const std::uint64_t i = number_of.extract(ending.index).mapped();
    put(i, ending.is_solved() ? row_of(ending.result, keep) : unsolved_row(ending.reason(), plan));
  };
  simulate_cases(source, ended, options);
}

}  // namespace

void add_topics(std::vector<cycle::Note> notes, ScenarioRow& row) {
  append_new(row.notes, std::move(notes),
             [](const cycle::Note& one, const cycle::Note& other) { return one.topic == other.topic; });
}

ScenarioRange shard_range(std::uint64_t n_scenarios, std::uint64_t part, std::uint64_t parts) {
  if (part < 1 || part > parts) {
    throw InputError("there is no part " + std::to_string(part) + " of " + std::to_string(parts),
                     "parts count from 1, for example 2/4");
  }
  const std::uint64_t least = n_scenarios / parts, n_longer = n_scenarios % parts;
  const std::uint64_t first = (part - 1) * least + std::min(part - 1, n_longer);
  return {first, first + least + (part <= n_longer ? 1 : 0)};
}

std::uint64_t run_scenarios(const Plan& plan, const ScenarioRange& range,
                            const std::function<Continuation(const ScenarioBlock&)>& finished,
                            const StudyRunOptions& options) {
  const OutputSelection& keep = plan.study().keep;
  StudyRunOptions in_blocks = options;
  in_blocks.most_rows = rows_in_block(plan.study(), options.most_rows);
  Collector collector(range.first, plan.values().has_cycle, finished, in_blocks);
  const bool is_film = is_one_film(plan.study(), plan.study().bases.front().input);
  const auto scenario = [&](std::uint64_t i) {
    cycle::Case one = scenario_case(plan.study(), plan.point(i));
    ask_for_kept(keep, one);
    return one;
  };
  const auto put = [&](std::uint64_t i, ScenarioRow row) {
    row.base = plan.base_of(i);
    collector.put(i, std::move(row));
  };
  BatchOptions batch = options.batch;
  batch.pulse = [&] {
    collector.look();
    if (options.batch.pulse) options.batch.pulse();
  };
  try {
    if (is_film) {
      run_in_lanes(plan, {range, scenario, options.there}, keep, put, batch);
    } else {
      run_one_by_one(plan, {range, scenario, options.there}, put, batch);
    }
    collector.finish();
  } catch (const Stopped&) {
    // What was handed over is kept.
    if (options.order == RowOrder::kAsFinished) collector.keep_waiting();
  }
  return collector.next();
}

std::vector<std::vector<double>> values_of_changed(const Plan& plan, const std::vector<std::uint64_t>& scenarios,
                                                   const std::function<cycle::Case(const cycle::Case&)>& change,
                                                   const Progress& progress, const BatchOptions& options) {
  const bool is_film = is_one_film(plan.study(), plan.study().bases.front().input);
  const auto changed = [&](std::uint64_t k) {
    cycle::Case one = scenario_case(plan.study(), plan.point(scenarios[k]));
    ask_for_kept(plan.study().keep, one);  // on which the steps of a case with an accuracy depend
    if (is_film) {
      one = change(one);
      ask_for_kept({}, one);
      return one;
    }
    std::vector<cycle::Case> rings = std::move(one.rings);
    one = change(one);
    for (cycle::Case& ring : rings) ring = change(ring);
    one.rings = std::move(rings);
    return one;
  };
  std::vector<std::vector<double>> values(scenarios.size());
  int n_ended = 0;
  const auto put = [&](std::uint64_t k, ScenarioRow row) {
    values[k] = std::move(row.values);
    if (progress) progress(++n_ended, static_cast<int>(scenarios.size()));
  };
  const Cases cases{{0, scenarios.size()}, changed};
  if (is_film) {
    run_in_lanes(plan, cases, {}, put, options);
  } else {
    run_one_by_one(plan, cases, put, options);
  }
  return values;
}

}  // namespace ringfilm::study
