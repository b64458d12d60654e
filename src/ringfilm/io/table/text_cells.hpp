#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Lines of text tables: what parts their cells, and what a cell is.
namespace ringfilm::io {

/// Without the blanks around it.
std::string_view without_blanks(std::string_view text);

/// Without the blanks around it, nor the quotes within these.
std::string_view stripped(std::string_view text);

/// With lower ASCII letters.
std::string lower(std::string_view text);

/// The separator that a line states for a spreadsheet ("sep=;"); nothing for any other line.
std::optional<char> stated_separator(std::string_view line);

/// Does the line start with #, % or //, or state the separator (sep=;)? One that starts with ; does where its second
/// cell is not a number.
bool is_comment(std::string_view line);

/// Does the cell mark a missing number: empty, -, nan, NA, bad, no data, ***, 1.#QNAN, inf and the like?
bool is_missing_word(std::string_view cell);

/// 1 of "true", 0 of "false", as programs write what is valid; nothing for any other cell.
std::optional<double> truth_of(std::string_view cell);

/// The number of a cell, with an exponent of e or of Fortran's d; nothing if it is not a finite number.
std::optional<double> number_of(std::string_view cell, bool decimal_commas);

/// Is the cell a number, finite or not?
bool is_number(std::string_view cell);

/// Does the cell begin as a number does? "12 kg" and "3,5" are damaged or foreign numbers, not words.
bool starts_number(std::string_view cell);

/// What parts the cells: ';', '\t', ',' or ' ' for any blanks.
char separator_of(std::string_view line);

/// Walks over the cells of a line. A separator between quotes parts nothing.
class Cells {
 public:
  Cells(std::string_view line, char separator) : line_(line), separator_(separator) {}

  /// @returns false behind the last cell
  bool next(std::string_view& cell);

  /// Column of the line in which the content of the cell begins, from 1.
  int column() const;

  /// May a comma of the cell be that of a decimal number: where commas part no cells, or it is between quotes?
  bool may_have_comma() const { return separator_ != ',' || is_quoted_; }

 private:
  std::size_t end_of_cell() const;

  std::string_view line_;
  char separator_;
  std::size_t place_ = 0;
  std::size_t start_ = 0;
  bool is_quoted_ = false;
};

/// A cell with its place in the line.
struct PlacedCell {
  std::string text;
  int column = 1;  ///< from 1
};

/// All cells of a line; an empty one at its end, behind the last separator, included.
std::vector<PlacedCell> cells_of(std::string_view line, char separator);

}  // namespace ringfilm::io
