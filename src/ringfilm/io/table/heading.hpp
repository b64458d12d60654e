#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Names of columns and their units, as programs write them.
namespace ringfilm::io {

/// A column as the header names it.
struct Heading {
  std::string name;                 ///< without the unit
  std::optional<std::string> unit;  ///< as written in brackets or in the row of units; nothing if there is none
  std::string text;                 ///< name and unit as the header has them
  int column = 1;                   ///< where the name begins in its line, from 1
  int unit_column = 1;              ///< where the unit begins in the row of units; the name, where there is none
};

/// Name and unit of a cell of the header: a unit is in brackets, `pressure [bar]`.
Heading heading_of(std::string_view cell);

/// Is a column of that name true or 1 where the row was measured?
bool is_validity(const std::string& name);

/// Is the text a unit of a quantity that tables have: length, angle, pressure, time and the like? That of a gauge
/// pressure (barg) is one, too.
bool is_any_unit(const std::string& text);

/// Name and unit of a heading without brackets, where `is_unit` holds of what is taken for the unit: `pressure (bar)`,
/// `Pressure / bar`, `Pcyl_bar`, `Pressure, bar`, `Pressure bar`. Nothing if there is none.
std::optional<Heading> with_unit_of_name(const Heading& heading,
                                         const std::function<bool(const std::string&)>& is_unit);

/// The unit that each cell states; nothing where it states none.
using StatedUnits = std::vector<std::optional<std::string>>;

/// The units of a row below the names of `n_columns` columns: `deg;bar`, `[deg]`, `(bar)`; `-` is that of a
/// dimensionless column, 1. Nothing if the row is not one of units: if a cell begins as a number does, or all are
/// empty.
std::optional<StatedUnits> row_of_units(const std::vector<std::string>& cells, std::size_t n_columns);

}  // namespace ringfilm::io
