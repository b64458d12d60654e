#include "fma_peak_of.hpp"

namespace ringfilm::benchmarks {

extern const FmaPeak kAvx512Peak;
constexpr FmaPeak kAvx512Peak = fma_peak_of<8, base::InstructionSet::kAvx512>();

}  // namespace ringfilm::benchmarks
