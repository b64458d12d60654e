#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ringfilm/io/table/table_head.hpp"

/// What the commas of a table mean: decimals, thousands as English programs write them, or the end of a cell.
namespace ringfilm::io {

/// A cell of a text with its place.
struct CellInText {
  TextLines::Line line;
  int column = 1;  ///< from 1
  std::string_view cell;
};

/// A table whose numbers can be read in two ways.
struct CommaDoubt {
  CellInText where;
  std::string message, remedy;
};

/// Commas within numbers. They are decimal commas unless each of them is in front of three digits, as between
/// thousands, and something else of the table speaks for thousands.
class NumberCommas {
 public:
  /// @param number a cell with the value `value` @param column of the table, from 0
  void see(const CellInText& number, double value, std::size_t column);

  bool has_commas() const { return has_commas_; }
  std::optional<CommaDoubt> doubt(char separator) const;

 private:
  struct Column {
    std::optional<CellInText> first;  ///< whose comma may be that of thousands
    bool has_long = false;            ///< are there numbers of three or more digits without a comma?
  };
  std::vector<Column> columns_;
  bool has_commas_ = false, shows_decimals_ = false, has_points_ = false;
};

/// Pairs of cells that commas part, and that may be one number each: "1,0672" in a table of one height per line.
class CellPairs {
 public:
  void see(const CellInText& cell, std::size_t place);

  /// Are all cells whole numbers, the second ones without a sign?
  bool may_be_numbers() const { return may_be_ && has_any_; }
  /// Nothing unless digits show it that no whole number has: a zero in front, or -0.
  std::optional<CommaDoubt> doubt(std::size_t n_columns) const;

 private:
  std::optional<CellInText> shown_;
  bool may_be_ = true, has_any_ = false;
};

/// What to do where the two values of a row may be one number with a decimal comma.
inline constexpr const char* kPairRemedy =
    "state which it is: --columns \"z [um]\" for one number with a decimal comma, --columns \"x [um], z [um]\" for two";

}  // namespace ringfilm::io
