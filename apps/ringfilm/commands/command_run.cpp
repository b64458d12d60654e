#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "output_names.hpp"
#include "progress.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/io/pad/pad_netcdf.hpp"
#include "ringfilm/io/result/result_csv.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/result/result_json.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/report/html.hpp"
#include "ringfilm/run/inverse/case_numbers.hpp"
#include "ringfilm/run/inverse/gradients.hpp"
#include "ringfilm/run/run.hpp"
#include "text/pad_summary.hpp"
#include "text/shared_options.hpp"
#include "text/summary.hpp"

namespace ringfilm::app {
namespace {

struct RunOptions : CaseWithOutputs {
  run::Options computed;
  bool all = false;                 ///< every value, default input, assumption and note
  std::optional<std::string> page;  ///< report of a ring or pack
  bool gradients = false;           ///< derivatives of all values with respect to the numbers of the case
};

std::vector<NamedOutput> outputs_of(const RunOptions& options) {
  return {{"--output", options.output, OutputKind::kNetcdf},
          {"--csv", options.csv, OutputKind::kCsv, io::Sink::kFileOrDevice},
          {"--report", options.page, OutputKind::kPage, io::Sink::kFileOrDevice}};
}

cycle::Case checked_case(const RunOptions& options) {
  Faults faults;
  cycle::Case input;
  faults.collect([&] { input = case_with_settings(options.case_path, options.overrides); });
  check_names(outputs_of(options), faults);
  faults.collect([&] { run::check_options(input, options.computed, {"--ledger", "--error-estimate"}); });
  if (options.page && input.problem == cycle::Problem::kPad) {
    faults.refuse("--report draws the cycle of rings, and the case is a pad", "remove it; --csv writes the curves");
  }
  faults.check();
  check_apart(outputs_of(options), input.files, "case", faults);
  faults.check();
  return input;
}

/// A result as its outputs have it: each is asked for alone.
struct Outputs {
  std::size_t n_solved = 0;  ///< crank angles or instants
  std::function<void(const std::string&)> write_netcdf;
  std::function<std::string()> csv, json, text, page;
};

std::string long_text(const io::ResultDocument& document, const cycle::Case& input) {
  const cycle::Case shown = cycle::with_rails(input);
  std::string all;
  const std::span<const io::ResultDocument> rings = io::rings_of(document);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    all += (i > 0 ? "\n" : "") + summary(shown.is_pack() ? shown.rings[i] : shown, rings[i]);
    if (rings[i].ledger_computed) all += "\n" + ledger_table(rings[i]);
  }
  return input.is_pack() ? all + "\n" + pack_summary(document) : all;
}

std::string short_text(const io::ResultDocument& document, const cycle::Case& input) {
  std::string text = input.is_pack() ? short_pack_summary(input, document) : short_summary(input, document);
  for (const io::ResultDocument& ring : io::rings_of(document)) {
    if (ring.ledger_computed) text += "\n" + (input.is_pack() ? ring.title + "\n" : "") + ledger_table(ring);
  }
  return text;
}

/// What is printed of gradients: of a ring or pack, else of a pad.
std::vector<cycle::Quantity> shown_gradients(const cycle::Case& input) {
  std::vector<cycle::Quantity> shown = run::value_quantities(input);
  std::erase_if(shown, [](const cycle::Quantity& quantity) {
    constexpr std::array kNames = {"fmep", "min_film_thickness", "load", "friction_moving"};
    return std::ranges::find(kNames, quantity.name) == kNames.end();
  });
  return shown;
}

/// Values of a case against its numbers: per cent for one of the input, for a temperature for a kelvin.
std::string gradient_table(const cycle::Case& input, const std::vector<run::Gradient>& gradients) {
  const std::vector<cycle::Quantity> shown = shown_gradients(input);
  const auto relative = [](const run::Gradient& one, const cycle::Quantity& quantity) {
    const auto found = one.derivatives.find(quantity.name);
    if (found == one.derivatives.end() || found->second.around == 0) return run::Derivative{};
    const auto ring = cycle::ring_key(one.key);
    const bool is_temperature = cycle::find_field(ring ? ring->key : one.key)->unit == "K";
    const double scale = (is_temperature ? 100 : one.at) / found->second.around;
    return run::Derivative{found->second.value * scale, std::abs(found->second.error * scale)};
  };
  std::vector<const run::Gradient*> order;
  for (const run::Gradient& one : gradients) order.push_back(&one);
  if (shown.empty() || order.empty()) return "";
  std::ranges::stable_sort(order, std::greater(),
                           [&](const run::Gradient* one) { return std::abs(relative(*one, shown.front()).value); });
  std::string text = fmt::format("\n{:<44}", "per cent for 1 % of an input, or 1 K");
  for (const cycle::Quantity& quantity : shown) text += fmt::format("{:>26}", quantity.long_name.substr(0, 24));
  text += "\n";
  for (const run::Gradient* one : order) {
    text += fmt::format("{:<44}", one->key);
    if (!one->reason.empty()) text += "  not computed: " + one->reason;
    for (std::size_t k = 0; one->reason.empty() && k < shown.size(); ++k) {
      const run::Derivative of = relative(*one, shown[k]);
      const std::string cell = of.error > std::abs(of.value) ? fmt::format("within {:.1g}", of.error)
                                                             : fmt::format("{:.3g} +- {:.1g}", of.value, of.error);
      text += fmt::format("{:>26}", cell);
    }
    text += "\n";
  }
  return text;
}

/// The JSON of a result with `gradients` and `gradient_errors`, by quantity and key.
std::string with_gradients(const std::string& json, const std::vector<run::Gradient>& gradients) {
  auto document = nlohmann::ordered_json::parse(json);
  document["gradients"] = document["gradient_errors"] = nlohmann::ordered_json::object();
  for (const run::Gradient& one : gradients) {
    for (const auto& [quantity, derivative] : one.derivatives) {
      document["gradients"][quantity][one.key] = derivative.value;
      document["gradient_errors"][quantity][one.key] = derivative.error;
    }
    if (!one.reason.empty()) document["gradients_not_computed"][one.key] = one.reason;
  }
  return document.dump(2) + "\n";
}

Outputs contents_of(const io::ResultDocument& document, const cycle::Case& input, bool all) {
  std::size_t n_solved = 0;
  for (const io::ResultDocument& ring : io::rings_of(document)) n_solved += ring.result.samples.size();
  const bool is_whole = document.result.complete;
  const auto text = [&document, &input, is_long = all || !is_whole] {
    return is_long ? long_text(document, input) : short_text(document, input);
  };
  return {n_solved,
          [&](const std::string& path) { io::write_result(path, document); },
          [&] { return io::result_csv(document); },
          [&] { return io::result_json(document); },
          text,
          [&] { return ringfilm::report::report_page({document}, {}); }};
}

Outputs contents_of(const io::PadDocument& document, const cycle::Case& input) {
  return {document.result.samples.size(),
          [&](const std::string& path) { io::write_pad(path, document); },
          [&] { return io::pad_csv(document.result); },
          [&] { return io::pad_json(document); },
          [&] { return pad_summary(input, document); },
          nullptr};
}

/// Why the integration of a cycle stopped, and what there is of it now.
ConvergenceError named_stop(const RunOptions& options, const ConvergenceError& stop, std::size_t n_solved) {
  std::string text = stop.what();
  if (n_solved == 0) {
    text += "\nno crank angle of those asked for was finished; nothing was written, files that exist are unchanged";
  } else if (options.output || options.csv || options.page) {
    text += fmt::format("\nwhat was written holds the {} crank angles that were solved before", n_solved);
  }
  return {text, stop.crank_angle_deg()};
}

void run(const RunOptions& options) {
  const cycle::Case input = checked_case(options);
  const std::vector<io::OutputClaim> claimed = claims(outputs_of(options));
  std::optional<RunProgress> progress(std::in_place);
  const run::Outcome done = run::run_case(input, options.computed, &*progress, options.case_path);
  progress.reset();
  const bool is_pad = input.problem == cycle::Problem::kPad;
  const Outputs outputs = is_pad ? contents_of(std::get<io::PadDocument>(done.result), input)
                                 : contents_of(std::get<io::ResultDocument>(done.result), input, options.all);
  const bool is_worth_writing = outputs.n_solved > 0;
  if (options.output && is_worth_writing) outputs.write_netcdf(*options.output);
  if (options.csv && is_worth_writing) io::write_atomically(*options.csv, outputs.csv());
  if (options.page && is_worth_writing) io::write_atomically(*options.page, outputs.page());
  const bool is_shown = is_worth_writing || !is_pad;
  const bool differentiates = options.gradients && !done.stopped;
  const auto gradients = [&] { return run::gradients(input, {}, options.computed.threads); };
  if (is_shown && options.summary == SummaryForm::kJson) {
    std::cout << (differentiates ? with_gradients(outputs.json(), gradients()) : outputs.json());
  } else if (is_shown) {
    std::cout << outputs.text() << std::flush;
    if (differentiates) std::cout << gradient_table(input, gradients());
    if (is_worth_writing) print_written(outputs_of(options));
  }
  if (!done.stopped) return;
  if (is_pad) throw *done.stopped;
  throw named_stop(options, *done.stopped, outputs.n_solved);
}

constexpr const char* kRunFooter = R"(Examples:
  ringfilm run case.toml
  ringfilm run case.toml --all
  ringfilm run case.toml --report case.html
  ringfilm run case.toml --output result.nc --csv curves.csv
  ringfilm run case.toml --set operating.speed='3000 rpm' --set solver.cells=400 --json
  ringfilm run case.toml --ledger --output result.nc
  ringfilm run case.toml --error-estimate --jobs 4
  ringfilm run case.toml --gradients
  ringfilm run verification/rayleigh1918_step/best.toml

A case with a table [pad] instead of [engine] and [ring] is the film of a slider, a step or two plates that approach
each other, steady or in time; --ledger and --error-estimate are for rings.

--set KEY= takes a key out of the case. A key of the case that --set makes unused is dropped, with a line on standard
error: --set ring.tangential_force='12.5 N' takes the place of ring.elastic_pressure.
An output that exists is replaced at once when the new one is complete; a kill or a full disk leaves the old one.
A study that exists is replaced with --overwrite only.
)";

void declare_run(CommandOptions& add, RunOptions& options) {
  add_case(add, options);
  add.text("-o,--output", options.output, "X.nc", "write the whole result as NetCDF-4");
  add_csv(add, options, "write the curves as CSV, SI units: over crank angle, of a pad along its length");
  add.text("--report", options.page, "X.html", "draw the result as one self-contained page");
  add.json(options.summary, "print the values as JSON, SI units, instead of the table");
  add.flag("--all", options.all, "print every value, default input, modelling assumption and note of each ring");
  add.flag("--ledger", options.computed.ledger,
           "run the other choice for every modelling assumption that can be lifted");
  add.flag("--error-estimate", options.computed.error_estimate,
           "integrate four other grids too and give every value its error (cost: docs/theory/error-estimate.md); "
           "always done where solver.accuracy is stated");
  add.flag("--gradients", options.gradients,
           "differentiate all values with respect to the numbers that the case states, with their errors: four runs "
           "each, on "
           "--jobs threads");
  add_jobs(add, options.computed.threads);
}

}  // namespace

void add_run_command(Program& program) {
  program.add("run", "Compute one engine cycle, or a pad, and print its summary", kRunFooter, declare_run, run);
}

}  // namespace ringfilm::app
