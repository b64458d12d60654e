#pragma once
#include <map>
#include <string>

#include "arguments.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/topography.hpp"

/// Height maps as numpy has them: rows along y, columns along x; NaN, or masked, where nothing was measured.
namespace ringfilm::python {

using GivenStep = Given<kinds::NumberOrPair>;

/// @param heights heights in the shape (y, x), or (x,) for a profile [m]
/// @param step between points, one number or (step_x, step_y) [m]
surface::HeightMap height_map(const GivenNumbers& heights, const GivenStep& step);

/// As (y, x); with `as_row` as (x,), of a map of one row.
py::array heights_of(const surface::HeightMap& map, bool as_row);

/// One of a few choices, as messages print it.
template <class Choice>
Choice chosen(const char* what, const GivenText& given, const std::map<std::string, Choice>& choices) {
  const std::string word = text_of(what, given.value, choices.begin()->first.c_str());
  const auto found = choices.find(word);
  if (found != choices.end()) return found->second;
  std::string names;
  for (const auto& [name, choice] : choices) names += (names.empty() ? "\"" : ", \"") + name + "\"";
  throw InputError(std::string(what) + " = \"" + word + "\" is not known", "choose one of " + names);
}

/// The word of a choice.
template <class Choice>
std::string word_of(Choice choice, const std::map<std::string, Choice>& choices) {
  for (const auto& [name, one] : choices) {
    if (one == choice) return name;
  }
  throw std::logic_error("a choice without a word");
}

}  // namespace ringfilm::python
