#pragma once
#include <string>
#include <vector>

#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/study/ensemble/alternatives.hpp"
#include "ringfilm/study/ensemble/ledger.hpp"

namespace ringfilm::study {

/// An assumption of a case with the alternatives that this program can run.
struct Assumption {
  LedgerEntry entry;  ///< without variants
  std::vector<Alternative> alternatives;
};

/// One whose source is the topic's place in docs/theory/assumptions.md.
Assumption assumption(const std::string& topic, std::string statement, std::string consequence,
                      std::vector<Alternative> alternatives = {});

/// What `setup` takes for granted, the weightiest first.
std::vector<Assumption> assumptions_of(const cycle::Setup& setup);

}  // namespace ringfilm::study
