#pragma once
#include <array>

#include "ringfilm/cycle/case/case.hpp"

namespace ringfilm::cycle {

/// Starts a case from the edges, the supply and the temperatures of `conditions`; what it states replaces them.
void set_conditions(Conditions conditions, Case& c);

/// A case that states one oil temperature has no other walls than those that it states, too.
void keep_own_temperature(Case& c);

/// Sections and keys that conditions replace where the command line asks for them.
inline constexpr std::array kKeysOfConditions{"operating.oil_temperature",
                                              "film.cavitation",
                                              "film.chamber_edge",
                                              "film.crankcase_edge",
                                              "film.supply",
                                              "supply.",
                                              "thermal."};

}  // namespace ringfilm::cycle
