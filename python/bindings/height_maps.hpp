#pragma once
#include <map>
#include <string>

#include "bindings.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography.hpp"

/// Height maps as numpy has them: rows along y, columns along x, NaN where nothing was measured.
namespace ringfilm::python {

using Heights = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// @param heights of shape (y, x), or (x,) for a profile [m]
/// @param step between points, one number or (step_x, step_y) [m]
surface::HeightMap height_map(const Heights& heights, const py::object& step);

/// The heights in the shape in which they came.
py::array heights_of(const surface::HeightMap& map, const Heights& like);
/// As (y, x), a profile as (x,).
py::array heights_of(const surface::HeightMap& map);

/// One of a few words, as messages have it.
template <class Choice>
Choice chosen(const std::string& what, const std::string& word, const std::map<std::string, Choice>& choices) {
  const auto found = choices.find(word);
  if (found != choices.end()) return found->second;
  std::string names;
  for (const auto& [name, choice] : choices) names += (names.empty() ? "\"" : ", \"") + name + "\"";
  throw InputError(what + " = \"" + word + "\" is not known", "choose one of " + names);
}

std::vector<double> numbers_of(const Heights& array);
py::array array_of(const std::vector<double>& values);

}  // namespace ringfilm::python
