#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {

/// A table of the file of a study or of a life with the keys that it may have. What is wrong goes to a list of faults,
/// each with its place; the functions then return nothing, as for keys that are absent.
class TomlTable {
 public:
  /// @param name for messages, e.g. "[[factor]]". Unknown keys are refused at once.
  TomlTable(const TomlValue& table, std::string name, std::vector<std::string> known, std::vector<Fault>& faults);

  const TomlValue* find(const std::string& key) const;
  const SourceMark& mark() const { return table_.key_mark; }

  std::optional<std::string> text(const std::string& key);
  /// As `text`, refused where it is absent. @param example the right-hand side as one would write it
  std::string needed_text(const std::string& key, const std::string& example);
  std::optional<double> number(const std::string& key);
  /// A whole number from 0 to 2^53.
  std::optional<std::uint64_t> count(const std::string& key);
  /// A list of texts; empty if absent.
  std::vector<std::string> texts(const std::string& key);
  /// The items of a list, empty if absent.
  std::vector<TomlValue> items(const std::string& key);

  template <class Choice>
  std::optional<Choice> chosen(const std::string& key, const std::vector<std::pair<std::string, Choice>>& choices) {
    const std::optional<std::string> word = text(key);
    if (!word) return std::nullopt;
    std::vector<std::string> names;
    for (const auto& [name, choice] : choices) {
      if (name == *word) return choice;
      names.push_back(name);
    }
    refuse_word(*find(key), key, *word, names);
    return std::nullopt;
  }

  /// Refuses a word that is not one of `names`: did you mean ...?
  void refuse_word(const TomlValue& at, const std::string& key, const std::string& word,
                   const std::vector<std::string>& names);
  void refuse(const SourceMark& mark, const std::string& message, const std::string& remedy);

 private:
  const TomlValue& table_;
  std::string name_;
  std::vector<Fault>& faults_;
};

}  // namespace ringfilm::io
