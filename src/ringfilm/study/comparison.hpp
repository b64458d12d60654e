#pragma once
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
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

/// The members of a published value, as all outputs have them.
constexpr auto members(const PublishedValue*) {
  using P = PublishedValue;
  return std::tuple{Member{"source", "", "source of the statement", &P::source},
                    Member{"quantity", "", "cycle quantity", &P::quantity},
                    Member{"statement", "", "statement", &P::statement},
                    Member{"published", "", "published value; unit in comparison_unit", &P::value},
                    Member{"decided_by", "", "inputs that the source leaves open", &P::decided_by}};
}

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

/// The members of a row beyond those of its published value, as all outputs have them.
constexpr auto members(const ComparisonRow*) {
  using R = ComparisonRow;
  return std::tuple{
      Member{"computed", "", "computed value; unit in comparison_unit", &R::computed},
      Member{"deviation", "1", "(computed - published)/published", &R::deviation},
      Member{"strongest_setting", "", "ledger variant that comes closest", &R::strongest_setting},
      Member{"with_strongest_setting", "", "value with it, NaN where there is none; unit in comparison_unit",
             &R::with_strongest_setting}};
}

/// One row per published value. Throws InputError for a quantity that is not a cycle value.
std::vector<ComparisonRow> compare(const cycle::CycleResult& result, const std::vector<PublishedValue>& published,
                                   const std::vector<LedgerEntry>& ledger);

}  // namespace ringfilm::study
