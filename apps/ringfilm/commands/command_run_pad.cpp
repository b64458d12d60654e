#include <fmt/format.h>

#include <iostream>
#include <optional>

#include "commands/commands.hpp"
#include "progress.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/pad/pad_netcdf.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/pad/solve_pad.hpp"
#include "text/pad_summary.hpp"

namespace ringfilm::app {
namespace {

class PadProgress : public pad::Observer {
 public:
  PadProgress(ProgressLine& line, const std::string& name) : line_(line), name_(name) {}
  void advanced(double time, double end_time) override {
    line_.show(fmt::format("{}: {:.4g} of {:.4g} s", name_, time, end_time));
  }

 private:
  ProgressLine& line_;
  std::string name_;
};

void check_pad_options(const RunOptions& options) {
  if (options.ledger == LedgerRequest::kComputed) {
    throw InputError("--ledger: a pad has no assumptions that could be lifted", "leave it out");
  }
  if (options.errors == ErrorRequest::kEstimated) {
    throw InputError("--error-estimate: the errors of a pad are not estimated",
                     "leave it out, and run the pad with twice the cells to see what changes");
  }
}

io::PadDocument document_of(const cycle::Case& input) {
  return {input.title, io::case_entries(input), input.notes, io::this_run(), {}};
}

}  // namespace

void run_pad(const RunOptions& options, const cycle::Case& input) {
  check_pad_options(options);
  io::PadDocument document = document_of(input);
  std::optional<ConvergenceError> stopped;
  try {
    ProgressLine line;
    PadProgress progress(line, options.case_path);
    document.result = pad::solve_pad(input, &progress);
  } catch (const pad::StoppedPad& stop) {
    document.result = stop.result;
    stopped = stop;
  }
  if (!document.result.samples.empty()) {
    if (options.output) io::write_pad(*options.output, document);
    if (options.csv) io::write_atomically(*options.csv, io::pad_csv(document.result));
    if (options.summary == SummaryForm::kJson) {
      std::cout << io::pad_json(document);
    } else {
      std::cout << pad_summary(input, document);
      if (options.output) std::cout << "wrote " << *options.output << "\n";
      if (options.csv) std::cout << "wrote " << *options.csv << "\n";
    }
  }
  if (stopped) throw *stopped;
}

}  // namespace ringfilm::app
