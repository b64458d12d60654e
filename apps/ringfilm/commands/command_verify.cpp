#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "commands/commands.hpp"
#include "commands/verify_trends.hpp"
#include "output_names.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/io/verification/verification_file.hpp"
#include "ringfilm/report/verification_page.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;
using study::Tolerance;
using study::Verdict;

enum class VerifyRequest { kTable, kJson, kNames };
enum class VerifySubject { kKnownAnswers, kTrends };

struct VerifyOptions {
  std::vector<std::string> names;     ///< folders of verification/, or parts of ids of trends; empty: all
  std::optional<std::string> output;  ///< web page
  VerifyRequest requested = VerifyRequest::kTable;
  VerifySubject subject = VerifySubject::kKnownAnswers;
};

/// The folders asked for, in the order of the shipped ones; all if none is named.
std::vector<std::string> chosen_folders(const std::vector<std::string>& names) {
  const std::vector<std::string> all = io::verification_folders();
  const auto name_of = [](const std::string& folder) { return fs::path(folder).filename().string(); };
  Faults faults;
  for (const std::string& name : names) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const auto& folder) { return name_of(folder) == name; });
    if (!known) faults.refuse("no verification is called " + name, "ringfilm verify --list prints their names");
  }
  faults.check();
  std::vector<std::string> chosen;
  for (const std::string& folder : all) {
    if (names.empty() || std::find(names.begin(), names.end(), name_of(folder)) != names.end()) {
      chosen.push_back(folder);
    }
  }
  return chosen;
}

/// The page must not replace what the checks are read from.
void check_page(const NamedOutput& page, const std::vector<std::string>& folders) {
  if (!page.path) return;
  Faults faults;
  check_names({page}, faults);
  const fs::path place = fs::weakly_canonical(fs::absolute(*page.path)).parent_path();
  for (const std::string& folder : folders) {
    if (fs::weakly_canonical(folder) != place) continue;
    faults.refuse("--output " + *page.path + ": this folder holds what the checks are read from",
                  "name another folder");
  }
  faults.check();
}

/// A number of a row in the unit that people read.
std::string shown(const study::VerificationRow& row, double value, int digits, const io::Units& units) {
  return std::isnan(value) ? "none" : units.shown(value, row.unit, row.display_unit, digits);
}

/// An error or a tolerance: a share in per cent, or an amount.
std::string shown_error(const study::VerificationRow& row, double error, const io::Units& units) {
  if (std::isnan(error)) return "none";
  constexpr double kRounding = 1e-12;  // digits below are those of the machine
  if (row.tolerance.kind == Tolerance::Kind::kRelative) {
    return error < kRounding ? "< 1e-10 %" : fmt::format("{:.2g} %", 100 * error);
  }
  return shown(row, error, 2, units);
}

void print_case(const study::VerificationOutcome& outcome, const io::Units& units) {
  std::cout << outcome.name << ": " << outcome.title << "\n";
  for (const study::VerificationRow& row : outcome.rows) {
    std::cout << fmt::format("  {:<52}{:>20}{:>20}{:>14}{:>14}  {}\n", row.label, shown(row, row.expected, 7, units),
                             shown(row, row.got, 7, units), shown_error(row, row.error, units),
                             shown_error(row, row.tolerance.value, units),
                             row.verdict == Verdict::kHolds ? "holds" : "FAILS");
  }
  for (const std::string& stop : outcome.stops) std::cout << "  NO SOLUTION: " << stop << "\n";
  std::cout << "\n" << std::flush;
}

void print_list() {
  const io::Units units;
  for (const std::string& folder : io::verification_folders()) {
    const study::Verification verification = io::read_verification(folder, units);
    std::cout << fmt::format("{:<34}{}\n", verification.name, verification.title);
  }
}

void print_not_covered(const std::vector<study::NotCovered>& all) {
  if (all.empty()) return;
  std::cout << "NOT COVERED by this version, and not counted:\n";
  for (const auto& [what, reason] : all) std::cout << "  " << what << ": " << reason << "\n";
  std::cout << "\n";
}

std::string totals(const std::vector<study::VerificationOutcome>& cases) {
  std::size_t n_rows = 0, n_held = 0;
  for (const auto& outcome : cases) {
    for (const auto& row : outcome.rows) {
      ++n_rows;
      n_held += row.verdict == Verdict::kHolds;
    }
  }
  return fmt::format("{} of {} checks hold in {} {}\n", n_held, n_rows, cases.size(),
                     cases.size() == 1 ? "case" : "cases");
}

/// Runs the shipped cases with known answers. Throws FailedChecks.
void verify_known_answers(const VerifyOptions& options) {
  if (options.requested == VerifyRequest::kNames) return print_list();
  const std::vector<std::string> folders = chosen_folders(options.names);
  const io::Units units;
  const NamedOutput page{"--output", options.output, OutputKind::kPage, io::Sink::kFileOrDevice};
  check_page(page, folders);
  const std::vector<io::OutputClaim> claimed = claims({page});
  std::vector<study::Verification> verifications;
  for (const std::string& folder : folders) verifications.push_back(io::read_verification(folder, units));
  ringfilm::report::VerificationResult result{{}, {}, io::this_program()};
  if (options.names.empty()) {
    result.not_covered =
        io::read_not_covered((fs::path(io::shipped_folder()) / "verification" / "not-covered.toml").string(), units);
  }
  const bool is_table = options.requested == VerifyRequest::kTable;
  if (is_table) {
    std::cout << fmt::format("  {:<52}{:>20}{:>20}{:>14}{:>14}  {}\n", "check", "expected", "got", "error", "tolerance",
                             "verdict");
  }
  for (const study::Verification& verification : verifications) {
    result.cases.push_back(study::verify(verification));
    if (is_table) print_case(result.cases.back(), units);
  }
  const bool holds = std::all_of(result.cases.begin(), result.cases.end(),
                                 [](const auto& outcome) { return outcome.verdict() == Verdict::kHolds; });
  if (is_table) {
    print_not_covered(result.not_covered);
    std::cout << totals(result.cases);
  } else {
    std::cout << ringfilm::report::verification_json(result);
  }
  if (options.output) {
    io::write_atomically(*options.output, ringfilm::report::verification_page(result));
    if (is_table) print_written({page});
  }
  if (!holds) throw FailedChecks("a number differs from its expected value");
}

void verify(const VerifyOptions& options) {
  if (options.subject == VerifySubject::kKnownAnswers) return verify_known_answers(options);
  if (options.requested == VerifyRequest::kNames) return list_trends(options.names);
  verify_trends(options.names, options.requested == VerifyRequest::kJson ? SummaryForm::kJson : SummaryForm::kTable);
}

constexpr const char* kVerifyFooter = R"(Examples:
  ringfilm verify
  ringfilm verify --list
  ringfilm verify rayleigh1918_step ausas2009_oscillating_squeeze
  ringfilm verify --output verification.html
  ringfilm verify --trends
  ringfilm verify --trends friction-speed friction-oil

Each case is computed here and now beside an answer that is known from elsewhere: a closed form, a quadrature, a
publication, an independent program. The exit code is 4 if a number lies outside its tolerance.
--trends computes published trends of measured rings instead, in a minute. Those that disagree are recorded with their
reason: the exit code is 4 if an outcome is not the recorded one.
)";

void declare_verify(CommandOptions& add, VerifyOptions& options) {
  add.text("NAME", options.names, "...", "cases to check, or parts of the ids of trends; all if none is named");
  const CLI::Option* list =
      add.flag("--list", options.requested, VerifyRequest::kNames, "print the names of the cases, compute nothing");
  add.flag("--json", options.requested, VerifyRequest::kJson, "print the rows as JSON, SI units, instead of the table");
  const CLI::Option* trends = add.flag("--trends", options.subject, VerifySubject::kTrends,
                                       "compute published trends of measured rings instead");
  const CLI::Option* output = add.text("-o,--output,--html", options.output, "X.html", "write the same as a web page");
  add.rule([list, trends, output, &options](Faults& faults) {
    if (is_stated(list)) options.requested = VerifyRequest::kNames;  // with --json, too
    if (is_stated(trends) && is_stated(output)) faults.refuse("--trends has no page", "remove --output");
  });
}

}  // namespace

void add_verify_command(Program& program) {
  program.add("verify", "Compute cases with known answers and report how far off they are", kVerifyFooter,
              declare_verify, verify);
}

}  // namespace ringfilm::app
