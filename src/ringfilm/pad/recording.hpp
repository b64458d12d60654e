#pragma once
#include "ringfilm/pad/pad_result.hpp"
#include "ringfilm/pad/pad_setup.hpp"

namespace ringfilm::pad {

/// Places of the nodes, a step of the gap twice [m].
std::vector<double> profile_places(const film::FilmGrid& grid);

Profile profile(const PadSetup& setup, const film::FilmProblem& problem, const film::FilmState& state, double time);

/// All numbers of a film solved with `inputs` from `previous`.
Sample sample(const PadSetup& setup, const film::FilmProblem& problem, const film::FilmInputs& inputs,
              const film::FilmState& previous, const film::FilmState& state, double time);

}  // namespace ringfilm::pad
