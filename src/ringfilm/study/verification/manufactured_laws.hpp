#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "ringfilm/film/solver/film_solver.hpp"

/// The oil and the scales of the manufactured films, written out without the program's own laws.
namespace ringfilm::study::manufactured {

inline constexpr double kWidth = 1.5e-3, kSpeed = 7;               // [m], [m/s]
inline constexpr double kEta = 0.008, kRho = 800, kZ = 0.5;        // [Pa s], [kg/m3], [-]
inline constexpr double kA = 6.0e-10, kB = 1.7e-9, kAtm = 101325;  // density of pressure [1/Pa], [Pa]
inline constexpr double kPeak = 6e7, kEdge = 2e5;                  // prescribed pressure [Pa]
inline constexpr double kFilm = 2e-6, kWedge = 3e-6,
                        kOscillation = 0.25;  // separation and its oscillating share [m], [-]
inline constexpr double kPeriod = 2e-3, kOmega = 2 * std::numbers::pi / kPeriod;  // [s], [1/s]

/// A property of pressure with its slope.
struct Property {
  double value, slope;
};

inline Property density(double p) {
  const double u = p - kAtm, below = 1 + kB * u;
  return {kRho * (1 + kA * u / below), kRho * kA / (below * below)};
}

inline Property viscosity(double p) {
  const double scale = 1.98e8, depth = std::log(kEta) + 9.67;
  const double eta = kEta * std::exp(depth * (std::pow(1 + p / scale, kZ) - 1));
  return {eta, eta * depth * kZ / scale * std::pow(1 + p / scale, kZ - 1)};
}

/// The largest difference in pressure as a share of the prescribed peak.
inline double difference_from_peak(const film::FilmState& a, const film::FilmState& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.p.size(); ++i) largest = std::max(largest, std::abs(a.p[i] - b.p[i]));
  return largest / kPeak;
}

}  // namespace ringfilm::study::manufactured
