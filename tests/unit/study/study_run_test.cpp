#include "ringfilm/study/study_run.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <semaphore>
#include <set>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "study_example.hpp"

namespace ringfilm::study {
namespace {

using testing::factor;
using testing::study_of;

/// Speeds of which those above 0 can be run.
Plan speeds(std::vector<double> values) {
  return Plan(study_of({factor("operating.speed", Levels{std::move(values)}, FactorMode::kScale)}, Method::kGrid));
}

struct Collected {
  std::vector<ScenarioRow> rows;
  std::uint64_t blocks = 0, next = 0;
};

Collected run(const Plan& plan, const ScenarioRange& range, std::uint64_t most_rows, std::uint64_t blocks_requested) {
  Collected all;
  StudyRunOptions options;
  options.most_rows = most_rows;
  const auto finished = [&](const ScenarioBlock& block) {
    EXPECT_EQ(block.first, range.first + all.rows.size());
    EXPECT_LE(block.rows.size(), most_rows);
    all.rows.insert(all.rows.end(), block.rows.begin(), block.rows.end());
    return ++all.blocks == blocks_requested ? Continuation::kNo : Continuation::kYes;
  };
  all.next = run_scenarios(plan, range, finished, options);
  return all;
}

TEST(ShardRange, PartsFollowEachOtherAndDifferByOneAtMost) {
  for (const std::uint64_t n : {0u, 1u, 7u, 100u}) {
    std::uint64_t next = 0;
    std::set<std::uint64_t> sizes;
    for (std::uint64_t part = 1; part <= 7; ++part) {
      const ScenarioRange range = shard_range(n, part, 7);
      EXPECT_EQ(range.first, next);
      next = range.end;
      sizes.insert(range.size());
    }
    EXPECT_EQ(next, n);
    EXPECT_LE(*sizes.rbegin() - *sizes.begin(), 1u);
  }
  EXPECT_THROW(shard_range(10, 0, 4), InputError);
  EXPECT_THROW(shard_range(10, 5, 4), InputError);
}

TEST(RunScenarios, ARowHasTheNotesOfItsResult) {
  const Plan plan = speeds({1.0, 0.0});
  const Collected all = run(plan, {0, plan.size()}, 2, 0);
  const auto alone = endings({scenario_case(plan.study(), plan.point(0))});
  std::set<std::string> expected, found;
  for (const cycle::Note& note : alone.front().result.notes) expected.insert(note.topic);
  for (const cycle::Note& note : all.rows.at(0).notes) EXPECT_TRUE(found.insert(note.topic).second) << note.topic;
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(found, expected);
  EXPECT_TRUE(all.rows.at(1).notes.empty());
}

TEST(RunScenarios, RowsComeInOrderAndARefusalIsARowWithItsReason) {
  const Plan plan = speeds({1.0, 1.1, 0.0, 1.2, -1.0, 1.3});
  const Collected all = run(plan, {0, plan.size()}, 2, 0);
  ASSERT_EQ(all.rows.size(), 6u);
  EXPECT_EQ(all.next, 6u);
  const auto& quantities = cycle::cycle_quantities();
  for (std::size_t i = 0; i < all.rows.size(); ++i) {
    const bool is_refused = i == 2 || i == 4;
    EXPECT_EQ(all.rows[i].reason.empty(), !is_refused) << i;
    ASSERT_EQ(all.rows[i].values.size(), quantities.size());
    for (const double value : all.rows[i].values) EXPECT_EQ(std::isnan(value), is_refused);
  }
  EXPECT_NE(all.rows[2].reason.find("operating.speed"), std::string::npos);
  // Each row is that of its own scenario.
  const auto alone = endings({scenario_case(plan.study(), plan.point(3))});
  for (std::size_t q = 0; q < quantities.size(); ++q)
    EXPECT_EQ(all.rows[3].values[q], alone.front().result.values.*quantities[q].value) << quantities[q].name;
}

TEST(RunScenarios, StopsAfterTheBlockAndContinuesWithTheSameNumbers) {
  const Plan plan = speeds({1.0, 1.1, 1.2, 1.3, 1.4, 1.5});
  const Collected whole = run(plan, {0, 6}, 6, 0), begun = run(plan, {0, 6}, 2, 1);
  EXPECT_EQ(begun.next, begun.rows.size());
  ASSERT_LT(begun.next, 6u);
  const Collected rest = run(plan, {begun.next, 6}, 6, 0);
  for (std::size_t i = 0; i < 6; ++i) {
    const ScenarioRow& row = i < begun.next ? begun.rows[i] : rest.rows[i - begun.next];
    EXPECT_EQ(row.values, whole.rows[i].values) << i;
  }
}

/// Two scenarios on two threads; one of them begins once a row has been handed over.
std::vector<std::uint64_t> order_with_late(std::uint64_t late, RowOrder order) {
  const std::vector<double> factors = {1.0, 1.1};
  const Plan plan = speeds(factors);
  std::counting_semaphore<8> has_row{0};
  bool was_in_time = true;
  StudyRunOptions options;
  options.order = order;
  options.longest_wait = 0.01;
  options.batch.threads = 2;
  options.batch.prepare = [&](const cycle::Case& c) {
    const bool is_late = c.operating.speed == scenario_case(plan.study(), plan.point(late)).operating.speed;
    if (is_late) was_in_time = has_row.try_acquire_for(std::chrono::seconds(60));
    return cycle::prepare(c);
  };
  std::vector<std::uint64_t> firsts;
  const auto finished = [&](const ScenarioBlock& block) {
    firsts.push_back(block.first);
    has_row.release();
    return Continuation::kYes;
  };
  EXPECT_EQ(run_scenarios(plan, {0, 2}, finished, options), 2u);
  EXPECT_TRUE(was_in_time);
  return firsts;
}

// What a kill loses is bounded by time: a row that is ready waits neither for the next one nor for a slower one.
TEST(RunScenarios, ARowIsHandedOverBeforeTheNextOneEnds) {
  EXPECT_EQ(order_with_late(1, RowOrder::kOfPlan), (std::vector<std::uint64_t>{0, 1}));
}

TEST(RunScenarios, ARowIsHandedOverBeforeASlowerOneOfLowerNumber) {
  EXPECT_EQ(order_with_late(0, RowOrder::kAsFinished), (std::vector<std::uint64_t>{1, 0}));
}

TEST(RunScenarios, ScenariosWhoseRowsExistAreNotRun) {
  const Plan plan = speeds({1.0, 1.1, 1.2, 1.3, 1.4, 1.5});
  StudyRunOptions options;
  options.there = {{1, 3}, {4, 5}};
  std::vector<std::uint64_t> run;
  const auto finished = [&](const ScenarioBlock& block) {
    for (std::size_t k = 0; k < block.rows.size(); ++k) run.push_back(block.first + k);
    return Continuation::kYes;
  };
  EXPECT_EQ(run_scenarios(plan, {0, 6}, finished, options), 6u);
  EXPECT_EQ(run, (std::vector<std::uint64_t>{0, 3, 5}));
  options.there = {{0, 2}, {5, 6}};
  run.clear();
  EXPECT_EQ(run_scenarios(plan, {0, 6}, finished, options), 6u);
  EXPECT_EQ(run, (std::vector<std::uint64_t>{2, 3, 4}));
}

TEST(RunScenarios, AnErrorOfTheObserverEndsTheRun) {
  const Plan plan = speeds({1.0, 1.1});
  const auto full = [](const ScenarioBlock&) -> Continuation { throw OutputError("the disk is full"); };
  EXPECT_THROW(run_scenarios(plan, {0, 2}, full), OutputError);
}

}  // namespace
}  // namespace ringfilm::study
