#include "fma_peak_of.hpp"

namespace ringfilm::benchmarks {

extern const FmaPeak kAvx2Peak;
constexpr FmaPeak kAvx2Peak = fma_peak_of<4, base::InstructionSet::kAvx2>();

}  // namespace ringfilm::benchmarks
