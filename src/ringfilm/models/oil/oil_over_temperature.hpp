#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "ringfilm/models/oil/oil_fit.hpp"

namespace ringfilm::models {

/// An oil at each temperature of a range: that of a film between walls whose temperatures vary along the stroke.
/// Immutable; may be used from several threads.
class OilOverTemperature {
 public:
  /// The laws of the oil at a temperature [K].
  using Laws = std::function<std::shared_ptr<const OilAtTemperature>(double T)>;

  /// An oil at one temperature alone, as it is.
  explicit OilOverTemperature(std::shared_ptr<const OilAtTemperature> oil) : only_(std::move(oil)) {}
  /// Without fits. @param low, high of the temperature [K]
  OilOverTemperature(Laws laws, double low, double high);

  /// Gives the oil fits from p = 0 to `highest_pressure` [Pa] whose coefficients are polynomials in temperature
  /// (eq-oil-fit-temperature). @returns false, and the oil remains as it was, where they are not certified: compared
  /// at temperatures and pressures between those of the fit, as fit_oil does over pressure
  bool fit(double highest_pressure);

  bool has_fit() const { return only_ ? only_->fit() != nullptr : !nodes_.fit.empty(); }

  /// The oil at T [K] within the range, with a fit where `fit` succeeded.
  std::shared_ptr<const OilAtTemperature> at(double T) const;

  double viscosity(double T) const;  ///< at atmospheric pressure, by the laws [Pa s]

 private:
  /// The fits at Chebyshev's nodes in temperature; K and its slope relative to K[0], which is kept as a logarithm.
  struct Nodes {
    std::vector<double> place, weight;  ///< in t = -1 ... 1, and the barycentric weights
    std::vector<OilFit> fit;
    std::vector<double> ln_fluidity;
  };
  bool fit_at_nodes(int n, double highest_pressure);
  OilFit interpolated(double T) const;

  std::shared_ptr<const OilAtTemperature> only_;
  Laws laws_;
  double centre_ = 0, half_width_ = 0;  ///< centre and half width of the range of temperature [K]
  Nodes nodes_;                         ///< empty: no fits
};

}  // namespace ringfilm::models
