#include "ringfilm/pad/pad_setup.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/base/table.hpp"
#include "ringfilm/cycle/integration/oil.hpp"

namespace ringfilm::pad {
namespace {

/// The gap between its steps.
std::vector<film::GapPiece> gap_pieces(const cycle::Pad& pad, double lowest) {
  std::vector<film::GapPiece> pieces;
  std::vector<double> x, height;
  const auto close_piece = [&] {
    const double begin = x.front(), end = x.back();
    pieces.push_back({begin, end, [x = std::exchange(x, {}), height = std::exchange(height, {})](double at) {
                        return interpolate_linear(x, height, at);
                      }});
  };
  for (std::size_t i = 0; i < pad.gap_x.size(); ++i) {
    if (i > 0 && pad.gap_x[i] == pad.gap_x[i - 1]) close_piece();
    x.push_back(pad.gap_x[i]);
    height.push_back(pad.gap_height[i] - lowest);
  }
  close_piece();
  return pieces;
}

/// The gap over x and y; one that is given along x alone is the same at every y.
GapSurface gap_surface(const cycle::Pad& pad, double lowest) {
  std::vector<double> y = pad.gap_y, height;
  for (const double h : pad.gap_height) height.push_back(h - lowest);
  if (y.empty()) {
    y = {0, *pad.width};
    const std::vector<double> row = height;
    height.insert(height.end(), row.begin(), row.end());
  }
  return {pad.gap_x, std::move(y), std::move(height)};
}

}  // namespace

film::FilmProblem PadSetup::problem(film::FilmGrid grid) const {
  film::FilmProblem problem;
  problem.grid = std::move(grid);
  problem.cavitation = input.film.cavitation == cycle::Cavitation::kMassConserving ? film::Cavitation::kMassConserving
                                                                                   : film::Cavitation::kReynoldsExit;
  // A ring carries on from step to step and has the load to hold it; a pad is solved once, with stiff squeeze and
  // strong compressibility among its cases, and can afford the iteration that takes the last step from 1e-4 to 1e-6.
  constexpr double kStricter = 1e-4, kRounding = 1e-13;
  const double tolerance = input.solver.tolerance;
  problem.tolerance = std::min(tolerance, std::max(kStricter * tolerance, kRounding));
  return problem;
}

film::FilmInputs PadSetup::steady_inputs() const {
  film::FilmInputs inputs;
  inputs.oil = oil;
  inputs.U = U;
  inputs.left.pressure = input.pad.left_pressure;
  inputs.right.pressure = input.pad.right_pressure;
  inputs.p_cavitation = p_cavitation;
  return inputs;
}

PadSetup prepare_pad(const cycle::Case& c) {
  const cycle::Pad& pad = c.pad;
  const double lowest = *std::min_element(pad.gap_height.begin(), pad.gap_height.end());
  PadSetup setup;
  setup.input = c;
  setup.oil = cycle::constant_oil(c.lubricant);
  if (pad.width) {
    setup.surface = gap_surface(pad, lowest);
  } else {
    setup.pieces = gap_pieces(pad, lowest);
  }
  setup.lowest_gap = lowest;
  setup.U = pad.direction == cycle::Direction::kPlusX ? pad.speed : -pad.speed;
  setup.p_cavitation = std::min({c.film.cavitation_pressure, pad.left_pressure, pad.right_pressure});
  return setup;
}

}  // namespace ringfilm::pad
