// Films and gas of a ring pack that shares the oil on the liner.
//   pack CASE.toml
#include <cstdio>
#include <exception>

#include "ringfilm/ringfilm.hpp"

namespace {

using namespace ringfilm;

void compute(const char* case_path) {
  const run::Outcome done = run::run_case(io::read_case(case_path));
  if (done.stopped) throw *done.stopped;
  const auto& pack = std::get<io::ResultDocument>(done.result);
  for (const io::ResultDocument& ring : io::rings_of(pack)) {
    std::printf("%s: %.2f kPa, %.1f W\n", ring.title.c_str(), 1e-3 * ring.result.values.fmep,
                ring.result.values.mean_power_loss);
  }
  std::printf("pack: %.2f kPa", 1e-3 * pack.result.values.fmep);
  if (pack.gas) std::printf(", blow-by %.2f l/min per cylinder", 60e3 * pack.gas->sums.blow_by_flow);
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: pack CASE.toml\n");
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
