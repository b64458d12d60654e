#include "ringfilm/models/oil/viscosity_index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "ringfilm/models/oil/walther.hpp"

namespace ringfilm::models {
namespace {

/// L = a Y^2 + b Y + c and H = d Y^2 + e Y + f from a viscosity Y at 100 degC on, all in mm2/s: ASTM D2270,
/// appendix X2. They follow the table of the practice; neighbours meet within 0.2 %.
struct ReferenceOils {
  double from, a, b, c, d, e, f;
};
constexpr std::array<ReferenceOils, 16> kReferenceOils{{{2.0, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077},
                                                        {3.8, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183},
                                                        {4.4, 2.5000, -7.2143, 13.812, 0.82143, 1.5679, 0.119},
                                                        {5.0, 0.10100, 16.6350, -45.469, 0.04985, 9.1613, -18.557},
                                                        {6.4, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656},
                                                        {7.0, 0.01191, 21.4750, -72.870, 0.79762, -0.7321, 14.610},
                                                        {7.7, 0.41858, 16.1558, -56.040, 0.05794, 10.5156, -28.240},
                                                        {9.0, 0.88779, 7.5527, -16.600, 0.26665, 6.7015, -10.810},
                                                        {12, 0.76720, 10.7972, -38.180, 0.20073, 8.4658, -22.490},
                                                        {15, 0.97305, 5.3135, -2.200, 0.28889, 5.9741, -4.930},
                                                        {18, 0.97256, 5.2500, -0.980, 0.24504, 7.4160, -16.730},
                                                        {22, 0.91413, 7.4759, -21.820, 0.20323, 9.1267, -34.230},
                                                        {28, 0.87031, 9.7157, -50.770, 0.18411, 10.1015, -46.750},
                                                        {40, 0.84703, 12.6752, -133.310, 0.17029, 11.4866, -80.620},
                                                        {55, 0.85921, 11.1009, -83.190, 0.17130, 11.3680, -76.940},
                                                        {70, 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947}}};
constexpr double kSlopeOfHighIndex = 0.00715;  // index above 100: 100 + (10^N - 1)/0.00715

struct ReferenceViscosities {
  double L, H;  ///< at 40 degC [mm2/s]
};

ReferenceViscosities reference_viscosities(double Y) {
  const auto next = std::upper_bound(kReferenceOils.begin() + 1, kReferenceOils.end(), Y,
                                     [](double value, const ReferenceOils& oils) { return value < oils.from; });
  const ReferenceOils& of = *std::prev(next);
  return {of.a * Y * Y + of.b * Y + of.c, of.d * Y * Y + of.e * Y + of.f};
}

/// Viscosity at 40 degC of an oil of the index; rises with Y, its viscosity at 100 degC, both in mm2/s.
double at_40_of(double Y, double index) {
  const auto [L, H] = reference_viscosities(Y);
  if (index <= 100) return L - index / 100 * (L - H);
  const double N = std::log10(1 + kSlopeOfHighIndex * (index - 100));
  return H * std::pow(Y, -N);
}

constexpr double kMinTabled = kMinIndexedViscosity / kMm2PerSecond;  // [mm2/s]
constexpr double kMaxTabled = 1e4;                                   // [mm2/s] at 100 degC, far beyond all oils

bool is_index(double index) { return index >= 0 && index <= kMaxViscosityIndex; }

}  // namespace

std::optional<double> viscosity_index(double at_40, double at_100) {
  const double U = at_40 / kMm2PerSecond, Y = at_100 / kMm2PerSecond;
  if (!(Y >= kMinTabled && U > Y)) return std::nullopt;
  const auto [L, H] = reference_viscosities(Y);
  if (U >= H) return 100 * (L - U) / (L - H);
  const double N = std::log10(H / U) / std::log10(Y);
  return 100 + (std::pow(10, N) - 1) / kSlopeOfHighIndex;
}

std::optional<double> viscosity_at_40(double at_100, double index) {
  const double Y = at_100 / kMm2PerSecond;
  if (!is_index(index) || !(Y >= kMinTabled && Y <= kMaxTabled)) return std::nullopt;
  return at_40_of(Y, index) * kMm2PerSecond;
}

std::optional<double> viscosity_at_100(double at_40, double index) {
  const double U = at_40 / kMm2PerSecond;
  if (!is_index(index) || !(U >= at_40_of(kMinTabled, index) && U <= at_40_of(kMaxTabled, index))) return std::nullopt;
  double low = kMinTabled, high = kMaxTabled;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (at_40_of(middle, index) < U ? low : high) = middle;
  }
  return 0.5 * (low + high) * kMm2PerSecond;
}

}  // namespace ringfilm::models
