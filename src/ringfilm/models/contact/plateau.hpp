#pragma once
#include <functional>

#include "ringfilm/models/contact/summit_contact.hpp"

/// Surfaces made in two steps: a plateau that carries over valleys that hold oil (docs/theory/contact.md).
namespace ringfilm::models {

/// The two lines of the material ratio curve over normal probability @cite iso13565_3, eq-plateau-curve.
struct PlateauCurve {
  double Rpq;  ///< rms of the plateau [m]
  double Rvq;  ///< rms of the valleys, above Rpq [m]
  double Rmq;  ///< material ratio at which both lines meet, above 0 and below 1 [-]
};

/// Planes of such a surface above its mean plane, and its rms height, eq-plateau-planes.
struct PlateauPlanes {
  double plateau;  ///< mean plane of the plateau above that of the surface [m]
  double valleys;  ///< mean plane of the surface that the valleys belong to above that of the surface [m]
  double rms;      ///< rms height of the whole surface [m]
};
/// Planes and rms height of the surface with these lines.
PlateauPlanes plateau_planes(const PlateauCurve& curve);

/// Core, peaks and valleys of a material ratio curve @cite iso13565_2.
struct CoreValues {
  double Rk;   ///< height of the core [m]
  double Rpk;  ///< height of the reduced peaks [m]
  double Rvk;  ///< depth of the reduced valleys [m]
  double Mr2;  ///< material ratio at which the valleys begin, above 0 and below kMr2OfGaussian [-]
};

/// Mr2 of a Gaussian surface: above it nothing is deeper than the valleys of one surface alone [-].
inline constexpr double kMr2OfGaussian = 0.90095;

/// The two lines with these values, eq-plateau-core; exact for two lines that meet at 0.7 to 0.9. Its Rvq is not above
/// its Rpq where the values are not of a plateau over deeper valleys.
PlateauCurve plateau_curve(const CoreValues& core);

/// A contact law, as summit_contact() returns it.
using ContactFunction = std::function<PressureAndArea(double)>;

/// Contact at a separation from the mean plane of the whole surface: the lower of what both parts would carry if each
/// was the whole surface, eq-plateau-contact.
/// @param plateau,valleys laws from their own mean planes
ContactFunction plateau_contact(ContactFunction plateau, ContactFunction valleys, const PlateauPlanes& planes);

}  // namespace ringfilm::models
