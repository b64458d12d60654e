#pragma once
#include <optional>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/case/case.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

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

/// Receives how far computations are: of the march of a case as cycle::Observer, and of all others.
class ComputationWatch : public cycle::Observer {
 public:
  virtual void begins(const Wanted& one) = 0;              ///< the march of this case
  virtual void others_ended(int n_done, int n_total) = 0;  ///< other grids and choices; never twice at a time
};

/// Marches each case, then all that ledgers and error estimates want in one batch.
std::vector<Computation> computations(const std::vector<Wanted>& wanted, const study::BatchOptions& options,
                                      ComputationWatch& watch);

/// The same, with a line of progress on standard error.
std::vector<Computation> computations(const std::vector<Wanted>& wanted, const study::BatchOptions& options);

}  // namespace ringfilm::app
