#include "ringfilm/models/oil/roelands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

constexpr double kRoelandsPressure = 1.98e8;  // [Pa]
constexpr double kRoelandsOffset = 9.67;      // -ln of the viscosity, 6.3e-5 Pa s, at which Roelands' law starts

/// Roelands' viscosity at one temperature: eta = eta_T exp(L (q - 1)) with q = (1 + p/1.98e8)^Z and L = ln eta_T
/// + 9.67.
class RoelandsCurve final : public ViscosityCurve {
 public:
  RoelandsCurve(double eta_T, double Z) : eta_T_(eta_T), Z_(Z), logarithm_(roelands_logarithm(eta_T)) {
    // Power series in x = (p - kCentre)/kScale, in which 1 + p/1.98e8 grows like 1 + x: first of L q by the binomial
    // series, then of its exponential, n e_n = sum over k of k a_k e_(n-k).
    std::array<double, kTerms> a{};
    a[0] = logarithm_ * std::pow(kScale / kRoelandsPressure, Z);
    for (int k = 1; k < kTerms; ++k) a[k] = a[k - 1] * (Z - (k - 1)) / k;
    series_[0] = eta_T * std::exp(a[0] - logarithm_);
    for (int n = 1; n < kTerms; ++n) {
      for (int k = 1; k <= n; ++k) series_[n] += k * a[k] * series_[n - k] / n;
    }
    // Where the last term is a few roundings of the sum, what is omitted is smaller.
    constexpr double kLastTerm = 1e-15;
    const double converged =
        std::pow(kLastTerm * series_[0] / std::abs(series_[kTerms - 1]), 1.0 / (kTerms - 1)) * kScale;
    half_width_ = std::min(kCentre, converged);
  }

  void viscosity(std::span<const double> p, std::span<double> eta, std::span<double> deta_dp) const override {
    for (std::size_t i = 0; i < p.size(); ++i) {  // without branches, so that it runs in vector registers
      const double x = (p[i] - kCentre) * kPerScale;
      double value = series_[kTerms - 1], slope = 0;
      for (int k = kTerms - 2; k >= 0; --k) {
        slope = slope * x + value;
        value = value * x + series_[k];
      }
      eta[i] = value;
      deta_dp[i] = slope * kPerScale;
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (std::abs(p[i] - kCentre) <= half_width_) continue;
      const double q = std::pow(1 + p[i] / kRoelandsPressure, Z_);
      eta[i] = eta_T_ * std::exp(logarithm_ * (q - 1));
      deta_dp[i] = eta[i] * logarithm_ * Z_ * q / (kRoelandsPressure + p[i]);
    }
  }

 private:
  // 0 to 30 MPa hold nearly every film under a ring; there |x| <= 0.07, and 13 terms leave rounding for an engine oil.
  // Other pressures take the law itself, and so do the ends of that range for a much stiffer oil.
  static constexpr double kCentre = 1.5e7;                       // [Pa]
  static constexpr double kScale = kRoelandsPressure + kCentre;  // [Pa]
  static constexpr double kPerScale = 1 / kScale;
  static constexpr int kTerms = 13;

  double eta_T_, Z_, logarithm_;
  std::array<double, kTerms> series_{};  // [Pa s]
  double half_width_;  // half width of the range of pressures around kCentre in which the series is used [Pa]
};

}  // namespace

double roelands_logarithm(double eta) {
  const double logarithm = std::log(eta) + kRoelandsOffset;
  if (!(logarithm > 0)) {
    throw InputError("an oil viscosity of " + number_text(number_in(eta, kMillipascalSecond)) +
                         " mPa.s is below the 0.0632 mPa.s of Roelands' law",
                     "check lubricant.kinematic_viscosity and the oil temperature, or choose "
                     "lubricant.viscosity_pressure = \"none\"");
  }
  return logarithm;
}

double roelands_index(double alpha_0, double eta_0) { return alpha_0 / (5.1e-9 * roelands_logarithm(eta_0)); }

std::unique_ptr<const ViscosityCurve> roelands_curve(double eta_T, double Z) {
  return std::make_unique<RoelandsCurve>(eta_T, Z);
}

}  // namespace ringfilm::models
