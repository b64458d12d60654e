#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/table/text_table.hpp"
#include "ringfilm/io/text/source_text.hpp"

/// Tables of numbers whose header names the columns and their units: `crank_angle [degree],cylinder_pressure [Pa]`.
/// The units may also be in a row of their own below the names, as test benches write them.
namespace ringfilm::io {

/// A named column of numbers.
struct CsvColumn : Heading {
  std::vector<double> values;  ///< as written
};

struct CsvFile {
  SourceText source;
  int header_line = 0;  ///< line of the header, counted from 1; 0 where the user names the columns
  int units_line = 0;   ///< line of the row of units, counted from 1; 0 if there is none
  std::vector<CsvColumn> columns;
  std::vector<int> row_lines;  ///< line of each row in the file
  std::vector<std::string>
      notes;              ///< comments in front of the header, byte-order mark, decimal commas, what was skipped
  std::vector<Gap> gaps;  ///< the first cells without a number, where these are listed
  std::size_t n_gaps = 0;

  SourceMark header_mark(std::size_t i_column) const;
  /// Where the unit of a column is stated, or would be.
  SourceMark unit_mark(std::size_t i_column) const;
  SourceMark cell_mark(std::size_t i_row, std::size_t i_column) const;

  /// Takes units out of the names of columns that have none in brackets, `pressure (bar)`, `Pressure / bar`,
  /// `p_bar`, where `is_unit` holds (with_unit_of_name()).
  void read_units_in_names(const std::function<bool(const std::string&)>& is_unit);

  /// The column of that name (with or without its unit), else the only one that has it in other capitals, or with its
  /// unit in the name; nothing if there is none.
  std::optional<std::size_t> find(const std::string& name) const;
  /// All names, for messages: `a, b`.
  std::string names() const;

 private:
  friend CsvFile read_csv(const NamedFile& file, Gaps gaps, const TableReading& stated);
  char separator_ = ',';
};

/// Reads a table with named columns (read_text_tables()). Throws InputError with the faults of the file (at most ten):
/// no header, no or one row, cells missing, text, NaN or infinity in a cell, a unit in the header and another in the
/// row of units.
CsvFile read_csv(const NamedFile& file, Gaps gaps = Gaps::kRefused, const TableReading& stated = {});

}  // namespace ringfilm::io
