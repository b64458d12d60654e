#pragma once
#include <optional>

#include "ringfilm/film/film_solver.hpp"
#include "ringfilm/pad/pad_result.hpp"
#include "ringfilm/pad/pad_setup.hpp"

namespace ringfilm::pad {

/// Solves the film at the h_m of `state` with pressures measured by what the motion makes of them: by an estimate
/// first, then, where that was far off, by the peak that came out, so that the tolerance is one of the film's own
/// pressures. Counts into `effort`. @param closing -dh/dt [m/s]
bool solve_at_separation(const PadSetup& setup, const film::FilmProblem& problem, film::FilmInputs inputs,
                         double closing, const film::FilmState& previous, film::FilmState& state,
                         film::FilmWorkspace& workspace, Effort& effort);

/// A film to start from at h_m [m]: edge pressures joined by a line, everything full.
film::FilmState full_film(const PadSetup& setup, const film::FilmProblem& problem, double h_m);

/// The steady film of a pad, on ever finer grids up to that of `problem`; where that fails, by raising the speed little
/// by little. Not converged: nothing is returned.
/// @param separation s [m]
std::optional<film::FilmState> steady_film_at(const PadSetup& setup, const film::FilmProblem& problem,
                                              double separation, Effort& effort);

}  // namespace ringfilm::pad
