#include "ringfilm/study/ensemble/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <numeric>
#include <set>
#include <stdexcept>

#include "../study_case.hpp"

namespace ringfilm::study {
namespace {

using cycle::Case;

/// Cases of several kinds, the integration of one of which stops, while another cannot be prepared.
constexpr std::size_t kStops = 4, kRefused = 7;

Case outside_its_table(Case c) {
  c.lubricant.table_file = "oil.csv";
  c.lubricant.table = cycle::OilTable{{283.15, 293.15}, {1e5, 1e7}, {6e-3, 7e-3, 4e-3, 5e-3}, {790, 795, 780, 785}};
  return c;
}

std::vector<Case> mixed_cases() {
  std::vector<Case> cases;
  for (int i = 0; i < 11; ++i) {
    Case c = testing::coarse_case();
    c.solver.cells = 20 + 10 * (i % 3);
    c.solver.crank_step_deg = 8;
    c.operating.speed *= 1 + 0.1 * i;
    if (i % 2 == 1) c.film.cavitation = cycle::Cavitation::kMassConserving;
    cases.push_back(c);
  }
  cases[kStops].contact.composite_modulus = 1e4;  // asperities of jelly carry nothing, nor does a film that is
  cases[kStops].operating.speed = 1e-3;
  cases[kRefused].lubricant = outside_its_table(cases[kRefused]).lubricant;
  return cases;
}

CaseSource source_of(const std::vector<Case>& cases, std::size_t& n_given) {
  return [&]() -> std::optional<Case> {
    if (n_given == cases.size()) return std::nullopt;
    return cases[n_given++];
  };
}

/// Bit by bit, so that a NaN equals itself.
void expect_same(const Ending& a, const Ending& b) {
  EXPECT_EQ(a.reason(), b.reason());
  EXPECT_EQ(std::memcmp(&a.result.values, &b.result.values, sizeof a.result.values), 0);
  ASSERT_EQ(a.result.samples.size(), b.result.samples.size());
  for (std::size_t k = 0; k < a.result.samples.size(); ++k) {
    EXPECT_EQ(std::memcmp(&a.result.samples[k], &b.result.samples[k], sizeof(cycle::Sample)), 0) << k;
  }
}

TEST(Batch, GivesTheSameBitsOnAnyNumberOfThreadsInAnyOrder) {
  const std::vector<Case> cases = mixed_cases();
  const std::vector<Ending> one = endings(cases, {}, {1});
  for (const int threads : {2, 3}) {
    const std::vector<Ending> several = endings(cases, {}, {threads});
    for (std::size_t i = 0; i < cases.size(); ++i) expect_same(several[i], one[i]);
  }
  const std::vector<Case> backwards(cases.rbegin(), cases.rend());
  const std::vector<Ending> other = endings(backwards, {}, {2});
  for (std::size_t i = 0; i < cases.size(); ++i) expect_same(other[cases.size() - 1 - i], one[i]);
}

TEST(Batch, AStopAndARefusalLeaveTheOthersAlone) {
  const std::vector<Ending> ended = endings(mixed_cases(), {}, {2});
  for (std::size_t i = 0; i < ended.size(); ++i) {
    EXPECT_EQ(ended[i].index, i);
    EXPECT_EQ(ended[i].is_solved(), i != kStops && i != kRefused) << ended[i].reason();
  }
  ASSERT_TRUE(ended[kStops].stop.has_value());
  EXPECT_NE(ended[kStops].reason().find("degree"), std::string::npos) << ended[kStops].reason();
  for (const std::size_t without : {kStops, kRefused}) {
    EXPECT_FALSE(ended[without].result.complete);
    for (const auto& quantity : cycle::cycle_quantities()) {
      EXPECT_TRUE(std::isnan(ended[without].result.values.*quantity.value)) << quantity.name;
    }
  }
  ASSERT_TRUE(ended[kRefused].refusal.has_value());
  EXPECT_NE(ended[kRefused].reason().find("outside the oil table"), std::string::npos) << ended[kRefused].reason();
}

TEST(Batch, ACaseThatBreaksARuleIsRefusedBeforeItTakesMemory) {
  Case c = testing::coarse_case();
  c.film.dimension = cycle::FilmDimension::kUnrolled;
  c.ring.end_gap = 0.3e-3;
  c.solver.cells = 4000;
  c.solver.cells_y = 4000;
  c.solver.method = cycle::Method::kPointRelaxation;
  const std::vector<Ending> ended = endings({c, testing::coarse_case()});
  ASSERT_TRUE(ended[0].refusal.has_value());
  EXPECT_EQ(ended[0].refusal->faults().size(), 2u);
  EXPECT_NE(ended[0].reason().find("nodes, more than 2e+06"), std::string::npos) << ended[0].reason();
  EXPECT_NE(ended[0].reason().find("point-relaxation"), std::string::npos) << ended[0].reason();
  EXPECT_EQ(ended[0].reason().find('\n'), std::string::npos) << ended[0].reason();
  EXPECT_TRUE(ended[1].is_solved()) << ended[1].reason();
}

TEST(Batch, EachOfMoreThanAreReadAheadEndsOnce) {
  std::vector<Case> cases(150, testing::coarse_case());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    cases[i].solver.cells = 10;
    cases[i].solver.crank_step_deg = 8;
    cases[i].solver.method = cycle::Method::kCoupledNewton;
    cases[i].operating.speed *= 1 + 0.001 * static_cast<double>(i);
  }
  const std::vector<Ending> alone = endings({cases.begin() + 140, cases.end()}, {}, {1});
  std::size_t n_given = 0;
  std::vector<Ending> ended(cases.size());
  std::multiset<std::size_t> seen;
  const BatchEffort effort = simulate_cases(source_of(cases, n_given),
                                            [&](Ending ending) {
                                              seen.insert(ending.index);
                                              ended[ending.index] = std::move(ending);
                                            },
                                            {2});
  std::vector<std::size_t> all(cases.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  EXPECT_TRUE(std::equal(seen.begin(), seen.end(), all.begin(), all.end()));
  for (std::size_t i = 0; i < alone.size(); ++i) expect_same(ended[140 + i], alone[i]);
  EXPECT_EQ(effort.threads, 2);
  EXPECT_GE(effort.lanes.lane_sweeps, effort.lanes.sweeps);
  EXPECT_GT(effort.lanes.sweeps, 0);
}

TEST(Batch, CasesAreSetUpAsTheCallerRequires) {
  const std::vector<Case> cases(3, testing::coarse_case());
  std::size_t n_given = 0;
  std::vector<Ending> ended(cases.size());
  BatchOptions options{2};
  options.prepare = [](const Case& c) {
    cycle::Setup setup = cycle::prepare(c);
    setup.notes.push_back({"made-ready", "by the test", 1});
    return setup;
  };
  simulate_cases(
      source_of(cases, n_given), [&](Ending ending) { ended[ending.index] = std::move(ending); }, options);
  for (const Ending& ending : ended) {
    EXPECT_TRUE(ending.is_solved()) << ending.reason();
    EXPECT_TRUE(std::any_of(ending.result.notes.begin(), ending.result.notes.end(),
                            [](const cycle::Note& note) { return note.topic == "made-ready"; }));
  }
}

TEST(Batch, ReadsNoFurtherAheadThanStated) {
  const std::vector<Case> cases(300, testing::coarse_case());
  std::size_t n_given = 0;
  const auto refuse = [&](const Ending&) {
    EXPECT_LT(n_given, 64u + 16u);  // and as many as there are lanes
    throw std::runtime_error("enough");
  };
  EXPECT_THROW(simulate_cases(source_of(cases, n_given), refuse, {1}), std::runtime_error);
}

TEST(Batch, AnExceptionOfTheObserverEndsIt) {
  std::vector<Case> cases(200, testing::coarse_case());
  for (Case& c : cases) {
    c.solver.cells = 10;
    c.solver.crank_step_deg = 8;
  }
  std::size_t n_given = 0;
  int reported = 0;
  const auto full = [&](const Ending&) {
    if (++reported == 3) throw std::runtime_error("the disk is full");
  };
  EXPECT_THROW(simulate_cases(source_of(cases, n_given), full, {2}), std::runtime_error);
  EXPECT_EQ(reported, 3);
}

TEST(Batch, NobodyIsCalledAgainAfterAnException) {
  const Case refused = outside_its_table(testing::coarse_case());  // each thread is back at once, to call again
  for (int repetition = 0; repetition < 50; ++repetition) {
    const bool by_source = repetition % 2 == 0;
    int n_given = 0, n_reported = 0, n_too_late = 0;
    bool has_thrown = false;
    const auto called = [&](bool fails) {
      if (has_thrown) ++n_too_late;
      if (!fails) return;
      has_thrown = true;
      throw std::runtime_error("no more");
    };
    const auto next = [&]() -> std::optional<Case> {
      called(++n_given == 300 && by_source);
      return refused;
    };
    const auto reported = [&](const Ending&) { called(++n_reported == 20 && !by_source); };
    EXPECT_THROW(simulate_cases(next, reported, {4}), std::runtime_error);
    EXPECT_EQ(n_too_late, 0);
  }
}

TEST(Batch, APulseThatThrowsEndsItInTheMidstOfAnIntegration) {
  std::vector<Case> cases(3, testing::coarse_case());
  std::size_t n_given = 0;
  std::atomic<int> pulses = 0;
  BatchOptions options;
  options.threads = 2;
  options.pulse = [&] {
    if (++pulses == 5) throw std::runtime_error("enough");
  };
  const auto reported = [](const Ending&) {
    ADD_FAILURE() << "five pulses are fewer than the steps of any of these cycles";
  };
  EXPECT_THROW(simulate_cases(source_of(cases, n_given), reported, options), std::runtime_error);
}

TEST(Batch, AnExceptionOfTheSourceEndsIt) {
  const auto broken = []() -> std::optional<Case> { throw std::logic_error("no more lines"); };
  EXPECT_THROW(simulate_cases(broken, [](const Ending&) {}, {2}), std::logic_error);
}

TEST(Batch, ReportsHowManyHaveEnded) {
  std::vector<int> reported;
  const auto progress = [&](int done, int total) {
    reported.push_back(done);
    EXPECT_EQ(total, 11);
  };
  endings(mixed_cases(), progress, {3});
  std::vector<int> all(11);
  std::iota(all.begin(), all.end(), 1);
  EXPECT_EQ(reported, all);
}

}  // namespace
}  // namespace ringfilm::study
