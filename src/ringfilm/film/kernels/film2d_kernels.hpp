#pragma once
#include <string_view>

#include "ringfilm/film/kernels/film2d_block.hpp"

/// The inner loops of the two-dimensional film, compiled for several kinds of machine from one source
/// (film2d_sweep.hpp).
namespace ringfilm::film {

struct Film2dKernels {
  std::string_view name;  ///< as that of the film's kernels
  /// Oil at all nodes by the fits.
  void (*oil)(Film2dBlock&);
  /// Load, balance of mass and its slopes, from z and the oil.
  void (*balance)(Film2dBlock&);
  /// z moves by `step`; a node that would change sides stops just beyond the kink.
  void (*update)(Film2dBlock&, const double* step);
  /// Eliminates along each strip.
  void (*factor)(const StripSystem&);
  /// Solves the strips of one colour for `rhs` as they are beside the others in `x`.
  void (*relax)(const StripSystem&, int colour, const double* rhs, double* x);
  /// y = A x.
  void (*product)(const StripSystem&, const double* x, double* y);
  /// The right-hand side of a coarser two-dimensional film: `weight` has a number for each node of the finer one.
  void (*to_coarse)(const ZebraShape& fine, const double* weight, const double* rhs, const ZebraShape& coarse,
                    double* to);
  /// The odd strips of a finer two-dimensional film, each between the strip that stands for it and the one after.
  void (*from_coarse)(const ZebraShape& coarse, const double* x, const ZebraShape& fine, const double* own,
                      const double* beside, double* to);
  /// y += the balance's slopes by the separations: of the strip itself, and at the faces to the strips beside.
  void (*add_columns)(const Film2dBlock&, const double* own, const double* low, const double* high, double* y);
  /// Sums of `row` times `x` over the nodes of each strip.
  void (*strip_sums)(const ZebraShape&, const double* row, const double* x, double* sums);
  /// Load that the film of each strip carries [N/m].
  void (*strip_loads)(const Film2dBlock&, double* loads);
  /// x -= column times the number of the strip.
  void (*take_columns)(const ZebraShape&, const double* column, const double* of_strip, double* x);
  double (*dot)(const double* a, const double* b, std::size_t n);
  /// y += c x.
  void (*add)(double c, const double* x, double* y, std::size_t n);
};

/// Those compiled for the same kind of machine as the film's of this name; they must be able to run here.
const Film2dKernels& film2d_kernels(std::string_view name);

}  // namespace ringfilm::film
