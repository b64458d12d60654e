#include "ringfilm/io/table/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/io/table/number_commas.hpp"
#include "ringfilm/io/table/table_head.hpp"
#include "ringfilm/io/table/text_cells.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kMaxTableFaults = 10, kMaxListedGaps = 1000;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The words and numbers of the user that mark a missing number.
struct StatedGaps {
  std::vector<std::string> words;
  std::vector<double> numbers;

  explicit StatedGaps(const std::vector<std::string>& missing) {
    for (const std::string& text : missing) {
      words.push_back(trimmed(text));
      if (const std::optional<double> number = number_of(words.back(), true)) numbers.push_back(*number);
    }
  }
  bool holds(std::string_view word) const { return std::find(words.begin(), words.end(), word) != words.end(); }
  bool holds(double number) const { return std::find(numbers.begin(), numbers.end(), number) != numbers.end(); }
};

class TableParser {
 public:
  TableParser(const std::string& file, std::string_view text, const TableRules& rules, const TableReading& stated)
      : file_(file), rules_(rules), stated_(stated), stated_gaps_(stated.missing), lines_(text) {
    if (stated.skip_lines) lines_.skip(*stated.skip_lines);
  }

  std::vector<TextTable> read() {
    std::vector<TextTable> tables;
    do {
      table_ = TextTable();
      keys_.clear();
      commas_ = NumberCommas();
      pairs_ = CellPairs();
      const TableHead head = find_head();
      if (!head.has_content) {
        if (!tables.empty()) break;  // comments behind the last row
        refuse({file_, 0, 0, ""}, "the file has no row of numbers", is_named() ? "" : "is it the right file?");
      }
      take(head);
      read_rows();
      finish();
      tables.push_back(std::move(table_));
    } while (!is_named() && !lines_.at_end());
    return tables;
  }

 private:
  bool is_named() const { return rules_.header == TableHeader::kRequired; }

  [[noreturn]] static void refuse(const SourceMark& mark, const std::string& message, const std::string& remedy) {
    throw InputError(std::vector<Fault>{{mark, message, remedy}});
  }

  SourceMark mark(const TextLines::Line& line, int column) const {
    return {file_, line.number, column, shown_line(line.text)};
  }

  TableHead find_head() {
    try {
      return table_head(lines_, rules_.header, stated_);
    } catch (const HeadFault& fault) {
      refuse(fault.line ? mark(*fault.line, fault.column) : SourceMark{file_, 0, 0, ""}, fault.what(), fault.remedy);
    }
  }

  void take(const TableHead& head) {
    table_.separator = head.separator;
    table_.columns = head.columns;
    table_.header_line = head.header ? head.header->number : 0;
    table_.units_line = head.units ? head.units->number : 0;
    table_.comments = head.comments;
    table_.head = head.skipped;
    for (const TextLine& comment : head.comments) note_key(comment.text);
    add_units(head);
    lines_ = head.rows;
    table_.n_columns = head.columns.empty() ? n_columns_of(head) : head.columns.size();
    may_hold_pairs_ = head.columns.empty() && head.separator == ',';
  }

  void note_key(std::string_view comment) {
    if (const std::optional<CommentEntry> entry = comment_entry(comment)) keys_.insert(lower(entry->name));
  }

  void add_units(const TableHead& head) {
    if (!head.units) return;
    for (std::size_t k = 0; k < head.stated_units.size(); ++k) {
      Heading& column = table_.columns[k];
      const std::optional<std::string>& below = head.stated_units[k];
      if (column.unit && below && *column.unit != *below) {
        faults_.push_back(
            {mark(*head.units, column.unit_column),
             "the unit of " + column.name + " is " + *below + " here and " + *column.unit + " in the header",
             "keep the right one; below the header a row of text is read as units"});
      }
      if (below) column.unit = below;
    }
  }

  /// Where no names count them: those of the first row. An empty cell behind the last separator does not count where a
  /// separator ends each of the rows.
  std::size_t n_columns_of(const TableHead& head) const {
    TextLines lines = head.rows;
    const std::optional<TextLines::Line> first = lines.next_row(table_.separator);
    if (!first) return 0;
    const std::vector<PlacedCell> cells = cells_of(first->text, table_.separator);
    const bool ends = table_.separator != ' ' && cells.size() > 1 && cells.back().text.empty() &&
                      stripped(first->text).ends_with(table_.separator);
    if (!ends) return cells.size();
    while (const std::optional<TextLines::Line> row = lines.next_row(' ')) {
      if (!stripped(row->text).ends_with(table_.separator)) return cells.size();
    }
    return cells.size() - 1;
  }

  void read_rows() {
    int blank_line = 0;
    while (std::optional<TextLines::Line> line = lines_.next(table_.separator)) {
      if (line->is_blank) {
        blank_line = line->number;
        continue;
      }
      if (line->is_comment) {
        if (!is_named() && table_.rows() > 0 && repeats(line->text)) {
          lines_.return_to(*line);
          return;
        }
        table_.comments.push_back({line->number, shown_line(line->text)});
        if (table_.rows() == 0) note_key(line->text);
        continue;
      }
      if (table_.rows() > 0 && blank_line > 0) {
        ++table_.n_parted;
        if (table_.parted_at == 0) table_.parted_at = blank_line;
      }
      blank_line = 0;
      if (table_.rows() >= 2 && is_tail(*line)) {
        take_tail(*line);
        return;
      }
      if (table_.rows() == 0 && table_.units_line > 0 && is_named() && is_row_of_ones(*line)) {
        table_.head.push_back({line->number, shown_line(line->text)});
        continue;
      }
      read_row(*line);
      if (faults_.size() >= kMaxTableFaults) throw InputError(faults_);
    }
  }

  bool repeats(std::string_view comment) const {
    const std::optional<CommentEntry> entry = comment_entry(comment);
    return entry && keys_.contains(lower(entry->name));
  }

  /// Words behind which no numbers follow.
  bool is_tail(const TextLines::Line& line) const {
    if (first_number_of(line)) return false;
    std::string_view first;
    Cells(line.text, table_.separator).next(first);
    if (is_missing_word(first) || stated_gaps_.holds(first)) return false;
    if (row_of_cells(line.text, table_.separator).has_number()) return false;
    constexpr int kMaxTail = 1000;
    TextLines ahead = lines_;
    for (int n = 0; n < kMaxTail; ++n) {
      const std::optional<TextLines::Line> next = ahead.next_row(table_.separator);
      if (!next) return row_of_cells(line.text, table_.separator).n_words > 0;
      const RowShape shape = row_of_cells(next->text, table_.separator);
      if (shape.is_row() && shape.n_cells == table_.n_columns) return false;
    }
    return false;
  }

  std::optional<double> first_number_of(const TextLines::Line& line) const {
    std::string_view first;
    Cells cells(line.text, table_.separator);
    cells.next(first);
    return number_of(first, cells.may_have_comma());
  }

  void take_tail(const TextLines::Line& first) {
    table_.tail.push_back({first.number, shown_line(first.text)});
    while (const std::optional<TextLines::Line> line = lines_.next_row(table_.separator)) {
      table_.tail.push_back({line->number, shown_line(line->text)});
    }
  }

  /// The third line of a header of some test benches, a 1 below each unit: out of order with the rows behind it.
  bool is_row_of_ones(const TextLines::Line& line) const {
    const std::vector<PlacedCell> cells = cells_of(line.text, table_.separator);
    if (cells.size() != table_.n_columns) return false;
    if (std::any_of(cells.begin(), cells.end(), [](const PlacedCell& cell) { return cell.text != "1"; })) return false;
    TextLines ahead = lines_;
    double place[2];
    for (double& one : place) {
      const std::optional<TextLines::Line> next = ahead.next_row(table_.separator);
      if (!next) return false;
      one = first_number_of(*next).value_or(kNoNumber);
    }
    return std::abs(place[0] - 1) > 3 * std::abs(place[1] - place[0]);
  }

  void read_row(const TextLines::Line& line) {
    const std::size_t first = table_.cells.size(), n = table_.n_columns, row = table_.rows();
    Cells cells(line.text, table_.separator);
    std::size_t n_cells = 0;
    bool is_last_empty = false;
    const std::size_t n_faults = faults_.size();
    for (std::string_view cell; cells.next(cell); ++n_cells) {
      is_last_empty = cell.empty();
      if (n_cells >= n) continue;
      const CellInText place{line, cells.column(), cell};
      if (may_hold_pairs_) pairs_.see(place, n_cells);
      table_.cells.push_back(value_of(place, cells.may_have_comma(), row, n_cells));
    }
    if (n_cells == n + 1 && is_last_empty) n_cells = n;
    if (n_cells != n) {
      faults_.resize(n_faults);
      faults_.push_back(wrong_count(line, n_cells));
    }
    table_.cells.resize(first + n, kNoNumber);
    table_.row_lines.push_back(line.number);
  }

  Fault wrong_count(const TextLines::Line& line, std::size_t n_cells) const {
    const std::size_t n = table_.n_columns;
    const bool is_doubled = table_.separator == ',' && n_cells == 2 * n;
    const char* const commas = "with decimal commas, separate the columns by semicolons";
    if (!table_.columns.empty()) {
      return {mark(line, 1), fmt::format("the row has {} values, the header names {} columns", n_cells, n),
              is_doubled ? commas : "give every row a value for each column"};
    }
    return {mark(line, 1), fmt::format("the row has {} values, and {} are required", n_cells, n),
            is_doubled ? commas
                       : "give every row as many values as the first; start lines before the heights, for example one "
                         "of counts, with #, or skip them (--skip-lines)"};
  }

  double value_of(const CellInText& place, bool may_have_comma, std::size_t row, std::size_t k) {
    const auto& [line, column, cell] = place;
    if (const std::optional<double> number = number_of(cell, may_have_comma)) {
      if (may_have_comma) commas_.see(place, *number, k);
      if (stated_gaps_.numbers.empty() || !stated_gaps_.holds(*number)) return *number;
    } else if (const std::optional<double> valid = truth_of(cell); valid && states_validity(k)) {
      return *valid;
    } else if (!is_missing_word(cell) && !stated_gaps_.holds(cell)) {
      faults_.push_back(not_a_number(cell, mark(line, column)));
      return kNoNumber;
    }
    if (rules_.gaps == Gaps::kKept) return kNoNumber;
    const bool is_nan = is_number(cell) && lower(cell).ends_with("nan");
    if (rules_.gaps == Gaps::kNaN && is_nan) return kNoNumber;
    Fault fault = cell.empty() ? Fault{mark(line, column), "a value is missing", "a number is required here"}
                               : not_a_number(cell, mark(line, column));
    if (rules_.gaps != Gaps::kListed) {
      faults_.push_back(std::move(fault));
    } else if (++table_.n_gaps <= kMaxListedGaps) {
      table_.gaps.push_back({row, k, std::move(fault)});
    }
    return kNoNumber;
  }

  bool states_validity(std::size_t k) const { return k < table_.columns.size() && is_validity(table_.columns[k].name); }

  Fault not_a_number(std::string_view cell, const SourceMark& where) const {
    const std::string shown = shown_line(cell.substr(0, 40));
    if (has_groups(cell)) {
      return {where, fmt::format("\"{}\" has separators of thousands", shown), "write the numbers without them"};
    }
    if (!is_named()) {
      return {where, fmt::format("\"{}\" is not a finite number", shown),
              "a number is required here, or nothing where no height was measured; another sign of missing heights is "
              "stated with --missing"};
    }
    return {where, is_number(cell) ? shown + " is not a finite number" : fmt::format("\"{}\" is not a number", shown),
            "a number is required here"};
  }

  /// "1,234.5", "1.234,5" and "1,234,567".
  static bool has_groups(std::string_view cell) {
    const std::size_t first = cell.find_first_of(".,");
    if (first == std::string_view::npos || cell.find_first_not_of("+-0123456789.,") != std::string_view::npos)
      return false;
    return starts_number(cell) && cell.find_first_of(".,", first + 1) == first + 4;
  }

  /// Refuses what can be read in two ways.
  void check_commas() {
    table_.has_decimal_commas = commas_.has_commas();
    table_.may_be_pairs = may_hold_pairs_ && table_.n_columns == 2 && pairs_.may_be_numbers();
    std::optional<CommaDoubt> doubt = commas_.doubt(table_.separator);
    if (!doubt && may_hold_pairs_) doubt = pairs_.doubt(table_.n_columns);
    if (doubt) faults_.push_back({mark(doubt->where.line, doubt->where.column), doubt->message, doubt->remedy});
  }

  void finish() {
    const std::size_t n = table_.rows();
    if (faults_.empty()) check_commas();
    if (faults_.empty() && n < (is_named() ? 2 : 1)) {
      faults_.push_back({{file_, 0, 0, ""},
                         std::string("the file has ") + (n == 0 ? "no row" : "only one row") + " of numbers",
                         is_named() ? "two or more are required" : "is it the right file?"});
    }
    if (faults_.empty()) return;
    for (const Gap& gap : table_.gaps) faults_.push_back(gap.fault);
    std::stable_sort(faults_.begin(), faults_.end(),
                     [](const Fault& a, const Fault& b) { return a.mark.line < b.mark.line; });
    faults_.resize(std::min(faults_.size(), kMaxTableFaults));
    throw InputError(faults_);
  }

  const std::string& file_;
  const TableRules rules_;
  const TableReading& stated_;
  const StatedGaps stated_gaps_;
  TextLines lines_;
  TextTable table_;
  std::set<std::string> keys_;  ///< names of the comments in front of the rows
  NumberCommas commas_;
  CellPairs pairs_;
  bool may_hold_pairs_ = false;  ///< do commas part cells without names?
  std::vector<Fault> faults_;
};

std::string lines_text(const std::vector<TextLine>& lines) {
  constexpr std::size_t kShown = 60;
  std::string text = lines.size() == 1 ? fmt::format("line {}", lines.front().number)
                                       : fmt::format("{} lines from {} to {}", lines.size(), lines.front().number,
                                                     lines.back().number);
  std::string words = trimmed(lines.front().text);
  if (words.size() > kShown) {
    std::size_t end = kShown;
    while (end > 0 && (static_cast<unsigned char>(words[end]) & 0xC0u) == 0x80u) --end;
    words = words.substr(0, end) + "...";
  }
  return text + " (" + words + ")";
}

}  // namespace

std::string TextTable::account() const {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  if (!head.empty()) {
    if (header_line > 0) {
      std::string names;
      for (const Heading& column : columns) {
        names += (names.empty() ? "" : ", ") + column.name + (column.unit ? " [" + *column.unit + "]" : "");
      }
      add(fmt::format("the columns are named in line {}: {}", header_line, names));
    }
    if (!row_lines.empty()) add(fmt::format("the numbers begin in line {}", row_lines.front()));
    add("skipped: " + lines_text(head));
  }
  if (has_decimal_commas) add("written with decimal commas and read so");
  if (!tail.empty()) add("skipped behind the numbers: " + lines_text(tail));
  return text;
}

std::vector<TextTable> read_text_tables(const std::string& file, std::string_view text, const TableRules& rules,
                                        const TableReading& stated) {
  return TableParser(file, text, rules, stated).read();
}

}  // namespace ringfilm::io
