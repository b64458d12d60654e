#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../tests/scenarios/engine_scenario.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/cycle_run.hpp"
#include "ringfilm/cycle/integration/side_by_side.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/film/integrals/film_integrals.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/models/oil/viscosity_laws.hpp"
#include "ringfilm/study/ensemble/batch.hpp"
#include "ringfilm/study/ensemble/threads.hpp"

/// Integrates one cycle of each of many seeded scenarios (tests/scenarios), side by side in the lanes of a register,
/// and counts how every step was solved. A film is believed only if all its numbers are finite and its load balances by
/// a sum of its own.
namespace ringfilm::cycle {
namespace {

using testing::EngineScenario;

/// How a scenario ended.
enum class End {
  kSolved,
  kOverloaded,       ///< reported: neither film nor asperities carry the load
  kLiftedOff,        ///< reported: the gas at the edges lifts the ring off
  kRunsAway,         ///< reported: thinner films have no pressure, since viscosity rises without limit
  kFalseOverload,    ///< reported as an overload although the asperities alone carry the load
  kUnexplained,      ///< reported: no balance found
  kNotFinite,        ///< a film with a NaN or an infinity was accepted
  kOutOfBalance,     ///< a film was accepted that does not carry its load
  kLastStateBroken,  ///< after a stop the last film is not a good one
  kException,        ///< anything else was thrown
};
constexpr int kEnds = 10;
constexpr const char* kEndNames[kEnds] = {
    "solved",      "overloaded", "lifted-off",     "runs-away",         "false-overload",
    "unexplained", "not-finite", "out-of-balance", "last-state-broken", "exception"};

/// Accepted films carry their load to sqrt(solver.tolerance), the solver's stop test (docs/theory/film.md).
constexpr double kLoadError = 1e-4;

struct Outcome {
  End end = End::kSolved;
  std::string message;
  std::optional<double> crank_angle_deg;
  bool is_graded = false;  ///< integrated on graded cells, since uniform ones found no film
  TimeIntegration::Totals totals;
  long side_steps = 0;
};

bool is_finite(const film::FilmState& state) {
  double sum = state.h_m;
  for (std::size_t i = 0; i < state.p.size(); ++i) sum += state.p[i] + state.deficit[i] + state.mass_per_area[i];
  return std::isfinite(sum);
}

/// Thrown where an accepted film is not a solution.
struct Broken {
  End end;
  double crank_angle_deg;
};

void check_film(const TimeIntegration& integration, const Instant& instant) {
  if (!is_finite(*instant.state)) throw Broken{End::kNotFinite, instant.crank_angle_deg};
  if (instant.at.off_liner) return;  // the stiffness of its gap carries what the gas presses it off with
  const auto sums = film::film_integrals(integration.problem(), instant.at.inputs, *instant.previous, *instant.state);
  const double carried = sums.hydrodynamic_load + sums.asperity_load;
  if (!(std::abs(carried - instant.at.inputs.load) <= kLoadError * instant.at.inputs.load)) {
    throw Broken{End::kOutOfBalance, instant.crank_angle_deg};
  }
}

/// Checks every accepted film; asks for films between the steps where the scenario requires them.
class Watch : public StepObserver {
 public:
  Watch(const EngineScenario& scenario, long& side_steps) : spacing_(scenario.side_spacing_deg), side_(side_steps) {}

  void before_step(TimeIntegration& integration, double from_deg, double to_deg) override {
    if (!spacing_) return;
    const double next = (std::floor(from_deg / *spacing_) + 1) * *spacing_;
    if (next >= to_deg) return;
    film::FilmState state;
    ++side_;
    check_film(integration, integration.side_step(next, state));
  }

  void after_step(const TimeIntegration& integration) override { check_film(integration, integration.instant()); }

 private:
  std::optional<double> spacing_;
  long& side_;
};

/// What the asperities carry where the surfaces touch, per length [N/m].
double asperity_capacity(const film::FilmProblem& problem) {
  double load = 0;
  for (std::size_t i = 0; i < problem.grid.x.size(); ++i) {
    const bool nominal = problem.contact_spread == film::ContactSpread::kNominal;
    load += problem.grid.share[i] * problem.contact->contact(nominal ? 0.0 : problem.grid.node_height[i]).pressure;
  }
  return load;
}

/// Could asperities and gas at the edges have carried the load that the integration could not balance?
bool is_false_overload(const Setup& setup, const film::FilmProblem& problem, double crank_angle_deg) {
  const film::FilmInputs inputs = ring_conditions(setup, crank_angle_deg, 0).inputs;
  const double of_gas = inputs.has_gas() ? film::least_hydrodynamic_load(problem, inputs) : 0;
  return asperity_capacity(problem) + of_gas >= inputs.load;
}

/// One cycle of a scenario. All that it throws is its outcome.
class ScenarioIntegration final : public BatchMember {
 public:
  /// Throws InputError.
  ScenarioIntegration(int index, const EngineScenario& scenario)
      : ScenarioIntegration(index, scenario, prepare(scenario.input)) {}

  ScenarioIntegration(int index, const EngineScenario& scenario, Setup setup)
      : index_(index),
        scenario_(scenario),
        setup_(std::move(setup)),
        integration_(setup_),
        watch_(scenario_, outcome_.side_steps),
        n_steps_(steps_per_cycle(setup_.input.solver)) {
    attempt([&] {
      integration_.start(static_cast<int>(std::lround(scenario_.start_angle_deg / kCycleDeg * n_steps_)) % n_steps_);
      started_ = true;
      check_film(integration_, integration_.instant());
    });
  }

  TimeIntegration& integration() override { return integration_; }
  bool done() const override { return done_; }

  void conclude(const film::FilmReport& report) override {
    attempt([&] {
      integration_.conclude(report, watch_);
      if (integration_.at_base_angle()) done_ = ++steps_ == n_steps_;
    });
  }

  int index() const { return index_; }
  Outcome outcome() const {
    Outcome outcome = outcome_;
    outcome.totals = integration_.totals();
    outcome.is_graded = setup_.cells == CellsOfFace::kGraded;
    return outcome;
  }
  /// Where this integration stopped and graded cells may help.
  std::unique_ptr<ScenarioIntegration> again() const {
    std::optional<Setup> setup = stop_ ? second_attempt(setup_, *stop_) : std::nullopt;
    return setup ? std::make_unique<ScenarioIntegration>(index_, scenario_, std::move(*setup)) : nullptr;
  }

 private:
  template <class Action>
  void attempt(const Action& action) {
    try {
      action();
      return;
    } catch (const NoBalance& error) {
      stopped(error);
    } catch (const Broken& broken) {
      outcome_.end = broken.end;
      outcome_.crank_angle_deg = broken.crank_angle_deg;
    } catch (const std::exception& error) {
      outcome_.end = End::kException;
      outcome_.message = error.what();
    }
    done_ = true;
  }

  void stopped(const NoBalance& error) {
    outcome_.message = error.what();
    outcome_.crank_angle_deg = error.crank_angle_deg();
    stop_ = Stop{error.what(), error.crank_angle_deg(), error.failure};
    outcome_.end = end_of(error);
    if (started_ && !is_finite(integration_.state())) outcome_.end = End::kLastStateBroken;
  }

  End end_of(const NoBalance& error) const {
    const double at = error.crank_angle_deg().value_or(scenario_.start_angle_deg);
    switch (error.failure) {
      case film::Failure::kLiftedOff:
        return End::kLiftedOff;
      case film::Failure::kRunsAway:
        return End::kRunsAway;
      case film::Failure::kOverloaded:
        return is_false_overload(setup_, integration_.problem(), at) ? End::kFalseOverload : End::kOverloaded;
      default:
        return End::kUnexplained;
    }
  }

  int index_;
  EngineScenario scenario_;
  Setup setup_;
  TimeIntegration integration_;
  Outcome outcome_;
  Watch watch_;
  int n_steps_;
  std::optional<Stop> stop_;
  int steps_ = 0;
  bool started_ = false, done_ = false;
};

/// One line with all that is needed to find and repeat a scenario.
std::string as_json(std::uint64_t seed, int index, const EngineScenario& scenario, const Outcome& outcome) {
  const Case& c = scenario.input;
  nlohmann::ordered_json line{
      {"repeat", "robustness --seed " + std::to_string(seed) + " --only " + std::to_string(index)},
      {"end", kEndNames[static_cast<int>(outcome.end)]},
      {"crank_angle_deg", nullptr},
      {"message", outcome.message},
      {"graded", outcome.is_graded},
      {"speed_rpm", c.operating.speed * 30 / std::numbers::pi},
      {"oil_temperature_degC", c.operating.oil_temperature - 273.15},
      {"peak_pressure_bar", scenario.peak_pressure * 1e-5},
      {"trace", name(scenario.trace)},
      {"face", name(scenario.face)},
      {"rise_um", scenario.rise * 1e6},
      {"face_width_mm", c.ring.face_width * 1e3},
      {"apex", c.ring.face.apex},
      {"orientation", static_cast<int>(c.ring.face.orientation)},
      {"roughness_um", c.contact.roughness * 1e6},
      {"asperity_radius_um", c.contact.asperity_radius * 1e6},
      {"asperity_density_per_um2", c.contact.asperity_density * 1e-12},
      {"lambda_ratio", c.contact.lambda_ratio == LambdaRatio::kLocal ? "local" : "nominal"},
      {"integrals", c.contact.integrals == ContactIntegrals::kExact ? "exact" : "polynomial-4-digit"},
      {"viscosity_pressure", models::viscosity_law(c.lubricant.viscosity_pressure).name},
      {"pressure_viscosity_coefficient", c.lubricant.law_parameters.at("pressure_viscosity_coefficient")},
      {"compressibility", c.lubricant.compressibility == Compressibility::kNone ? "none" : "dowson-higginson"},
      {"tangential_force_N", c.ring.tangential_force.value_or(0)},
      {"cavitation", c.film.cavitation == Cavitation::kMassConserving ? "mass-conserving" : "reynolds-exit"},
      {"cavitation_pressure_bar", c.film.cavitation_pressure * 1e-5},
      {"cells", c.solver.cells},
      {"crank_step_deg", c.solver.crank_step_deg},
      {"control", c.solver.crank_step_control == StepControl::kFixed ? "fixed" : "adaptive"},
      {"start_angle_deg", scenario.start_angle_deg},
      {"crank_steps", outcome.totals.crank_steps},
      {"search", outcome.totals.fallback_secant},
      {"cut", outcome.totals.fallback_sub_step},
      {"side_steps", outcome.side_steps}};
  if (outcome.crank_angle_deg) line["crank_angle_deg"] = *outcome.crank_angle_deg;
  return line.dump();
}

/// Sums of one row of the table.
struct Row {
  std::string name;
  std::function<bool(const EngineScenario&)> holds;
  long scenarios = 0, steps = 0, newton = 0, search = 0, cuts = 0, short_steps = 0, side_steps = 0;
  long graded = 0;  ///< integrated again on graded cells
  long ends[kEnds] = {};

  void add(const Outcome& outcome) {
    ++scenarios;
    ++ends[static_cast<int>(outcome.end)];
    graded += outcome.is_graded;
    steps += outcome.totals.crank_steps;
    newton += outcome.totals.newton_iterations;
    search += outcome.totals.fallback_secant;
    cuts += outcome.totals.fallback_sub_step;
    short_steps += outcome.totals.sub_steps;
    side_steps += outcome.side_steps;
  }
  long ended(End end) const { return ends[static_cast<int>(end)]; }
  long faults() const {
    return scenarios - ended(End::kSolved) - ended(End::kOverloaded) - ended(End::kLiftedOff) - ended(End::kRunsAway);
  }
};

/// Below this rise the film hangs on nanometres of form; such faces are counted apart and promised nothing.
constexpr double kPromisedRise = 2e-6;

std::vector<Row> empty_rows() {
  const auto rise = [](double low, double high) {
    return [low, high](const EngineScenario& s) { return s.rise >= low && s.rise < high; };
  };
  const auto promised = rise(kPromisedRise, 1);
  const auto and_promised = [promised](const std::function<bool(const EngineScenario&)>& holds) {
    return [promised, holds](const EngineScenario& s) { return promised(s) && holds(s); };
  };
  const auto model = [&](Cavitation cavitation) {
    return and_promised([cavitation](const EngineScenario& s) { return s.input.film.cavitation == cavitation; });
  };
  const auto control = [&](StepControl requested) {
    return and_promised(
        [requested](const EngineScenario& s) { return s.input.solver.crank_step_control == requested; });
  };
  std::vector<Row> rows;
  rows.push_back({"rise of 2 um and more", promised});
  rows.push_back({"  reynolds-exit", model(Cavitation::kReynoldsExit)});
  rows.push_back({"  mass-conserving", model(Cavitation::kMassConserving)});
  rows.push_back({"  fixed steps", control(StepControl::kFixed)});
  rows.push_back({"  adaptive steps", control(StepControl::kAdaptive)});
  rows.push_back({"  rise 2-10 um", rise(kPromisedRise, 10e-6)});
  rows.push_back({"  rise 10-50 um", rise(10e-6, 50e-6)});
  rows.push_back({"  rise 50 um and more", rise(50e-6, 1)});
  rows.push_back({"  cranked, below 500 rpm", and_promised([](const EngineScenario& s) {
                    return s.input.operating.speed < 500 * std::numbers::pi / 30;
                  })});
  rows.push_back({"  start from standstill",
                  and_promised([](const EngineScenario& s) { return std::fmod(s.start_angle_deg, 180) == 0; })});
  rows.push_back({"  knocks, steps, noise",
                  and_promised([](const EngineScenario& s) { return s.trace != testing::TraceKind::kSmooth; })});
  rows.push_back({"rise below 2 um", rise(0, kPromisedRise)});
  return rows;
}

void print(const std::vector<Row>& rows) {
  std::printf("%-24s %9s %10s %9s %9s %8s %9s %8s %10s %8s %9s %7s %11s\n", "", "scenarios", "steps", "direct",
              "search", "cut", "side", "graded", "overloaded", "lifted", "runs away", "faults", "it per step");
  for (const Row& row : rows) {
    if (row.scenarios == 0) continue;
    const double steps = static_cast<double>(std::max(row.steps, 1L));
    std::printf("%-24s %9ld %10ld %8.3f%% %9ld %8ld %9ld %8ld %10ld %8ld %9ld %7ld %11.2f\n", row.name.c_str(),
                row.scenarios, row.steps, 100 * (1 - static_cast<double>(row.search) / steps), row.search, row.cuts,
                row.side_steps, row.graded, row.ended(End::kOverloaded), row.ended(End::kLiftedOff),
                row.ended(End::kRunsAway), row.faults(), static_cast<double>(row.newton) / steps);
  }
  std::printf(
      "\ndirect, search: steps solved by the coupled Newton, by the bracketed search; cut: attempts given up for a\n"
      "shorter step; side: films asked for between steps; graded: integrated again on graded cells, since uniform "
      "ones\n"
      "found no film; overloaded: nothing carries the load; lifted: the gas under the ring lifts it off; runs away:\n"
      "thinner films have no pressure; faults: all else that did not end well");
  for (const Row* row : {&rows.front(), &rows.back()}) {
    std::printf("\n%s:", row->name.c_str());
    for (int end = 0; end < kEnds; ++end) std::printf(" %s %ld", kEndNames[end], row->ends[end]);
  }
  std::printf("\n");
}

struct Options {
  int count = 1500;
  int first = 0;
  int jobs = 1;
  std::uint64_t seed = 1;
  std::optional<int> only;
  std::optional<int> cells;   ///< in place of those of the sample
  bool gas_edges = false;     ///< gas where the film leaves, and mass-conserving cavitation, in all scenarios
  bool oil_on_liner = false;  ///< the same, and inlets that find what lies on the liner
  std::string failures;
};

/// What became of each scenario, and what it took.
struct Survey {
  std::vector<Outcome> outcomes;
  LaneEffort lanes;
  double processor_seconds = 0;  ///< of all threads
};

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

EngineScenario scenario_of(const Options& options, int index) {
  EngineScenario scenario = testing::engine_scenario(options.seed, index);
  scenario.input.solver.cells = options.cells.value_or(scenario.input.solver.cells);
  if (options.gas_edges || options.oil_on_liner) testing::put_gas_at_edges(scenario.input);
  if (options.oil_on_liner) testing::lay_oil_on_liner(index, scenario.input);
  return scenario;
}

/// Scenarios `first` and following, each thread with lanes of its own.
Survey surveyed(const Options& options, int first, int count) {
  const int n_threads = options.jobs;
  Survey survey;
  survey.outcomes.resize(count);
  const double start = processor_seconds();
  std::mutex mutex;
  int n_given = 0, n_done = 0;
  const auto end = [&](int index, Outcome outcome) {
    const std::lock_guard lock(mutex);
    survey.outcomes[index] = std::move(outcome);
    if (++n_done % 1000 == 0) std::fprintf(stderr, "%d of %d\n", n_done, count);
  };
  const auto next_index = [&]() -> std::optional<int> {
    const std::lock_guard lock(mutex);
    if (n_given == count) return std::nullopt;
    return n_given++;
  };
  const auto next = [&]() -> std::unique_ptr<BatchMember> {
    while (const std::optional<int> index = next_index()) {
      try {
        return std::make_unique<ScenarioIntegration>(*index, scenario_of(options, first + *index));
      } catch (const std::exception& error) {
        Outcome outcome;
        outcome.end = End::kException;
        outcome.message = error.what();
        end(*index, outcome);
      }
    }
    return nullptr;
  };
  const auto finished = [&](std::unique_ptr<BatchMember> integrating) {
    const auto& integration = static_cast<const ScenarioIntegration&>(*integrating);
    const std::unique_ptr<ScenarioIntegration> again = integration.again();
    if (again != nullptr) integrate_alone(*again);
    end(integration.index(), (again != nullptr ? *again : integration).outcome());
  };
  std::vector<LaneEffort> efforts(n_threads);
  study::on_threads(n_threads, [&](int thread) { efforts[thread] = integrate_side_by_side(next, finished); });
  for (const LaneEffort& effort : efforts) study::add(effort, survey.lanes);
  survey.processor_seconds = processor_seconds() - start;
  return survey;
}

void print(const Survey& survey) {
  const film::FilmKernels& kernels = film::kernels();
  const auto per = [](double sum, double n) { return n > 0 ? sum / n : 0; };
  const auto lanes = static_cast<double>(survey.lanes.sweeps) * kernels.width;
  long steps = 0;
  for (const Outcome& outcome : survey.outcomes) steps += outcome.totals.crank_steps;
  std::printf(
      "\n%.*s, %d lanes: %.1f %% busy; %ld films sought one by one after a lane had failed, in %ld steps;\n"
      "%.1f ms of processor time per scenario, %.1f s in all\n",
      static_cast<int>(kernels.name.size()), kernels.name.data(), kernels.width,
      100 * per(static_cast<double>(survey.lanes.lane_sweeps), lanes), survey.lanes.single_solves, steps,
      1e3 * per(survey.processor_seconds, static_cast<double>(survey.outcomes.size())), survey.processor_seconds);
}

/// Returns the number of faults among promised scenarios.
long survey(const Options& options) {
  const int first = options.only.value_or(options.first);
  const int count = options.only ? 1 : options.count;
  const Survey survey = surveyed(options, first, count);
  const std::vector<Outcome>& outcomes = survey.outcomes;

  std::ofstream file;
  if (!options.failures.empty()) {
    file.open(options.failures);
    if (!file) throw std::runtime_error("cannot write " + options.failures);
  }
  std::ostream& to = options.failures.empty() ? std::cout : file;
  auto rows = empty_rows();
  for (int i = 0; i < count; ++i) {
    const EngineScenario scenario = scenario_of(options, first + i);
    for (Row& row : rows) {
      if (row.holds(scenario)) row.add(outcomes[i]);
    }
    if (options.only || outcomes[i].end != End::kSolved) {
      to << as_json(options.seed, first + i, scenario, outcomes[i]) << '\n';
    }
  }
  to.flush();
  std::printf("seed %llu, scenarios %d to %d\n", static_cast<unsigned long long>(options.seed), first,
              first + count - 1);
  print(rows);
  print(survey);
  return rows.front().faults();
}

}  // namespace
}  // namespace ringfilm::cycle

int main(int argc, char** argv) {
  ringfilm::cycle::Options options;
  CLI::App app("Integrates one cycle of each of many seeded scenarios and counts how every step was solved");
  app.add_option("--count", options.count, "scenarios")->check(CLI::Range(1, 10'000'000))->capture_default_str();
  app.add_option("--first", options.first, "index of the first one")->check(CLI::NonNegativeNumber);
  app.add_option("--seed", options.seed, "of the sample")->capture_default_str();
  app.add_option("--jobs", options.jobs, "threads")->check(CLI::Range(1, 256))->capture_default_str();
  app.add_option("--only", options.only, "integrate this one scenario and print it")->check(CLI::NonNegativeNumber);
  app.add_option("--cells", options.cells, "solver.cells of all scenarios")->check(CLI::Range(8, 100'000));
  app.add_flag("--oil-on-liner", options.oil_on_liner, "the same, with 0.3 to 20 um that the oil ring leaves");
  app.add_flag("--gas-edges", options.gas_edges, "gas where the film leaves, and mass-conserving cavitation");
  app.add_option("--failures", options.failures, "file for one line of JSON per scenario that was not solved");
  CLI11_PARSE(app, argc, argv);
  try {
    return ringfilm::cycle::survey(options) == 0 ? 0 : 4;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "robustness: %s\n", error.what());
    return 5;
  }
}
