#include "ringfilm/film/kernels/kernels_of.hpp"

namespace ringfilm::film {

extern const FilmKernels kAvx2Kernels;
constexpr FilmKernels kAvx2Kernels = kernels_of<4, base::InstructionSet::kAvx2>("avx2");

}  // namespace ringfilm::film
