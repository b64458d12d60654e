// Assumptions of a case, and the effect of other choices: the assumption ledger.
//   assumptions CASE.toml
#include <cstdio>
#include <exception>

#include "ringfilm/ringfilm.hpp"

namespace {

using namespace ringfilm;

void compute(const char* case_path) {
  const cycle::Case input = io::read_case(case_path);
  run::Options options;
  options.ledger = true;
  const run::Outcome done = run::run_case(input, options);
  if (done.stopped) throw *done.stopped;
  const auto& document = std::get<io::ResultDocument>(done.result);
  std::printf("friction mean effective pressure %.1f kPa\n", 1e-3 * document.result.values.fmep);
  for (const study::LedgerEntry& entry : document.ledger) {
    std::printf("%s: %s\n", entry.topic.c_str(), entry.statement.c_str());
    for (const study::LedgerVariant& variant : entry.variants) {
      if (variant.solved) std::printf("  %.1f kPa with %s\n", 1e-3 * variant.values.fmep, variant.setting.c_str());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: assumptions CASE.toml\n");
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
