#pragma once
#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ringfilm/base/members.hpp"
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
/// The variable of a member of a record.
template <class Record, class Value>
cycle::Quantity described(const std::string& prefix, const Member<Record, Value>& member) {
  return described(prefix + member.name, member.unit, member.long_name, member.symbol, member.equation);
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

/// What a file holds for a member of each row, or of a part of each.
template <class Row, class Base, class Value, class Part>
auto stored_column(const std::vector<Row>& rows, Value Base::*member, const Part& part) {
  std::vector<std::decay_t<decltype(stored(std::declval<const Value&>()))>> values;
  for (const Row& row : rows) values.push_back(stored(part(row).*member));
  return values;
}

/// Each of `values` as the scalar variable `prefix`name, described where `known` has its name.
template <class File, class Values>
void exchange_scalars(File& file, const std::string& prefix, const std::vector<cycle::Quantity>& known,
                      Values& values) {
  if constexpr (File::kReads) {
    file.scalars(prefix, values);
  } else {
    for (const auto& [name, value] : values) {
      const auto match = std::find_if(known.begin(), known.end(),
                                      [&of = name](const cycle::Quantity& quantity) { return quantity.name == of; });
      cycle::Quantity variable = match == known.end() ? cycle::Quantity{} : *match;
      variable.name = prefix + name;
      file.scalar(variable, value);
    }
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

/// The members of `Record` as columns of rows that exist, each by its name behind the prefix.
/// @param part returns the part of a row that is a `Record`
template <class Record, class File, class Rows, class Part = std::identity>
void exchange_members(File& file, const char* dimension, const std::string& prefix, Rows& rows, const Part& part = {}) {
  for_each_member<Record>(
      [&](const auto& member) { file.column(dimension, described(prefix, member), rows, member.value, part); });
}

/// Records as rows of a dimension.
template <class File, class Rows>
void exchange_rows(File& file, const char* dimension, const std::string& prefix, Rows& rows) {
  file.rows(dimension, rows);
  exchange_members<typename Rows::value_type>(file, dimension, prefix, rows);
}

/// An array that a file may lack: nothing is written of an empty one.
template <class File, class Values>
void exchange_present(File& file, const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                      Values& values) {
  if constexpr (File::kReads) {
    if (file.has_variable(quantity.name)) file.numbers(dimensions, quantity, values);
  } else {
    if (!values.empty()) file.numbers(dimensions, quantity, values);
  }
}

/// The notes, as result files and files of the gas have them.
/// @param of_input those of reading the case @param of_result those on the result
template <class File, class Texts, class Notes>
void exchange_notes(File& file, Texts& of_input, Notes& of_result) {
  file.texts("input_note", text("input_note_message", "note on the input files of the case"), of_input);
  exchange_rows(file, "note", "note_", of_result);
}

}  // namespace ringfilm::io
