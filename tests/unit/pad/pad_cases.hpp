#pragma once
#include <cmath>
#include <functional>
#include <vector>

#include "ringfilm/pad/solve_pad.hpp"

/// Pads of a constant oil, as values.
namespace ringfilm::pad::testing {

inline constexpr double kLength = 0.01, kOutlet = 10e-6, kEta = 0.02, kU = 5.0, kDensity = 850;
/// eta U L^2/h0^2, by which books measure the load of a slider [N/m].
inline constexpr double kLoadUnit = kEta * kU * kLength * kLength / (kOutlet * kOutlet);

/// A plane slider with K = 1 that may not cavitate, as a start; pressures from the zero of the case.
inline cycle::Case slider() {
  cycle::Case c = cycle::blank_case(cycle::Problem::kPad);
  c.pad.length = kLength;
  c.pad.gap_x = {0, kLength};
  c.pad.gap_height = {2 * kOutlet, kOutlet};
  c.pad.speed = kU;
  c.pad.separation = 0;
  c.lubricant.viscosity = kEta;
  c.lubricant.constant_density = kDensity;
  c.film.cavitation_pressure = 0;
  c.solver.cells = 200;
  c.solver.tolerance = 1e-10;
  return c;
}

/// h(x) on so many straight pieces.
inline void set_gap(cycle::Case& c, int n_pieces, const std::function<double(double)>& height) {
  c.pad.gap_x.clear();
  c.pad.gap_height.clear();
  for (int i = 0; i <= n_pieces; ++i) {
    const double x = i == n_pieces ? c.pad.length : c.pad.length * i / n_pieces;
    c.pad.gap_x.push_back(x);
    c.pad.gap_height.push_back(height(x));
  }
}

inline Sample solved(const cycle::Case& c) { return solve_pad(c).samples.back(); }

}  // namespace ringfilm::pad::testing
