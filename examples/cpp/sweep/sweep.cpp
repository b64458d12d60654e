// Friction and film of a ring over engine speed, all cases side by side.
//   sweep CASE.toml
#include <cstdio>
#include <exception>
#include <numbers>
#include <vector>

#include "ringfilm/ringfilm.hpp"

namespace {

using namespace ringfilm;

void compute(const char* case_path) {
  const cycle::Case base = io::read_case(case_path);
  std::vector<cycle::Case> cases;
  for (int rpm = 1000; rpm <= 5000; rpm += 1000) {
    cases.push_back(base);
    cases.back().operating.speed = rpm * std::numbers::pi / 30;  // [rad/s]
  }
  for (const study::Ending& ending : study::endings(cases)) {
    if (!ending.is_solved()) {
      std::printf("case %zu: %s\n", ending.index, ending.reason().c_str());
      continue;
    }
    const cycle::CycleValues& values = ending.result.values;
    std::printf("%.0f rpm: %.2f kPa, minimum film thickness %.3f um\n",
                cases[ending.index].operating.speed * 30 / std::numbers::pi, 1e-3 * values.fmep,
                1e6 * values.min_film_thickness);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: sweep CASE.toml\n");
    return 2;
  }
  try {
    compute(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
