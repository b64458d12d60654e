#include "ringfilm/io/text/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ringfilm/io/text/suggestion.hpp"

namespace ringfilm::io {
namespace {

using Kind = TomlValue::Kind;

/// Up to which each whole number is a double.
constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 53;

/// "wear." of "[wear]", "duty.point." of "[[duty.point]]"; empty for a file as a whole, "a study".
std::string prefix_of(std::string name) {
  if (name.find(' ') != std::string::npos) return "";
  std::erase_if(name, [](char c) { return c == '[' || c == ']'; });
  return name + ".";
}

}  // namespace

double quantity_of(const TomlValue& value, const std::string& si_unit, const std::string& example, const Units& units) {
  if (value.kind == Kind::kText) return units.quantity(value.text, si_unit, example);
  const std::string remedy = fmt::format("{} is required here, for example {}", dimension_words(si_unit), example);
  if (!value.is_number()) throw UnitError("is not a quantity", remedy);
  if (!std::isfinite(value.number)) throw UnitError("is not a finite number", "for example " + example);
  if (si_unit != "1") throw UnitError("has no unit", remedy);
  return value.number;
}

void refuse_unknown_keys(const TomlValue& table, const std::string& name, const std::vector<std::string>& known,
                         std::vector<Fault>& faults) {
  for (const auto& [key, value] : table.members) {
    if (std::ranges::find(known, key) != known.end()) continue;
    faults.push_back({value.key_mark, fmt::format("unknown key {} in {}{}", key, name, did_you_mean(key, known)),
                      fmt::format("there may be: {}", fmt::join(known, ", "))});
  }
}

TomlTable::TomlTable(const TomlValue& table, std::string name, std::vector<Fault>& faults)
    : table_(table), name_(std::move(name)), prefix_(prefix_of(name_)), faults_(faults) {
  if (table.kind != Kind::kTable) {
    refuse(table.mark, fmt::format("{} is not a table", name_), fmt::format("write {} and its keys below", name_));
  }
}

TomlTable::TomlTable(const TomlValue& table, std::string name, const std::vector<std::string>& known,
                     std::vector<Fault>& faults)
    : TomlTable(table, std::move(name), faults) {
  refuse_unknown_keys(table, name_, known, faults);
}

void TomlTable::refuse_the_rest() { refuse_unknown_keys(table_, name_, {asked_.begin(), asked_.end()}, faults_); }

const TomlValue* TomlTable::find(const std::string& key) {
  asked_.insert(key);
  return table_.find(key);
}

const TomlValue* TomlTable::need(const std::string& key, const std::string& example) {
  const TomlValue* value = find(key);
  if (value == nullptr) {
    refuse(table_.key_mark, fmt::format("{} has no {}", name_, key),
           example.empty() ? "" : fmt::format("write, for example, {} = {}", key, example));
  }
  return value;
}

std::optional<std::string> TomlTable::text(const std::string& key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->kind == Kind::kText && !value->text.empty()) return value->text;
  refuse_value(key, "is not a text", "a text must be in quotes");
  return std::nullopt;
}

std::string TomlTable::needed_text(const std::string& key, const std::string& example) {
  need(key, example);
  return text(key).value_or("");
}

std::optional<double> TomlTable::number(const std::string& key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number() && std::isfinite(value->number)) return value->number;
  refuse_value(key, "is not a number", "a bare number is required here");
  return std::nullopt;
}

std::optional<double> TomlTable::quantity(const std::string& key, const std::string& si_unit,
                                          const std::string& example, const Units& units) {
  const TomlValue* value = find(key);
  return value == nullptr ? std::nullopt : quantity(key, *value, si_unit, example, units);
}

std::optional<double> TomlTable::quantity(const std::string& key, const TomlValue& value, const std::string& si_unit,
                                          const std::string& example, const Units& units) {
  try {
    return quantity_of(value, si_unit, example, units);
  } catch (const UnitError& problem) {
    faults_.push_back(value_fault(prefix_ + key, value, problem.what(), problem.remedy));
    return std::nullopt;
  }
}

std::optional<std::uint64_t> TomlTable::count(const std::string& key) {
  const TomlValue* value = find(key);
  return value == nullptr ? std::nullopt : count(key, *value, 0, kMaxCount);
}

std::optional<std::uint64_t> TomlTable::count(const std::string& key, const TomlValue& value, std::uint64_t fewest,
                                              std::uint64_t most) {
  const double number = value.is_number() ? value.number : -1;  // 1e6 is whole, too
  if (number >= static_cast<double>(fewest) && number <= static_cast<double>(most) && number == std::floor(number)) {
    return static_cast<std::uint64_t>(number);
  }
  const std::string bounds =
      most == kMaxCount ? fmt::format(", {} or above,", fewest) : fmt::format(" from {} to {}", fewest, most);
  faults_.push_back(value_fault(prefix_ + key, value, "is not a whole number",
                                fmt::format("a whole number{} is required here", bounds)));
  return std::nullopt;
}

std::vector<TomlValue> TomlTable::items(const std::string& key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return {};
  if (value->kind == Kind::kList) return value->items;
  refuse_value(key, "is not a list", "a list must be in brackets: [..., ...]");
  return {};
}

std::vector<std::string> TomlTable::texts(const std::string& key) {
  std::vector<std::string> all;
  for (const TomlValue& item : items(key)) {
    if (item.kind == Kind::kText && !item.text.empty()) {
      all.push_back(item.text);
    } else {
      refuse(item.mark, fmt::format("{}{} has {}, which is not a text", prefix_, key, item.as_written()),
             "a text must be in quotes");
    }
  }
  return all;
}

void TomlTable::refuse_word(const std::string& key, const std::string& word, const std::vector<std::string>& names) {
  const TomlValue* value = find(key);
  refuse(value == nullptr ? mark() : value->mark,
         fmt::format("{}{} = \"{}\" is not known{}", prefix_, key, word, did_you_mean(word, names)),
         fmt::format("one of: {}", fmt::join(names, ", ")));
}

void TomlTable::refuse_value(const std::string& key, const std::string& predicate, const std::string& remedy) {
  if (const TomlValue* value = find(key)) faults_.push_back(value_fault(prefix_ + key, *value, predicate, remedy));
}

void TomlTable::refuse_key(const std::string& key, const std::string& predicate, const std::string& remedy) {
  if (const TomlValue* value = find(key)) refuse(value->key_mark, prefix_ + key + " " + predicate, remedy);
}

void TomlTable::refuse(const SourceMark& mark, const std::string& message, const std::string& remedy) {
  faults_.push_back({mark, message, remedy});
}

}  // namespace ringfilm::io
