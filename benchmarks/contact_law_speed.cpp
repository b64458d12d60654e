#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

// What a contact law that is a table costs in the batched engine: processor time of a cycle with Greenwood and Tripp
// and with a table of the same pressures, in turns, set up included, one thread; the fastest of all repetitions.
// usage: contact_law_speed CASE [CASES] [REPETITIONS]

namespace {

using namespace ringfilm;

/// The law of the case as a table, as ringfilm contact would write it.
cycle::Case tabulated(cycle::Case c) {
  constexpr double kFirst = 0.3, kLast = 5, kStep = 0.1;  // lambda ratio
  const auto law = cycle::asperity_contact(c);
  const double sigma = cycle::roughness(c);
  cycle::ContactLawTable table;
  for (double lambda = kFirst; lambda < kLast; lambda += kStep) {
    const auto at = law->contact(lambda * sigma);
    table.rows.h.push_back(lambda * sigma);
    table.rows.pressure.push_back(at.pressure);
    table.rows.area_share.push_back(at.area_share);
    table.mean_gap.push_back(lambda * sigma);
  }
  table.composite_roughness = sigma;
  table.composite_modulus = cycle::composite_modulus(c);
  table.last_supported_separation = table.rows.h.back();
  c.contact.model = cycle::ContactLaw::kTable;
  c.contact.law = base::Shared<cycle::ContactLawTable>(std::move(table));
  return c;
}

/// Processor time of a cycle [ms], and the mean power of the first, for comparison [W].
struct Measured {
  double milliseconds, power;
};

Measured measured(const cycle::Case& input, int n) {
  int next_case = 0;
  double power = 0;
  const auto next = [&]() -> std::optional<cycle::Case> {
    if (next_case == n) return std::nullopt;
    cycle::Case one = input;
    one.operating.speed = 150.0 + 100.0 * next_case++ / n;
    return one;
  };
  study::BatchOptions options;
  options.threads = 1;
  const std::clock_t begin = std::clock();
  study::simulate_cases(
      next,
      [&](study::Ending ending) {
        if (ending.index == 0) power = ending.result.values.mean_power_loss;
      },
      options);
  return {1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / n, power};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const cycle::Case closed = io::read_case(argv[1]), table = tabulated(closed);
  const int n = argc > 2 ? std::atoi(argv[2]) : 64, repetitions = argc > 3 ? std::atoi(argv[3]) : 10;
  Measured of_closed{1e300, 0}, of_table{1e300, 0};
  std::vector<double> ratios;
  for (int k = 0; k < repetitions; ++k) {
    const Measured one = measured(closed, n), other = measured(table, n);
    of_closed = {std::min(of_closed.milliseconds, one.milliseconds), one.power};
    of_table = {std::min(of_table.milliseconds, other.milliseconds), other.power};
    ratios.push_back(other.milliseconds / one.milliseconds);
  }
  std::sort(ratios.begin(), ratios.end());
  std::printf("greenwood-tripp %8.4f ms a cycle, %.10g W\n", of_closed.milliseconds, of_closed.power);
  std::printf("table           %8.4f ms a cycle, %.10g W\n", of_table.milliseconds, of_table.power);
  std::printf("table : closed  %8.4f of the fastest, %.4f median of %d pairs\n",
              of_table.milliseconds / of_closed.milliseconds, ratios[ratios.size() / 2], repetitions);
}
