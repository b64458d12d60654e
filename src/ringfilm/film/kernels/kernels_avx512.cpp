#include "ringfilm/film/kernels/kernels_of.hpp"

namespace ringfilm::film {

extern const FilmKernels kAvx512Kernels;
constexpr FilmKernels kAvx512Kernels = kernels_of<8, base::InstructionSet::kAvx512>("avx512");

}  // namespace ringfilm::film
