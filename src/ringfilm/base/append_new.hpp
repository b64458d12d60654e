#pragma once
#include <algorithm>
#include <vector>

namespace ringfilm {

/// Appends those of `rows` that are not in `all` yet. @param same of two rows
template <class Row, class Same>
void append_new(std::vector<Row>& all, std::vector<Row> rows, const Same& same) {
  for (Row& row : rows) {
    const auto is_same = [&](const Row& other) { return same(row, other); };
    if (std::none_of(all.begin(), all.end(), is_same)) all.push_back(std::move(row));
  }
}

}  // namespace ringfilm
