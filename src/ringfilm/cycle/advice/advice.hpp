#pragma once
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::cycle {

/// What to know about a case before it is computed: numbers that no engine has, keys without effect, and what was found
/// out while it was set up. The most serious note first.
std::vector<Note> advice(const Setup& setup);

}  // namespace ringfilm::cycle
