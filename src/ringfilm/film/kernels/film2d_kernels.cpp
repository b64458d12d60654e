#include "ringfilm/film/kernels/film2d_kernels.hpp"

namespace ringfilm::film {

extern const Film2dKernels kBaselineFilm2dKernels;
#if defined(RINGFILM_X86_KERNELS)
extern const Film2dKernels kAvx2Film2dKernels, kAvx512Film2dKernels;
#endif

const Film2dKernels& film2d_kernels(std::string_view name) {
#if defined(RINGFILM_X86_KERNELS)
  if (name == kAvx512Film2dKernels.name) return kAvx512Film2dKernels;
  if (name == kAvx2Film2dKernels.name) return kAvx2Film2dKernels;
#endif
  static_cast<void>(name);
  return kBaselineFilm2dKernels;
}

}  // namespace ringfilm::film
