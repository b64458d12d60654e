#pragma once
#include <optional>
#include <string>
#include <vector>

namespace ringfilm::benchmarks {

/// A number that may not have been measured; what is made of one that was not is not either.
using Value = std::optional<double>;
inline Value operator*(Value a, Value b) { return a && b ? Value(*a * *b) : std::nullopt; }
inline Value operator/(Value a, Value b) { return a && b ? Value(*a / *b) : std::nullopt; }
inline Value operator+(Value a, Value b) { return a && b ? Value(*a + *b) : std::nullopt; }

/// By a format of printf for one double; a dash where there is none.
std::string text(const char* format, Value value);

/// A table of Markdown with columns as wide as their widest cell.
class MarkdownTable {
 public:
  explicit MarkdownTable(std::vector<std::string> head) : head_(std::move(head)) {}

  /// @param names the first cells; the row is omitted if no value of the others was measured
  void row(std::vector<std::string> names, const std::vector<std::string>& values);
  /// Prints to standard output, or nothing if there is no row.
  void print(const std::string& title) const;

 private:
  std::vector<std::string> head_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace ringfilm::benchmarks
