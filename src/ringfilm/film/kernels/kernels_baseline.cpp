#include "ringfilm/film/kernels/kernels_of.hpp"

namespace ringfilm::film {

extern const FilmKernels kBaselineKernels;
constexpr FilmKernels kBaselineKernels = kernels_of<2, base::InstructionSet::kBaseline>("baseline");

}  // namespace ringfilm::film
