#pragma once
#include <string_view>

#include "ringfilm/sheet/sheet_block.hpp"

/// The inner loops of the sheet, compiled for several kinds of machine from one source (sheet_sweep.hpp).
namespace ringfilm::sheet {

struct SheetKernels {
  std::string_view name;  ///< as that of the film's kernels
  /// Oil at all nodes by the fits.
  void (*oil)(SheetBlock&);
  /// Load, balance of mass and its slopes, from z and the oil.
  void (*balance)(SheetBlock&);
  /// z moves by `step`; a node that would change sides stops just beyond the kink.
  void (*update)(SheetBlock&, const double* step);
  /// Eliminates along each strip.
  void (*factor)(const StripSystem&);
  /// Solves the strips of one colour for `rhs` as they are beside the others in `x`.
  void (*relax)(const StripSystem&, int colour, const double* rhs, double* x);
  /// y = A x.
  void (*product)(const StripSystem&, const double* x, double* y);
  /// The right-hand side of a coarser sheet: `weight` has a number for each node of the finer one.
  void (*to_coarse)(const ZebraShape& fine, const double* weight, const double* rhs, const ZebraShape& coarse,
                    double* to);
  /// The odd strips of a finer sheet, each between the strip that stands for it and the one after.
  void (*from_coarse)(const ZebraShape& coarse, const double* x, const ZebraShape& fine, const double* own,
                      const double* beside, double* to);
  double (*dot)(const double* a, const double* b, std::size_t n);
  /// y += c x.
  void (*add)(double c, const double* x, double* y, std::size_t n);
};

/// Those compiled for the same kind of machine as the film's of this name; they must be able to run here.
const SheetKernels& sheet_kernels(std::string_view name);

}  // namespace ringfilm::sheet
