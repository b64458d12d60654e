#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>

#include "ringfilm/io/life/life_file.hpp"
#include "ringfilm/study/ensemble/cycle_integrators.hpp"

/// What a life of 150 h costs on two threads: the path between measured states, and wear of a level ring and of one
/// with a spread of tilt, over the shipped duties (docs/manual/performance.md). usage: life_speed [--quick]
namespace ringfilm {
namespace {

constexpr int kThreads = 2;

life::Life level(life::Life life) {
  life.wear.tilt_spread = 0;
  life.wear.edge_factor = 1;
  life.wear.running_in_coefficient.reset();
  life.wear.coefficient = 4e-18;
  return life;
}

void print_row(const std::string& words, const life::Life& life) {
  using Clock = std::chrono::steady_clock;
  const std::clock_t processor = std::clock();
  const Clock::time_point start = Clock::now();
  const life::LifeResult result = life::run_life(life, study::cycle_integrators({kThreads}));
  const double wall = std::chrono::duration<double>(Clock::now() - start).count();
  const double used = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
  std::printf("| %-42s | %6zu | %5d | %6ld | %6.2f | %11.2f | %9.2f |\n", words.c_str(), life.points.size(),
              result.wear ? result.wear->effort.jumps : 0, result.cycles, wall, used,
              1e3 * used / static_cast<double>(result.cycles));
  std::fflush(stdout);
}

int run(bool is_quick) {
  const std::string folder = std::string(RINGFILM_SOURCE_FOLDER) + "/cases/life/";
  const life::Life path = io::read_life(folder + "durability_test.toml").life;
  const life::Life tilted = io::read_life(folder + "archard_scenario.toml").life;
  life::Life three = level(tilted);
  three.points = path.points;
  std::printf("Lives of 150 h, ring of styles2014, two threads\n\n");
  std::printf(
      "| life                                       | points | jumps | cycles | wall s | processor s | ms/cycle  |\n");
  std::printf(
      "|:-------------------------------------------|-------:|------:|-------:|-------:|------------:|----------:|\n");
  print_row("measured path with bands", path);
  print_row("level ring, surface on the path", three);
  if (!is_quick) print_row("spread of 12 tilts, surface on the path", tilted);
  return 0;
}

}  // namespace
}  // namespace ringfilm

int main(int argc, char** argv) {
  const bool is_quick = argc == 2 && std::strcmp(argv[1], "--quick") == 0;
  if (argc > 1 && !is_quick) {
    std::fprintf(stderr, "usage: life_speed [--quick]\n");
    return 2;
  }
  return ringfilm::run(is_quick);
}
