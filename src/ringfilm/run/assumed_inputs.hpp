#pragma once
#include <set>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/study/ensemble/assumed_inputs.hpp"

namespace ringfilm::run {

/// What is changed to see what an assumed input decides: 20 % more, of a temperature 10 K more, or as much less where
/// the case allows no more.
inline constexpr double kAssumedStep = 0.2, kAssumedTemperatureStep = 10;  ///< [-], [K]

/// The assumed inputs of a case with films, each changed alone and computed coarsely (study::coarse_case), the one that
/// changes the FMEP most first. Assumed are defaults whose description has the word, what `conditions` set, and what
/// the case states and `called_assumed` names; keys of oil consumption alone, which change no film, are omitted.
/// Throws ConvergenceError where the unchanged case has no result, InputError where it breaks a rule.
/// @param called_assumed as io::keys_called_assumed lists them @param threads 0: as many as the machine runs at once
std::vector<study::AssumedInput> assumed_inputs(const cycle::Case& c, const std::set<std::string>& called_assumed,
                                                int threads = 0);

/// How many inputs assumed_inputs() would change.
std::size_t n_assumed_inputs(const cycle::Case& c, const std::set<std::string>& called_assumed);

}  // namespace ringfilm::run
