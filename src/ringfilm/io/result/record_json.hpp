#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/io/result/input_members.hpp"
#include "ringfilm/io/result/result_file.hpp"

/// Records as JSON: every member by its name.
namespace ringfilm::io {

/// The value of a member; null for one that is absent.
template <class Value>
nlohmann::ordered_json json_value(const Value& value) {
  return value;
}
template <class Value>
nlohmann::ordered_json json_value(const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// Puts the members of a record into an object.
template <class Record>
void put_members(const Record& record, nlohmann::ordered_json& object) {
  for_each_member<Record>([&](const auto& member) { object[member.name] = json_value(record.*member.value); });
}

/// A record as an object of its members.
template <class Record>
nlohmann::ordered_json record_object(const Record& record) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  put_members(record, object);
  return object;
}

/// Records as a list of objects.
template <class Record>
nlohmann::ordered_json record_array(const std::vector<Record>& records) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Record& record : records) list.push_back(record_object(record));
  return list;
}

/// The units of the members of a record that have one.
template <class Record>
void put_member_units(nlohmann::ordered_json& units) {
  for_each_member<Record>([&](const auto& member) {
    if (*member.unit != '\0') units[member.name] = member.unit;
  });
}

/// Puts the values of a table of quantities into an object; what is absent is omitted.
template <class Quantities, class Row>
void put_quantities(const Quantities& quantities, const Row& row, nlohmann::ordered_json& object) {
  for (const auto& quantity : quantities) {
    const auto put = [&](auto member) {
      const auto& value = row.*member;
      if constexpr (requires { value.has_value(); }) {
        if (value) object[quantity.name] = *value;
      } else {
        object[quantity.name] = value;
      }
    };
    if constexpr (requires { quantity.value.index(); }) {
      std::visit(put, quantity.value);
    } else {
      put(quantity.value);
    }
  }
}

/// The values of a table of quantities as an object.
template <class Quantities, class Row>
nlohmann::ordered_json quantities_object(const Quantities& quantities, const Row& row) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  put_quantities(quantities, row, object);
  return object;
}

/// Puts the units of a table of quantities into an object.
template <class Quantities>
void put_units(const Quantities& quantities, nlohmann::ordered_json& units) {
  for (const cycle::Quantity& quantity : quantities) units[quantity.name] = quantity.unit;
}

/// The notes of reading a case, of the topic "input", and those on its result.
nlohmann::ordered_json notes_array(const std::vector<std::string>& of_input, const std::vector<cycle::Note>& of_result);

/// The keys that a case does not state, with the values in use as people read them.
nlohmann::ordered_json assumed_object(const std::vector<CaseEntry>& inputs);

/// Puts what computed a result into its object; what is not known is omitted.
void put_provenance(const Provenance& provenance, nlohmann::ordered_json& object);

/// The text of a JSON file. A title in another encoding than UTF-8 must not lose the result.
std::string json_text(const nlohmann::ordered_json& object);

}  // namespace ringfilm::io
