#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "ringfilm/models/contact/contact_fit.hpp"

namespace ringfilm::models {

/// Polynomials that replace a law in the inner loop.
struct FittedContact {
  const ContactFit* fit;
  double reach;           ///< separation at which they end [m]
  double pressure_scale;  ///< p_a over the eighth power of the first [Pa]
  double area_scale;      ///< area share over the eighth power of the second [-]
};

/// Cubics that are the law, on equal pieces from 0 to the reach: eighth roots of p_a and of the area share over their
/// scales, by powers of the place within the piece, 0 to 1.
struct ContactPieces {
  using Cubics = std::vector<std::array<double, 4>>;
  Cubics pressure, area;      ///< coefficients of the cubic of each piece
  double reach = 0;           ///< [m]
  double pressure_scale = 0;  ///< [Pa]
  double area_scale = 0;      ///< [-]

  /// The piece of a separation between 0 and the reach, and its place within it.
  struct Place {
    std::size_t piece;
    double within;
  };
  Place place(double h) const {
    const double at = h / reach * static_cast<double>(pressure.size());
    const std::size_t piece = std::min(static_cast<std::size_t>(at), pressure.size() - 1);
    return {piece, at - static_cast<double>(piece)};
  }
  static double value(const std::array<double, 4>& c, double d) { return c[0] + d * (c[1] + d * (c[2] + d * c[3])); }
  static double eighth_power(double root) {
    const double square = root * root, fourth = square * square;
    return fourth * fourth;
  }
};

/// What rough surfaces carry at a separation, whatever law that follows: as film and results use it.
class AsperityContact {
 public:
  /// Pressure on the nominal area at the separation h [m], its slope and the real contact area per nominal area.
  struct Contact {
    double pressure;        ///< p_a [Pa]
    double pressure_slope;  ///< dp_a/dh [Pa/m]
    double area_share;      ///< A_a/A [-]
  };

  virtual ~AsperityContact() = default;

  virtual Contact contact(double h) const = 0;  ///< at separation h [m]
  /// p_a and dp_a/dh alone, for the inner loop. Below h = 0 both continue along the tangent; NaN gives NaN.
  virtual void pressure(double h, double& p_a, double& dp_a_dh) const = 0;
  /// Beyond this separation the contact pressure is taken as zero [m].
  virtual double reach() const = 0;
  virtual double length_scale() const = 0;  ///< over which the law falls, about the rms of the heights [m]
  /// Has the law kinks, at which the order of an iteration is lost?
  virtual bool has_kinks() const = 0;
  /// Separation beyond which the law is not trusted, whose load is summed by itself [m].
  virtual double trusted_up_to() const = 0;

  /// What may replace the law in the inner loop; nothing where nothing does.
  virtual std::optional<FittedContact> fitted() const { return std::nullopt; }
  /// The law for the inner loop where it is cubics; else nullptr.
  virtual const ContactPieces* pieces() const { return nullptr; }
};

}  // namespace ringfilm::models
