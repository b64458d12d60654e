#pragma once
#include <type_traits>
#include <vector>

#include "arguments.hpp"
#include "ringfilm/base/members.hpp"

/// Records of C++ whose members are described once (base/members.hpp) as plain objects of Python.
namespace ringfilm::python {

/// The value of a member: lists of numbers are arrays, choices their numbers.
template <class Value>
py::object member_value(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return py::int_(static_cast<int>(value));
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    return array_of(value);
  } else {
    return py::cast(value);
  }
}

/// The member of such a value.
template <class Value>
void restore_member(const py::handle& from, Value& member) {
  if constexpr (std::is_enum_v<Value>) {
    member = static_cast<Value>(py::cast<int>(from));
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    member = pickled_row(from);
  } else {
    member = py::cast<Value>(from);
  }
}

/// All members, {name: value}.
template <class Record>
py::dict members_dict(const Record& record) {
  py::dict values;
  for_each_member<Record>([&](const auto& member) { values[member.name] = member_value(record.*member.value); });
  return values;
}

/// All members in their order.
template <class Record>
py::tuple members_tuple(const Record& record) {
  py::list values;
  for_each_member<Record>([&](const auto& member) { values.append(member_value(record.*member.value)); });
  return py::tuple(values);
}

/// The record of members_dict().
template <class Record>
Record record_of(const py::handle& values) {
  Record record;
  for_each_member<Record>(
      [&](const auto& member) { restore_member(py::object(values[member.name]), record.*member.value); });
  return record;
}

/// A list of members_dict(), and its records.
template <class Record>
py::list members_list(const std::vector<Record>& records) {
  py::list list;
  for (const Record& record : records) list.append(members_dict(record));
  return list;
}
template <class Record>
std::vector<Record> records_of(const py::handle& list) {
  std::vector<Record> records;
  for (const py::handle one : list) records.push_back(record_of<Record>(one));
  return records;
}

}  // namespace ringfilm::python
