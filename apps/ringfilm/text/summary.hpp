#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::app {

/// The table that `ringfilm run` prints: what was computed, the values of the cycle, how well it was solved, what was
/// assumed and what must be known about it.
std::string summary(const cycle::Case& input, const io::ResultDocument& document);

/// The keys that the case does not state, with the values in use.
std::string default_input_lines(const std::vector<io::CaseEntry>& inputs);

/// What the friction of all rings of a pack adds up to, in a line.
std::string pack_summary(const io::ResultDocument& pack);

/// The ledger with the change of minimum film, mean power and oil flow for each choice that was run.
std::string ledger_table(const io::ResultDocument& document);

}  // namespace ringfilm::app
