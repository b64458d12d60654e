#include "ringfilm/io/verification/published_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "ringfilm/base/renamed.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {
namespace {

constexpr std::array kTextKeys = {"case", "source", "quantity", "statement", "decided_by"};

const TomlValue* find_member(const TomlValue& table, const std::string& key) {
  for (const auto& [name, value] : table.members) {
    if (name == key) return &value;
  }
  return nullptr;
}

std::string text_of(const TomlValue& table, const std::string& key, std::vector<Fault>& faults) {
  const TomlValue* value = find_member(table, key);
  if (value == nullptr) {
    faults.push_back({table.mark, "published." + key + " is missing", ""});
  } else if (value->kind != TomlValue::Kind::kText) {
    faults.push_back({value->mark, "published." + key + " = " + value->as_written() + " is not a text", ""});
  } else {
    return value->text;
  }
  return "";
}

/// The value in SI; a relative deviation must be possible, so it is not zero.
double number_of(const TomlValue& table, const std::string& si_unit, const Units& units, std::vector<Fault>& faults) {
  const TomlValue* value = find_member(table, "value");
  if (value == nullptr) {
    faults.push_back({table.mark, "published.value is missing", ""});
    return 0;
  }
  const bool is_plain = value->kind == TomlValue::Kind::kNumber || value->kind == TomlValue::Kind::kInteger;
  double number = 0;
  try {
    if (is_plain && si_unit == "1") number = value->number;
    if (value->kind == TomlValue::Kind::kText)
      number = units.quantity(value->text, si_unit, si_unit == "1" ? "0.12" : "118 W");
  } catch (const UnitError& problem) {
    faults.push_back({value->mark, "published.value = " + value->as_written() + " " + problem.what(), problem.remedy});
    return 0;
  }
  if (number == 0) {
    faults.push_back({value->mark, "published.value = " + value->as_written() + " is not a number to compare with",
                      si_unit == "1" ? "a number other than 0 is required" : "a number with unit is required, not 0"});
  }
  return number;
}

std::string unit_of_column(const TomlValue& table, const std::string& quantity, std::vector<Fault>& faults) {
  for (const auto& candidate : cycle::cycle_quantities()) {
    if (candidate.name == quantity) return candidate.unit;
  }
  if (!quantity.empty()) {
    const std::string present(present_name(quantity));
    faults.push_back(
        {table.mark, "published.quantity = \"" + quantity + "\" is not a cycle value",
         present.empty() ? "the names are those of ringfilm run --json" : "did you mean " + present + "?"});
  }
  return "1";
}

void refuse_unknown_keys(const TomlValue& table, std::vector<Fault>& faults) {
  for (const auto& [key, value] : table.members) {
    if (key != "value" && std::find(kTextKeys.begin(), kTextKeys.end(), key) == kTextKeys.end()) {
      faults.push_back({value.key_mark, "unknown key published." + key, ""});
    }
  }
}

}  // namespace

std::vector<study::PublishedValue> read_published(const std::string& path, const std::string& case_name,
                                                  const Units& units) {
  const TomlValue root = parse_toml(read_source_text(path, path, kLargestToml));
  std::vector<Fault> faults;
  std::vector<study::PublishedValue> values;
  const TomlValue* tables = find_member(root, "published");
  if (tables == nullptr || tables->kind != TomlValue::Kind::kList) {
    throw InputError(path + ": there is no table [[published]]");
  }
  for (const TomlValue& table : tables->items) {
    refuse_unknown_keys(table, faults);
    study::PublishedValue published;
    const std::string of_case = text_of(table, "case", faults);
    published.source = text_of(table, "source", faults);
    published.quantity = text_of(table, "quantity", faults);
    published.statement = text_of(table, "statement", faults);
    published.decided_by = text_of(table, "decided_by", faults);
    published.value = number_of(table, unit_of_column(table, published.quantity, faults), units, faults);
    if (of_case == case_name) values.push_back(std::move(published));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return values;
}

}  // namespace ringfilm::io
