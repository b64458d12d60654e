#include "ringfilm/io/toml_tree.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "ringfilm/io/toml_scan.hpp"
#include "ringfilm/io/units.hpp"

namespace ringfilm::io {
namespace {

SourceMark mark_of(const SourceText& source, const toml::source_region& region) {
  return source.mark(static_cast<int>(region.begin.line), static_cast<int>(region.begin.column));
}

bool earlier(const SourceMark& a, const SourceMark& b) {
  return a.line != b.line ? a.line < b.line : a.column < b.column;
}

TomlValue plain(const toml::node& node, const SourceText& source) {
  TomlValue value;
  value.mark = mark_of(source, node.source());
  value.key_mark = value.mark;
  if (const auto* text = node.as_string()) {
    value.kind = TomlValue::Kind::kText;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = TomlValue::Kind::kInteger;
    value.number = static_cast<double>(integer->get());
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = TomlValue::Kind::kNumber;
    value.number = number->get();
  } else if (const auto* list = node.as_array()) {
    value.kind = TomlValue::Kind::kList;
    for (const toml::node& item : *list) value.items.push_back(plain(item, source));
  } else if (const auto* table = node.as_table()) {
    value.kind = TomlValue::Kind::kTable;
    for (const auto& [key, member] : *table) {
      value.members.push_back({std::string(key.str()), plain(member, source)});
      value.members.back().value.key_mark = mark_of(source, key.source());
    }
    std::stable_sort(value.members.begin(), value.members.end(),
                     [](const auto& a, const auto& b) { return earlier(a.value.key_mark, b.value.key_mark); });
  }
  return value;
}

void flatten_into(const TomlValue& table, const std::string& prefix, const std::string& folder, FlatToml& flat) {
  for (const auto& [name, value] : table.members) {
    const std::string key = prefix + name;
    if (value.kind == TomlValue::Kind::kTable) {
      flat.sections.push_back({key, value, folder});
      flatten_into(value, key + ".", folder, flat);
    } else {
      flat.entries.push_back({key, value, folder});
    }
  }
}

}  // namespace

TomlValue parse_toml(const SourceText& source) {
  check_before_parsing(source);
  try {
    const toml::table table = toml::parse(source.text, source.path);
    return plain(table, source);
  } catch (const toml::parse_error& error) {
    throw InputError(std::vector<Fault>{
        {mark_of(source, error.source()), "this is not valid TOML: " + std::string(error.description()),
         "a line is key = value or [section]; texts and values with a unit stand in quotes"}});
  }
}

TomlValue parse_toml_value(const std::string& text) {
  SourceText source;
  source.path = "--set";
  source.text = "value = " + text + "\n";
  const TomlValue table = parse_toml(source);
  if (table.members.size() != 1 || table.members.front().key != "value") {
    throw InputError("more than one value");
  }
  return table.members.front().value;
}

FlatToml flatten(const TomlValue& root, const std::string& folder) {
  FlatToml flat;
  flatten_into(root, "", folder, flat);
  return flat;
}

std::string TomlValue::as_written() const {
  constexpr std::size_t kLongest = 60;
  std::string written;
  switch (kind) {
    case TomlValue::Kind::kText:
      written = quoted(text);
      break;
    case TomlValue::Kind::kInteger:
    case TomlValue::Kind::kNumber:
      return exact_text(number);
    case TomlValue::Kind::kList:
      for (const TomlValue& item : items) {
        if (written.size() > kLongest) break;
        written += (written.empty() ? "" : ", ") + item.as_written();
      }
      written = "[" + written + "]";
      break;
    case TomlValue::Kind::kTable:
      return "{...}";
    case TomlValue::Kind::kOther:
      return "(neither text nor number)";
  }
  return written.size() <= kLongest ? written : written.substr(0, kLongest) + "...";
}

std::string quoted(const std::string& text) {
  std::string written = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      written += std::string("\\") + c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == '\x7f') {
      written += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      written += c;
    }
  }
  return written + "\"";
}

}  // namespace ringfilm::io
