#pragma once
#include <optional>
#include <span>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

/// How steeply the friction of a single ring depends on the oil that it finds on the liner.
namespace ringfilm::study {

/// Topic of the note on a friction that depends steeply on supply.film.
inline constexpr const char* kSupplySteep = "supply-steep";

/// The case computed coarsely (coarse_case) as it is, with 20 % less and 20 % more of supply.film and, where that is
/// the default of the conditions, at both ends of its band. Empty where the ring is flooded or its coarse case takes
/// long.
std::vector<cycle::Case> supply_cases(const cycle::Case& c);

/// The note on a FMEP that 20 % more or less of supply.film change by more than 5 %; nothing where it changes less.
/// @param ended how the supply_cases ended
std::optional<cycle::Note> supply_note(const cycle::Case& c, std::span<const Ending> ended);

/// Computes the supply_cases on the calling thread and adds their note to a result of `c`.
void add_supply_note(const cycle::Case& c, cycle::CycleResult& result);

}  // namespace ringfilm::study
