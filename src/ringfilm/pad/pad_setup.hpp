#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/film/factors/factor_laws.hpp"
#include "ringfilm/pad/gap_surface.hpp"

namespace ringfilm::pad {

/// A pad that is set up for the solver. Immutable.
struct PadSetup {
  cycle::Case input;
  std::shared_ptr<const models::OilAtTemperature> oil;
  double viscosity, density;  ///< viscosity and density of the oil at the zero of the pressures [Pa s], [kg/m3]
  std::optional<double> film_temperature;  ///< temperature of the film, for walls of stated temperatures [K]
  std::shared_ptr<const models::AsperityContact> contact;  ///< nullptr: the surfaces never touch
  std::vector<film::GapPiece> pieces;  ///< gap of an infinitely wide pad: heights above its lowest point
  std::optional<GapSurface> surface;   ///< gap of a pad with a width: heights above its lowest point
  double lowest_gap;                   ///< min g [m]
  double lowest_x;                     ///< where g is lowest [m]
  double U;                            ///< velocity of the flat surface, positive in +x [m/s]
  double p_cavitation;                 ///< p_c, not above the pressure of any edge [Pa]
  film::FactorLaws factors;            ///< flow factors of an infinitely wide pad
  std::vector<cycle::Note> notes;      ///< on the oil and the contact as stated

  /// The film across a grid.
  film::FilmProblem problem(film::FilmGrid grid) const;
  /// What acts on a steady film, but for load and scale.
  film::FilmInputs steady_inputs() const;
  /// The film that comes in out of gas, f [m]; nothing where the inlet is flooded.
  std::optional<double> supply() const {
    if (!input.enters_out_of_gas(input.pad.direction)) return std::nullopt;
    return runs_left() ? input.film.supply_right : input.film.supply_left;
  }
  /// Does the flat surface move in -x?
  bool runs_left() const { return input.pad.direction == cycle::Direction::kMinusX; }
};

/// Throws InputError where a value that is fine by itself cannot be used with the others.
PadSetup prepare_pad(const cycle::Case& c);

}  // namespace ringfilm::pad
