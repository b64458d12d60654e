#pragma once
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/text/source_text.hpp"

/// A TOML file as plain values, each with its place in the file.
namespace ringfilm::io {

struct TomlMember;

struct TomlValue {
  enum class Kind { kText, kInteger, kNumber, kList, kTable, kOther };

  Kind kind = Kind::kOther;         ///< kOther: booleans, dates, times
  std::string text;                 ///< kText
  double number = 0;                ///< kInteger, kNumber; may be NaN or infinite
  std::vector<TomlValue> items;     ///< kList
  std::vector<TomlMember> members;  ///< kTable, in the order of the file
  SourceMark key_mark;              ///< place of the key in front of the value; equal to `mark` for items of a list
  SourceMark mark;                  ///< place of the value

  /// Is it a number, whole or not?
  bool is_number() const { return kind == Kind::kInteger || kind == Kind::kNumber; }
  /// The value of a key of a table; nullptr if there is none.
  const TomlValue* find(const std::string& key) const;
  /// As in the file, shortened, for messages: "12.5 N", [1, 2], 3.5.
  std::string as_written() const;
};

/// One key of a table.
struct TomlMember {
  std::string key;
  TomlValue value;
};

/// One key with its value, by its whole name ("ring.face.form").
struct TomlEntry {
  std::string key;
  TomlValue value;
  std::string folder;  ///< folder of the file: file names in the value are relative to it
};

/// Which lines to delete so that what two places of files state is stated once; the lines of one file in order.
std::string deletion_words(const SourceMark& one, const SourceMark& other);

/// Which lines to delete so that one of several ways to state a thing remains; each way has the places of its keys.
/// Empty if a place is not in a line of a file.
std::string deletion_words(std::vector<std::vector<SourceMark>> ways);

/// Parses one file. Throws InputError with the place of the first syntax error, or of each key and text that holds a
/// control character; refuses keys that are not ASCII and nesting beyond any case file before the parser sees them.
TomlValue parse_toml(const SourceText& source);

/// Parses the right-hand side of one key ("3.5", "\"wiebe\"", "[1, 2]"); throws InputError if it is not a TOML value.
TomlValue parse_toml_value(const std::string& text);

/// A fault of the value of a key, at its place: "ring.face_width = 1.2 has no unit".
Fault value_fault(const std::string& key, const TomlValue& value, const std::string& predicate,
                  const std::string& remedy);

/// The keys of a tree and, apart, the sections that hold none. Tables inside lists stay values.
struct FlatToml {
  std::vector<TomlEntry> entries;
  std::vector<TomlEntry> sections;  ///< every table by its whole name
};
FlatToml flatten(const TomlValue& root, const std::string& folder);

/// The end of the sentence on a text that holds a control character, which may be a line end or a tab; empty where it
/// holds none.
enum class LinesAndTabs { kAllowed, kRefused };
std::string control_character_words(const std::string& text, LinesAndTabs lines_and_tabs);
inline constexpr const char* kControlCharacterRemedy = "take it out: a text is letters, digits and signs";

/// A TOML basic string with quotes and escapes.
std::string quoted(const std::string& text);

}  // namespace ringfilm::io
