#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

// The yardstick of benchmarks/python_speed.py: prints the seconds of a run, or of a batch, of the same cases.
// usage: case_speed run CASE RUNS | case_speed batch CASE CASES THREADS

int main(int argc, char** argv) {
  using namespace ringfilm;
  if (argc < 4) return 2;
  const std::string what = argv[1];
  const cycle::Case input = io::read_case(argv[2]);
  const int n = std::atoi(argv[3]);
  const auto begin = std::chrono::steady_clock::now();
  int n_left = n;
  if (what == "run") {
    while (n_left-- > 0) cycle::simulate(cycle::prepare(input));
  } else {
    const auto next = [&]() -> std::optional<cycle::Case> {
      if (n_left-- <= 0) return std::nullopt;
      cycle::Case one = input;
      one.operating.speed = 150.0 + 100.0 * (n - n_left - 1) / n;
      return one;
    };
    study::BatchOptions options;
    options.threads = argc > 4 ? std::atoi(argv[4]) : 0;
    study::simulate_cases(
        next, [](study::Ending) {}, options);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::printf("%.6f\n", what == "run" ? seconds / n : seconds);
}
