#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/cycle/setup.hpp"
#include "ringfilm/study/ledger.hpp"

namespace ringfilm::study {

/// Another choice for an assumption: how one would write it, and what it does to the case.
struct Alternative {
  std::string setting;  ///< "film.cavitation = \"mass-conserving\""
  std::function<void(cycle::Case&)> apply;
};

/// An assumption of a case with the alternatives that this program can run.
struct Assumption {
  LedgerEntry entry;  ///< without variants
  std::vector<Alternative> alternatives;
};

/// What `setup` takes for granted, the weightiest first.
std::vector<Assumption> assumptions_of(const cycle::Setup& setup);

}  // namespace ringfilm::study
