#pragma once
#include <optional>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

namespace ringfilm::app {

/// One case and what is to be known of it.
struct RunRequest {
  cycle::Case input;
  LedgerRequest ledger = LedgerRequest::kStatements;
  ErrorRequest errors = ErrorRequest::kNone;
  std::string name;  ///< for the progress line
};

/// One case, computed: what is to be written, and why the integration stopped early if it did.
struct Computation {
  io::ResultDocument document;
  std::optional<ConvergenceError> stopped;
};

/// Receives how far computations are: of the integration of a case as cycle::Observer, and of all others.
class ComputationWatch : public cycle::Observer {
 public:
  virtual void begins(const RunRequest& one) = 0;          ///< the integration of this case
  virtual void others_ended(int n_done, int n_total) = 0;  ///< other grids and choices; never twice at a time
};

/// Integrates each case, then all that ledgers and error estimates require in one batch.
std::vector<Computation> computations(const std::vector<RunRequest>& requested, const study::BatchOptions& options,
                                      ComputationWatch& watch);

/// The same, with a line of progress on standard error.
std::vector<Computation> computations(const std::vector<RunRequest>& requested, const study::BatchOptions& options);

}  // namespace ringfilm::app
