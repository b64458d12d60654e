#include "ringfilm/models/conformity/fourier_series.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace ringfilm::models {

double FourierSeries::operator()(double theta) const { return derivative(theta, 0); }

double FourierSeries::derivative(double theta, int degree) const {
  double sum = 0;
  for (const FourierOrder& one : orders_) {
    if (degree > 0 && one.order == 0) continue;
    const double n = one.order, angle = n * (theta - one.phase);
    double size = one.amplitude;
    for (int k = 0; k < degree; ++k) size *= n;
    switch (degree % 4) {
      case 0:
        sum += size * std::cos(angle);
        break;
      case 1:
        sum -= size * std::sin(angle);
        break;
      case 2:
        sum -= size * std::cos(angle);
        break;
      default:
        sum += size * std::sin(angle);
        break;
    }
  }
  return sum;
}

double FourierSeries::integral(double from, double to) const {
  double sum = 0;
  for (const FourierOrder& one : orders_) {
    if (one.order == 0) {
      sum += one.amplitude * (to - from);
      continue;
    }
    const double n = one.order;
    sum += one.amplitude / n * (std::sin(n * (to - one.phase)) - std::sin(n * (from - one.phase)));
  }
  return sum;
}

FourierSeries FourierSeries::turned(double angle) const {
  std::vector<FourierOrder> orders = orders_;
  for (FourierOrder& one : orders) one.phase -= angle;
  return FourierSeries(std::move(orders));
}

double FourierSeries::bound() const {
  double sum = 0;
  for (const FourierOrder& one : orders_) sum += std::abs(one.amplitude);
  return sum;
}

FourierSeries fourier_series(const std::vector<double>& samples, double first_angle, int last) {
  const double n_samples = static_cast<double>(samples.size()), step = 2 * std::numbers::pi / n_samples;
  std::vector<FourierOrder> orders;
  for (int n = 0; n <= last; ++n) {
    double in_phase = 0, out_of_phase = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double angle = n * (first_angle + static_cast<double>(i) * step);
      in_phase += samples[i] * std::cos(angle);
      out_of_phase += samples[i] * std::sin(angle);
    }
    if (n == 0) {
      orders.push_back({0, in_phase / n_samples, 0});
    } else {
      orders.push_back({n, 2 / n_samples * std::hypot(in_phase, out_of_phase), std::atan2(out_of_phase, in_phase) / n});
    }
  }
  return FourierSeries(std::move(orders));
}

}  // namespace ringfilm::models
