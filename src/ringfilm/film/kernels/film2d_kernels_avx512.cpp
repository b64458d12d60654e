#include "ringfilm/film/kernels/film2d_sweep.hpp"

namespace ringfilm::film {

extern const Film2dKernels kAvx512Film2dKernels;
constexpr Film2dKernels kAvx512Film2dKernels = film2d_kernels_of<8, base::InstructionSet::kAvx512>("avx512");

}  // namespace ringfilm::film
