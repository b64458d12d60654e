#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "commands/commands.hpp"
#include "output_names.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/io/verification/verification_file.hpp"
#include "ringfilm/report/verification_page.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;
using study::Tolerance;
using study::Verdict;

/// The folders asked for, in the order of the shipped ones; all if none is named.
std::vector<std::string> chosen_folders(const std::vector<std::string>& names) {
  const std::vector<std::string> all = io::verification_folders();
  const auto name_of = [](const std::string& folder) { return fs::path(folder).filename().string(); };
  std::vector<Fault> faults;
  for (const std::string& name : names) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const auto& folder) { return name_of(folder) == name; });
    if (!known)
      faults.push_back({{}, "no verification is called " + name, "ringfilm verify --list prints their names"});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  std::vector<std::string> chosen;
  for (const std::string& folder : all) {
    if (names.empty() || std::find(names.begin(), names.end(), name_of(folder)) != names.end()) {
      chosen.push_back(folder);
    }
  }
  return chosen;
}

/// The page must not replace what the checks are read from.
void check_apart(const std::string& output, const std::vector<std::string>& folders) {
  const fs::path place = fs::weakly_canonical(fs::absolute(output)).parent_path();
  std::vector<Fault> faults;
  for (const std::string& folder : folders) {
    if (fs::weakly_canonical(folder) != place) continue;
    faults.push_back(
        {{}, "--output " + output + ": this folder holds what the checks are read from", "name another folder"});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

/// A number of a row in the unit that people read.
std::string shown(const study::VerificationRow& row, double value, int digits, const io::Units& units) {
  if (std::isnan(value)) return "none";
  const double converted = units.scale(row.display_unit, row.unit).from_si(value);
  const std::string number = fmt::format("{:.{}g}", converted, digits);
  return row.display_unit == "1" ? number : number + " " + row.display_unit;
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

}  // namespace

void verify(const VerifyOptions& options) {
  if (options.requested == VerifyRequest::kNames) return print_list();
  const std::vector<std::string> folders = chosen_folders(options.names);
  const io::Units units;
  if (options.output) {
    io::check_can_write(*options.output, io::Sink::kFileOrDevice);
    check_apart(*options.output, folders);
    check_suffix("--output", *options.output, OutputKind::kPage);
  }
  const std::vector<io::OutputClaim> claimed = claims({options.output});
  std::vector<study::Verification> verifications;
  for (const std::string& folder : folders) verifications.push_back(io::read_verification(folder, units));
  ringfilm::report::VerificationResult result{{}, {}, io::this_program()};
  if (options.names.empty()) {
    result.not_covered =
        io::read_not_covered((fs::path(io::shipped_folder()) / "verification" / "not-covered.toml").string(), units);
  }
  const bool in_words = options.requested == VerifyRequest::kTable;
  if (in_words) {
    std::cout << fmt::format("  {:<52}{:>20}{:>20}{:>14}{:>14}  {}\n", "check", "expected", "got", "error", "tolerance",
                             "verdict");
  }
  for (const study::Verification& verification : verifications) {
    result.cases.push_back(study::verify(verification));
    if (in_words) print_case(result.cases.back(), units);
  }
  const bool holds = std::all_of(result.cases.begin(), result.cases.end(),
                                 [](const auto& outcome) { return outcome.verdict() == Verdict::kHolds; });
  if (in_words) {
    print_not_covered(result.not_covered);
    std::cout << totals(result.cases);
  } else {
    std::cout << ringfilm::report::verification_json(result);
  }
  if (options.output) {
    io::write_atomically(*options.output, ringfilm::report::verification_page(result));
    if (in_words) std::cout << "wrote " << *options.output << "\n";
  }
  if (!holds) throw FailedChecks("a number differs from its expected value");
}

}  // namespace ringfilm::app
