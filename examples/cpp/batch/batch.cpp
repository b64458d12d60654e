// Many cycles on all threads, side by side in the lanes of a vector register: how the friction of a ring follows its
// tension and the roughness. Memory does not grow with their number.
//   batch CASE.toml [COUNT]
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>

#include "ringfilm/ringfilm.hpp"

namespace {

using namespace ringfilm;

void compute(const char* case_path, std::size_t count) {
  const cycle::Case base = io::read_case(case_path);
  std::size_t given = 0;
  const auto next = [&]() -> std::optional<cycle::Case> {
    if (given == count) return std::nullopt;
    const double share = static_cast<double>(given++) / static_cast<double>(count);
    cycle::Case c = base;
    c.ring.elastic_pressure = *base.ring.elastic_pressure * (0.5 + share);
    c.contact.roughness = base.contact.roughness * (1.2 - 0.4 * share);
    return c;
  };

  std::vector<double> power(count);  // scenarios end in any order
  std::size_t failed = 0;
  const study::BatchEffort effort = study::simulate_cases(next, [&](const study::Ending& ending) {
    power[ending.index] = ending.result.values.mean_power_loss;  // NaN if not solved
    if (ending.is_solved()) return;
    ++failed;
    std::printf("scenario %zu: %s\n", ending.index, ending.reason().c_str());
  });
  for (std::size_t i = 0; i < count; i += (count + 9) / 10) std::printf("scenario %zu: %.4f W\n", i, power[i]);
  std::printf("%zu scenarios, %zu not solved, %d threads\n", count, failed, effort.threads);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: batch CASE.toml [COUNT]\n");
    return 2;
  }
  try {
    const long count = argc == 3 ? std::atol(argv[2]) : 200;
    if (count < 1) throw InputError("COUNT is not a positive number", "omit it, or write for example 200");
    compute(argv[1], static_cast<std::size_t>(count));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
