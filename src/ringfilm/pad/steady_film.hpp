#pragma once
#include <optional>

#include "ringfilm/pad/pad_film.hpp"

namespace ringfilm::pad {

/// Solves the film at the h_m of `state` with pressures measured by what the motion makes of them: by an estimate
/// first, then, where that was far off, by the peak that came out, so that the tolerance is one of the film's own
/// pressures. Counts into `effort`. @param closing -dh/dt [m/s]
bool solve_at_separation(PadFilm& film, film::FilmInputs inputs, double closing, const film::FilmState& previous,
                         film::FilmState& state, Effort& effort);

/// The steady film of a pad, on ever finer grids; where that fails, by raising the speed little by little. Not
/// converged: nothing is returned.
/// @param separation s [m]
std::optional<film::FilmState> steady_film_at(PadFilms& films, double separation, Effort& effort);

}  // namespace ringfilm::pad
