#include "ringfilm/models/asperity_contact.hpp"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ringfilm::models {
namespace {

using boost::math::double_constants::one_div_root_two_pi;
using boost::math::double_constants::pi;
using boost::math::double_constants::root_two;

// Exact form: power series of F_n about the middle of each of kPieces equal pieces of 0 <= lambda <= kReach. Eleven
// powers leave 6e-14 of F_n at the far end, where F_n falls by 40 % over one piece, and rounding elsewhere.
constexpr double kReach = 8.0;
constexpr int kPieces = 128;
constexpr int kDegree = 11;
constexpr double kPiecesPerLambda = kPieces / kReach;

struct ValueAndSlope {
  double value, slope;
};

/// The power series of the solution of F'' + lambda F' - n F = 0 about `centre`.
std::array<double, kDegree + 1> series(double n, double centre, const ValueAndSlope& F) {
  std::array<double, kDegree + 1> c{F.value, F.slope};
  for (int k = 0; k + 2 <= kDegree; ++k) {
    c[k + 2] = ((n - k) * c[k] - centre * (k + 1) * c[k + 1]) / ((k + 1.0) * (k + 2.0));
  }
  return c;
}

ValueAndSlope horner(const double* c, double x) {
  double value = c[kDegree], slope = 0;
  for (int k = kDegree - 1; k >= 0; --k) {
    slope = slope * x + value;
    value = value * x + c[k];
  }
  return {value, slope};
}

/// Series of F_n for all pieces, piece by piece from the far end: F_n is the solution that decays with lambda, so the
/// march towards lambda = 0 damps whatever rounding adds of the other one.
std::vector<double> exact_pieces(double n) {
  std::vector<double> c(kPieces * (kDegree + 1));
  ValueAndSlope F{gaussian_integral(n, kReach), -n * gaussian_integral(n - 1, kReach)};
  double from = kReach;
  for (int piece = kPieces - 1; piece >= 0; --piece) {
    const double middle = (piece + 0.5) / kPiecesPerLambda, to = piece / kPiecesPerLambda;
    const auto inwards = series(n, from, F);
    const auto about_middle = series(n, middle, horner(inwards.data(), middle - from));
    std::copy(about_middle.begin(), about_middle.end(), c.begin() + piece * (kDegree + 1));
    F = horner(about_middle.data(), to - middle);
    from = to;
  }
  return c;
}

ValueAndSlope exact(const std::vector<double>& c, double lambda) {
  if (lambda >= kReach) return {0, 0};
  const int piece = static_cast<int>(lambda * kPiecesPerLambda);
  return horner(c.data() + piece * (kDegree + 1), lambda - (piece + 0.5) / kPiecesPerLambda);
}

/// Fifth-order polynomials of the literature, highest power first; behind them where they end: the separation from
/// which on they are held at zero.
using Quintic = std::array<double, 6>;
constexpr Quintic kF52FourDigit{-0.0046, 0.0574, -0.2958, 0.7844, -1.0776, 0.6167};
constexpr Quintic kF2FourDigit{-0.0018, 0.0281, -0.1728, 0.5258, -0.8043, 0.5003};
constexpr Quintic kF52AsPrinted{-0.004, 0.057, -0.296, 0.784, -1.078, 0.617};
constexpr Quintic kF2AsPrinted{-0.002, 0.028, -0.173, 0.526, -0.804, 0.500};

ValueAndSlope horner(const Quintic& c, double lambda) {
  double value = c[0], slope = 0;
  for (std::size_t k = 1; k < c.size(); ++k) {
    slope = slope * lambda + value;
    value = value * lambda + c[k];
  }
  return {value, slope};
}

/// Where the polynomial changes sign between 0 and 10, in increasing order.
std::vector<double> zeros(const Quintic& c) {
  constexpr double kEnd = 10, kStep = 1.0 / 64;
  const auto value = [&](double lambda) { return horner(c, lambda).value; };
  std::vector<double> found;
  for (double low = 0; low < kEnd; low += kStep) {
    if ((value(low) > 0) == (value(low + kStep) > 0)) continue;
    std::uintmax_t iterations = 100;
    const auto bracket = boost::math::tools::toms748_solve(value, low, low + kStep,
                                                           boost::math::tools::eps_tolerance<double>(), iterations);
    found.push_back((bracket.first + bracket.second) / 2);
  }
  return found;
}

/// The six coefficients and the end: the first zero, or the last one where the form is cut by max(., 0) alone.
std::vector<double> with_end(const Quintic& c, ContactIntegralForm form) {
  const auto z = zeros(c);
  std::vector<double> packed(c.begin(), c.end());
  packed.push_back(form == ContactIntegralForm::kPolynomial4Digit ? z.front() : z.back());
  return packed;
}

ValueAndSlope polynomial(const std::vector<double>& packed, double lambda) {
  if (lambda >= packed[6]) return {0, 0};
  Quintic c;
  std::copy_n(packed.begin(), c.size(), c.begin());
  const auto F = horner(c, lambda);
  return F.value > 0 ? F : ValueAndSlope{0, 0};
}

ValueAndSlope integral(ContactIntegralForm form, const std::vector<double>& coefficients, double lambda) {
  if (std::isnan(lambda)) return {lambda, lambda};  // else it would pick no piece, or pass for "no contact"
  const double inside = std::max(lambda, 0.0);
  auto F = form == ContactIntegralForm::kExact ? exact(coefficients, inside) : polynomial(coefficients, inside);
  F.value += F.slope * (lambda - inside);
  return F;
}

}  // namespace

double gaussian_integral(double n, double lambda) {
  // F_n = exp(-lambda^2/2)/sqrt(2 pi) int_0^inf u^n exp(-u^2/2 - lambda u) du. With u = exp(v) the integrand is
  // analytic for |Im v| < pi/4 and falls exponentially on both sides, so that the trapezoidal rule converges like
  // exp(-4.9/step).
  constexpr double kStep = 0.125;
  const double first = -45 / (n + 1);
  constexpr double kLast = 2.5;
  double sum = 0;
  for (double v = first; v <= kLast; v += kStep) {
    const double u = std::exp(v);
    sum += std::exp((n + 1) * v - u * (u / 2 + lambda));
  }
  return one_div_root_two_pi * std::exp(-lambda * lambda / 2) * sum * kStep;
}

GreenwoodTripp::GreenwoodTripp(const Parameters& parameters) : parameters_(parameters) {
  const auto& [N, beta, sigma, E_prime, form] = parameters_;
  const double roughness = N * beta * sigma;
  pressure_scale_ = 8 * root_two / 15 * pi * roughness * roughness * std::sqrt(sigma / beta) * E_prime;
  area_scale_ = pi * pi * roughness * roughness;
  switch (form) {
    case ContactIntegralForm::kExact:
      F_52_ = exact_pieces(2.5);
      F_2_ = exact_pieces(2);
      reach_ = kReach * sigma;
      break;
    case ContactIntegralForm::kPolynomial4Digit:
      F_52_ = with_end(kF52FourDigit, form);
      F_2_ = with_end(kF2FourDigit, form);
      reach_ = F_52_.back() * sigma;
      break;
    case ContactIntegralForm::kPolynomialAsPrinted:
      F_52_ = with_end(kF52AsPrinted, form);
      F_2_ = with_end(kF2AsPrinted, form);
      reach_ = F_52_.back() * sigma;
      break;
  }
}

void GreenwoodTripp::pressure(double h, double& p_a, double& dp_a_dh) const {
  const auto F = integral(parameters_.form, F_52_, h / parameters_.sigma);
  p_a = pressure_scale_ * F.value;
  dp_a_dh = pressure_scale_ / parameters_.sigma * F.slope;
}

GreenwoodTripp::Contact GreenwoodTripp::contact(double h) const {
  Contact c;
  pressure(h, c.pressure, c.pressure_slope);
  c.area_share = area_scale_ * integral(parameters_.form, F_2_, h / parameters_.sigma).value;
  return c;
}

double composite_modulus(double E_1, double nu_1, double E_2, double nu_2) {
  return 2 / ((1 - nu_1 * nu_1) / E_1 + (1 - nu_2 * nu_2) / E_2);
}

}  // namespace ringfilm::models
