#pragma once
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/case.hpp"
#include "ringfilm/io/result_file.hpp"
#include "ringfilm/study/batch.hpp"

namespace ringfilm::app {

/// One case and what is to be known of it.
struct Wanted {
  cycle::Case input;
  LedgerWanted ledger = LedgerWanted::kStatements;
  ErrorsWanted errors = ErrorsWanted::kNone;
  std::string name;  ///< for the progress line
};

/// One case, computed: what is to be written, and why the march stopped early if it did.
struct Computation {
  io::ResultDocument document;
  std::optional<ConvergenceError> stopped;
};

/// Marches each case, then all that ledgers and error estimates want in one batch.
std::vector<Computation> computations(const std::vector<Wanted>& wanted, const study::BatchOptions& options);

}  // namespace ringfilm::app
