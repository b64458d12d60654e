#include "ringfilm/life/dry_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ringfilm::life {
namespace {

/// A rough surface that is only smaller where sigma is: the same roughness parameter and slope of its peaks.
models::GreenwoodTripp contact_of(double sigma) {
  const double beta = 3 * sigma;
  constexpr double kRoughnessParameter = 0.07, kModulus = 130e9;
  return models::GreenwoodTripp({kRoughnessParameter / (beta * sigma), beta, sigma, kModulus});
}

}  // namespace

DryContact::DryContact(double sigma, double load, double speed, std::vector<double> x, std::vector<double> height)
    : contact_(contact_of(sigma)), load_(load), speed_(speed), x_(std::move(x)), height_(std::move(height)) {}

double DryContact::share(std::size_t i) const {
  const double before = i > 0 ? x_[i] - x_[i - 1] : 0, after = i + 1 < x_.size() ? x_[i + 1] - x_[i] : 0;
  return 0.5 * (before + after);
}

/// Where the mean planes touch it continues along its tangent, so that any load is carried.
double DryContact::pressure(double separation, double& slope) const {
  double p = 0;
  contact_.pressure(std::max(separation, 0.0), p, slope);
  return separation < 0 ? p + slope * separation : p;
}

/// That carries the load: Newton's method from below, where load over separation is convex.
double DryContact::separation(const std::vector<double>& worn) const {
  double lowest = height_[0] + worn[0];
  for (std::size_t i = 0; i < x_.size(); ++i) lowest = std::min(lowest, height_[i] + worn[i]);
  double h = -lowest;
  constexpr int kMax = 200;
  for (int n = 0; n < kMax; ++n) {
    double carried = 0, stiffness = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      double slope = 0;
      carried += share(i) * pressure(h + height_[i] + worn[i], slope);
      stiffness += share(i) * slope;
    }
    const double step = (load_ - carried) / stiffness;
    h += step;
    if (std::abs(step) <= 1e-15 * contact_.parameters().sigma || std::abs(carried / load_ - 1) < 1e-15) break;
  }
  return h;
}

WearLoad DryContact::operator()(const std::vector<double>& worn) const {
  const double h = separation(worn);
  WearLoad load;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    double slope = 0;
    load.face.push_back(pressure(h + height_[i] + worn[i], slope) * speed_);
  }
  return load;
}

double DryContact::area(const std::vector<double>& worn) const {
  double area = 0;
  for (std::size_t i = 0; i < x_.size(); ++i) area += share(i) * worn[i];
  return area;
}

std::vector<double> places(double length, int n_cells) {
  std::vector<double> x;
  for (int i = 0; i <= n_cells; ++i) x.push_back(length * i / n_cells);
  return x;
}

}  // namespace ringfilm::life
