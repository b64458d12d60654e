// Mean and standard deviation of the friction over all scenarios of a study.
//   study STUDY.toml
#include <cmath>
#include <cstdio>
#include <exception>
#include <vector>

#include "ringfilm/ringfilm.hpp"

namespace {

using namespace ringfilm;

void compute(const char* study_path) {
  const study::Plan plan(io::read_study(study_path).study);
  const std::size_t fmep = plan.values().index("fmep").value();
  std::vector<double> values;
  study::run_scenarios(plan, {0, plan.size()}, [&](const study::ScenarioBlock& block) {
    for (const study::ScenarioRow& row : block.rows) {
      if (row.reason.empty()) values.push_back(row.values[fmep]);
    }
    return study::Continuation::kYes;
  });
  double mean = 0, variance = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values)
    variance += (value - mean) * (value - mean) / static_cast<double>(values.size() - 1);
  std::printf("%zu scenarios, %zu not solved\n", plan.size(), plan.size() - values.size());
  std::printf("friction mean effective pressure: mean %.1f kPa, standard deviation %.1f kPa\n", 1e-3 * mean,
              1e-3 * std::sqrt(variance));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: study STUDY.toml\n");
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
