#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "ringfilm/io/case/case_file.hpp"

/// Cases that differ in the values of some keys, of `gas --vary` and `sweep`.
namespace ringfilm::app {

/// A key and its values, of `KEY=VALUE, VALUE, ...` or `KEY=FROM..TO`.
struct Variation {
  std::string key;
  std::vector<std::string> values;  ///< as a setting has them, with their units
};

/// How a command has its variations.
struct VariationForm {
  std::string label;         ///< before the text in messages: "--vary "
  std::string example;       ///< what a key with its values looks like
  std::size_t n_points = 0;  ///< values of a range FROM..TO, with both ends; 0: ranges are refused
};

/// Bare numbers of a key with a dimension have the unit in which `ringfilm fields` shows it. Throws InputError where a
/// text is not of that form, or a key is varied twice.
std::vector<Variation> variations(const std::vector<std::string>& texts, const VariationForm& form);

/// A text as a cell of CSV.
std::string quoted_cell(const std::string& text);

/// Number of the combinations. Throws InputError where they are too many.
std::size_t n_combinations(const std::vector<Variation>& varied, const VariationForm& form);

/// The settings of a combination, by its number; the last key changes fastest.
std::vector<io::Override> combination(const std::vector<Variation>& varied, std::size_t number,
                                      const VariationForm& form);

/// A case of each combination; whatever is wrong with one is reported before anything is computed. Prints once which
/// keys of the file the values make unused.
std::vector<cycle::Case> cases_of(const std::string& path, const std::vector<io::Override>& overrides,
                                  const std::vector<Variation>& varied, const VariationForm& form,
                                  cycle::CasePurpose purpose);

}  // namespace ringfilm::app
