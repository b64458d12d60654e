#include "fma_peak_of.hpp"

namespace ringfilm::benchmarks {

extern const FmaPeak kBaselinePeak;
constexpr FmaPeak kBaselinePeak = fma_peak_of<2, base::InstructionSet::kBaseline>();

}  // namespace ringfilm::benchmarks
