#pragma once
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "ringfilm/io/table/heading.hpp"
#include "ringfilm/io/table/text_cells.hpp"
#include "ringfilm/io/table/text_table.hpp"

/// Where the numbers of a text begin, and which lines in front of them name the columns.
namespace ringfilm::io {

/// Walks over the lines of a text.
class TextLines {
 public:
  struct Line {
    std::size_t begin = 0;  ///< its place in the text
    int number = 0;         ///< from 1
    std::string_view text;
    bool is_blank = false, is_comment = false;
  };

  explicit TextLines(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) place_ = 3;
  }

  bool at_end() const { return place_ >= text_.size(); }
  void skip(std::size_t n_lines);
  void return_to(const Line& line);

  /// The next line, whatever it is. Where tabulators separate the cells, a line of tabulators is not blank.
  std::optional<Line> next(char separator);
  /// The next line that is neither blank nor a comment.
  std::optional<Line> next_row(char separator);

 private:
  std::size_t next_sign(char sign, std::size_t& found) const;

  static constexpr std::size_t kUnknown = std::string_view::npos;
  std::string_view text_;
  std::size_t place_ = 0;
  std::size_t line_feed_ = kUnknown, carriage_return_ = kUnknown;  ///< the first ones behind the place
  int number_ = 0;
};

/// What the cells of a line are.
struct RowShape {
  char separator = ',';
  std::size_t n_cells = 0;  ///< without an empty one behind the last separator
  std::size_t n_numbers = 0, n_words = 0;
  bool starts_with_number = false;  ///< is the first cell a number, or missing?
  bool holds_start_of_number = false;

  bool has_number() const { return n_numbers > 0; }
  bool is_row() const { return n_numbers > 0 && n_words == 0; }
};

RowShape row_of_cells(std::string_view line, char separator);

/// The cells of a header; where blanks part them, a unit in brackets belongs to the name in front of it.
std::vector<PlacedCell> heading_cells(std::string_view line, char separator);

/// "name: value" or "name = value" of a comment.
struct CommentEntry {
  std::string name, value;
};
std::optional<CommentEntry> comment_entry(std::string_view comment);

/// The line without control characters, cut where it is very long.
std::string shown_line(std::string_view line);

struct TableHead {
  bool has_content = false;  ///< is there a line that is neither blank nor a comment?
  char separator = ',';
  std::vector<Heading> columns;  ///< empty where nothing names them
  std::optional<TextLines::Line> header, units;
  StatedUnits stated_units;  ///< units of the row of units
  std::vector<TextLine> comments, skipped;
  TextLines rows{std::string_view()};  ///< begins in front of the first row
};

/// A head that cannot be read.
class HeadFault : public std::runtime_error {
 public:
  HeadFault(const std::optional<TextLines::Line>& where, int column_of, const std::string& message, std::string cure)
      : std::runtime_error(message), line(where), column(column_of), remedy(std::move(cure)) {}
  std::optional<TextLines::Line> line;
  int column;
  std::string remedy;
};

/// @param lines begins where the table, its comments included, does
TableHead table_head(TextLines lines, TableHeader rule, const TableReading& stated);

}  // namespace ringfilm::io
