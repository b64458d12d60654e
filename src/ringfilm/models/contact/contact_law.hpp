#pragma once
#include <array>
#include <optional>
#include <vector>

#include "ringfilm/models/contact_fit.hpp"

namespace ringfilm::models {

/// Polynomials that replace a law in the inner loop.
struct FittedContact {
  const ContactFit* fit;
  double reach;           ///< separation at which they end [m]
  double pressure_scale;  ///< p_a over the eighth power of the first [Pa]
  double area_scale;      ///< area share over the eighth power of the second [-]
};

/// Cubics that are the law, on equal pieces from 0 to the reach: the eighth root of p_a over the scale, by powers of
/// the place within the piece, 0 to 1.
struct ContactPieces {
  std::vector<std::array<double, 4>> root;
  double reach = 0;           ///< [m]
  double pressure_scale = 0;  ///< [Pa]
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
