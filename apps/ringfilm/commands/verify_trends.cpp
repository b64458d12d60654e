#include "commands/verify_trends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "faults.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/io/verification/trends_file.hpp"
#include "ringfilm/report/trends_json.hpp"
#include "ringfilm/run/trends.hpp"

namespace ringfilm::app {
namespace {

using study::Agreement;
using study::InexpressibleTrend;
using study::Trend;
using study::TrendExpectation;
using study::TrendOutcome;

bool has_part(const std::string& id, const std::vector<std::string>& filters) {
  return filters.empty() || std::any_of(filters.begin(), filters.end(),
                                        [&](const std::string& part) { return id.find(part) != std::string::npos; });
}

/// The shipped trends, of those that cannot be expressed the selected ones.
study::TrendList selected_trends(const std::vector<std::string>& filters, const io::Units& units) {
  study::TrendList list = io::read_trends(io::trends_path(), units);
  Faults faults;
  for (const std::string& filter : filters) {
    const auto matches = [&](const auto& trend) { return trend.id.find(filter) != std::string::npos; };
    if (std::any_of(list.trends.begin(), list.trends.end(), matches) ||
        std::any_of(list.inexpressible.begin(), list.inexpressible.end(), matches))
      continue;
    faults.refuse("no trend has " + filter + " in its id", "ringfilm verify --trends --list prints their ids");
  }
  faults.check();
  std::erase_if(list.inexpressible, [&](const InexpressibleTrend& trend) { return !has_part(trend.id, filters); });
  return list;
}

/// "rises", "from 1 um to 3.5 um", ...
std::string expected_words(const TrendOutcome& outcome, const io::Units& units) {
  const Trend& trend = outcome.trend;
  const auto shown = [&](double value) {
    return units.shown(value, outcome.quantity.unit, outcome.quantity.display_unit, 3);
  };
  switch (trend.expectation) {
    case TrendExpectation::kHasMinimumInside:
      return "has its minimum inside";
    case TrendExpectation::kLargerChangeThan:
      return "changes more than in " + trend.than;
    case TrendExpectation::kWithin:
      return "lies between " + shown(trend.least_limit) + " and " + shown(trend.most_limit);
    case TrendExpectation::kUnchanged:
      return fmt::format("is unchanged within {:.3g} %", 100 * trend.least_change);
    default:
      return study::word_of(study::trend_expectations(), trend.expectation);
  }
}

std::string quantity_words(const TrendOutcome& outcome) {
  const auto& ring = outcome.trend.probe.ring;
  const auto& window = outcome.trend.probe.window;
  std::string words = outcome.quantity.long_name;
  if (ring) words += fmt::format(" of ring {}", *ring);
  if (window) words += fmt::format(", {:g} to {:g} degree", window->from_deg, window->to_deg);
  return words;
}

std::string computed_words(const TrendOutcome& outcome, const io::Units& units) {
  std::vector<std::string> levels;
  for (std::size_t i = 0; i < outcome.values.size(); ++i) {
    const double value = outcome.values[i];
    const std::string number =
        std::isnan(value) ? "none" : units.shown(value, outcome.quantity.unit, outcome.quantity.display_unit, 3);
    levels.push_back(outcome.trend.levels[i].name + ": " + number);
  }
  const bool changes = levels.size() > 1 && !std::isnan(outcome.change);
  return joined(levels, ", ") + (changes ? fmt::format(" ({:+.1f} %)", 100 * outcome.change) : "");
}

void print_line(const char* head, const std::string& text) { std::cout << fmt::format("  {:<11}{}\n", head, text); }

void print_statement(const std::string& statement, const std::string& size, const std::string& source) {
  print_line("published", statement + (size.empty() ? "" : "; " + size));
  print_line("source", source);
}

void print_trend(const TrendOutcome& outcome, const io::Units& units) {
  const Trend& trend = outcome.trend;
  const std::string recorded = study::word_of(study::agreements(), trend.known);
  const std::string word = study::word_of(study::agreements(), outcome.found);
  const std::string verdict = !outcome.stops.empty()     ? "NO SOLUTION"
                              : outcome.is_as_recorded() ? word
                                                         : word + ", NOT AS RECORDED (" + recorded + ")";
  std::cout << trend.id << ": " << verdict << "\n";
  print_statement(trend.statement, trend.size, trend.source);
  print_line("compared", quantity_words(outcome) + " " + expected_words(outcome, units));
  print_line("computed", trend.base + ", " + computed_words(outcome, units));
  print_line("assumed", trend.assumed);
  if (!trend.reason.empty()) print_line("reason", trend.reason);
  for (const std::string& stop : outcome.stops) print_line("stopped", stop);
  std::cout << "\n" << std::flush;
}

void print_inexpressible(const std::vector<InexpressibleTrend>& trends) {
  for (const InexpressibleTrend& trend : trends) {
    std::cout << trend.id << ": cannot be expressed\n";
    print_statement(trend.statement, "", trend.source);
    print_line("reason", trend.reason);
    std::cout << "\n";
  }
}

std::string totals(const std::vector<TrendOutcome>& outcomes, std::size_t n_inexpressible) {
  const auto n_agree = std::count_if(outcomes.begin(), outcomes.end(), [](const TrendOutcome& outcome) {
    return outcome.stops.empty() && outcome.found == Agreement::kAgrees;
  });
  const auto n_recorded = std::count_if(outcomes.begin(), outcomes.end(),
                                        [](const TrendOutcome& outcome) { return outcome.is_as_recorded(); });
  return fmt::format("{} of {} trends agree, {} are as recorded; {} cannot be expressed\n", n_agree, outcomes.size(),
                     n_recorded, n_inexpressible);
}

}  // namespace

void list_trends(const std::vector<std::string>& filters) {
  const study::TrendList list = selected_trends(filters, io::Units());
  const auto print = [](const auto& trend) { std::cout << fmt::format("{:<36}{}\n", trend.id, trend.statement); };
  for (const Trend& trend : list.trends) {
    if (has_part(trend.id, filters)) print(trend);
  }
  for (const InexpressibleTrend& trend : list.inexpressible) print(trend);
}

void verify_trends(const std::vector<std::string>& filters, SummaryForm summary) {
  const io::Units units;
  const study::TrendList list = selected_trends(filters, units);
  const bool is_table = summary == SummaryForm::kTable;
  const auto print = [&](const TrendOutcome& outcome) {
    if (is_table) print_trend(outcome, units);
  };
  const std::vector<TrendOutcome> outcomes = run::run_trends(
      list, [&](const std::string& id) { return has_part(id, filters); }, print);
  if (is_table) {
    print_inexpressible(list.inexpressible);
    std::cout << totals(outcomes, list.inexpressible.size());
  } else {
    std::cout << ringfilm::report::trends_json(outcomes, list.inexpressible, io::this_program());
  }
  const bool as_recorded = std::all_of(outcomes.begin(), outcomes.end(),
                                       [](const TrendOutcome& outcome) { return outcome.is_as_recorded(); });
  if (!as_recorded) throw FailedChecks("the outcome of a trend is not the recorded one");
}

}  // namespace ringfilm::app
