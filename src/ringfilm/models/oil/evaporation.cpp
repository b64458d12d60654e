#include "ringfilm/models/oil/evaporation.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "ringfilm/base/constants.hpp"

namespace ringfilm::models {

double OilFraction::molar_mass_or_correlated() const {
  return molar_mass ? *molar_mass : molar_mass_of_boiling_point(boiling_point);
}

double molar_mass_of_boiling_point(double boiling_point) {
  constexpr double kA = 6.97996, kB = 0.01964, kGram = 1e-3;
  return kGram * std::pow((kA - std::log(kMaxBoilingPoint - boiling_point)) / kB, 1.5);
}

double vapour_pressure(double boiling_point, double T) {
  constexpr double kEntropy = 4.4;  // over the gas constant, of Trouton, Hildebrand and Everett
  return base::kAtmosphere * std::exp((kEntropy + std::log(boiling_point)) * (1 - boiling_point / T));
}

double vapour_concentration(double boiling_point, double T) {
  return vapour_pressure(boiling_point, T) / (base::kMolarGasConstant * T);
}

namespace {

/// Moles that remain of a fraction at the parameter s of eq-depletion.
double remaining(double moles, double concentration, double s) { return moles * std::exp(-concentration * s); }

}  // namespace

void evaporate(std::span<double> moles, std::span<const double> concentration, double exposure) {
  double dries_out = 0;  // exposure that takes all
  for (std::size_t i = 0; i < moles.size(); ++i) dries_out += moles[i] / concentration[i];
  if (exposure >= dries_out) {
    std::fill(moles.begin(), moles.end(), 0.0);
    return;
  }
  // The exposure rises with s, ever more slowly: Newton's iterates come from below and do not pass the root.
  constexpr int kMaxIterations = 100;
  constexpr double kTolerance = 1e-14;
  double s = 0;
  for (int k = 0; k < kMaxIterations; ++k) {
    double missing = exposure, all = 0;
    for (std::size_t i = 0; i < moles.size(); ++i) {
      missing += moles[i] / concentration[i] * std::expm1(-concentration[i] * s);
      all += remaining(moles[i], concentration[i], s);
    }
    if (!(missing > kTolerance * exposure) || !(all > 0)) break;
    s += missing / all;
  }
  for (std::size_t i = 0; i < moles.size(); ++i) moles[i] = remaining(moles[i], concentration[i], s);
}

double noack_loss(std::span<const OilFraction> fractions) {
  constexpr double kTemperature = 250 + base::kZeroCelsius, kSample = 65e-3;  // [K], [kg]
  // Air at 250 degC that leaves saturated, with which the oils in data/lubricants lose what they state; assumed [m3].
  constexpr double kAir = 0.253;
  std::vector<double> moles, concentration;
  for (const OilFraction& fraction : fractions) {
    moles.push_back(kSample * fraction.share / fraction.molar_mass_or_correlated());
    concentration.push_back(vapour_concentration(fraction.boiling_point, kTemperature));
  }
  evaporate(moles, concentration, kAir);
  double left = 0;
  for (std::size_t i = 0; i < moles.size(); ++i) left += moles[i] * fractions[i].molar_mass_or_correlated();
  return 1 - left / kSample;
}

std::vector<OilFraction> distillation_of_noack(double loss) {
  // The first boiling point lies between these at any loss that is allowed; the last one is 200 K higher [K].
  constexpr double kMin = 600, kMax = 860, kTolerance = 1e-9;
  const auto fractions = [](double first) {
    return std::vector<OilFraction>{{0.1, first, 0.33},
                                    {0.25, first + 45, 0.38},
                                    {0.3, first + 80, 0.43},
                                    {0.2, first + 125, 0.49},
                                    {0.15, first + 200, 0.6}};
  };
  boost::uintmax_t evaluations = 100;
  const auto [low, high] =
      boost::math::tools::toms748_solve([&](double first) { return noack_loss(fractions(first)) - loss; }, kMin, kMax,
                                        [](double a, double b) { return std::abs(b - a) <= kTolerance; }, evaluations);
  return fractions(0.5 * (low + high));
}

}  // namespace ringfilm::models
