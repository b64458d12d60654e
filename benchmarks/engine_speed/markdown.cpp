#include "markdown.hpp"

#include <algorithm>
#include <cstdio>

namespace ringfilm::benchmarks {
namespace {

const std::string kNothing = "-";

void print_row(const std::vector<std::string>& row, const std::vector<std::size_t>& width) {
  for (std::size_t c = 0; c < row.size(); ++c) std::printf("| %*s ", static_cast<int>(width[c]), row[c].c_str());
  std::printf("|\n");
}

}  // namespace

std::string text(const char* format, Value value) {
  if (!value) return kNothing;
  char shown[64];
  std::snprintf(shown, sizeof shown, format, *value);
  return shown;
}

void MarkdownTable::row(std::vector<std::string> names, const std::vector<std::string>& values) {
  if (std::all_of(values.begin(), values.end(), [](const std::string& cell) { return cell == kNothing; })) return;
  names.insert(names.end(), values.begin(), values.end());
  rows_.push_back(std::move(names));
}

void MarkdownTable::print(const std::string& title) const {
  if (rows_.empty()) return;
  std::vector<std::size_t> width(head_.size());
  for (std::size_t c = 0; c < head_.size(); ++c) {
    width[c] = head_[c].size();
    for (const auto& row : rows_) width[c] = std::max(width[c], row[c].size());
  }
  std::printf("\n%s\n\n", title.c_str());
  print_row(head_, width);
  for (const std::size_t w : width) std::printf("|%s:", std::string(w + 1, '-').c_str());
  std::printf("|\n");
  for (const auto& row : rows_) print_row(row, width);
}

}  // namespace ringfilm::benchmarks
