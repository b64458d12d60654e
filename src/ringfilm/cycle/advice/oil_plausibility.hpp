#pragma once
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::cycle {

/// Notes on a viscosity far from those of engine oils at the film's temperatures; docs/theory/oil.md.
void append_viscosity_notes(const OilSetup& oil, std::vector<Note>& notes);

}  // namespace ringfilm::cycle
