#pragma once
#include <string>
#include <vector>

/// Texts that are written from the table of case keys.
namespace ringfilm::io {

/// A key as a case to start from has it.
struct StartValue {
  std::string key;
  std::string value;   ///< the right-hand side in TOML; empty: the user has to state it
  std::string remark;  ///< where the value comes from, or what is to be stated
};

/// A commented case that states `values` alone: every other key is in it as a comment, with its default or an example.
/// @param head comment lines before the first key
std::string commented_case(const std::string& head, const std::vector<StartValue>& values);

/// The table of case keys for a terminal (`ringfilm fields`): key, unit, default, range, meaning, when it is in use.
/// @param words sections, keys or parts of keys, "ring.face", of which the table is made; empty: all keys. Throws
/// InputError for a word that is in no key.
std::string fields_table(const std::vector<std::string>& words = {});

/// The table of case keys as Markdown, one table for each section, for the manual.
std::string fields_markdown();

}  // namespace ringfilm::io
