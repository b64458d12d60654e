#include "ringfilm/pad/pad_setup.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/base/table.hpp"
#include "ringfilm/case/case_face.hpp"
#include "ringfilm/cycle/advice/contact_plausibility.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/cycle/setup/oil_setup.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::pad {
namespace {

/// The formula of a gap, above its lowest point, with grooves between the lands.
std::vector<film::GapPiece> formula_pieces(const cycle::Pad& pad, double lowest) {
  const auto land = [face = cycle::face_of_formula(pad.face, pad.length), lowest](double x) {
    return face.height(x) - lowest;
  };
  const auto groove = [land, depth = pad.grooves.depth](double x) { return land(x) + depth; };
  std::vector<film::GapPiece> pieces;
  double begin = 0;
  for (const auto& [from, to] : cycle::groove_ends(pad)) {
    if (from > begin) pieces.push_back({begin, from, land});
    pieces.push_back({from, to, groove});
    begin = to;
  }
  if (begin < pad.length) pieces.push_back({begin, pad.length, land});
  return pieces;
}

/// The gap between its steps.
std::vector<film::GapPiece> gap_pieces(const cycle::Pad& pad, double lowest) {
  if (pad.has_formula()) return formula_pieces(pad, lowest);
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
  if (pad.has_formula()) return {formula_pieces(pad, lowest), *pad.width};
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
  const bool is_plain = !input.film.has_gas_edge_of_pad() && factors.are_of_plain_film();
  problem.contact = contact.get();
  problem.contact_spread = input.contact.lambda_ratio == cycle::LambdaRatio::kLocal ? film::ContactSpread::kLocal
                                                                                    : film::ContactSpread::kNominal;
  problem.terms = is_plain ? film::Terms::kPlain : film::Terms::kAll;
  problem.tolerance = std::min(tolerance, std::max(kStricter * tolerance, kRounding));
  return problem;
}

film::FilmInputs PadSetup::steady_inputs() const {
  film::FilmInputs inputs;
  inputs.oil = oil;
  inputs.U = U;
  inputs.left = {input.pad.left_pressure, input.film.left_edge};
  inputs.right = {input.pad.right_pressure, input.film.right_edge};
  inputs.p_cavitation = p_cavitation;
  inputs.broken = input.film.broken;
  return inputs;
}

PadSetup prepare_pad(const cycle::Case& c) {
  const cycle::Pad& pad = c.pad;
  PadSetup setup;
  setup.input = c;
  cycle::PadOil oil = cycle::pad_oil(c);
  setup.oil = std::move(oil.law);
  setup.viscosity = oil.viscosity;
  setup.density = oil.density;
  setup.film_temperature = oil.temperature;
  setup.notes = std::move(oil.notes);
  if (c.has_contact()) {
    setup.contact = cycle::asperity_contact(c);
    cycle::append_contact_notes(c, setup.notes);
  }
  const models::RingFace::Minimum lowest = cycle::lowest_point(pad);
  setup.lowest_gap = lowest.height;
  setup.lowest_x = lowest.x;
  if (pad.width) {
    setup.surface = gap_surface(pad, setup.lowest_gap);
  } else {
    setup.pieces = gap_pieces(pad, setup.lowest_gap);
  }
  setup.U = pad.direction == cycle::Direction::kPlusX ? pad.speed : -pad.speed;
  setup.p_cavitation = std::min({c.film.cavitation_pressure, pad.left_pressure, pad.right_pressure});
  setup.factors = cycle::factor_laws(c, cycle::roughness(c), oil.thinning);
  return setup;
}

}  // namespace ringfilm::pad
