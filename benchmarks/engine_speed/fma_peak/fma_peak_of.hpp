#pragma once
#include "fma_peak.hpp"
#include "ringfilm/base/pack.hpp"

/// For the sources that compile the loop, each for one kind of machine with the options of the film's kernels:
/// fma_peak_*.cpp.
namespace ringfilm::benchmarks {

/// Products that enter sums in chains that wait for nothing but themselves: enough of them to hide how long one takes,
/// few enough for the registers of any machine.
template <class Real>
double multiply_and_add(long rounds) {
  constexpr int kChains = 12;
  const Real factor(0.999999);
  const Real term(1e-6);
  Real chain[kChains];
  for (int c = 0; c < kChains; ++c) chain[c] = Real(1 + 0.01 * c);
  for (long round = 0; round < rounds; ++round) {
#pragma GCC unroll 16
    for (int c = 0; c < kChains; ++c) chain[c] = chain[c] * factor + term;
  }
  Real total(0);
  for (int c = 0; c < kChains; ++c) total += chain[c];
  return total.sum();
}

template <int kWidth, base::InstructionSet kSet>
constexpr FmaPeak fma_peak_of() {
  return {multiply_and_add<base::Pack<kWidth, kSet>>, 2.0 * 12 * kWidth};
}

}  // namespace ringfilm::benchmarks
