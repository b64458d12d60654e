#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/table/heading.hpp"

/// The one reader of tables of numbers as text: cylinder pressures, oils and faces with named columns, and heights with
/// or without names.
namespace ringfilm::io {

/// What the user states of a table in place of what the text shows.
struct TableReading {
  std::optional<std::string> columns;     ///< names and units of all columns: "x [mm], -, z [um]"; - is not used
  std::optional<std::size_t> skip_lines;  ///< lines of the file in front of the table
  std::vector<std::string> missing;       ///< further words or numbers of cells without a number

  bool is_empty() const { return !columns && !skip_lines && missing.empty(); }  ///< does the user state nothing?
};

/// Does the first line name the columns?
enum class TableHeader {
  kRequired,  ///< yes, unless the user does
  kOptional   ///< where its first cell is not a number
};

/// What becomes of cells that mark a missing number.
enum class Gaps {
  kRefused,  ///< a fault
  kNaN,      ///< `nan` is NaN, others are a fault
  kListed,   ///< NaN, and a fault of its own in TextTable::gaps
  kKept      ///< NaN
};

struct TableRules {
  TableHeader header = TableHeader::kRequired;
  Gaps gaps = Gaps::kRefused;
};

struct TextLine {
  int number = 0;  ///< from 1
  std::string text;
};

/// A cell without a number.
struct Gap {
  std::size_t row = 0, column = 0;  ///< from 0
  Fault fault;                      ///< what to report where a number is required
};

/// The numbers of a text, and what is around them.
struct TextTable {
  char separator = ',';
  bool has_decimal_commas = false;
  bool may_be_pairs = false;     ///< may the two cells of each row be one number with a decimal comma?
  int header_line = 0;           ///< line of the names, from 1; 0 where there is none
  int units_line = 0;            ///< line of the row of units, from 1; 0 where there is none
  std::vector<Heading> columns;  ///< empty where neither the file nor the user names them
  std::size_t n_columns = 0;
  std::vector<double> cells;       ///< row after row; NaN where a number is missing
  std::vector<int> row_lines;      ///< line of each row, from 1
  std::vector<TextLine> comments;  ///< in front of the numbers and between them
  std::vector<TextLine> head;      ///< lines in front of header and numbers that are neither comments nor used
  std::vector<TextLine> tail;      ///< lines of words behind the numbers
  std::vector<Gap> gaps;           ///< the first cells without a number
  std::size_t n_gaps = 0;
  int parted_at = 0;         ///< first blank line between rows, from 1; 0: none
  std::size_t n_parted = 0;  ///< how often blank lines part rows

  std::size_t rows() const { return row_lines.size(); }
  double at(std::size_t row, std::size_t column) const { return cells[row * n_columns + column]; }
  /// In one line what was taken for what, where the text has more than a header, units and numbers; else empty.
  std::string account() const;
};

/// The tables of a text. Cells are parted by semicolon, tabulator, comma or blanks, and may be in quotes; decimal
/// commas are read where they cannot part cells; commas that may be those of thousands are refused. Lines that start
/// with #, % or //, and blank lines, are skipped; `sep=;` states the separator. A table whose comments repeat one of
/// those in front of it, as where the head of another map begins, ends there. Lines in front of the header and lines of
/// words behind the numbers are skipped and kept. Throws InputError with the faults of the text (at most ten).
/// @param file name for messages
/// @param text UTF-8, lines end with "\n", "\r\n" or "\r"
std::vector<TextTable> read_text_tables(const std::string& file, std::string_view text, const TableRules& rules,
                                        const TableReading& stated = {});

/// How a text begins.
struct TextOutline {
  int line = 0;                      ///< number of the first line that is neither blank nor a comment, from 1
  std::string words;                 ///< that line
  bool starts_with_numbers = false;  ///< is the first cell of that line a number, or missing?
  std::vector<Heading> columns;      ///< names in that line, or in the header right above the first numbers
  int numbers_line = 0;              ///< first line of numbers alone, from 1; 0: none was found
};

/// Looks at the lines up to the first numbers.
TextOutline outline_of_text(std::string_view text, const TableReading& stated = {});

}  // namespace ringfilm::io
