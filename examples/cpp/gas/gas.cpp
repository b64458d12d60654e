// Blow-by and pressures between the rings of a pack for two end gaps.
//   gas CASE.toml
#include <cstdio>
#include <exception>

#include "ringfilm/ringfilm.hpp"

namespace {

using namespace ringfilm;

void compute(const char* case_path) {
  for (const char* end_gap : {"0.25 mm", "0.5 mm"}) {
    const cycle::Case pack =
        io::read_case(case_path, {{"ring.1.end_gap", end_gap}}, io::Units(), io::CasePurpose::kGasPath);
    const run::Outcome done = run::run_case(pack);
    const auto& document = std::get<io::GasPathDocument>(done.result);
    std::printf("end gap of the top ring %s: blow-by %.2f l/min per cylinder\n", end_gap,
                60e3 * document.gas.sums.blow_by_flow);
    for (const gas_path::RegionValues& region : document.result.regions) {
      std::printf("  %s: peak pressure %.2f bar at %.0f degree\n", region.name.c_str(), 1e-5 * region.peak_pressure,
                  region.peak_pressure_angle_deg);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: gas CASE.toml\n");
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
