#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iostream>

#include "commands/commands.hpp"
#include "computation.hpp"
#include "output_names.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/io/result/result_csv.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/result/result_json.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "text/summary.hpp"

namespace ringfilm::app {
namespace {

/// Runs a check and keeps its faults, so that all are reported at once.
void collect(std::vector<Fault>& faults, const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
  }
}

/// A result must not replace what it was computed from, nor another output.
void check_outputs_apart(const RunOptions& options, const cycle::Case& input) {
  std::vector<Fault> faults;
  for (const auto& output : {options.output, options.csv}) {
    if (!output) continue;
    for (const cycle::InputFile& file : input.files) {
      if (is_same_file(*output, file.path)) {
        faults.push_back({{}, *output + ": the output is a file that the case is read from", "name another file"});
      }
    }
  }
  if (options.output && options.csv && is_same_file(*options.output, *options.csv)) {
    faults.push_back({{}, *options.csv + ": --output and --csv name the same file", "name two files"});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

cycle::Case checked_case(const RunOptions& options) {
  std::vector<Fault> faults;
  cycle::Case input;
  collect(faults, [&] { input = case_with_settings(options.case_path, options.overrides); });
  collect(faults, [&] {
    if (!options.output) return;
    check_suffix("--output", *options.output, OutputKind::kNetcdf);
    io::check_can_write(*options.output, io::Sink::kFile);
  });
  collect(faults, [&] {
    if (!options.csv) return;
    check_suffix("--csv", *options.csv, OutputKind::kCsv);
    io::check_can_write(*options.csv, io::Sink::kFileOrDevice);
  });
  if (!faults.empty()) throw InputError(std::move(faults));
  check_outputs_apart(options, input);
  return input;
}

/// Why the integration stopped, and what there is of it now.
ConvergenceError named_stop(const RunOptions& options, const Computation& done) {
  std::size_t n_solved = 0;
  for (const io::ResultDocument& ring : io::rings_of(done.document)) n_solved += ring.result.samples.size();
  std::string text = done.stopped->what();
  if (n_solved == 0) {
    text += "\nno crank angle of those asked for was finished; nothing was written, files that exist are unchanged";
  } else if (options.output || options.csv) {
    text += fmt::format("\nwhat was written holds the {} crank angles that were solved before", n_solved);
  }
  return {text, done.stopped->crank_angle_deg()};
}

}  // namespace

void run(const RunOptions& options) {
  const cycle::Case input = checked_case(options);
  const std::vector<io::OutputClaim> claimed = claims({options.output, options.csv});
  if (input.problem == cycle::Problem::kPad) return run_pad(options, input);
  const Computation done =
      computations({{input, options.ledger, options.errors, options.case_path}}, {options.jobs}).front();
  const std::span<const io::ResultDocument> rings = io::rings_of(done.document);
  const bool is_worth_writing =
      std::any_of(rings.begin(), rings.end(), [](const auto& ring) { return !ring.result.samples.empty(); });
  if (options.output && is_worth_writing) io::write_result(*options.output, done.document);
  if (options.csv && is_worth_writing) io::write_atomically(*options.csv, io::result_csv(done.document));
  if (options.summary == SummaryForm::kJson) {
    std::cout << io::result_json(done.document);
  } else {
    const cycle::Case shown = cycle::with_rails(input);
    for (std::size_t i = 0; i < rings.size(); ++i) {
      std::cout << (i > 0 ? "\n" : "") << summary(shown.is_pack() ? shown.rings[i] : shown, rings[i]);
      if (rings[i].ledger_computed) std::cout << "\n" << ledger_table(rings[i]);
    }
    if (input.is_pack()) std::cout << "\n" << pack_summary(done.document);
    if (options.output && is_worth_writing) std::cout << "wrote " << *options.output << "\n";
    if (options.csv && is_worth_writing) std::cout << "wrote " << *options.csv << "\n";
  }
  if (done.stopped) throw named_stop(options, done);
}

}  // namespace ringfilm::app
