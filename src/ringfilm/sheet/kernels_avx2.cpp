#include "ringfilm/sheet/sheet_sweep.hpp"

namespace ringfilm::sheet {

extern const SheetKernels kAvx2SheetKernels;
constexpr SheetKernels kAvx2SheetKernels = sheet_kernels_of<4, base::InstructionSet::kAvx2>("avx2");

}  // namespace ringfilm::sheet
