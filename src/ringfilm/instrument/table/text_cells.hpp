#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Lines of text tables: what parts their cells, and what a cell is.
namespace ringfilm::instrument {

/// UTF-16, which starts with its mark of byte order, as UTF-8; nothing for any other bytes.
std::optional<std::string> from_utf16(std::string_view bytes);

/// Without the blanks around it.
std::string_view without_blanks(std::string_view text);

/// Without the blanks around it, nor the quotes within these.
std::string_view stripped(std::string_view text);

/// With lower ASCII letters.
std::string lower(std::string_view text);

/// Does the line start with # or with %, or state the separator for a spreadsheet (sep=;)?
bool is_comment(std::string_view line);

/// Does the cell mark a missing height: empty, nan, bad, no data and the like?
bool is_missing_word(std::string_view cell);

/// The number of a cell; nothing if it is not a finite number.
std::optional<double> number_of(std::string_view cell, bool decimal_commas);

/// What parts the cells: ';', '\t', ',' or ' ' for any blanks.
char separator_of(std::string_view line);

/// Walks over the cells of a line. An empty cell at the end of a line, after its last separator, does not count.
class Cells {
 public:
  Cells(std::string_view line, char separator) : line_(line), separator_(separator) {}

  /// @returns false behind the last cell
  bool next(std::string_view& cell);

  /// Column of the line in which the cell begins, from 1.
  int column() const;

 private:
  std::string_view line_;
  char separator_;
  std::size_t place_ = 0;
  std::size_t start_ = 0;
};

/// A column as the first line names it.
struct Column {
  std::string name;  ///< in lower case
  std::string unit;  ///< in brackets behind the name; may be empty
};

Column column_of(std::string_view header);

}  // namespace ringfilm::instrument
