#include "ringfilm/surface/face/face_polynomial.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <string>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr int kMaxFaceDegree = 12;
constexpr int kSearchSteps = 4000;

/// Legendre polynomials of t from -1 to 1, up to `degree`, as rows of powers, lowest first.
std::vector<std::vector<long double>> legendre_powers(int degree) {
  std::vector<std::vector<long double>> powers{{1.0L}};
  if (degree > 0) powers.push_back({0.0L, 1.0L});
  for (int k = 1; k < degree; ++k) {
    std::vector<long double> next(k + 2, 0.0L);
    for (int i = 0; i <= k; ++i) next[i + 1] += (2 * k + 1) * powers[k][i] / (k + 1);
    for (int i = 0; i < k; ++i) next[i] -= k * powers[k - 1][i] / (k + 1);
    powers.push_back(std::move(next));
  }
  return powers;
}

/// sum c_i (2 x/w - 1)^i as powers of x, lowest first.
std::vector<long double> shifted(const std::vector<long double>& c, long double width) {
  std::vector<long double> result{c.back()};
  for (int i = static_cast<int>(c.size()) - 2; i >= 0; --i) {
    std::vector<long double> next(result.size() + 1, 0.0L);
    for (std::size_t k = 0; k < result.size(); ++k) {
      next[k] -= result[k];
      next[k + 1] += 2 * result[k] / width;
    }
    next[0] += c[i];
    result = std::move(next);
  }
  return result;
}

}  // namespace

FacePolynomial FacePolynomial::fit(const std::vector<double>& x_m, const std::vector<double>& height_m, double width_m,
                                   int degree) {
  const int n = static_cast<int>(x_m.size());
  if (degree < 1 || degree > kMaxFaceDegree || n < 2 * (degree + 1) || height_m.size() != x_m.size()) {
    throw InputError(
        "a polynomial of degree " + std::to_string(degree) + " cannot be fitted to " + std::to_string(n) + " points",
        "degrees 1 to " + std::to_string(kMaxFaceDegree) + " with two points or more a coefficient");
  }
  Eigen::MatrixXd basis(n, degree + 1);
  Eigen::VectorXd heights(n);
  for (int i = 0; i < n; ++i) {
    // Each point counts with the length of trace that it represents.
    const double length = (x_m[std::min(i + 1, n - 1)] - x_m[std::max(i - 1, 0)]) / 2;
    const double root = std::sqrt(length / width_m), t = 2 * x_m[i] / width_m - 1;
    basis(i, 0) = root;
    basis(i, 1) = root * t;
    for (int k = 1; k < degree; ++k) {
      basis(i, k + 1) = ((2 * k + 1) * t * basis(i, k) - k * basis(i, k - 1)) / (k + 1);
    }
    heights[i] = root * height_m[i] * 1e6;
  }
  const Eigen::VectorXd solved = basis.colPivHouseholderQr().solve(heights);
  const auto powers = legendre_powers(degree);
  std::vector<long double> of_t(degree + 1, 0.0L);
  for (int k = 0; k <= degree; ++k) {
    for (std::size_t i = 0; i < powers[k].size(); ++i) of_t[i] += solved[k] * powers[k][i];
  }
  const std::vector<long double> of_x = shifted(of_t, width_m * 1e3L);
  FacePolynomial polynomial;
  polynomial.width_m_ = width_m;
  for (auto c = of_x.rbegin(); c != of_x.rend(); ++c) polynomial.coefficients_.push_back(static_cast<double>(*c));
  return polynomial;
}

double FacePolynomial::height_m(double x_m) const {
  double height = 0;
  for (const double c : coefficients_) height = height * x_m * 1e3 + c;
  return height * 1e-6;
}

double FacePolynomial::slope(double x_m) const {
  double slope = 0;
  const std::size_t degree = coefficients_.size() - 1;
  for (std::size_t k = 0; k < degree; ++k) {
    slope = slope * x_m * 1e3 + static_cast<double>(degree - k) * coefficients_[k];
  }
  return slope * 1e-3;
}

std::vector<double> FacePolynomial::turning_points_m() const {
  std::vector<double> places;
  for (int i = 0; i < kSearchSteps; ++i) {
    double low = width_m_ * i / kSearchSteps, high = width_m_ * (i + 1) / kSearchSteps;
    const bool rises = slope(low) > 0;
    if (rises == (slope(high) > 0)) continue;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (rises == (slope(middle) > 0) ? low : high) = middle;
    }
    places.push_back((low + high) / 2);
  }
  return places;
}

}  // namespace ringfilm::surface
