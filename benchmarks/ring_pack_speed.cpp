#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/cycle/pack/gas_of_pack.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/cycle/pack/simulate_pack.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"
#include "ringfilm/io/case/case_file.hpp"

/// What the gas of a ring pack costs alone, and what its films cost together next to the same rings one by one.
namespace {

using namespace ringfilm;

const char* const kFolder = RINGFILM_SOURCE_FOLDER "/cases/ring-pack/";

/// Processor time, the shortest of three [ms].
double milliseconds(const std::function<void()>& work) {
  double shortest = 1e300;
  for (int i = 0; i < 3; ++i) {
    const std::clock_t begin = std::clock();
    work();
    shortest = std::min(shortest, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return shortest;
}

/// Integrates a ring by itself. @returns the cycles that it took; short of oil it may never repeat itself
double cycles_alone(const cycle::Case& ring) {
  try {
    return cycle::simulate(cycle::prepare(ring)).effort.cycles_integrated;
  } catch (const cycle::StoppedCycle& stop) {
    return stop.result.effort.cycles_integrated;
  }
}

void measure_gas(const char* motion, const char* speed) {
  const cycle::Case c = io::read_case(std::string(kFolder) + "two_rings.toml",
                                      {{"gas_path.ring_motion", motion}, {"operating.speed", speed}}, io::Units(),
                                      io::CasePurpose::kGasPath);
  const gas_path::Pack pack = cycle::gas_pack(c);
  int cycles = 0;
  const double ms = milliseconds([&] { cycles = gas_path::solve_gas_path(pack).cycles; });
  std::printf("gas alone, %s, %s: %.1f ms, %d cycles, %.2f ms a cycle\n", motion, speed, ms, cycles, ms / cycles);
}

void measure_pack(const char* scraped) {
  const cycle::Case pack = cycle::with_gas_path(
      cycle::with_rails(io::read_case(std::string(kFolder) + "three_rings.toml", {{"supply.scraped", scraped}})));
  double cycles = 0;
  const double together = milliseconds([&] {
    std::vector<cycle::Setup> rings;
    for (const cycle::Case& ring : pack.rings) rings.push_back(cycle::prepare(ring));
    cycles = cycle::simulate_pack(std::move(rings)).front().result.effort.cycles_integrated;
  });
  double alone = 0, per_cycle = 0;
  std::string of_rings;
  for (const cycle::Case& ring : pack.rings) {
    double own = 0;
    const double ms = milliseconds([&] { own = cycles_alone(ring); });
    alone += ms;
    per_cycle += ms / own;
    of_rings += ' ';
    of_rings += std::to_string(static_cast<int>(own + 0.5));
  }
  std::printf("three_rings, scraped oil %s: together %.0f ms in %.1f cycles, one by one %.0f ms in%s cycles\n", scraped,
              together, cycles, alone, of_rings.c_str());
  std::printf("  ratio %.2f of the whole, %.2f of a cycle\n", together / alone, together / cycles / per_cycle);
}

}  // namespace

int main() try {
  for (const char* motion : {"seated", "axial"}) {
    for (const char* speed : {"1500 rpm", "4500 rpm"}) measure_gas(motion, speed);
  }
  for (const char* scraped : {"bead", "discarded"}) measure_pack(scraped);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "ring_pack_speed: %s\n", error.what());
  return 1;
}
