#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/ensemble/ledger.hpp"

/// A result beside published statements.
namespace ringfilm::study {

/// A number (or a statement in words) that a publication makes about a cycle.
struct PublishedValue {
  std::string source;      ///< "paper, section 4" or "independent model"
  std::string quantity;    ///< name from cycle_quantities()
  std::string statement;   ///< in words, e.g. "lambda ratio at peak cylinder pressure"
  double value = 0;        ///< [SI]
  std::string decided_by;  ///< inputs that the source leaves open and that move this value
};

/// One row of the comparison table.
struct ComparisonRow {
  PublishedValue published;
  double computed = 0;   ///< [SI]
  double deviation = 0;  ///< (computed - published)/published [-]
  /// Ledger variant that comes closest to the published value; empty without ledger, where none comes closer than the
  /// result, and where the deviation is 1 % or less.
  std::string strongest_setting;
  std::optional<double> with_strongest_setting;  ///< the value with it [SI]
};

/// One row per published value. Throws InputError for a quantity that is not a cycle value.
std::vector<ComparisonRow> compare(const cycle::CycleResult& result, const std::vector<PublishedValue>& published,
                                   const std::vector<LedgerEntry>& ledger);

}  // namespace ringfilm::study
