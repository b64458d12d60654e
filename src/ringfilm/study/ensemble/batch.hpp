#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/simulate_batch.hpp"

/// Many scenarios at once: threads, and on each of them the lanes of a vector register.
namespace ringfilm::study {

/// How a batch is computed; none of it changes a number.
struct BatchOptions {
  int threads = 0;  ///< 0: as many as the machine runs at once
  /// How a case is set up: empty, by cycle::prepare. One's own may bring another oil (cycle::OwnOil); it is called
  /// from several threads at a time, and an InputError that it throws refuses the case.
  std::function<cycle::Setup(const cycle::Case&)> prepare = {};
  /// Called by every thread now and then from within its integrations, from several at a time. What it throws ends the
  /// batch.
  std::function<void()> pulse = {};
};

/// Throws InputError with every rule that a case breaks: one that was made from another was never checked as a file is.
void check_rules(const cycle::Case& c);

/// All faults of a refusal on one line.
std::string reason_of(const InputError& refusal);

/// How a scenario of a batch ended.
struct Ending {
  std::size_t index = 0;  ///< in the order in which the cases were given, from 0
  /// All up to the last good angle if the integration stopped, nothing if the case was refused; both with every value
  /// NaN.
  cycle::CycleResult result;
  std::optional<cycle::Stop> stop;    ///< why the integration stopped
  std::optional<InputError> refusal;  ///< why the case could not be prepared, or which rules it breaks

  bool is_solved() const { return !stop && !refusal; }  ///< neither stopped nor refused
  /// Why not, on one line; empty if solved.
  std::string reason() const;
};

/// Gives the cases one by one; nothing: there are no more.
using CaseSource = std::function<std::optional<cycle::Case>()>;

/// What a batch took.
struct BatchEffort {
  int threads = 0;          ///< threads that had cases to integrate
  cycle::LaneEffort lanes;  ///< effort of the lanes of all threads
};

/// Adds what another thread took.
void add(const cycle::LaneEffort& part, cycle::LaneEffort& all);

/// Simulates the cycle of every case that `next` gives and reports each as it ends, not in order. `next` and `ended`
/// are called from several threads but never two at a time. Same case, same bits, whatever the number of threads and
/// whatever else is in the batch. Memory does not grow with the number of cases: 64 for each thread are read ahead, and
/// on each thread, beside those in its lanes, at most 64 more that are ready wait for a lane of their kind. Fewer than
/// are read ahead are shared out so that all threads end at about the same time. An exception, be it of `next` or
/// `ended`, ends the batch: neither is called again, and it is rethrown when all threads have ended.
BatchEffort simulate_cases(const CaseSource& next, const std::function<void(Ending)>& ended,
                           const BatchOptions& options = {});

/// Called as each case ends: done, total; never twice at a time.
using Progress = std::function<void(int, int)>;

/// How all of a few cases end, in their order.
std::vector<Ending> endings(const std::vector<cycle::Case>& cases, const Progress& progress = {},
                            const BatchOptions& options = {});

}  // namespace ringfilm::study
