#include "ringfilm/film/kernels/film2d_sweep.hpp"

namespace ringfilm::film {

extern const Film2dKernels kBaselineFilm2dKernels;
constexpr Film2dKernels kBaselineFilm2dKernels = film2d_kernels_of<2, base::InstructionSet::kBaseline>("baseline");

}  // namespace ringfilm::film
