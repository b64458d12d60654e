#include "ringfilm/sheet/sheet_sweep.hpp"

namespace ringfilm::sheet {

extern const SheetKernels kBaselineSheetKernels;
constexpr SheetKernels kBaselineSheetKernels = sheet_kernels_of<2, base::InstructionSet::kBaseline>("baseline");

}  // namespace ringfilm::sheet
