#include "../tests/unit/study/error_coverage.hpp"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

// usage: error_coverage [cases] [times finer] [first seed]
// How many true errors lie within the bands of --error-estimate, quantity by quantity.
namespace {

using ringfilm::study::testing::Coverage;

void print(const char* what, std::map<std::string, Coverage>& parts) {
  std::printf("%s\n", what);
  for (auto& [name, part] : parts) {
    if (part.values == 0) continue;  // exact, as inputs are
    std::printf("  %-36s %8ld values  %6.2f %% within  band/error, median %8.3g\n", name.c_str(), part.values,
                100 * part.share(), part.median_width());
  }
  Coverage all = ringfilm::study::testing::together(parts);
  std::printf("  %-36s %8ld values  %6.2f %% within  band/error, median %8.3g\n\n", "all", all.values,
              100 * all.share(), all.median_width());
}

}  // namespace

int main(int argc, char** argv) {
  const int cases = argc > 1 ? std::atoi(argv[1]) : 100;
  const int finer = argc > 2 ? std::atoi(argv[2]) : 8;
  const int first = argc > 3 ? std::atoi(argv[3]) : 1;
  ringfilm::study::testing::CoverageTable table;
  for (int i = 0; i < cases; ++i) {
    add_case(ringfilm::study::testing::coverage_case(static_cast<std::uint64_t>(first + i)), finer, table);
  }
  print("values of the cycle", table.values);
  print("curves", table.curves);
  std::printf("%ld cases, %ld stopped, %ld values without estimate\n", table.cases, table.stopped, table.not_estimated);
  const auto hold = [](const std::map<std::string, Coverage>& parts) {
    return ringfilm::study::testing::together(parts).share() >= 0.95;  // a NaN, of no case at all, does not
  };
  return hold(table.values) && hold(table.curves) ? 0 : 4;
}
