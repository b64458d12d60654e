#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/models/contact/contact_law.hpp"

namespace ringfilm::models {

/// A contact law as numbers over the separation.
struct ContactTable {
  std::vector<double> h;           ///< separations, rising, from 0 or above [m]
  std::vector<double> pressure;    ///< above 0, strictly falling [Pa]
  std::vector<double> area_share;  ///< above 0, strictly falling [-]
};

/// A law between the rows of a table: y = (p/p_0)^(1/8) is a cubic spline with limited slopes, strictly falling as the
/// table, cut into equal pieces, eq-contact-table; the same for the area. Before the first row and beyond the last one
/// that is trusted ln p continues, straight before and with the curvature of the last rows beyond.
class TabulatedContact final : public AsperityContact {
 public:
  static constexpr std::size_t kMinRows = 4;
  static constexpr double kMaxError = 1e-3;  ///< largest permitted row_error(), relative to the pressure at a row [-]

  /// @param trusted_up_to_m last separation whose rows are used [m]
  /// Throws InputError for fewer than 4 such rows, and rows that do not fall.
  TabulatedContact(const ContactTable& table, double trusted_up_to_m);

  Contact contact(double h) const override;
  void pressure(double h, double& p_a, double& dp_a_dh) const override;
  double reach() const override { return pieces_.reach; }
  double length_scale() const override { return pieces_.reach / ContactFit::kEnd; }
  bool has_kinks() const override { return false; }
  double trusted_up_to() const override { return trusted_up_to_; }
  const ContactPieces* pieces() const override { return &pieces_; }

  double row_error() const { return row_error_; }  ///< largest relative error of the pressure at the rows used [-]

 private:
  ContactPieces pieces_;
  double trusted_up_to_;
  double row_error_ = 0;
};

}  // namespace ringfilm::models
