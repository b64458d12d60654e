#pragma once
#include <algorithm>
#include <string>

namespace ringfilm {

/// The first row of a table with this name; nullptr: there is no such row.
template <class Rows>
auto find_by_name(const Rows& rows, const std::string& name) -> decltype(&*rows.begin()) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace ringfilm
