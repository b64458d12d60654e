#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iostream>

#include "commands/commands.hpp"
#include "output_names.hpp"
#include "progress.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/io/pad/pad_netcdf.hpp"
#include "ringfilm/io/result/result_csv.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/result/result_json.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/run/run.hpp"
#include "text/pad_summary.hpp"
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
  if (input.problem == cycle::Problem::kPad) {
    const std::pair<bool, const char*> of_rings[] = {{options.computed.ledger, "--ledger"},
                                                     {options.computed.error_estimate, "--error-estimate"}};
    for (const auto& [is_given, option] : of_rings) {
      if (is_given) faults.push_back({{}, std::string(option) + " is for rings, and the case is a pad", "remove it"});
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  check_outputs_apart(options, input);
  return input;
}

/// A result as its outputs have it: each is asked for alone.
struct Outputs {
  std::size_t n_solved = 0;  ///< crank angles or instants
  std::function<void(const std::string&)> write_netcdf;
  std::function<std::string()> csv, json, text;
};

Outputs outputs_of(const io::ResultDocument& document, const cycle::Case& input) {
  std::size_t n_solved = 0;
  for (const io::ResultDocument& ring : io::rings_of(document)) n_solved += ring.result.samples.size();
  const auto text = [&document, &input] {
    const cycle::Case shown = cycle::with_rails(input);
    std::string all;
    const std::span<const io::ResultDocument> rings = io::rings_of(document);
    for (std::size_t i = 0; i < rings.size(); ++i) {
      all += (i > 0 ? "\n" : "") + summary(shown.is_pack() ? shown.rings[i] : shown, rings[i]);
      if (rings[i].ledger_computed) all += "\n" + ledger_table(rings[i]);
    }
    if (input.is_pack()) all += "\n" + pack_summary(document);
    return all;
  };
  return {n_solved, [&](const std::string& path) { io::write_result(path, document); },
          [&] { return io::result_csv(document); }, [&] { return io::result_json(document); }, text};
}

Outputs outputs_of(const io::PadDocument& document, const cycle::Case& input) {
  return {document.result.samples.size(), [&](const std::string& path) { io::write_pad(path, document); },
          [&] { return io::pad_csv(document.result); }, [&] { return io::pad_json(document); },
          [&] { return pad_summary(input, document); }};
}

/// Why the integration of a cycle stopped, and what there is of it now.
ConvergenceError named_stop(const RunOptions& options, const ConvergenceError& stop, std::size_t n_solved) {
  std::string text = stop.what();
  if (n_solved == 0) {
    text += "\nno crank angle of those asked for was finished; nothing was written, files that exist are unchanged";
  } else if (options.output || options.csv) {
    text += fmt::format("\nwhat was written holds the {} crank angles that were solved before", n_solved);
  }
  return {text, stop.crank_angle_deg()};
}

}  // namespace

void run(const RunOptions& options) {
  const cycle::Case input = checked_case(options);
  const std::vector<io::OutputClaim> claimed = claims({options.output, options.csv});
  std::optional<RunProgress> progress(std::in_place);
  const run::Outcome done = run::run_case(input, options.computed, &*progress, options.case_path);
  progress.reset();
  const bool is_pad = input.problem == cycle::Problem::kPad;
  const Outputs outputs = is_pad ? outputs_of(std::get<io::PadDocument>(done.result), input)
                                 : outputs_of(std::get<io::ResultDocument>(done.result), input);
  const bool is_worth_writing = outputs.n_solved > 0;
  if (options.output && is_worth_writing) outputs.write_netcdf(*options.output);
  if (options.csv && is_worth_writing) io::write_atomically(*options.csv, outputs.csv());
  const bool is_shown = is_worth_writing || !is_pad;
  if (is_shown && options.summary == SummaryForm::kJson) {
    std::cout << outputs.json();
  } else if (is_shown) {
    std::cout << outputs.text();
    if (options.output && is_worth_writing) std::cout << "wrote " << *options.output << "\n";
    if (options.csv && is_worth_writing) std::cout << "wrote " << *options.csv << "\n";
  }
  if (!done.stopped) return;
  if (is_pad) throw *done.stopped;
  throw named_stop(options, *done.stopped, outputs.n_solved);
}

}  // namespace ringfilm::app
