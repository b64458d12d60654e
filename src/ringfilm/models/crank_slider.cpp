#include "ringfilm/models/crank_slider.hpp"

#include <cmath>

namespace ringfilm::models {

double CrankSlider::position(double phi) const {
  // Written without differences of nearly equal numbers, so that it stays exact near TDC.
  const double r = crank_radius, l = connecting_rod_length;
  const double sin_half = std::sin(phi / 2);
  const double offset = r * std::sin(phi);  // offset of the crank pin from the axis of the bore
  return 2 * r * sin_half * sin_half + offset * offset / (l + std::sqrt(l * l - offset * offset));
}

double CrankSlider::velocity(double phi, double omega) const {
  const double rod_ratio = connecting_rod_length / crank_radius;
  const double s = std::sin(phi);
  return -crank_radius * omega * s * (1 + std::cos(phi) / std::sqrt(rod_ratio * rod_ratio - s * s));
}

double CrankSlider::acceleration(double phi, double omega) const {
  const double rod_ratio = connecting_rod_length / crank_radius;
  const double s = std::sin(phi), c = std::cos(phi);
  const double root = std::sqrt(rod_ratio * rod_ratio - s * s);
  const double of_rod = (c * c - s * s) / root + s * s * c * c / (root * root * root);
  return -crank_radius * omega * omega * (c + of_rod);
}

}  // namespace ringfilm::models
