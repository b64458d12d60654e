#include "ringfilm/sheet/sheet_kernels.hpp"

namespace ringfilm::sheet {

extern const SheetKernels kBaselineSheetKernels;
#if defined(RINGFILM_X86_KERNELS)
extern const SheetKernels kAvx2SheetKernels, kAvx512SheetKernels;
#endif

const SheetKernels& sheet_kernels(std::string_view name) {
#if defined(RINGFILM_X86_KERNELS)
  if (name == kAvx512SheetKernels.name) return kAvx512SheetKernels;
  if (name == kAvx2SheetKernels.name) return kAvx2SheetKernels;
#endif
  static_cast<void>(name);
  return kBaselineSheetKernels;
}

}  // namespace ringfilm::sheet
