#pragma once
#include <array>

#include "ringfilm/cycle/case/case.hpp"

namespace ringfilm::cycle {

/// Starts a case from the edges, the supply and the temperatures of `conditions`; what it states replaces them.
void set_conditions(Conditions conditions, Case& c);

/// The conditions that the case has now, in place of what it states of edges, supply and walls.
void replace_conditions(Case& c);

/// A case that states one oil temperature has no other walls than those that it states, too.
void keep_own_temperature(Case& c);

/// Sections and keys that conditions replace where the command line asks for others than the files.
inline constexpr std::array kKeysOfConditions{"film.chamber_edge", "film.crankcase_edge", "film.supply", "supply.",
                                              "thermal.ring",      "thermal.liner",       "thermal.film"};
/// Those of an engine also these: they have walls, and gas requires mass to be kept.
inline constexpr std::array kKeysOfEngine{"operating.oil_temperature", "film.cavitation"};

}  // namespace ringfilm::cycle
