#include "ringfilm/io/text/toml_tree.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <optional>

#include "ringfilm/base/joined.hpp"
#include "ringfilm/base/printable_text.hpp"
#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/io/text/toml_scan.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {
namespace {

/// Each value keeps the line that it is in, so that thousands of them in one long line would fill the memory. Longer
/// lines are lists of numbers, which people find by line and column.
constexpr std::size_t kMaxKeptLine = 400;

SourceMark mark_of(const SourceText& source, const toml::source_region& region) {
  const auto line = static_cast<int>(region.begin.line), column = static_cast<int>(region.begin.column);
  const auto i = static_cast<std::size_t>(line - 1);
  if (i < source.lines.size() && source.lines[i].size() > kMaxKeptLine) return {source.path, line, column, ""};
  return source.mark(line, column);
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

/// Only escapes such as \u0000 lead control characters into a text: bytes of that kind were refused before.
void find_control_characters(const TomlValue& value, std::vector<Fault>& faults) {
  const auto check = [&](const SourceMark& mark, const std::string& what, const std::string& text) {
    const std::string words = control_character_words(text, LinesAndTabs::kAllowed);
    if (!words.empty()) faults.push_back({mark, what + " " + words, kControlCharacterRemedy});
  };
  check(value.mark, value.as_written(), value.text);
  for (const TomlValue& item : value.items) find_control_characters(item, faults);
  for (const auto& [key, member] : value.members) {
    check(member.key_mark, "the key " + quoted(key), key);
    find_control_characters(member, faults);
  }
}

/// The last line before `line` that states the same key in its section, or begins the same section; 0 for none.
int first_statement(const SourceText& source, int line, const std::string& name, bool is_section) {
  for (int i = line - 1; i > 0; --i) {
    const std::string text = trimmed(source.lines[static_cast<std::size_t>(i - 1)]);
    const bool is_head = text.rfind('[', 0) == 0;
    if (is_section ? text.rfind("[" + name + "]", 0) == 0
                   : text.rfind(name, 0) == 0 && trimmed(text.substr(name.size())).rfind('=', 0) == 0) {
      return i;
    }
    if (is_head && !is_section) return 0;
  }
  return 0;
}

/// A key or section that the parser found twice in one file; nothing for another error.
std::optional<Fault> redefinition(const SourceText& source, const SourceMark& mark, const std::string& description) {
  const std::size_t end = description.rfind('\''), begin = description.rfind('\'', end - 1);
  if (description.find("cannot redefine existing") == std::string::npos || end == std::string::npos ||
      begin == std::string::npos || begin + 1 >= end) {
    return std::nullopt;
  }
  const std::string name = description.substr(begin + 1, end - begin - 1);
  const bool is_section = description.find("table header") != std::string::npos;
  const int first = first_statement(source, mark.line, name, is_section);
  if (first == 0) return std::nullopt;
  if (!is_section) return Fault{mark, name + " is given twice", deletion_words(source.mark(first), mark)};
  return Fault{mark, "[" + name + "] is given twice",
               fmt::format("move its keys below line {} and delete line {}", first, mark.line)};
}

TomlValue parsed(const SourceText& source) {
  check_before_parsing(source);
  try {
    const toml::table table = toml::parse(source.text, source.path);
    return plain(table, source);
  } catch (const toml::parse_error& error) {
    const SourceMark mark = mark_of(source, error.source());
    if (auto twice = redefinition(source, mark, std::string(error.description()))) throw InputError({*twice});
    throw InputError(
        std::vector<Fault>{{mark, "this is not valid TOML: " + std::string(error.description()),
                            "a line is key = value or [section]; texts and values with a unit must be in quotes"}});
  }
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

std::string deletion_words(const SourceMark& one, const SourceMark& other) { return deletion_words({{one}, {other}}); }

std::string deletion_words(std::vector<std::vector<SourceMark>> ways) {
  const std::string file = ways.front().front().file;
  bool is_one_file = true;
  for (const std::vector<SourceMark>& way : ways) {
    for (const SourceMark& mark : way) {
      if (mark.line == 0) return "";
      is_one_file = is_one_file && mark.file == file;
    }
  }
  const auto is_before = [](const auto& a, const auto& b) { return a.front().line < b.front().line; };
  if (is_one_file) std::stable_sort(ways.begin(), ways.end(), is_before);
  std::vector<std::string> places;
  for (const std::vector<SourceMark>& way : ways) {
    std::vector<std::string> lines;
    for (const SourceMark& mark : way) {
      lines.push_back("line " + std::to_string(mark.line) + (is_one_file ? "" : " of " + mark.file));
    }
    places.push_back(joined(lines, " and "));
  }
  const std::string of_file = is_one_file ? " of " + file : "";
  if (places.size() == 2) return "delete " + joined(places, " or ") + of_file;
  return "delete all but one of these: " + joined(places, "; ") + of_file;
}

TomlValue parse_toml(const SourceText& source) {
  TomlValue root = parsed(source);
  std::vector<Fault> faults;
  find_control_characters(root, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
  return root;
}

TomlValue parse_toml_value(const std::string& text) {
  SourceText source;
  source.path = "--set";
  source.text = "value = " + text + "\n";
  const TomlValue table = parsed(source);  // who takes the value checks its texts, and has their key
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

Fault value_fault(const std::string& key, const TomlValue& value, const std::string& predicate,
                  const std::string& remedy) {
  return {value.mark, fmt::format("{} = {} {}", key, value.as_written(), predicate), remedy};
}

const TomlValue* TomlValue::find(const std::string& key) const {
  const auto found = std::ranges::find(members, key, &TomlMember::key);
  return found == members.end() ? nullptr : &found->value;
}

std::string TomlValue::as_written() const {
  constexpr std::size_t kMax = 60;
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
        if (written.size() > kMax) break;
        written += (written.empty() ? "" : ", ") + item.as_written();
      }
      written = "[" + written + "]";
      break;
    case TomlValue::Kind::kTable:
      return "{...}";
    case TomlValue::Kind::kOther:
      return "(neither text nor number)";
  }
  return written.size() <= kMax ? written : written.substr(0, kMax) + "...";
}

std::string control_character_words(const std::string& text, LinesAndTabs lines_and_tabs) {
  std::size_t at = find_control_character(text);
  if (lines_and_tabs == LinesAndTabs::kRefused) at = std::min(at, text.find_first_of("\n\t"));
  if (at == std::string::npos) return "";
  return fmt::format("holds the control character U+{:04X}", static_cast<unsigned>(code_point_at(text, at)));
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
