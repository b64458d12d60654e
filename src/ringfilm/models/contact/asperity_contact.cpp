#include "ringfilm/models/contact/asperity_contact.hpp"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"

namespace ringfilm::models {
namespace {

using boost::math::double_constants::one_div_root_two_pi;
using boost::math::double_constants::root_two;
using std::numbers::pi;

// Exact form: power series of F_n about the middle of each of kPieces equal pieces of 0 <= lambda <= kReach. Eleven
// powers leave 6e-14 of F_n at the far end, where F_n falls by 40 % over one piece, and rounding elsewhere.
constexpr double kReach = 8.0;
constexpr int kPieces = 128;
constexpr int kDegree = 11;
constexpr double kPiecesPerLambda = kPieces / kReach;

using Numbers = ValueAndSlope<double>;
using Series = std::array<double, kDegree + 1>;
using Pieces = std::array<Series, kPieces>;

/// The power series of the solution of F'' + lambda F' - n F = 0 about `centre`.
constexpr Series series(double n, double centre, const Numbers& F) {
  Series c{F.value, F.slope};
  for (int k = 0; k + 2 <= kDegree; ++k) {
    c[k + 2] = ((n - k) * c[k] - centre * (k + 1) * c[k + 1]) / ((k + 1.0) * (k + 2.0));
  }
  return c;
}

constexpr Numbers horner(const Series& c, double x) {
  double value = c[kDegree], slope = 0;
  for (int k = kDegree - 1; k >= 0; --k) {
    slope = slope * x + value;
    value = value * x + c[k];
  }
  return {value, slope};
}

/// Series of F_n for all pieces, piece by piece from the far end: F_n is the solution that decays with lambda, so the
/// integration towards lambda = 0 damps whatever rounding adds of the other one.
/// @param F at kReach
constexpr Pieces exact_pieces(double n, Numbers F) {
  Pieces pieces{};
  double from = kReach;
  for (int piece = kPieces - 1; piece >= 0; --piece) {
    const double middle = (piece + 0.5) / kPiecesPerLambda, to = piece / kPiecesPerLambda;
    pieces[piece] = series(n, middle, horner(series(n, from, F), middle - from));
    F = horner(pieces[piece], to - middle);
    from = to;
  }
  return pieces;
}

// From gaussian_integral(n, kReach), and F_n' = -n F_(n-1).
constexpr Pieces kF52 = exact_pieces(2.5, {1.0339176028096323e-17, -2.5 * 3.4783997922186902e-17});
constexpr Pieces kF2 = exact_pieces(2, {1.8075064471458501e-17, -2 * 7.5502624119464992e-17});

Numbers exact(const Pieces& pieces, double lambda) {
  if (lambda >= kReach) return {0, 0};
  const int piece = static_cast<int>(lambda * kPiecesPerLambda);
  return horner(pieces[piece], lambda - (piece + 0.5) / kPiecesPerLambda);
}

/// Fifth-order polynomials of the literature, highest power first.
using Quintic = std::array<double, 6>;
constexpr Quintic kF52FourDigit{-0.0046, 0.0574, -0.2958, 0.7844, -1.0776, 0.6167};
constexpr Quintic kF2FourDigit{-0.0018, 0.0281, -0.1728, 0.5258, -0.8043, 0.5003};
constexpr Quintic kF52AsPrinted{-0.004, 0.057, -0.296, 0.784, -1.078, 0.617};
constexpr Quintic kF2AsPrinted{-0.002, 0.028, -0.173, 0.526, -0.804, 0.500};

Numbers horner(const Quintic& c, double lambda) {
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

/// Ends at the first zero, or at the last one where the form is cut by max(., 0) alone.
ContactQuintic with_end(const Quintic& c, ContactIntegralForm form) {
  const auto z = zeros(c);
  return {c, form == ContactIntegralForm::kPolynomial4Digit ? z.front() : z.back()};
}

Numbers quintic(const ContactQuintic& quintic, double lambda) {
  if (lambda >= quintic.end) return {0, 0};
  const auto F = horner(quintic.c, lambda);
  return F.value > 0 ? F : Numbers{0, 0};
}

/// @param other form than the exact one; nullptr: exact
Numbers integral(const Pieces& pieces, const ContactQuintic* other, double lambda) {
  if (std::isnan(lambda)) return {lambda, lambda};  // else it would pick no piece, or pass for "no contact"
  const double inside = std::max(lambda, 0.0);
  auto F = other ? quintic(*other, inside) : exact(pieces, inside);
  if (lambda < 0) F.value += F.slope * lambda;
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
      break;
    case ContactIntegralForm::kPolynomial4Digit:
      quintics_ = {with_end(kF52FourDigit, form), with_end(kF2FourDigit, form)};
      break;
    case ContactIntegralForm::kPolynomialAsPrinted:
      quintics_ = {with_end(kF52AsPrinted, form), with_end(kF2AsPrinted, form)};
      break;
  }
  reach_ = (quintics_ ? quintics_->F_52.end : kReach) * sigma;
}

void GreenwoodTripp::pressure(double h, double& p_a, double& dp_a_dh) const {
  const auto F = integral(kF52, quintic_52(), h / parameters_.sigma);
  p_a = pressure_scale_ * F.value;
  dp_a_dh = pressure_scale_ / parameters_.sigma * F.slope;
}

GreenwoodTripp::Contact GreenwoodTripp::contact(double h) const {
  Contact c;
  pressure(h, c.pressure, c.pressure_slope);
  c.area_share = area_scale_ * integral(kF2, quintics_ ? &quintics_->F_2 : nullptr, h / parameters_.sigma).value;
  return c;
}

std::optional<SummitStatistics> summit_statistics(const GreenwoodTripp::Parameters& pair) {
  // Least bandwidth parameter of any isotropic Gaussian surface (Nayak 1971).
  constexpr double kMinBandwidth = 1.5;
  const double root_m4 = 3 * std::sqrt(pi) / (8 * pair.beta);
  const double m4 = root_m4 * root_m4;
  const double m2 = m4 / (6 * pi * std::numbers::sqrt3 * pair.N);
  const double alpha = pair.sigma * pair.sigma * m4 / (m2 * m2);
  if (!(alpha >= kMinBandwidth) || !std::isfinite(alpha)) return std::nullopt;
  return SummitStatistics{alpha, std::sqrt(2 * m2), 4 * pair.sigma / std::sqrt(pi * alpha),
                          pair.sigma * std::sqrt(1 - 0.8968 / alpha)};
}

double plasticity_index(const GreenwoodTripp::Parameters& pair, double sigma_s, double hardness) {
  const double E_star = pair.E_prime / 2;  // 1/E* is the whole sum of (1 - nu^2)/E
  return E_star / hardness * std::sqrt(sigma_s / pair.beta);
}

double contact_spot_radius(double beta, double sigma, double lambda) {
  return std::sqrt(beta * sigma * gaussian_integral(2, lambda) / (4 * gaussian_integral(1, lambda)));
}

double share_below_coating(double spot_radius, double thickness, double nu) {
  return std::min(1.0, 2 / (3 * pi) * (3 - 2 * nu) / (1 - nu) * spot_radius / thickness);
}

double composite_modulus(double E_1, double nu_1, double E_2, double nu_2) {
  for (const double E : {E_1, E_2}) {
    if (!(E > 0)) {
      throw InputError("a Young's modulus of " + number_text(E) + " Pa is not above 0", "that of steel is 2.1e11 Pa");
    }
  }
  for (const double nu : {nu_1, nu_2}) {
    if (!(nu > -1 && nu <= 0.5)) {
      throw InputError("a Poisson's ratio of " + number_text(nu) + " is not above -1 and up to 0.5",
                       "that of steel is 0.3");
    }
  }
  return 2 / ((1 - nu_1 * nu_1) / E_1 + (1 - nu_2 * nu_2) / E_2);
}

}  // namespace ringfilm::models
