#pragma once
#include <optional>
#include <string>

#include "commands.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/case.hpp"
#include "ringfilm/io/result_file.hpp"

namespace ringfilm::app {

/// One case, computed: what is to be written, and why the march stopped early if it did.
struct Computation {
  io::ResultDocument document;
  std::optional<ConvergenceError> stopped;
};

/// Prepares and marches the case, with ledger and errors if wanted. @param name for the progress line
Computation computation(const cycle::Case& input, LedgerWanted ledger, ErrorsWanted errors, const std::string& name);

}  // namespace ringfilm::app
