#pragma once
#include <vector>

#include "ringfilm/life/wear_integration.hpp"
#include "ringfilm/models/contact/asperity_contact.hpp"

/// Wear without oil: what the integration of wear is compared with closed forms on.
namespace ringfilm::life {

/// A rigid face on a rough flat.
class DryContact {
 public:
  /// @param sigma composite roughness [m] @param load per width [N/m] @param speed [m/s]
  /// @param x places, increasing [m] @param height of the face at them [m]
  DryContact(double sigma, double load, double speed, std::vector<double> x, std::vector<double> height);

  /// Asperity pressure times speed where these depths are lost.
  WearLoad operator()(const std::vector<double>& worn) const;

  double area(const std::vector<double>& worn) const;  ///< integral of the depths [m2]

 private:
  double share(std::size_t i) const;
  double pressure(double separation, double& slope) const;
  double separation(const std::vector<double>& worn) const;

  models::GreenwoodTripp contact_;
  double load_, speed_;
  std::vector<double> x_, height_;
};

/// Equally spaced places from 0 to a length.
std::vector<double> places(double length, int n_cells);

}  // namespace ringfilm::life
