#pragma once
#include <array>

/// One asperity against a flat, elastic and beyond (docs/theory/contact.md).
namespace ringfilm::models {

/// How an asperity deforms.
enum class AsperityLaw {
  kElastic,           ///< Hertz
  kZhaoMaiettaChang,  ///< elastic, mixed, fully plastic
  kKogutEtsion,       ///< fits of finite elements in four ranges
  kJacksonGreen,      ///< fits of finite elements; hardness falls with the contact radius
};

/// What an asperity is made of.
struct AsperityMaterial {
  double E_star;    ///< 1/E* = sum (1 - nu^2)/E [Pa]
  double hardness;  ///< H of the softer face; not used by kElastic [Pa]
  double nu;        ///< Poisson's ratio of the softer face [-]
};

/// Load and area of a summit of radius R that is pressed by w.
class SingleAsperity {
 public:
  SingleAsperity(AsperityLaw law, const AsperityMaterial& material, double radius);

  double load(double w) const;  ///< [N] of w [m], above 0; eq-single-asperity
  double area(double w) const;  ///< [m2]
  /// Approaches between which load and area are smooth, rising; 0 where there are fewer [m].
  const std::array<double, 3>& limits() const { return limits_; }

 private:
  double jackson_green_load(double w) const;
  double hertz_load(double w) const;

  AsperityLaw law_;
  AsperityMaterial material_;
  double radius_;
  double critical_ = 0;  ///< approach at which it begins to flow [m]
  std::array<double, 3> limits_{};
};

}  // namespace ringfilm::models
