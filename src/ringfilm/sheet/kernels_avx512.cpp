#include "ringfilm/sheet/sheet_sweep.hpp"

namespace ringfilm::sheet {

extern const SheetKernels kAvx512SheetKernels;
constexpr SheetKernels kAvx512SheetKernels = sheet_kernels_of<8, base::InstructionSet::kAvx512>("avx512");

}  // namespace ringfilm::sheet
