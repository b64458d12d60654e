#include "computation.hpp"

#include <fmt/format.h>

#include "progress.hpp"
#include "ringfilm/cycle/setup.hpp"
#include "ringfilm/cycle/simulate.hpp"

namespace ringfilm::app {

Computation computation(const cycle::Case& input, LedgerWanted ledger, ErrorsWanted errors, const std::string& name) {
  ProgressLine line;
  MarchProgress progress(line, name);
  Computation done;
  io::ResultDocument& document = done.document;
  document.title = input.title;
  document.inputs = io::case_entries(input);
  document.resolved_case = io::resolved_case(input);
  document.files = input.files;
  document.input_notes = input.notes;
  document.provenance = io::this_program();
  try {
    document.result = cycle::simulate(cycle::prepare(input), &progress);
  } catch (const cycle::StoppedCycle& stop) {
    document.result = stop.result;
    document.result.complete = false;
    done.stopped = stop;
  }
  if (errors == ErrorsWanted::kEstimated && !done.stopped) {
    document.errors = study::error_estimate(input, document.result, [&](int n_done, int n_total) {
      line.show(fmt::format("{}: error estimate, {} of {} other grids", name, n_done, n_total));
    });
    const auto notes = study::notes_on(*document.errors);
    document.result.notes.insert(document.result.notes.end(), notes.begin(), notes.end());
  }
  document.ledger_computed = ledger == LedgerWanted::kComputed && !done.stopped;
  if (document.ledger_computed) {
    document.ledger = study::ledger(input, [&](int n_done, int n_total) {
      line.show(fmt::format("{}: ledger, {} of {} other choices", name, n_done, n_total));
    });
  } else {
    document.ledger = study::assumptions(input);
  }
  return done;
}

}  // namespace ringfilm::app
