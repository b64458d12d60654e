#include "ringfilm/io/table/csv_file.hpp"

#include <utility>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/io/table/text_cells.hpp"

namespace ringfilm::io {
namespace {

void append_notes(const TextTable& table, CsvFile& csv) {
  const std::string& path = csv.source.path;
  for (const TextLine& comment : table.comments) {
    const bool is_in_front = comment.number < csv.header_line || csv.header_line == 0;
    if (!is_in_front || stated_separator(comment.text)) continue;
    if (!table.row_lines.empty() && comment.number > table.row_lines.front()) break;
    csv.notes.push_back(path + " states: " + comment.text);
  }
  if (csv.source.has_byte_order_mark) csv.notes.push_back(path + " starts with a byte-order mark, which was skipped");
  if (!csv.source.encoding.empty()) csv.notes.push_back(path + " is " + csv.source.encoding + " text and was read so");
  if (csv.units_line > 0) {
    csv.notes.push_back(path + " has a row of units in line " + std::to_string(csv.units_line) + ", which was used");
  }
  if (const std::string account = table.account(); !account.empty()) csv.notes.push_back(path + ": " + account);
}

}  // namespace

SourceMark CsvFile::header_mark(std::size_t i_column) const {
  return source.mark(header_line, header_line > 0 ? columns[i_column].column : 0);
}

SourceMark CsvFile::unit_mark(std::size_t i_column) const {
  if (units_line == 0) return header_mark(i_column);
  return source.mark(units_line, columns[i_column].unit_column);
}

SourceMark CsvFile::cell_mark(std::size_t i_row, std::size_t i_column) const {
  const int line = row_lines[i_row];
  return source.mark(line, cells_of(source.lines[static_cast<std::size_t>(line) - 1], separator_)[i_column].column);
}

void CsvFile::read_units_in_names(const std::function<bool(const std::string&)>& is_unit) {
  for (CsvColumn& column : columns) {
    if (std::optional<Heading> found = with_unit_of_name(column, is_unit)) static_cast<Heading&>(column) = *found;
  }
}

std::optional<std::size_t> CsvFile::find(const std::string& name) const {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const CsvColumn& column = columns[i];
    const bool is_name_and_unit = column.unit && column.name + " [" + *column.unit + "]" == name;
    if (column.name == name || column.text == name || is_name_and_unit) return i;
  }
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::optional<Heading> parted = with_unit_of_name(columns[i], is_any_unit);
    if (lower(parted ? parted->name : columns[i].name) != lower(name)) continue;
    if (found) return std::nullopt;  // which one is meant?
    found = i;
  }
  return found;
}

std::string CsvFile::names() const {
  std::string all;
  for (const CsvColumn& column : columns) all += (all.empty() ? "" : ", ") + column.name;
  return all;
}

CsvFile read_csv(const NamedFile& file, Gaps gaps, const TableReading& stated) {
  CsvFile csv;
  csv.source = read_table_text(file.path, file.shown, kMaxCsv);
  TextTable table = read_text_tables(file.shown, csv.source.text, {TableHeader::kRequired, gaps}, stated).front();
  csv.header_line = table.header_line;
  csv.units_line = table.units_line;
  csv.separator_ = table.separator;
  csv.row_lines = table.row_lines;
  append_notes(table, csv);
  csv.gaps = std::move(table.gaps);
  csv.n_gaps = table.n_gaps;
  for (std::size_t k = 0; k < table.n_columns; ++k) {
    CsvColumn column{table.columns[k], {}};
    for (std::size_t i = 0; i < table.rows(); ++i) column.values.push_back(table.at(i, k));
    csv.columns.push_back(std::move(column));
  }
  return csv;
}

}  // namespace ringfilm::io
