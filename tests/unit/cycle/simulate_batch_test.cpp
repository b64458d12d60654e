#include "ringfilm/cycle/simulate_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

#include "batch_cases.hpp"

namespace ringfilm::cycle::testing {
namespace {

constexpr int kEngines = 60;

/// Easy and hard, both ways of cavitation, fixed and adaptive steps, some that stop; in front two whose contact once
/// corrupted each other's film.
std::vector<Case> mixed_engines() {
  std::vector<Case> cases = {ring_on_its_edge(0.05), ring_on_its_edge(0.95)};
  constexpr int kGraded = 41;  // integrated on graded cells in a hundred times the time of the others
  for (int index = 0; static_cast<int>(cases.size()) < kEngines; ++index) {
    if (index != kGraded) cases.push_back(small_engine(index));
  }
  return cases;
}

std::vector<int> forwards(const std::vector<Case>& cases) {
  std::vector<int> order(cases.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

template <class Number>
bool same_bits(const std::vector<Number>& a, const std::vector<Number>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Number)) == 0);
}

bool same_bits(const CycleResult& a, const CycleResult& b) {
  static_assert(sizeof(CycleValues) % sizeof(double) == 0 && sizeof(Sample) % sizeof(double) == 0);  // no gaps
  return std::memcmp(&a.values, &b.values, sizeof a.values) == 0 && same_bits(a.samples, b.samples) &&
         same_bits(a.fields.film_pressure, b.fields.film_pressure) &&
         same_bits(a.fields.film_content, b.fields.film_content) &&
         same_bits(a.stroke.archard_wear_load_density, b.stroke.archard_wear_load_density) && a.derived == b.derived &&
         a.complete == b.complete && a.notes.size() == b.notes.size() &&
         std::memcmp(&a.effort, &b.effort, sizeof a.effort) == 0;
}

/// Each of `batch` must be in `all`, to the last bit.
void expect_same_bits(const Batch& batch, const Batch& all) {
  for (const auto& [i, outcome] : batch.outcomes) {
    const BatchOutcome& other = all.outcomes.at(i);
    EXPECT_TRUE(same_bits(outcome.result, other.result)) << "engine " << i;
    EXPECT_EQ(outcome.stop.has_value(), other.stop.has_value()) << "engine " << i;
    if (!outcome.stop || !other.stop) continue;
    EXPECT_EQ(outcome.stop->message, other.stop->message) << "engine " << i;
  }
}

class SimulateBatchWith : public ::testing::TestWithParam<std::string_view> {};

INSTANTIATE_TEST_SUITE_P(Everywhere, SimulateBatchWith, ::testing::ValuesIn(film::kernel_names()),
                         [](const auto& kernels) { return std::string(kernels.param); });

TEST_P(SimulateBatchWith, GivesTheSameBitsWhateverTheNeighboursTheOrderAndTheLane) {
  const std::vector<Case> cases = mixed_engines();
  std::vector<int> order = forwards(cases);
  const Batch all = batch_of(cases, order, GetParam());
  ASSERT_EQ(all.outcomes.size(), cases.size());
  std::reverse(order.begin(), order.end());
  expect_same_bits(batch_of(cases, order, GetParam()), all);
  for (int i = 0; i < kEngines; i += i < 4 ? 1 : 7) expect_same_bits(batch_of(cases, {i}, GetParam()), all);
}

TEST_P(SimulateBatchWith, GradedCellsGiveTheSameBitsAmongNeighboursAsAlone) {
  const std::vector<Case> cases = {small_engine(0), narrow_crown(100), small_engine(1), narrow_crown(60)};
  const Batch all = batch_of(cases, {3, 0, 1, 2}, GetParam());
  for (const int i : {1, 3}) {
    const CycleResult& result = all.outcomes.at(i).result;
    EXPECT_TRUE(result.complete);
    EXPECT_TRUE(std::any_of(result.notes.begin(), result.notes.end(),
                            [](const Note& note) { return note.topic == kCellsGraded; }));
    expect_same_bits(batch_of(cases, {i}, GetParam()), all);
  }
}

TEST(SimulateBatch, TheEnginesAreAMixOfHardAndEasy) {
  const std::vector<Case> cases = mixed_engines();
  const Batch all = batch_of(cases, forwards(cases), film::kernels().name);
  EXPECT_TRUE(all.outcomes.at(0).result.complete && all.outcomes.at(1).result.complete);
  EXPECT_GT(all.effort.single_solves, 20);  // films that a lane cannot find alone
  int stops = 0, complete = 0, sub_stepped = 0, exits = 0, adaptive = 0, by_laws = 0;
  for (const auto& [i, outcome] : all.outcomes) {
    stops += outcome.stop.has_value();
    complete += outcome.result.complete;
    sub_stepped += outcome.result.effort.fallback_sub_step > 0;
    exits += cases[i].film.cavitation == Cavitation::kReynoldsExit;
    adaptive += cases[i].solver.crank_step_control == StepControl::kAdaptive;
    by_laws += cases[i].contact.integrals != ContactIntegrals::kExact;
  }
  EXPECT_EQ(stops + complete, kEngines);
  EXPECT_GT(stops, 0);
  EXPECT_GT(sub_stepped, 0);
  EXPECT_GT(by_laws, 3);
  EXPECT_TRUE(exits > 10 && exits < kEngines - 10) << exits;
  EXPECT_TRUE(adaptive > 10 && adaptive < kEngines - 10) << adaptive;
}

/// What `simulate` gives for each engine, one by one.
std::map<int, BatchOutcome> one_by_one(const std::vector<Case>& cases) {
  std::map<int, BatchOutcome> outcomes;
  for (int i = 0; i < static_cast<int>(cases.size()); ++i) outcomes.emplace(i, single(cases[i]));
  return outcomes;
}

/// Every cycle value of every width within `limit` of what the single engine gives. Angles and counts may be those of a
/// neighbouring step where two steps are alike to rounding.
void expect_agreement(const std::vector<Case>& cases, double limit) {
  const std::map<int, BatchOutcome> reference = one_by_one(cases);
  for (const std::string_view kernels : film::kernel_names()) {
    int jumps = 0;
    const Batch batch = batch_of(cases, forwards(cases), kernels);
    for (const auto& [i, outcome] : batch.outcomes) {
      const BatchOutcome& one = reference.at(i);
      const Difference found = difference(one.result, one.stop, outcome.result, outcome.stop);
      EXPECT_TRUE(found.same_end) << kernels << ", engine " << i;
      EXPECT_LT(found.largest, limit) << kernels << ", engine " << i << ": " << found.value;
      jumps += found.jumps;
    }
    EXPECT_LE(jumps, 2) << kernels;
  }
}

TEST(SimulateBatch, AgreesWithTheSingleEngineAtEveryWidth) { expect_agreement(mixed_engines(), 1e-5); }

TEST(SimulateBatch, AgreesMoreCloselyAtTheStrictStop) {
  std::vector<Case> cases = mixed_engines();
  for (Case& c : cases) c.solver.tolerance = 1e-12;
  expect_agreement(cases, 1e-8);
}

TEST(SimulateBatch, OtherMethodsAreIntegratedOneByOneWithTheBitsOfSimulate) {
  std::vector<Case> cases = {small_engine(0), small_engine(1), small_engine(0)};
  cases[0].solver.method = Method::kPointRelaxation;
  for (Case& c : cases) c.solver.crank_step_deg = 5;
  const Batch batch = batch_of(cases, {0, 1, 2}, film::kernels().name);
  EXPECT_TRUE(same_bits(batch.outcomes.at(0).result, single(cases[0]).result));
  EXPECT_EQ(batch.outcomes.size(), 3u);
}

TEST(SimulateBatch, OfNothingIsNothing) {
  const LaneEffort effort = simulate_batch([]() -> std::optional<cycle::Setup> { return std::nullopt; },
                                           [](const BatchOutcome&) { FAIL() << "nothing was given"; });
  EXPECT_EQ(effort.sweeps, 0);
}

// A scenario is asked for only when there is room for it: far fewer than all are at hand at a time.
TEST(SimulateBatch, AsksForScenariosAsLanesBecomeFree) {
  Case easy = styles_new_ring();
  easy.solver.cells = 20;
  easy.solver.crank_step_deg = 5;
  int given = 0, finished = 0, most_at_hand = 0;
  const auto next = [&]() -> std::optional<cycle::Setup> {
    if (given == 40) return std::nullopt;
    ++given;
    most_at_hand = std::max(most_at_hand, given - finished);
    return prepare(easy);
  };
  const LaneEffort effort = simulate_batch(next, [&](const BatchOutcome&) { ++finished; });
  EXPECT_EQ(finished, 40);
  EXPECT_LE(most_at_hand, film::kernels().width);
  // They are all alike: only the last lanes may wait for each other.
  EXPECT_EQ(effort.lane_sweeps, effort.sweeps * film::kernels().width);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
