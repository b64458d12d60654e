#pragma once
#include <vector>

#include "ringfilm/life/wear_integration.hpp"
#include "ringfilm/models/asperity_contact.hpp"

namespace ringfilm::life::testing {

/// A rigid face on a rough flat without oil, pressed with a load per width and slid with a speed.
class DryContact {
 public:
  DryContact(double sigma, double load, double speed, std::vector<double> x, std::vector<double> height)
      : contact_({0.1e12, 1.5e-6, sigma, 130e9}),
        load_(load),
        speed_(speed),
        x_(std::move(x)),
        height_(std::move(height)) {}

  double share(std::size_t i) const {
    const double before = i > 0 ? x_[i] - x_[i - 1] : 0, after = i + 1 < x_.size() ? x_[i + 1] - x_[i] : 0;
    return 0.5 * (before + after);
  }

  /// Asperity pressure times speed where these depths are lost [Pa m/s].
  WearLoad operator()(const std::vector<double>& worn) const {
    // The separation that carries the load, by bisection: load falls with it.
    double low = -20e-6, high = 60e-6;
    for (int n = 0; n < 200; ++n) {
      const double middle = 0.5 * (low + high);
      (carried(worn, middle) > load_ ? low : high) = middle;
    }
    WearLoad load;
    for (std::size_t i = 0; i < x_.size(); ++i) load.face.push_back(pressure(worn, low, i) * speed_);
    return load;
  }

  double area(const std::vector<double>& worn) const {
    double area = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) area += share(i) * worn[i];
    return area;
  }

  const models::GreenwoodTripp& contact() const { return contact_; }
  double load() const { return load_; }
  double speed() const { return speed_; }

 private:
  double pressure(const std::vector<double>& worn, double separation, std::size_t i) const {
    double p = 0, slope = 0;
    contact_.pressure(separation + height_[i] + worn[i], p, slope);
    return p;
  }
  double carried(const std::vector<double>& worn, double separation) const {
    double load = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) load += share(i) * pressure(worn, separation, i);
    return load;
  }

  models::GreenwoodTripp contact_;
  double load_, speed_;
  std::vector<double> x_, height_;
};

inline std::vector<double> places(double length, int n_cells) {
  std::vector<double> x;
  for (int i = 0; i <= n_cells; ++i) x.push_back(length * i / n_cells);
  return x;
}

}  // namespace ringfilm::life::testing
