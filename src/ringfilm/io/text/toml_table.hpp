#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// The number of a value in SI: a bare number where `si_unit` is 1, else a text with its unit. Throws UnitError.
/// @param example the right-hand side as one would write it
double quantity_of(const TomlValue& value, const std::string& si_unit, const std::string& example, const Units& units);

/// Refuses the keys of a table that are not in `known`. @param name name of the table for messages, e.g. "[[factor]]"
void refuse_unknown_keys(const TomlValue& table, const std::string& name, const std::vector<std::string>& known,
                         std::vector<Fault>& faults);

/// A table of a TOML file, whose keys it reads by type. What is wrong goes to a list of faults, each with its place;
/// the functions then return nothing, as for keys that are absent. Messages have the keys of a section with its name
/// in front: "wear.jumps".
class TomlTable {
 public:
  /// @param name for messages, e.g. "[[factor]]", "a study"
  TomlTable(const TomlValue& table, std::string name, std::vector<Fault>& faults);
  /// A table with the keys that it may have. Unknown keys are refused at once.
  TomlTable(const TomlValue& table, std::string name, const std::vector<std::string>& known,
            std::vector<Fault>& faults);

  /// The value of a key; nullptr where it is absent.
  const TomlValue* find(const std::string& key);
  /// As `find`, refused where it is absent. @param example the right-hand side as one would write it; may be empty
  const TomlValue* need(const std::string& key, const std::string& example = "");
  const SourceMark& mark() const { return table_.key_mark; }  ///< place of the table in its file
  const std::string& name() const { return name_; }           ///< name of the table in messages

  /// A text that is not empty.
  std::optional<std::string> text(const std::string& key);
  /// As `text`, refused where it is absent. @param example as of `need`
  std::string needed_text(const std::string& key, const std::string& example = "");
  /// A finite bare number.
  std::optional<double> number(const std::string& key);
  /// In SI, as quantity_of.
  std::optional<double> quantity(const std::string& key, const std::string& si_unit, const std::string& example,
                                 const Units& units);
  /// As the one above, of a value below a key: an item of its list.
  std::optional<double> quantity(const std::string& key, const TomlValue& value, const std::string& si_unit,
                                 const std::string& example, const Units& units);
  /// A whole number from 0 to 2^53.
  std::optional<std::uint64_t> count(const std::string& key);
  /// As the one above, of a value below a key, between two bounds.
  std::optional<std::uint64_t> count(const std::string& key, const TomlValue& value, std::uint64_t fewest,
                                     std::uint64_t most);
  /// A list of texts; empty if absent.
  std::vector<std::string> texts(const std::string& key);
  /// The items of a list, empty if absent.
  std::vector<TomlValue> items(const std::string& key);

  /// Puts the choice that a text names into `choice`, which keeps its value where the key is absent or wrong.
  /// @returns whether it was chosen
  template <class Choice>
  bool choose(const std::string& key, const std::vector<std::pair<std::string, std::type_identity_t<Choice>>>& choices,
              Choice& choice) {
    const std::optional<std::string> word = text(key);
    if (!word) return false;
    std::vector<std::string> names;
    for (const auto& [name, one] : choices) {
      if (name == *word) {
        choice = one;
        return true;
      }
      names.push_back(name);
    }
    refuse_word(key, *word, names);
    return false;
  }

  /// Refuses a word of the value of a key that is not one of `names`: did you mean ...?
  void refuse_word(const std::string& key, const std::string& word, const std::vector<std::string>& names);
  /// Refuses a key with its value: "wear.jumps = 0 is not from 1 to 9". Nothing where the key is absent.
  void refuse_value(const std::string& key, const std::string& predicate, const std::string& remedy = "");
  /// Refuses the key itself: "wear.jump_error means nothing with jumps". Nothing where the key is absent.
  void refuse_key(const std::string& key, const std::string& predicate, const std::string& remedy);
  /// Refuses what is at `mark`.
  void refuse(const SourceMark& mark, const std::string& message, const std::string& remedy);
  /// Refuses the keys that no function was asked for, where what a table may have depends on its other keys.
  void refuse_the_rest();

 private:
  const TomlValue& table_;
  std::string name_, prefix_;
  std::vector<Fault>& faults_;
  std::set<std::string> asked_;
};

}  // namespace ringfilm::io
