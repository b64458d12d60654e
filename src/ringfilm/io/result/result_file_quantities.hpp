#pragma once
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

/// Descriptions of the variables of a result file that are not in a table of cycle/result.hpp.
namespace ringfilm::io {

/// Plain description of a variable that is not a quantity of the tables in cycle/result.hpp.
inline cycle::Quantity described(std::string name, std::string unit, std::string long_name, std::string symbol = "",
                                 std::string equation = "") {
  return {std::move(name), std::move(unit), "", std::move(long_name), std::move(symbol), std::move(equation)};
}
inline cycle::Quantity count(std::string name, std::string long_name) {
  return described(std::move(name), "1", std::move(long_name));
}
inline cycle::Quantity text(std::string name, std::string long_name) {
  return described(std::move(name), "", std::move(long_name));
}
/// The value of the cycle as a whole beside the curve of the same name.
inline cycle::Quantity cycle_variable(cycle::Quantity quantity) {
  quantity.name = "cycle_" + quantity.name;
  return quantity;
}

/// The discretisation error beside a quantity.
inline cycle::Quantity error_variable(cycle::Quantity quantity) {
  quantity.name += "_error";
  quantity.long_name = "discretisation error of " + quantity.long_name;
  quantity.equation = "eq-grid-error";
  return quantity;
}
/// The order of convergence seen in a quantity, `in` cells or step.
inline cycle::Quantity order_variable(const cycle::Quantity& quantity, const std::string& in) {
  return described(quantity.name + "_order_in_" + in, "1",
                   "order of convergence in " + in + " of " + quantity.long_name + ", NaN where it is not monotone",
                   "p", "eq-observed-order");
}

// What a file holds for a value of that type.
inline const std::string& stored(const std::string& text) { return text; }
inline signed char stored(const bool& value) { return value ? 1 : 0; }
inline long stored(const long& value) { return value; }
inline double stored(const double& value) { return value; }
inline double stored(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// Hands each of `values` to `put(quantity, value)` as the variable `prefix`name, described where `known` has its name.
template <class Put>
void put_scalars(const std::string& prefix, const std::vector<cycle::Quantity>& known,
                 const std::map<std::string, double>& values, const Put& put) {
  for (const auto& [name, value] : values) {
    const auto match = std::find_if(known.begin(), known.end(),
                                    [&of = name](const cycle::Quantity& quantity) { return quantity.name == of; });
    cycle::Quantity variable = match == known.end() ? cycle::Quantity{} : *match;
    variable.name = prefix + name;
    put(variable, value);
  }
}

/// Where the i-th entry of an array of `lengths` is in one of the larger `shape`, both row-major.
inline std::size_t place_in(std::size_t i, const std::vector<std::size_t>& lengths,
                            const std::vector<std::size_t>& shape) {
  std::size_t place = 0, stride = 1;
  for (std::size_t d = lengths.size(); d-- > 0;) {
    place += i % lengths[d] * stride;
    i /= lengths[d];
    stride *= shape[d];
  }
  return place;
}

/// The notes, as result files and files of the gas have them.
/// @param of_input those of reading the case @param of_result those on the result
template <class File, class Texts, class Notes>
void exchange_notes(File& file, Texts& of_input, Notes& of_result) {
  file.texts("input_note", text("input_note_message", "note on the input files of the case"), of_input);
  file.rows("note", of_result);
  file.column("note", text("note_topic", "stable word for the note"), of_result, &cycle::Note::topic);
  file.column("note", text("note_message", "what the user must know about this result"), of_result,
              &cycle::Note::message);
  file.column("note", count("note_count", "crank steps or evaluations concerned"), of_result, &cycle::Note::count);
}

}  // namespace ringfilm::io
