#pragma once
#include "ringfilm/cycle/pack/gas_of_pack.hpp"
#include "ringfilm/cycle/simulate.hpp"

namespace ringfilm::cycle {

/// The case with the gas path of its pack computed, as by solve_gas_of_case(). Where gas_path.film = "breakthrough",
/// films and gas are computed in turns until the blow-by no longer changes: gas passes a face where its film does not
/// hold it. The first ring has a note on the turns. Where a film is not found the gas of the turn before is returned,
/// and the run of the films will report it.
/// @param pack each rail of an oil ring by itself (with_rails)
CaseWithGas solve_gas_through_films(Case pack, Observer* observer = nullptr);

}  // namespace ringfilm::cycle
