#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/text/source_text.hpp"

/// Tables of numbers whose first line names the columns and their units: `crank_angle [degree],cylinder_pressure [Pa]`.
/// The units may also be in a row of their own below the names, as test benches write them.
namespace ringfilm::io {

/// What becomes of cells that read `nan`.
enum class NaN { kRefused, kKept };

struct CsvColumn {
  std::string name;                 ///< without the unit
  std::optional<std::string> unit;  ///< as written in brackets, or in the row of units; nothing if there is none
  std::vector<double> values;       ///< as written
  std::string heading;              ///< name and unit as the header has them
};

struct CsvFile {
  SourceText source;
  char separator = ',';
  int header_line = 0;  ///< line of the header, counted from 1
  int units_line = 0;   ///< line of the row of units, counted from 1; 0 if there is none
  std::vector<CsvColumn> columns;
  std::vector<int> row_lines;      ///< line of each row in the file
  std::vector<std::string> notes;  ///< comments in front of the header, byte-order mark, decimal commas

  SourceMark header_mark(std::size_t i_column) const;
  /// Where the unit of a column is stated, or would be.
  SourceMark unit_mark(std::size_t i_column) const;
  SourceMark cell_mark(std::size_t i_row, std::size_t i_column) const;

  /// Takes a text in parentheses at the end of a name, `pressure (bar)`, for the unit of a column that has none in
  /// brackets, where `is_unit` holds.
  void read_units_in_parentheses(const std::function<bool(const std::string&)>& is_unit);

  /// The column of that name (with or without its unit); nothing if there is none.
  std::optional<std::size_t> find(const std::string& name) const;
  /// All names, for messages: `a, b`.
  std::string names() const;
};

/// The unit that each cell states; nothing where it states none.
using StatedUnits = std::vector<std::optional<std::string>>;

/// The units of a row below the names of `n_columns` columns: `deg;bar`, `[deg]`, `(bar)`; `-` is that of a
/// dimensionless column, 1. Nothing if the row is not one of units: if a cell begins as a number does, or all are
/// empty.
std::optional<StatedUnits> row_of_units(const std::vector<std::string>& cells, std::size_t n_columns);

/// Reads values separated by comma, semicolon or tabulator; decimal commas where they cannot be separators. Lines that
/// start with '#' and blank lines are skipped. A first row without any number is the row of units
/// (row_of_units). Throws InputError with the faults of the
/// file (at most ten): no header, no or one row, cells missing, text, NaN or infinity in a cell, a unit in the header
/// and another in the row of units.
CsvFile read_csv(const NamedFile& file, NaN nan = NaN::kRefused);

}  // namespace ringfilm::io
