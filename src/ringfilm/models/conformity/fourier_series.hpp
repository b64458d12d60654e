#pragma once
#include <vector>

namespace ringfilm::models {

/// One term, amplitude cos(order (theta - phase)).
struct FourierOrder {
  int order = 0;         ///< n, periods around the circle
  double amplitude = 0;  ///< [unit of the series]
  double phase = 0;      ///< phase of a crest [rad]
};

/// A sum of such terms over the angle theta [rad].
class FourierSeries {
 public:
  FourierSeries() = default;
  explicit FourierSeries(std::vector<FourierOrder> orders) : orders_(std::move(orders)) {}

  const std::vector<FourierOrder>& orders() const { return orders_; }
  double operator()(double theta) const;
  /// The derivative of that degree with respect to theta.
  double derivative(double theta, int degree) const;
  double integral(double from, double to) const;
  /// This series over theta' = theta - angle.
  FourierSeries turned(double angle) const;
  /// The sum of the amplitudes' sizes: no value lies farther from zero.
  double bound() const;

 private:
  std::vector<FourierOrder> orders_;
};

/// The series through samples over one turn by the trapezoidal rule, orders 0 to `last`, where angles are evenly spaced
/// from `first_angle` on; 2 last < number of samples.
FourierSeries fourier_series(const std::vector<double>& samples, double first_angle, int last);

}  // namespace ringfilm::models
