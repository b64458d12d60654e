#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/design/plan.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

/// Runs scenarios of a plan and hands over what came of them, in their order.
namespace ringfilm::study {

/// Above this many points a full grid is only run where the user allows it.
inline constexpr std::uint64_t kMaxGrid = 10'000;

/// What is kept of a scenario.
struct ScenarioRow {
  std::vector<double> values;           ///< in the order of Plan::values(); all NaN if not solved
  std::string reason;                   ///< why it was not solved; empty if it was
  std::vector<float> curves = {};       ///< kept_numbers(): quantity by quantity over the angles; all NaN if not solved
  std::vector<cycle::Note> notes = {};  ///< notes on the result, each topic once; none if not solved
  std::size_t base = 0;                 ///< base case of the scenario
};

/// Adds the notes to those of a row, each topic once.
void add_topics(std::vector<cycle::Note> notes, ScenarioRow& row);

/// Scenarios `first` to `first + rows.size()`.
struct ScenarioBlock {
  std::uint64_t first = 0;        ///< number of the first of them in the plan
  std::vector<ScenarioRow> rows;  ///< in the order of the plan
  bool has_cycle = true;          ///< StudyValues::has_cycle of the study
};

/// Scenarios from `first` to before `end`.
struct ScenarioRange {
  std::uint64_t first = 0;                            ///< number in the plan, from 0
  std::uint64_t end = 0;                              ///< one past the last
  std::uint64_t size() const { return end - first; }  ///< how many
};

/// The scenarios of part `part` (from 1) of `parts` that differ by one scenario at the most. Throws InputError unless
/// 1 <= part <= parts.
ScenarioRange shard_range(std::uint64_t n_scenarios, std::uint64_t part, std::uint64_t parts);

/// Whether an observer of a run requests more.
enum class Continuation {
  kYes,  ///< the next scenarios
  kNo    ///< no more: rows that are not handed over are lost
};

/// The order in which rows are handed over.
enum class RowOrder {
  kOfPlan,     ///< a row waits for all before it, however long they take
  kAsFinished  ///< as kOfPlan, but rows that wait are handed over out of turn after kWaitsOutOfTurn waits
};
inline constexpr int kWaitsOutOfTurn = 4;  ///< each row out of turn costs a block of its own

/// How a study is run; none of it changes a number.
struct StudyRunOptions {
  BatchOptions batch;             ///< threads, and how a case is set up
  std::uint64_t most_rows = 256;  ///< in one block; fewer where their curves are more than 16 MB
  /// What is ready is handed over after this time [s]. To write a block to the disk takes some milliseconds.
  double longest_wait = 0.5;
  RowOrder order = RowOrder::kOfPlan;     ///< in which rows are handed over
  std::vector<ScenarioRange> there = {};  ///< in their order: scenarios whose rows exist, which are not run
};

/// Runs the scenarios of a range and hands them over in blocks, as they are ready; where a block ends depends on the
/// time, the content of its rows does not. A scenario that cannot be made into a case, or be solved, is a row with its
/// reason. Where `finished` returns kNo or throws, rows that are not handed over are lost. It is called by one thread
/// at a time.
/// @returns the first scenario that was not handed over
std::uint64_t run_scenarios(const Plan& plan, const ScenarioRange& range,
                            const std::function<Continuation(const ScenarioBlock&)>& finished,
                            const StudyRunOptions& options = {});

/// Values of some scenarios whose cases are changed before they are run, in the order of `scenarios`; all NaN of one
/// that cannot be made into a case, or be solved.
/// @param change of the case of one film with the output that the study requires, or of each ring of a pack
std::vector<std::vector<double>> values_of_changed(const Plan& plan, const std::vector<std::uint64_t>& scenarios,
                                                   const std::function<cycle::Case(const cycle::Case&)>& change,
                                                   const Progress& progress = {}, const BatchOptions& options = {});

}  // namespace ringfilm::study
