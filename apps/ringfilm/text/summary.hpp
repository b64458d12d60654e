#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::app {

/// What `ringfilm run` prints of a ring: a verdict, the values that decide, the most serious notes.
std::string short_summary(const cycle::Case& input, const io::ResultDocument& document);

/// What it prints of a pack, the rings side by side.
std::string short_pack_summary(const cycle::Case& input, const io::ResultDocument& pack);

/// What it prints with --all, of a ring: what was computed, the values of the cycle, how well it was solved, what was
/// assumed and what must be known about it.
std::string summary(const cycle::Case& input, const io::ResultDocument& document);

/// The keys that the case does not state, with the values in use.
std::string default_input_lines(const std::vector<io::CaseEntry>& inputs);

/// What the friction of all rings of a pack adds up to, in a line.
std::string pack_summary(const io::ResultDocument& pack);

/// The ledger with the change of minimum film, mean power and oil flow for each choice that was run.
std::string ledger_table(const io::ResultDocument& document);

}  // namespace ringfilm::app
