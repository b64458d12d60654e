#pragma once
#include <tuple>

/// Records whose members are described once. A record lists them in `members(const Record*)`, a tuple of Member in the
/// order of files; result files, JSON, pages and Python walk that list.
namespace ringfilm {

/// A member of a record: its name, unit and meaning.
template <class Record, class Value>
struct Member {
  const char* name;           ///< in JSON, on pages and in Python; in result files behind a prefix
  const char* unit;           ///< SI, UDUNITS spelling; "1" for counts and truths, empty for text
  const char* long_name;      ///< plain words
  Value Record::*value;       ///< the member that holds it
  const char* symbol = "";    ///< as in docs/theory; empty: none
  const char* equation = "";  ///< label in docs/theory; empty: none
};
/// The types of a member follow from the pointer to it.
template <class Record, class Value, class... Words>
Member(const char*, const char*, const char*, Value Record::*, Words...) -> Member<Record, Value>;

/// Hands each of some members to `use(member)`.
template <class... Members, class Use>
void for_each_of(const std::tuple<Members...>& list, const Use& use) {
  std::apply([&use](const auto&... member) { (use(member), ...); }, list);
}

/// Hands each member of a record to `use(member)`, in the order of files.
template <class Record, class Use>
void for_each_member(const Use& use) {
  for_each_of(members(static_cast<const Record*>(nullptr)), use);
}

}  // namespace ringfilm
