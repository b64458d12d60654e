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

/// A value with its slopes in time and in place; across the film zero where the film has one dimension.
struct Varying {
  double value, d_dt, d_dx, d_dy = 0;
};

/// The prescribed pressure, with its second derivatives in place.
struct Pressure : Varying {
  double d2_dx2, d2_dy2 = 0;
};

/// d(rho h)/dt + d/dx [U rho h/2 - M p_x] - d/dy [M p_y] with M = rho h^3/(12 eta), every derivative written out.
inline double source(const Pressure& p, const Varying& h) {
  const auto [rho, rho_p] = density(p.value);
  const auto [eta, eta_p] = viscosity(p.value);
  const double storage = rho_p * p.d_dt * h.value + rho * h.d_dt;
  const double couette = kSpeed / 2 * (rho_p * p.d_dx * h.value + rho * h.d_dx);
  const double mobility = rho * std::pow(h.value, 3) / (12 * eta);
  const double mobility_x = mobility * (rho_p * p.d_dx / rho + 3 * h.d_dx / h.value - eta_p * p.d_dx / eta);
  const double mobility_y = mobility * (rho_p * p.d_dy / rho + 3 * h.d_dy / h.value - eta_p * p.d_dy / eta);
  return storage + couette - mobility_x * p.d_dx - mobility_y * p.d_dy - mobility * (p.d2_dx2 + p.d2_dy2);
}

/// The largest difference in pressure from the prescribed one, as a share of its peak.
inline double difference_from_peak(const film::FilmState& a, const film::FilmState& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.p.size(); ++i) largest = std::max(largest, std::abs(a.p[i] - b.p[i]));
  return largest / kPeak;
}

/// The error of a steady film, started at the pressure of its edges, or after so many steps in time.
/// @param n_steps 0: a steady film
/// @param end of the time [s]
template <class Film>
double film_error(int n_cells, int n_steps, double end) {
  if (n_steps == 0) {
    const Film steady(n_cells, 0.0);
    const film::FilmState exact = steady.prescribed(0);
    film::FilmState start = exact;
    std::fill(start.p.begin(), start.p.end(), kEdge);
    return difference_from_peak(steady.solved(0, film::kSteady, start), exact);
  }
  const Film transient(n_cells, kOscillation);
  film::FilmState state = transient.prescribed(0);
  for (int k = 1; k <= n_steps; ++k) state = transient.solved(end * k / n_steps, end / n_steps, state);
  return difference_from_peak(state, transient.prescribed(end));
}

}  // namespace ringfilm::study::manufactured
