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
  double (*dot)(const double* a, const double* b, std::size_t n);
  /// y += c x.
  void (*add)(double c, const double* x, double* y, std::size_t n);
};

/// Those compiled for the same kind of machine as the film's of this name; they must be able to run here.
const SheetKernels& sheet_kernels(std::string_view name);

}  // namespace ringfilm::sheet
