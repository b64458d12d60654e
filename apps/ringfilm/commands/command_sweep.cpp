#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands/commands.hpp"
#include "output_names.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/run/run.hpp"
#include "ringfilm/study/ensemble/threads.hpp"
#include "text/engineering_text.hpp"
#include "text/shared_options.hpp"
#include "variations.hpp"

namespace ringfilm::app {
namespace {

struct SweepOptions : CaseOptions {
  std::vector<std::string> varied;  ///< as written: KEY=VALUE, VALUE, ... or KEY=FROM..TO
  std::size_t points = 11;
  std::optional<std::string> csv;
  int threads = 0;
};

/// What a combination has; of a pack the sums of its rings, and the least film of all.
struct Row {
  std::vector<io::Override> settings;
  std::optional<cycle::CycleValues> values;  ///< nothing where it was not solved
  std::string reason;                        ///< why
};

constexpr auto kShown = {"fmep", "mean_power_loss", "mean_boundary_power", "peak_total_friction", "min_film_thickness"};

std::vector<NamedOutput> outputs_of(const SweepOptions& options) {
  return {{"--csv", options.csv, OutputKind::kCsv, io::Sink::kFileOrDevice}};
}

void compute(const cycle::Case& c, Row& row) {
  run::Options run;
  run.describe = run.accuracy_estimate = false;
  run.threads = 1;
  try {
    const run::Outcome done = run::run_case(c, run);
    const auto& document = std::get<io::ResultDocument>(done.result);
    if (done.stopped) {
      row.reason = done.stopped->what();
      return;
    }
    row.values = document.result.values;
    const double none = std::numeric_limits<double>::infinity();
    double least = document.rings.empty() ? row.values->min_film_thickness : none, peak = 0;
    for (const io::ResultDocument& ring : document.rings) {
      least = std::min(least, ring.result.values.min_film_thickness);
      peak = std::max(peak, ring.result.values.peak_total_friction);
    }
    row.values->min_film_thickness = least;
    if (!document.rings.empty()) row.values->peak_total_friction = peak;
  } catch (const ConvergenceError& error) {
    row.reason = error.what();
  }
}

std::string settings_text(const Row& row) {
  std::vector<std::string> texts;
  for (const io::Override& one : row.settings) texts.push_back(one.key + " = " + one.value);
  return joined(texts, ", ");
}

/// The settings and the values that decide, a line each; the lowest friction and the thickest film are named below.
std::string table_of(const std::vector<Row>& rows) {
  const EngineeringText in_words;
  std::string text;
  for (const io::Override& one : rows.front().settings) text += fmt::format("{:<26}", one.key);
  for (const char* name : {"FMEP", "mean power", "boundary", "peak friction", "min. film"}) {
    text += fmt::format("{:>15}", name);
  }
  text += "\n";
  for (const Row& row : rows) {
    for (const io::Override& one : row.settings) text += fmt::format("{:<26}", one.value);
    for (const char* name : kShown) {
      const cycle::CycleQuantity& quantity = cycle_quantity(name);
      text += fmt::format("{:>15}", row.values ? in_words(quantity, (*row.values).*quantity.value) : "not solved");
    }
    text += "\n";
  }
  const auto friction = [](const Row& row) {
    return row.values ? row.values->fmep : std::numeric_limits<double>::infinity();
  };
  const auto best = std::ranges::min_element(rows, {}, friction);
  if (best->values) {
    text += fmt::format("lowest FMEP: {} at {}\n", in_words("fmep", best->values->fmep), settings_text(*best));
  }
  for (const Row& row : rows) {
    if (!row.values) text += "not solved: " + settings_text(row) + ": " + row.reason + "\n";
  }
  return text;
}

std::string csv_of(const std::vector<Row>& rows) {
  std::string text;
  for (const io::Override& one : rows.front().settings) text += one.key + ",";
  std::vector<std::string> names;
  for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
    names.push_back(quantity.name + (quantity.unit == "1" ? "" : " [" + quantity.unit + "]"));
  }
  text += joined(names, ",") + "\n";
  for (const Row& row : rows) {
    for (const io::Override& one : row.settings) text += one.value + ",";
    std::vector<std::string> cells;
    for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
      cells.push_back(row.values ? fmt::format("{}", (*row.values).*quantity.value) : "nan");
    }
    text += joined(cells, ",") + "\n";
  }
  return text;
}

std::string json_of(const std::string& case_path, const std::vector<Row>& rows) {
  nlohmann::ordered_json all{{"case", case_path}, {"scenarios", nlohmann::ordered_json::array()}};
  for (const Row& row : rows) {
    nlohmann::ordered_json one;
    for (const io::Override& setting : row.settings) one["settings"][setting.key] = setting.value;
    one["complete"] = row.values.has_value();
    if (!row.values) one["reason"] = row.reason;
    for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
      if (row.values) one["values"][quantity.name] = (*row.values).*quantity.value;
    }
    all["scenarios"].push_back(std::move(one));
  }
  for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) all["units"][quantity.name] = quantity.unit;
  return all.dump(2) + "\n";
}

void sweep(const SweepOptions& options) {
  const VariationForm form{"", "operating.speed=1000..6000 or lubricant.grade='SAE 0W-20, SAE 5W-30'", options.points};
  const std::vector<Variation> varied = variations(options.varied, form);
  Faults faults;
  check_names(outputs_of(options), faults);
  faults.check();
  const std::vector<cycle::Case> cases =
      cases_of(options.case_path, options.overrides, varied, form, cycle::CasePurpose::kFilm);
  if (cases.front().problem != cycle::Problem::kCycle) {
    throw InputError(options.case_path + ": sweep computes cycles of rings, and this is another case",
                     "run it with --set for each value");
  }
  check_apart(outputs_of(options), cases.front().files, "case", faults);
  faults.check();
  const std::vector<io::OutputClaim> claimed = claims(outputs_of(options));
  std::vector<Row> rows(cases.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].settings = combination(varied, i, form);
  std::atomic<std::size_t> next = 0;
  study::on_threads(std::min(study::n_threads(options.threads), static_cast<int>(rows.size())), [&](int) {
    for (std::size_t i = next++; i < rows.size(); i = next++) compute(cases[i], rows[i]);
  });
  if (options.csv) io::write_atomically(*options.csv, csv_of(rows));
  std::cout << (options.summary == SummaryForm::kJson ? json_of(options.case_path, rows) : table_of(rows));
  if (options.summary != SummaryForm::kJson) print_written(outputs_of(options));
  const auto n_failed = std::ranges::count_if(rows, [](const Row& row) { return !row.values; });
  if (n_failed > 0) throw FailedChecks(fmt::format("{} of {} cases were not solved", n_failed, rows.size()));
}

constexpr const char* kSweepFooter = R"(Examples:
  ringfilm sweep case.toml operating.speed=1000..6000
  ringfilm sweep case.toml lubricant.grade='SAE 0W-20, SAE 5W-30' operating.speed='1000..6000 rpm' --points 6
  ringfilm sweep pack.toml ring.1.face.crown_height='2 um, 4 um, 8 um' --csv crowns.csv

A bare number has the unit of `ringfilm fields`. All combinations are computed, the last key fastest;
`ringfilm study` computes larger plans, with a page, and continues after a kill.
)";

void declare_sweep(CommandOptions& add, SweepOptions& options) {
  add.text("CASE.toml", options.case_path, "", "the case file")->required();
  add_settings(add, options.overrides);
  add.text("KEY=VALUES", options.varied, "...", "a key with a list of values, or a range FROM..TO; several keys")
      ->required();
  add.number("--points", options.points, 2, 1000, "11", "N", "values of a range, with both ends");
  add.text("--csv", options.csv, "X.csv", "write all values of the cycles as CSV, SI units");
  add_threads(add, options.threads);
  add.json(options.summary, "print settings and values as JSON, SI units, instead of the table");
}

}  // namespace

void add_sweep_command(Program& program) {
  program.add("sweep", "Compute a case over values of one key or several, and print a table", kSweepFooter,
              declare_sweep, sweep);
}

}  // namespace ringfilm::app
