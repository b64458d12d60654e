#include "ringfilm/io/table/table_head.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ringfilm/base/trimmed.hpp"

namespace ringfilm::io {
namespace {

/// Lines that are searched for the first numbers.
constexpr std::size_t kMaxHeadLines = 1000;
constexpr const char* kHeaderExample = "for example: crank_angle [degree],cylinder_pressure [Pa]";

/// A line in front of the numbers, or the first of them.
struct HeadLine {
  TextLines::Line line;
  RowShape shape;

  /// May it name the columns of rows of `n` cells?
  bool may_name(std::size_t n) const {
    const bool is_entry = shape.separator == ' ' && line.text.find('=') != std::string_view::npos;  // "Units=um"
    return shape.n_cells == n && shape.n_words > 0 && !shape.holds_start_of_number && !is_entry;
  }
};

bool opens_unit(std::string_view cell) { return cell.starts_with('[') || cell.starts_with('('); }

/// Has the heading a unit, in brackets or behind its name?
bool states_unit(const Heading& heading) {
  return !heading.name.empty() && (heading.unit || with_unit_of_name(heading, is_any_unit));
}

/// Does a cell of the line end with brackets or parentheses behind a name? `opening` are those that count.
bool has_brackets(const HeadLine& line, char separator, std::string_view opening) {
  const std::vector<PlacedCell> cells = heading_cells(line.line.text, separator);
  return std::any_of(cells.begin(), cells.end(), [opening](const PlacedCell& cell) {
    const std::size_t open = cell.text.find_first_of(opening);
    return open != std::string::npos && open > 0 && (cell.text.back() == ']' || cell.text.back() == ')');
  });
}

/// Names and units of the cells of a header.
std::vector<Heading> headings_of(const std::vector<PlacedCell>& cells) {
  std::vector<Heading> columns;
  for (const PlacedCell& cell : cells) {
    columns.push_back(heading_of(cell.text));
    columns.back().column = columns.back().unit_column = cell.column;
  }
  return columns;
}

/// Is each cell a unit, in brackets or not?
bool holds_units_alone(const HeadLine& line, char separator) {
  const auto is_unit = [](const std::string& text) {
    if (text.size() > 2 && (text.front() == '[' || text.front() == '(')) return true;
    return text.empty() || text == "-" || is_any_unit(text);
  };
  const std::vector<PlacedCell> cells = cells_of(line.line.text, separator);
  return std::all_of(cells.begin(), cells.end(), [&](const PlacedCell& cell) { return is_unit(cell.text); });
}

class HeadFinder {
 public:
  HeadFinder(TextLines lines, TableHeader rule, const TableReading& stated)
      : lines_(lines), rule_(rule), stated_(stated) {}

  TableHead find() {
    gather();
    head_.has_content = !lines_before_.empty();
    if (!head_.has_content) return std::move(head_);
    if (stated_.columns) {
      take_stated_columns();
    } else if (starts_with_rows()) {
      begin_at(0);
      take_commented_header();
      if (head_.columns.empty() && is_required()) {
        throw HeadFault(lines_before_[0].line, 1, "the first line must name the columns and their units",
                        std::string(kHeaderExample) + "; or state them in this form (--columns, gas.columns)");
      }
    } else {
      take_header();
    }
    return std::move(head_);
  }

 private:
  bool is_required() const { return rule_ == TableHeader::kRequired; }

  /// Lines up to the first numbers: two rows of as many cells, one right below names of as many, or any in a short
  /// text.
  void gather() {
    char separator = ',';
    while (lines_before_.size() < kMaxHeadLines) {
      const std::optional<TextLines::Line> line = lines_.next(separator);
      if (!line) break;
      if (line->is_comment) {
        if (const std::optional<char> stated = stated_separator(line->text)) separator_ = stated;
        head_.comments.push_back({line->number, shown_line(line->text)});
        comment_lines_.push_back(*line);
      }
      if (line->is_blank || line->is_comment) continue;
      const RowShape shape = row_of_cells(line->text, separator_.value_or(separator_of(line->text)));
      const bool follows_row = !lines_before_.empty() && lines_before_.back().shape.is_row();
      if (follows_row && shape.is_row() && shape.n_cells == lines_before_.back().shape.n_cells) {
        first_row_ = lines_before_.size() - 1;
        return;
      }
      // The comments behind the first row of numbers belong to the rows.
      lines_before_.push_back({*line, shape});
      n_comments_.push_back(head_.comments.size());
      separator = shape.separator;
      if (shape.is_row() && shape.n_cells > 1 && lines_before_.size() > 1 &&
          lines_before_[lines_before_.size() - 2].may_name(shape.n_cells)) {
        first_row_ = lines_before_.size() - 1;  // right below its names
        return;
      }
    }
    const auto row = std::find_if(lines_before_.begin(), lines_before_.end(),
                                  [](const HeadLine& line) { return line.shape.is_row(); });
    if (row != lines_before_.end() && lines_.at_end()) {
      first_row_ = static_cast<std::size_t>(row - lines_before_.begin());
    }
  }

  /// Is the first line with content one of numbers? One that starts with a number and has as many cells as the rows
  /// below is a row with a fault in it.
  bool starts_with_rows() const {
    const RowShape& first = lines_before_[0].shape;
    if (first.is_row()) return true;
    if (is_required()) return first.n_words == 0 && first.n_numbers > 0;
    if (!first.starts_with_number) return false;
    return !first_row_ || first.n_cells == lines_before_[*first_row_].shape.n_cells;
  }

  /// The rows begin with line `k` of those in front.
  void begin_at(std::size_t k) {
    head_.separator = separator_.value_or(lines_before_[k].shape.separator);
    head_.rows = lines_;
    head_.rows.return_to(lines_before_[k].line);
    head_.comments.resize(n_comments_[k]);
  }

  void skip_up_to(std::size_t k, std::optional<std::size_t> header, std::optional<std::size_t> units) {
    for (std::size_t i = 0; i < k; ++i) {
      if (i == header || i == units) continue;
      head_.skipped.push_back({lines_before_[i].line.number, shown_line(lines_before_[i].line.text)});
    }
  }

  void take_stated_columns() {
    const char separator = stated_.columns->find(';') != std::string::npos ? ';' : ',';
    std::vector<PlacedCell> cells = cells_of(*stated_.columns, separator);
    if (cells.size() > 1 && cells.back().text.empty()) cells.pop_back();  // behind the last separator
    head_.columns = headings_of(cells);
    for (Heading& column : head_.columns) {
      column.column = column.unit_column = 1;
      if (column.name.empty()) column.name = "-";
    }
    std::size_t first = first_row_.value_or(0);
    const std::size_t stated = head_.columns.size();
    const RowShape& row = lines_before_[first].shape;
    const bool is_doubled = row.separator == ',' && !separator_ && row.n_cells == 2 * stated;
    const bool is_decimal = is_doubled && stated == 1;  // "1,5" is one number, as are whole ones in front of it
    const auto is_whole = [](const RowShape& shape) { return shape.is_row() && shape.n_cells == 1; };
    while (is_decimal && first > 0 && is_whole(lines_before_[first - 1].shape)) --first;
    if (first_row_ && row.n_cells != stated && !is_decimal) {
      throw HeadFault(lines_before_[first].line, 1,
                      fmt::format("{} column{} stated, and the row has {} value{}", stated,
                                  stated == 1 ? " is" : "s are", row.n_cells, row.n_cells == 1 ? "" : "s"),
                      std::string("name every column; one that is not used is -") +
                          (is_doubled ? "; with decimal commas, separate the columns of the file by semicolons" : ""));
    }
    begin_at(first);
    if (is_decimal) head_.separator = ' ';
    skip_up_to(first, {}, {});
  }

  /// A comment right in front of the numbers may name their columns: "# x [um]  z [nm]".
  void take_commented_header() {
    if (comment_lines_.empty() || head_.comments.empty()) return;
    const TextLines::Line& line = comment_lines_[head_.comments.size() - 1];
    std::string_view text = without_blanks(line.text);
    text.remove_prefix(text.starts_with("//") ? 2 : 1);
    const std::size_t n = lines_before_[0].shape.n_cells;
    for (const char separator : {head_.separator, separator_of(text)}) {
      const std::vector<PlacedCell> cells = heading_cells(text, separator);
      if (cells.size() != n) continue;
      std::vector<Heading> columns = headings_of(cells);
      if (!std::all_of(columns.begin(), columns.end(), states_unit)) continue;
      head_.columns = std::move(columns);
      return;
    }
  }

  void take_header() {
    std::size_t header = 0;
    if (first_row_) {
      const std::size_t n = lines_before_[*first_row_].shape.n_cells;
      head_.separator = separator_.value_or(lines_before_[*first_row_].shape.separator);
      if (n == 1 && head_.separator == ' ') keep_blanks_in_names();
      const std::optional<std::size_t> found = header_among(n);
      if (!found && !is_required()) {  // numbers behind words that do not name them
        begin_at(*first_row_);
        skip_up_to(*first_row_, {}, {});
        return;
      }
      header = found.value_or(0);
      if (found) share_separator(lines_before_[*found].shape.separator, lines_before_[*first_row_]);
      if (!found) head_.separator = separator_.value_or(lines_before_[0].shape.separator);
    } else {
      head_.separator = separator_.value_or(lines_before_[0].shape.separator);
    }
    name_columns(header);
  }

  /// The separator of the names, where it parts the numbers as well: "0,<tab>1" below "a,b".
  void share_separator(char of_names, const HeadLine& row) {
    if (separator_ || of_names == head_.separator) return;
    const RowShape parted = row_of_cells(row.line.text, of_names);
    if (parted.is_row() && parted.n_cells == row.shape.n_cells) head_.separator = of_names;
  }

  /// One column alone: blanks are part of its name.
  void keep_blanks_in_names() {
    head_.separator = ',';
    for (HeadLine& line : lines_before_) line.shape = row_of_cells(line.line.text, ',');
  }

  /// The line that names the columns of rows of `n` cells: of the lines right above the numbers that may, the first, or
  /// the last where that alone has units; the one in front of a row of units.
  std::optional<std::size_t> header_among(std::size_t n) const {
    const auto may_name = [&](std::size_t i) { return lines_before_[i].may_name(n); };
    std::optional<std::size_t> last;
    for (std::size_t i = *first_row_; i-- > 0 && !last;) {
      if (may_name(i)) last = i;
    }
    if (!last) return std::nullopt;
    const char separator = head_.separator;
    if (*last > 0 && may_name(*last - 1) && !has_brackets(lines_before_[*last], separator, "[") &&
        holds_units_alone(lines_before_[*last], separator) && !holds_units_alone(lines_before_[*last - 1], separator)) {
      return *last - 1;
    }
    std::size_t first = *last;
    while (first > 0 && may_name(first - 1) &&
           lines_before_[first - 1].line.number + 1 == lines_before_[first].line.number)
      --first;
    const bool is_better =
        has_brackets(lines_before_[*last], separator, "[(") && !has_brackets(lines_before_[first], separator, "[(");
    return is_better ? *last : first;
  }

  void name_columns(std::size_t header) {
    const HeadLine& line = lines_before_[header];
    head_.header = line.line;
    std::vector<PlacedCell> cells = heading_cells(line.line.text, head_.separator);
    if (first_row_ && cells.size() < lines_before_[*first_row_].shape.n_cells) {  // blanks part the names alone
      const std::vector<PlacedCell> by_blanks = heading_cells(line.line.text, ' ');
      if (by_blanks.size() == lines_before_[*first_row_].shape.n_cells) cells = by_blanks;
    }
    if (is_required() && cells.size() > 1 && cells.back().text.empty()) cells.pop_back();
    for (const PlacedCell& cell : cells) {
      if (is_required() && cell.text.empty()) throw HeadFault(line.line, cell.column, "a column has no name", "");
    }
    head_.columns = headings_of(cells);
    head_.comments.resize(n_comments_[header]);
    TextLines rows = lines_;
    rows.return_to(line.line);
    rows.next(head_.separator);
    head_.rows = rows;
    skip_up_to(header, {}, {});
    take_units();
  }

  void take_units() {
    TextLines rows = head_.rows;
    const std::optional<TextLines::Line> line = rows.next_row(',');
    if (!line) return;
    std::vector<std::string> texts;
    const std::vector<PlacedCell> cells = heading_cells(line->text, head_.separator);
    for (const PlacedCell& cell : cells) {
      if (!is_required() && !cell.text.empty() && cell.text != "-" && is_missing_word(cell.text)) return;
      texts.push_back(cell.text);
    }
    if (!is_required() && texts.size() == head_.columns.size() - 1 && head_.columns.back().text.empty()) {
      texts.emplace_back();
    }
    std::optional<StatedUnits> units = row_of_units(texts, head_.columns.size());
    if (!units) return;
    head_.units = line;
    head_.stated_units = std::move(*units);
    for (std::size_t k = 0; k < std::min(cells.size(), head_.columns.size()); ++k) {
      head_.columns[k].unit_column = cells[k].column;
    }
    head_.rows = rows;
  }

  TextLines lines_;
  TableHeader rule_;
  const TableReading& stated_;
  std::optional<char> separator_;  ///< that the text states
  std::vector<HeadLine> lines_before_;
  std::vector<std::size_t> n_comments_;  ///< comments in front of each of them
  std::vector<TextLines::Line> comment_lines_;
  std::optional<std::size_t> first_row_;
  TableHead head_;
};

}  // namespace

void TextLines::skip(std::size_t n_lines) {
  for (; n_lines > 0 && !at_end(); --n_lines) next(',');
}

void TextLines::return_to(const Line& line) {
  place_ = line.begin;
  number_ = line.number - 1;
  line_feed_ = carriage_return_ = kUnknown;
}

/// The first one from the place on, or the end; the one that was found before, unless it is passed.
std::size_t TextLines::next_sign(char sign, std::size_t& found) const {
  if (found == kUnknown || found < place_) found = std::min(text_.find(sign, place_), text_.size());
  return found;
}

std::optional<TextLines::Line> TextLines::next(char separator) {
  if (at_end()) return std::nullopt;
  const std::size_t feed = next_sign('\n', line_feed_), end = std::min(feed, next_sign('\r', carriage_return_));
  Line line{place_, ++number_, text_.substr(place_, end - place_)};
  place_ = (end < feed && end + 1 == feed ? feed : end) + 1;
  const std::string_view content = without_blanks(line.text);
  line.is_blank = content.empty() && !(separator == '\t' && line.text.find('\t') != std::string_view::npos);
  line.is_comment = !content.empty() && is_comment(content);
  return line;
}

std::optional<TextLines::Line> TextLines::next_row(char separator) {
  while (std::optional<Line> line = next(separator)) {
    if (!line->is_blank && !line->is_comment) return line;
  }
  return std::nullopt;
}

RowShape row_of_cells(std::string_view line, char separator) {
  RowShape shape;
  shape.separator = separator;
  Cells cells(line, separator);
  bool is_last_empty = false;
  for (std::string_view cell; cells.next(cell); ++shape.n_cells) {
    const bool is_number_cell = number_of(cell, cells.may_have_comma()).has_value();
    const bool is_gap = is_missing_word(cell) || truth_of(cell);
    shape.n_numbers += is_number_cell ? 1 : 0;
    shape.n_words += is_number_cell || is_gap ? 0 : 1;
    shape.holds_start_of_number = shape.holds_start_of_number || is_number_cell || starts_number(cell);
    if (shape.n_cells == 0) shape.starts_with_number = is_number_cell || is_gap;
    // Where blanks part the cells, "[um]" belongs to the name in front of it.
    if (separator == ' ' && shape.n_cells > 0 && opens_unit(cell)) --shape.n_cells;
    is_last_empty = cell.empty();
  }
  if (is_last_empty && shape.n_cells > 1) --shape.n_cells;
  return shape;
}

std::vector<PlacedCell> heading_cells(std::string_view line, char separator) {
  std::vector<PlacedCell> merged;
  for (PlacedCell& cell : cells_of(line, separator)) {
    const bool is_unit = separator == ' ' && !merged.empty() && opens_unit(cell.text);
    if (is_unit) {
      merged.back().text += " " + cell.text;
    } else {
      merged.push_back(std::move(cell));
    }
  }
  return merged;
}

std::optional<CommentEntry> comment_entry(std::string_view comment) {
  const std::string_view content = without_blanks(comment);
  if (content.size() < 2 || content.size() > 200) return std::nullopt;
  std::size_t end = content.find_first_of(":="), length = 1;
  if (const std::size_t wide = content.find("："); wide < end) {
    end = wide;
    length = 3;  // bytes of the wide colon
  }
  if (end == std::string_view::npos || end == 0) return std::nullopt;
  return CommentEntry{trimmed(content.substr(1, end - 1)), trimmed(content.substr(end + length))};
}

std::string shown_line(std::string_view line) {
  constexpr std::size_t kMax = 2000;
  std::string text(line.substr(0, kMax));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == '\x7f') c = c == '\t' ? '\t' : ' ';
  }
  return text;
}

TableHead table_head(TextLines lines, TableHeader rule, const TableReading& stated) {
  return HeadFinder(lines, rule, stated).find();
}

TextOutline outline_of_text(std::string_view text, const TableReading& stated) {
  TextOutline found;
  TextLines lines(text);
  if (stated.skip_lines) lines.skip(*stated.skip_lines);
  TextLines first_lines = lines;
  const std::optional<TextLines::Line> first = first_lines.next_row(',');
  if (!first) return found;
  found.line = first->number;
  found.words = shown_line(first->text.substr(0, 200));
  const RowShape shape = row_of_cells(first->text, separator_of(first->text));
  found.starts_with_numbers = shape.starts_with_number;
  try {
    const TableHead head = table_head(lines, TableHeader::kOptional, stated);
    found.columns = head.columns;
    TextLines rows = head.rows;
    if (const std::optional<TextLines::Line> row = rows.next_row(head.separator)) {
      if (row_of_cells(row->text, head.separator).is_row()) found.numbers_line = row->number;
    }
  } catch (const HeadFault&) {
    // The reader reports it.
  }
  return found;
}

}  // namespace ringfilm::io
