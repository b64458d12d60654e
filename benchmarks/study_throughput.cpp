#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/storage/shard_file.hpp"
#include "ringfilm/io/study/study_file.hpp"
#include "ringfilm/io/study/study_netcdf.hpp"
#include "ringfilm/io/study/study_result.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/report/study_page.hpp"
#include "ringfilm/study/design/kept_curves.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/sampling/hash.hpp"
#include "ringfilm/study/study_run.hpp"

/// What a study costs beside the engine: its scenarios through plan, cases, rows and their file on the disk, against
/// the bare engine on the very same cases; and what the results of a million scenarios take in memory and time
/// (docs/manual/performance.md).
/// usage: study_throughput [--quick] [--scenarios=COUNT] [--rows=COUNT] [--folder=FOLDER]
namespace ringfilm {
namespace {

namespace fs = std::filesystem;

constexpr int kThreads = 2;
/// Scenarios that run one way, then the other, so that both meet the same machine.
constexpr std::uint64_t kSlice = 500;
constexpr double kMillion = 1e6;

struct Options {
  std::uint64_t scenarios = 50'000, rows = 1'000'000;
  std::string folder = ".";
};

struct Times {
  double wall = 0, processor = 0;  ///< [s]
};

Times operator+(Times a, Times b) { return {a.wall + b.wall, a.processor + b.processor}; }

Times time_of(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const std::clock_t processor = std::clock();
  const Clock::time_point begun = Clock::now();
  work();
  return {std::chrono::duration<double>(Clock::now() - begun).count(),
          static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}

io::StudyFile uncertainty_study(std::uint64_t scenarios, study::Curves curves) {
  io::StudyFile file = io::read_study(std::string(RINGFILM_SOURCE_FOLDER) + "/cases/studies/new_ring_uncertainty.toml");
  file.study.sampling.scenarios = scenarios;
  file.study.sampling.indices = study::Indices::kNone;
  file.study.bases.front().input.solver.cells = 200;
  file.study.keep.curves = curves;
  return file;
}

io::ShardHeader header_of(const study::Plan& plan) {
  const study::OutputSelection& keep = plan.study().keep;
  return {"plan",
          "inputs",
          "program",
          1,
          1,
          0,
          plan.size(),
          cycle::cycle_quantities().size(),
          keep.curves == study::Curves::kNone ? std::vector<std::string>{} : keep.quantities,
          study::kept_angles(keep).size()};
}

/// Does the work in a process of its own, of which the largest memory is reported [MB]. Ends the program if that fails.
double memory_of(const std::function<void()>& work) {
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    int status = 0;
    try {
      work();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "study_throughput: %s\n", error.what());
      status = 1;
    }
    std::fflush(stdout);
    ::_exit(status);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || ::wait4(child, &status, 0, &usage) != child || status != 0) std::exit(1);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return (values[values.size() / 2] + values[(values.size() - 1) / 2]) / 2;
}

void compare_with_engine(const Options& options, const std::string& rows_path) {
  const io::StudyFile file = uncertainty_study(options.scenarios, study::Curves::kNone);
  const study::Plan plan(file.study);
  io::ShardWriter writer(rows_path, header_of(plan));
  study::StudyRunOptions run_options;
  run_options.batch.threads = kThreads;
  Times making, bare, whole;
  std::uint64_t stopped = 0, unsolved = 0;
  const auto run_bare = [&](const study::ScenarioRange& slice) {
    std::vector<cycle::Case> cases;
    making = making + time_of([&] {
               for (std::uint64_t i = slice.first; i < slice.end; ++i) {
                 cases.push_back(study::scenario_case(plan.study(), plan.point(i)));
                 study::ask_for_kept(plan.study().keep, cases.back());
               }
             });
    std::size_t next = 0;
    const auto source = [&]() -> std::optional<cycle::Case> {
      if (next == cases.size()) return std::nullopt;
      return std::move(cases[next++]);
    };
    bare = bare + time_of([&] {
             study::simulate_cases(
                 source, [&](study::Ending ending) { stopped += ending.is_solved() ? 0 : 1; }, run_options.batch);
           });
  };
  const auto run_whole = [&](const study::ScenarioRange& slice) {
    const auto finished = [&](const study::ScenarioBlock& block) {
      writer.append(block);
      for (const auto& row : block.rows) unsolved += row.reason.empty() ? 0 : 1;
      return study::Continuation::kYes;
    };
    whole = whole + time_of([&] { study::run_scenarios(plan, slice, finished, run_options); });
  };
  std::vector<double> walls, processors;  // of each slice, bare over whole
  for (std::uint64_t first = 0; first < plan.size(); first += kSlice) {
    const study::ScenarioRange slice{first, std::min(first + kSlice, plan.size())};
    const Times bare_before = bare, whole_before = whole;
    const bool is_bare_first = first / kSlice % 2 == 0;
    if (is_bare_first) run_bare(slice);
    run_whole(slice);
    if (!is_bare_first) run_bare(slice);
    walls.push_back((bare.wall - bare_before.wall) / (whole.wall - whole_before.wall));
    processors.push_back((bare.processor - bare_before.processor) / (whole.processor - whole_before.processor));
  }
  const auto n = static_cast<double>(plan.size());
  std::printf("Uncertainty of the new ring of styles2014, 200 cells, %.0f scenarios, %d threads, slice by slice\n\n", n,
              kThreads);
  std::printf("|              | scenarios/s | processor ms/scenario | not solved | a million, hours |\n");
  std::printf("|:-------------|------------:|----------------------:|-----------:|-----------------:|\n");
  for (const auto& [name, times, left] :
       {std::tuple{"bare engine", bare, stopped}, std::tuple{"whole study", whole, unsolved}}) {
    std::printf("| %-12s | %11.1f | %21.4f | %10llu | %16.2f |\n", name, n / times.wall, 1e3 * times.processor / n,
                static_cast<unsigned long long>(left), kMillion / n * times.wall / 3600);
  }
  std::printf("\nof it: %.4f ms/scenario of processor time for making cases from the plan\n",
              1e3 * making.processor / n);
  std::printf("whole study : bare engine, scenarios a second: %.3f, median of %zu slices %.3f\n",
              bare.wall / whole.wall, walls.size(), median(walls));
  std::printf("the same by processor time: %.3f, median %.3f\n", bare.processor / whole.processor, median(processors));
}

/// Rows of made-up numbers, which compress as badly as results do. Every hundredth was not solved.
void write_rows(const study::Plan& plan, const std::string& path) {
  io::ShardWriter writer(path, header_of(plan));
  const std::uint64_t n_curve_numbers = header_of(plan).n_curve_numbers();
  constexpr std::uint64_t kInBlock = 256;
  for (std::uint64_t first = 0; first < plan.size(); first += kInBlock) {
    study::ScenarioBlock block{first, {}};
    for (std::uint64_t i = first; i < std::min(first + kInBlock, plan.size()); ++i) {
      study::ScenarioRow& row = block.rows.emplace_back();
      const bool is_solved = i % 100 != 99;
      if (!is_solved) row.reason = "no film that carries the load was found at 12 degree of the cycle";
      for (std::size_t v = 0; v < cycle::cycle_quantities().size(); ++v)
        row.values.push_back(is_solved ? 1 + 0x1p-53 * static_cast<double>(study::hash(i, v) >> 11) : std::nan(""));
      for (std::uint64_t c = 0; c < n_curve_numbers; ++c)
        row.curves.push_back(is_solved ? 1 + 0x1p-24F * static_cast<float>(study::hash(i, c) >> 40) : std::nanf(""));
    }
    writer.append(block);
  }
}

double megabytes(const std::string& path) { return static_cast<double>(fs::file_size(path)) / 1e6; }

void measure_results(std::uint64_t n, study::Curves curves, const char* name, const fs::path& folder) {
  const std::string rows_path = folder / "study.rows", result = folder / "study.nc", table = folder / "study.csv",
                    page = folder / "study.html";
  const io::StudyFile file = uncertainty_study(n, curves);
  const study::Plan plan(file.study);
  fs::remove(rows_path);
  memory_of([&] { write_rows(plan, rows_path); });
  const auto with_rows = [&](const std::function<void(const io::StudyRows&)>& work) {
    std::vector<io::ShardReader> shards;
    const Times opened = time_of([&] { shards.emplace_back(rows_path); });
    const io::StudyRows rows{file, plan, std::move(shards)};
    const Times worked = time_of([&] { work(rows); });
    std::printf(" %7.1f | %7.1f |", opened.wall, worked.wall);
  };
  std::printf("| %-9s | %9llu | %7.0f | netCDF |", name, static_cast<unsigned long long>(n), megabytes(rows_path));
  const double of_result =
      memory_of([&] { with_rows([&](const auto& rows) { io::write_study_result(result, rows); }); });
  std::printf(" %7.0f | %7.0f |\n", megabytes(result), of_result);
  std::printf("| %-9s | %9llu | %7.0f | CSV    |", name, static_cast<unsigned long long>(n), megabytes(rows_path));
  const double of_table = memory_of([&] { with_rows([&](const auto& rows) { io::write_study_csv(table, rows); }); });
  std::printf(" %7.0f | %7.0f |\n", megabytes(table), of_table);
  std::printf("| %-9s | %9llu | %7.0f | page   |", name, static_cast<unsigned long long>(n), megabytes(rows_path));
  const double of_page = memory_of([&] {
    with_rows([&](const auto& rows) {
      io::write_atomically(page, report::study_page(rows, io::Units(), {"ringfilm", "", "", ""}));
    });
  });
  std::printf(" %7.1f | %7.0f |\n", megabytes(page), of_page);
}

int run(const Options& options) {
  const fs::path folder = fs::path(options.folder) / ("study-throughput-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  if (options.scenarios > 0) {
    const double memory = memory_of([&] { compare_with_engine(options, folder / "engine.rows"); });
    std::printf("peak memory: %.0f MB, with the cases of the bare engine, %llu at a time\n\n", memory,
                static_cast<unsigned long long>(kSlice));
  }
  if (options.rows > 0) {
    std::printf("Results from rows of made-up numbers\n\n");
    std::printf("| curves    | scenarios | rows MB | file   | check s | write s | file MB | peak MB |\n");
    std::printf("|:----------|----------:|--------:|:-------|--------:|--------:|--------:|--------:|\n");
    measure_results(options.rows, study::Curves::kNone, "none", folder);
    measure_results(std::max<std::uint64_t>(options.rows / 20, 1), study::Curves::kAll, "all", folder);
    measure_results(std::max<std::uint64_t>(options.rows / 20, 1), study::Curves::kQuantiles, "quantiles", folder);
  }
  fs::remove_all(folder);
  return 0;
}

}  // namespace
}  // namespace ringfilm

int main(int n_words, char** words) {
  ringfilm::Options options;
  for (int i = 1; i < n_words; ++i) {
    const std::string word = words[i];
    const auto value = [&word](const char* start) { return word.substr(std::strlen(start)); };
    if (word == "--quick") {
      options.scenarios = 2000;
      options.rows = 100'000;
    } else if (word.rfind("--scenarios=", 0) == 0) {
      options.scenarios = std::strtoull(value("--scenarios=").c_str(), nullptr, 10);
    } else if (word.rfind("--rows=", 0) == 0) {
      options.rows = std::strtoull(value("--rows=").c_str(), nullptr, 10);
    } else if (word.rfind("--folder=", 0) == 0) {
      options.folder = value("--folder=");
    } else {
      std::fprintf(stderr, "usage: study_throughput [--quick] [--scenarios=COUNT] [--rows=COUNT] [--folder=FOLDER]\n");
      return 2;
    }
  }
  return ringfilm::run(options);
}
