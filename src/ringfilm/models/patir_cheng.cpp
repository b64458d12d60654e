#include "ringfilm/models/patir_cheng.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ringfilm::models {
namespace {

constexpr int kRows = 7;
constexpr std::array<double, kRows> kOrientation{1.0 / 9, 1.0 / 6, 1.0 / 3, 1, 3, 6, 9};

/// phi_x = 1 - C exp(-r H), and for gamma > 1 1 + C H^-r; patir1978, Table 1.
struct PressureFlow {
  double C, r, from;
};
constexpr std::array<PressureFlow, kRows> kPressureFlow{{{1.48, 0.42, 1},
                                                         {1.38, 0.42, 1},
                                                         {1.18, 0.42, 0.75},
                                                         {0.90, 0.56, 0.5},
                                                         {0.225, 1.5, 0.5},
                                                         {0.520, 1.5, 0.5},
                                                         {0.870, 1.5, 0.5}}};

/// Phi_s = A_1 H^a_1 exp(-a_2 H + a_3 H^2), from H = 5 on A_2 exp(-H/4); patir1979, Table 1.
struct ShearFlow {
  double A_1, a_1, a_2, a_3, A_2;
};
constexpr std::array<ShearFlow, kRows> kShearFlow{{{2.046, 1.12, 0.78, 0.03, 1.856},
                                                   {1.962, 1.08, 0.77, 0.03, 1.754},
                                                   {1.858, 1.01, 0.76, 0.03, 1.561},
                                                   {1.899, 0.98, 0.92, 0.05, 1.126},
                                                   {1.560, 0.85, 1.13, 0.08, 0.556},
                                                   {1.290, 0.62, 1.09, 0.08, 0.388},
                                                   {1.011, 0.54, 1.07, 0.08, 0.295}}};
constexpr double kThickShearFlow = 5;

/// Phi_fs = A_3 H^a_4 exp(-a_5 H + a_6 H^2), 0 from H = 7 on; phi_fp = 1 - D exp(-s H); patir1979, Tables 2 and 3.
struct Stress {
  double A_3, a_4, a_5, a_6, D, s;
};
constexpr std::array<Stress, kRows> kStress{{{14.1, 2.45, 2.30, 0.10, 1.51, 0.52},
                                             {13.4, 2.42, 2.30, 0.10, 1.51, 0.54},
                                             {12.3, 2.32, 2.30, 0.10, 1.47, 0.58},
                                             {11.1, 2.31, 2.38, 0.11, 1.40, 0.66},
                                             {9.8, 2.25, 2.80, 0.18, 0.98, 0.79},
                                             {10.1, 2.25, 2.90, 0.18, 0.97, 0.91},
                                             {8.7, 2.15, 2.97, 0.18, 0.73, 0.91}}};
constexpr double kNoShearStress = 7;
constexpr double kThinnest = 0.5;  // H from which on the tables of shear hold

double bell(double H, double A, double a, double b, double c) { return A * std::pow(H, a) * std::exp(H * (c * H - b)); }

}  // namespace

PatirCheng::PatirCheng(double gamma) {
  const auto above = std::upper_bound(kOrientation.begin(), kOrientation.end(), gamma);
  row_ = std::max(0, static_cast<int>(above - kOrientation.begin()) - 1);
  const bool is_between = gamma > kOrientation[row_] && row_ + 1 < kRows;
  share_ =
      is_between ? std::log(gamma / kOrientation[row_]) / std::log(kOrientation[row_ + 1] / kOrientation[row_]) : 0;
}

template <class Factor>
double PatirCheng::between_rows(const Factor& factor) const {
  const double low = factor(row_);
  return share_ == 0 ? low : low + share_ * (factor(row_ + 1) - low);
}

double PatirCheng::pressure_flow(double H) const {
  return between_rows([H](int row) {
    const PressureFlow& of = kPressureFlow[row];
    const double within = std::max(H, of.from);
    if (kOrientation[row] <= 1) return 1 - of.C * std::exp(-of.r * within);
    return 1 + of.C * std::pow(within, -of.r);
  });
}

double PatirCheng::shear_flow(double H) const {
  const double within = std::max(H, kThinnest);
  return between_rows([within](int row) {
    const ShearFlow& of = kShearFlow[row];
    if (within > kThickShearFlow) return of.A_2 * std::exp(-0.25 * within);
    return bell(within, of.A_1, of.a_1, of.a_2, of.a_3);
  });
}

double PatirCheng::shear_stress(double H) const {
  if (H >= kNoShearStress) return 0;
  const double within = std::max(H, kThinnest);
  return between_rows([within](int row) {
    const Stress& of = kStress[row];
    return bell(within, of.A_3, of.a_4, of.a_5, of.a_6);
  });
}

double PatirCheng::pressure_stress(double H) const {
  const double within = std::max(H, kThinnest);
  return between_rows([within](int row) { return 1 - kStress[row].D * std::exp(-kStress[row].s * within); });
}

double mean_inverse_film(double H) {
  constexpr double kSeriesFrom = 3, kReach = 3, kFloor = 300;  // ends of the heights [sigma]; 1/(smallest film/3 sigma)
  const double z = H / kReach;
  if (z >= kSeriesFrom) {  // the closed form loses its digits to rounding
    double sum = 1, term = 1;
    for (int k = 1; k < 30; ++k) {
      term *= (2 * k - 1) / ((2 * k + 7) * z * z);
      sum += term;
    }
    return sum;
  }
  constexpr double kScale = 35.0 / 32;
  const double square = z * z, cube = (1 - square) * (1 - square) * (1 - square);
  if (z > 1) {
    const double rest = z / 15 * (66 + square * (30 * square - 80));
    return kScale * z * (cube * std::log((z + 1) / (z - 1)) + rest);
  }
  const double rest = -55 + z * (132 + z * (345 + z * (-160 + z * (-405 + z * (60 + z * 147)))));
  return kScale * z * (cube * std::log(kFloor * (z + 1)) + rest / 60);
}

double average_gap_excess(double H) {
  constexpr double kInverseRoot = std::numbers::inv_sqrtpi / std::numbers::sqrt2;
  return kInverseRoot * std::exp(-0.5 * H * H) - 0.5 * H * std::erfc(H / std::numbers::sqrt2);
}

}  // namespace ringfilm::models
