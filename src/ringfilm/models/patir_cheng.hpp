#pragma once
#include <array>

/// Roughness in the average flow of a film after Patir and Cheng @cite patir1978 @cite patir1979
/// (docs/theory/flow-factors.md). H = h/sigma is the nominal film thickness over the composite roughness.
namespace ringfilm::models {

/// Factors of surfaces of one orientation gamma: the correlation length of their heights along the motion over that
/// across it. At the orientations of the published tables, 1/9, 1/6, 1/3, 1, 3, 6 and 9, they are the published ones;
/// between these they are linear in ln gamma, beyond them those of the last. Films below the range of a table have the
/// values at its end.
class PatirCheng {
 public:
  /// @param gamma above zero [-]
  explicit PatirCheng(double gamma);

  double pressure_flow(double H) const;    ///< phi_x, eq-pressure-flow-factor [-]
  double shear_flow(double H) const;       ///< Phi_s, of one rough surface, eq-shear-flow-factor [-]
  double shear_stress(double H) const;     ///< Phi_fs, of one rough surface, eq-stress-factors [-]
  double pressure_stress(double H) const;  ///< phi_fp, eq-stress-factors [-]

 private:
  template <class Factor>
  double between_rows(const Factor& factor) const;

  int row_;       ///< row of the tables for the orientation
  double share_;  ///< weight of the next row [-]; 0: the factors are those of `row_`
};

/// phi_f, the mean of h over the local film thickness, which ends at a hundredth of sigma; eq-stress-factors [-].
/// Heights have the density that Patir and Cheng take for it, which ends at 3 sigma.
double mean_inverse_film(double H);

/// Mean local film thickness of surfaces of Gaussian heights that do not overlap, less the nominal one, over sigma;
/// eq-average-gap [-].
double average_gap_excess(double H);

}  // namespace ringfilm::models
