#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"

/// Changes to a case in memory, key by key, for who has no file to write them into.
namespace ringfilm::io {

/// The entry of the table of case keys. Throws UnknownKeyError with the key that comes nearest.
const cycle::Field& known_field(const std::string& key);

/// A key and the case that has it: of a ring pack that of one of its rings.
struct LocatedKey {
  const cycle::Field& field;
  const cycle::Case& of;
};
/// Throws UnknownKeyError, also for a key of a ring without its number in a pack.
LocatedKey located_key(const cycle::Case& c, const std::string& key);

/// States a key: its value is read as in a case file, a file that it names is read at once, and so are those whose
/// meaning it changes (the unit of a trace, the width that a face must have). File names are relative to the working
/// folder. An oil file takes the place of all that was stated of the oil. Throws InputError, the case is then as
/// before; TraceKeyError where another key of the case does not fit a trace.
void state(cycle::Case& c, const std::string& key, const TomlValue& value, const Units& units);

/// Takes a key out: what it was by default it is again. Throws InputError for a key that does not exist
/// and for a file that cannot be read without it, TraceKeyError as state() does.
void retract(cycle::Case& c, const std::string& key, const Units& units);

/// A key with its new value; absent: the key is taken out.
struct Change {
  std::string key;
  std::optional<TomlValue> value;
};

/// States and takes out several keys at once, for keys that only fit together: files are read after all changes. Keys
/// next to lubricant.file are stated on top of the oil file. Throws InputError with the faults of all keys, the case is
/// then as before.
void update(cycle::Case& c, const std::vector<Change>& changes, const Units& units);

/// Throws InputError with everything that is wrong with the case as a whole.
void check_case(const cycle::Case& c);

}  // namespace ringfilm::io
