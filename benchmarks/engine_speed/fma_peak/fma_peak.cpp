#include "fma_peak.hpp"

namespace ringfilm::benchmarks {

extern const FmaPeak kBaselinePeak;
#if defined(RINGFILM_X86_KERNELS)
extern const FmaPeak kAvx2Peak, kAvx512Peak;
#endif

const FmaPeak& fma_peak([[maybe_unused]] std::string_view kernels) {
#if defined(RINGFILM_X86_KERNELS)
  if (kernels == "avx512") return kAvx512Peak;
  if (kernels == "avx2") return kAvx2Peak;
#endif
  return kBaselinePeak;
}

}  // namespace ringfilm::benchmarks
