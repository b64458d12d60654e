#pragma once
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "ringfilm/base/display.hpp"
#include "ringfilm/case/case.hpp"

/// Other settings of the keys of a case, written and applied by the one table of keys (cycle/case/case_fields.hpp).
/// None of them is the case itself, leaves the range of its key or breaks a rule that joins several keys.
namespace ringfilm::study {

/// Another setting for a case: how one would write it, and what it does to the case.
struct Alternative {
  std::string setting;  ///< "film.cavitation = \"mass-conserving\""
  std::function<void(cycle::Case&)> apply;
};

/// Name of the choice that `c` makes for `key`.
std::string chosen(const std::string& key, const cycle::Case& c);

/// The choices of `key` that `c` does not make.
std::vector<Alternative> other_choices(const std::string& key, const cycle::Case& c);

/// Other values [SI] of `key`, each rounded to four digits in `unit` before it is applied: what a setting states is
/// what is run. Values within a thousandth of `in_use` [SI] are omitted.
std::vector<Alternative> other_numbers(const std::string& key, const cycle::Case& c, double in_use,
                                       const DisplayUnit& unit, std::initializer_list<double> values);

/// `value`, or `instead` if the case uses `value` already.
double other_than(double in_use, double value, double instead);

}  // namespace ringfilm::study
