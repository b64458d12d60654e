#include "ringfilm/io/text/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ringfilm/io/text/suggestion.hpp"

namespace ringfilm::io {
namespace {

using Kind = TomlValue::Kind;

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = nearest_word(word, known);
  return near.empty() ? "" : fmt::format("; did you mean {}?", near);
}

}  // namespace

TomlTable::TomlTable(const TomlValue& table, std::string name, std::vector<std::string> known,
                     std::vector<Fault>& faults)
    : table_(table), name_(std::move(name)), faults_(faults) {
  if (table.kind != Kind::kTable) {
    refuse(table.mark, fmt::format("{} is not a table", name_), fmt::format("write {} and its keys below", name_));
  }
  for (const auto& [key, value] : table.members) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    refuse(value.key_mark, fmt::format("unknown key {} in {}{}", key, name_, did_you_mean(key, known)),
           fmt::format("there may be: {}", fmt::join(known, ", ")));
  }
}

const TomlValue* TomlTable::find(const std::string& key) const {
  for (const auto& member : table_.members) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

std::optional<std::string> TomlTable::text(const std::string& key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->kind == Kind::kText && !value->text.empty()) return value->text;
  refuse(value->mark, fmt::format("{} = {} is not a text", key, value->as_written()), "a text must be in quotes");
  return std::nullopt;
}

std::string TomlTable::needed_text(const std::string& key, const std::string& example) {
  if (find(key) == nullptr) {
    refuse(table_.key_mark, fmt::format("{} has no {}", name_, key),
           fmt::format("write, for example, {} = {}", key, example));
  }
  return text(key).value_or("");
}

std::optional<double> TomlTable::number(const std::string& key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if ((value->kind == Kind::kNumber || value->kind == Kind::kInteger) && std::isfinite(value->number))
    return value->number;
  refuse(value->mark, fmt::format("{} = {} is not a number", key, value->as_written()),
         "a bare number is required here");
  return std::nullopt;
}

std::optional<std::uint64_t> TomlTable::count(const std::string& key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  const bool is_number = value->kind == Kind::kInteger || value->kind == Kind::kNumber;  // 1e6 is whole, too
  if (is_number && value->number >= 0 && value->number <= 0x1p53 && value->number == std::floor(value->number))
    return static_cast<std::uint64_t>(value->number);
  refuse(value->mark, fmt::format("{} = {} is not a whole number", key, value->as_written()),
         "a whole number, 0 or above, is required here");
  return std::nullopt;
}

std::vector<TomlValue> TomlTable::items(const std::string& key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return {};
  if (value->kind == Kind::kList) return value->items;
  refuse(value->mark, fmt::format("{} = {} is not a list", key, value->as_written()),
         "a list must be in brackets: [..., ...]");
  return {};
}

std::vector<std::string> TomlTable::texts(const std::string& key) {
  std::vector<std::string> all;
  for (const TomlValue& item : items(key)) {
    if (item.kind == Kind::kText && !item.text.empty()) {
      all.push_back(item.text);
    } else {
      refuse(item.mark, fmt::format("{} has {}, which is not a text", key, item.as_written()),
             "a text must be in quotes");
    }
  }
  return all;
}

void TomlTable::refuse_word(const TomlValue& at, const std::string& key, const std::string& word,
                            const std::vector<std::string>& names) {
  refuse(at.mark, fmt::format("{} = \"{}\" is not known{}", key, word, did_you_mean(word, names)),
         fmt::format("one of: {}", fmt::join(names, ", ")));
}

void TomlTable::refuse(const SourceMark& mark, const std::string& message, const std::string& remedy) {
  faults_.push_back({mark, message, remedy});
}

}  // namespace ringfilm::io
