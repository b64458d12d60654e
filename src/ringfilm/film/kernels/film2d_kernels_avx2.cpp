#include "ringfilm/film/kernels/film2d_sweep.hpp"

namespace ringfilm::film {

extern const Film2dKernels kAvx2Film2dKernels;
constexpr Film2dKernels kAvx2Film2dKernels = film2d_kernels_of<4, base::InstructionSet::kAvx2>("avx2");

}  // namespace ringfilm::film
