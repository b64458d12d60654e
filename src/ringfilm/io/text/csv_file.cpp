#include "ringfilm/io/text/csv_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "ringfilm/base/trimmed.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kMaxCsvFaults = 10;

struct CsvCell {
  std::string text;  ///< without blanks and quotes around it
  int column;        ///< counts from 1
};

std::vector<CsvCell> split(const std::string& line, char separator) {
  std::vector<CsvCell> cells;
  std::size_t start = 0;
  while (true) {
    const std::size_t end = std::min(line.find(separator, start), line.size());
    std::size_t first = start, last = end;
    while (first < last && (line[first] == ' ' || line[first] == '\t')) ++first;
    while (last > first && (line[last - 1] == ' ' || line[last - 1] == '\t')) --last;
    if (last - first >= 2 && line[first] == '"' && line[last - 1] == '"') ++first, --last;
    cells.push_back({line.substr(first, last - first), static_cast<int>(first) + 1});
    if (end == line.size()) return cells;
    start = end + 1;
  }
}

bool is_number(const std::string& text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && rest == text.data() + text.size();
}

/// Does it begin as a number does? "12 kg" and "3,5" are damaged or foreign numbers, not units.
bool starts_number(const std::string& text) {
  const std::size_t first = text.find_first_not_of("+-.");
  return first != std::string::npos && text[first] >= '0' && text[first] <= '9';
}

char separator_of(const std::string& header) {
  if (header.find(';') != std::string::npos) return ';';
  if (header.find(',') != std::string::npos) return ',';
  return header.find('\t') != std::string::npos ? '\t' : ',';
}

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t") == std::string::npos; }
bool is_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string::npos && line[first] == '#';
}

/// The unit that a cell of the row of units states; nothing where it states none.
std::optional<std::string> unit_of(std::string cell) {
  if (cell.size() >= 2 &&
      ((cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')'))) {
    cell = trimmed(cell.substr(1, cell.size() - 2));
  }
  if (cell.empty()) return std::nullopt;
  return cell == "-" ? "1" : cell;
}

CsvColumn column_of(const std::string& heading) {
  const std::size_t open = heading.find('['), close = heading.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open) {
    return {heading, std::nullopt, {}, heading};
  }
  return {trimmed(heading.substr(0, open)), heading.substr(open + 1, close - open - 1), {}, heading};
}

/// Where the parenthesis opens that ends a text; nothing where none does, or nothing is before it.
std::optional<std::size_t> last_parenthesis(const std::string& text) {
  int depth = 0;
  for (std::size_t i = text.size(); i-- > 1;) {
    depth += text[i] == ')' ? 1 : text[i] == '(' ? -1 : 0;
    if (depth == 0) return text[i] == '(' ? std::optional(i) : std::nullopt;
  }
  return std::nullopt;
}

class CsvReader {
 public:
  CsvReader(const NamedFile& file, NaN nan) : nan_(nan) {
    csv_.source = read_source_text(file.path, file.shown, kMaxCsv);
  }

  CsvFile read() {
    const std::size_t first_row = read_units(read_header());
    for (std::size_t i = first_row; i < csv_.source.lines.size() && faults_.size() < kMaxCsvFaults; ++i) {
      const std::string& line = csv_.source.lines[i];
      if (!is_blank(line) && !is_comment(line)) read_row(line, static_cast<int>(i) + 1);
    }
    if (faults_.empty() && csv_.row_lines.size() < 2) {
      const std::string n_rows = csv_.row_lines.empty() ? "no row" : "only one row";
      faults_.push_back({csv_.source.mark(0), "the file has " + n_rows + " of numbers", "two or more are required"});
    }
    if (!faults_.empty()) throw InputError(faults_);
    write_notes();
    return std::move(csv_);
  }

 private:
  /// @returns index of the line after the header
  std::size_t read_header() {
    const auto& lines = csv_.source.lines;
    std::size_t i = 0;
    while (i < lines.size() && (is_blank(lines[i]) || is_comment(lines[i]))) {
      if (is_comment(lines[i])) csv_.notes.push_back(csv_.source.path + " states: " + lines[i]);
      ++i;
    }
    if (i == lines.size()) refuse(csv_.source.mark(0), "the file has no row of numbers", "");
    csv_.header_line = static_cast<int>(i) + 1;
    csv_.separator = separator_of(lines[i]);
    std::vector<CsvCell> cells = split(lines[i], csv_.separator);
    if (cells.size() > 1 && cells.back().text.empty()) cells.pop_back();
    if (std::all_of(cells.begin(), cells.end(), [](const CsvCell& cell) { return is_number(cell.text); })) {
      refuse(csv_.source.mark(csv_.header_line, 1), "the first line must name the columns and their units",
             "for example: crank_angle [degree],cylinder_pressure [Pa]");
    }
    for (const CsvCell& cell : cells) {
      if (cell.text.empty()) refuse(csv_.source.mark(csv_.header_line, cell.column), "a column has no name", "");
      csv_.columns.push_back(column_of(cell.text));
    }
    return i + 1;
  }

  /// @param i index of the line after the header  @returns index of the line after the row of units, if there is one
  std::size_t read_units(std::size_t i) {
    const std::size_t after_header = i;
    const auto& lines = csv_.source.lines;
    while (i < lines.size() && (is_blank(lines[i]) || is_comment(lines[i]))) ++i;
    if (i == lines.size()) return after_header;
    const std::vector<CsvCell> cells = split(lines[i], csv_.separator);
    std::vector<std::string> texts;
    for (const CsvCell& cell : cells) texts.push_back(cell.text);
    const std::optional<StatedUnits> units = row_of_units(texts, csv_.columns.size());
    if (!units) return after_header;
    csv_.units_line = static_cast<int>(i) + 1;
    for (std::size_t k = 0; k < units->size(); ++k) {
      std::optional<std::string>& unit = csv_.columns[k].unit;
      const std::optional<std::string>& below = (*units)[k];
      if (unit && below && *unit != *below) {
        faults_.push_back(
            {csv_.source.mark(csv_.units_line, cells[k].column),
             "the unit of " + csv_.columns[k].name + " is " + *below + " here and " + *unit + " in the header",
             "keep the right one; below the header a row of text is read as units"});
      }
      if (below) unit = below;
    }
    return i + 1;
  }

  void read_row(const std::string& line, int number) {
    std::vector<CsvCell> cells = split(line, csv_.separator);
    const std::size_t n = csv_.columns.size();
    if (cells.size() == n + 1 && cells.back().text.empty()) cells.pop_back();
    if (cells.size() != n) {
      const bool doubled = csv_.separator == ',' && cells.size() == 2 * n;
      faults_.push_back({csv_.source.mark(number, 1),
                         "the row has " + std::to_string(cells.size()) + " values, the header names " +
                             std::to_string(n) + " columns",
                         doubled ? "with decimal commas, separate the columns by semicolons"
                                 : "give every row a value for each column"});
      return;
    }
    csv_.row_lines.push_back(number);
    for (std::size_t i = 0; i < n; ++i) csv_.columns[i].values.push_back(value_of(cells[i], number));
  }

  double value_of(const CsvCell& cell, int line) {
    std::string text = cell.text.rfind('+', 0) == 0 ? cell.text.substr(1) : cell.text;
    if (csv_.separator != ',' && std::count(text.begin(), text.end(), ',') == 1 &&
        text.find('.') == std::string::npos) {
      text[text.find(',')] = '.';
      has_decimal_commas_ = true;
    }
    double value = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    std::string wrong;
    if (text.empty()) {
      wrong = "a value is missing";
    } else if (error != std::errc{} || rest != text.data() + text.size()) {
      wrong = "\"" + cell.text + "\" is not a number";
    } else if (std::isnan(value) ? nan_ == NaN::kRefused : std::isinf(value)) {
      wrong = cell.text + " is not a finite number";
    }
    if (!wrong.empty()) faults_.push_back({csv_.source.mark(line, cell.column), wrong, "a number is required here"});
    return value;
  }

  void write_notes() {
    const std::string& path = csv_.source.path;
    if (csv_.source.has_byte_order_mark)
      csv_.notes.push_back(path + " starts with a byte-order mark, which was skipped");
    if (csv_.units_line > 0) {
      csv_.notes.push_back(path + " has a row of units in line " + std::to_string(csv_.units_line) +
                           ", which was used");
    }
    if (has_decimal_commas_) csv_.notes.push_back(path + " is written with decimal commas and was read so");
  }

  [[noreturn]] static void refuse(const SourceMark& mark, const std::string& message, const std::string& remedy) {
    throw InputError(std::vector<Fault>{{mark, message, remedy}});
  }

  NaN nan_;
  CsvFile csv_;
  std::vector<Fault> faults_;
  bool has_decimal_commas_ = false;
};

}  // namespace

std::optional<StatedUnits> row_of_units(const std::vector<std::string>& cells, std::size_t n_columns) {
  const bool ends_with_separator = cells.size() == n_columns + 1 && cells.back().empty();
  const auto end = cells.end() - (ends_with_separator ? 1 : 0);
  const auto holds_digits = [](const std::string& cell) { return is_number(cell) || starts_number(cell); };
  const auto is_empty = [](const std::string& cell) { return cell.empty(); };
  if (static_cast<std::size_t>(end - cells.begin()) != n_columns || std::any_of(cells.begin(), end, holds_digits) ||
      std::all_of(cells.begin(), end, is_empty)) {
    return std::nullopt;
  }
  StatedUnits units;
  std::transform(cells.begin(), end, std::back_inserter(units), unit_of);
  return units;
}

SourceMark CsvFile::header_mark(std::size_t i_column) const {
  const auto cells = split(source.lines[header_line - 1], separator);
  return source.mark(header_line, cells[i_column].column);
}

SourceMark CsvFile::unit_mark(std::size_t i_column) const {
  if (units_line == 0) return header_mark(i_column);
  return source.mark(units_line, split(source.lines[units_line - 1], separator)[i_column].column);
}

SourceMark CsvFile::cell_mark(std::size_t i_row, std::size_t i_column) const {
  const int line = row_lines[i_row];
  return source.mark(line, split(source.lines[line - 1], separator)[i_column].column);
}

void CsvFile::read_units_in_parentheses(const std::function<bool(const std::string&)>& is_unit) {
  for (CsvColumn& column : columns) {
    const std::optional<std::size_t> open = column.unit ? std::nullopt : last_parenthesis(column.name);
    if (!open) continue;
    const std::string unit = trimmed(column.name.substr(*open + 1, column.name.size() - *open - 2));
    if (!is_unit(unit)) continue;
    column.name = trimmed(column.name.substr(0, *open));
    column.unit = unit;
  }
}

std::optional<std::size_t> CsvFile::find(const std::string& name) const {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const CsvColumn& column = columns[i];
    const bool is_name_and_unit = column.unit && column.name + " [" + *column.unit + "]" == name;
    if (column.name == name || column.heading == name || is_name_and_unit) return i;
  }
  return std::nullopt;
}

std::string CsvFile::names() const {
  std::string all;
  for (const CsvColumn& column : columns) all += (all.empty() ? "" : ", ") + column.name;
  return all;
}

CsvFile read_csv(const NamedFile& file, NaN nan) { return CsvReader(file, nan).read(); }

}  // namespace ringfilm::io
