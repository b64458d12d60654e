#include "ringfilm/io/table/number_commas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ringfilm::io {
namespace {

constexpr std::size_t kGroup = 3;  // digits of a group of thousands
constexpr double kLong = 100;      // least number of three digits

bool are_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string_view without_sign(std::string_view number) {
  if (!number.empty() && (number.front() == '-' || number.front() == '+')) number.remove_prefix(1);
  return number;
}

/// "1,002" and "-12,345"; not "0,500", "1,02" and "1000,500".
bool may_part_thousands(std::string_view number, std::size_t comma) {
  const std::string_view whole = without_sign(number.substr(0, comma)), behind = number.substr(comma + 1);
  return behind.size() == kGroup && are_digits(behind) && are_digits(whole) && whole.size() <= kGroup &&
         whole.front() != '0';
}

std::string without_comma(std::string_view number, const char* in_its_place) {
  const std::size_t comma = number.find(',');
  return std::string(number.substr(0, comma)) + in_its_place + std::string(number.substr(comma + 1));
}

}  // namespace

void NumberCommas::see(const CellInText& number, double value, std::size_t column) {
  if (column >= columns_.size()) columns_.resize(column + 1);
  const std::size_t comma = number.cell.find(',');
  if (comma == std::string_view::npos) {
    if (std::abs(value) >= kLong) columns_[column].has_long = true;
    if (!has_points_) has_points_ = number.cell.find('.') != std::string_view::npos;
    return;
  }
  has_commas_ = true;
  if (shows_decimals_) return;
  if (!may_part_thousands(number.cell, comma)) {
    shows_decimals_ = true;
  } else if (!columns_[column].first) {
    columns_[column].first = number;
  }
}

std::optional<CommaDoubt> NumberCommas::doubt(char separator) const {
  if (shows_decimals_) return std::nullopt;
  for (const Column& column : columns_) {
    if (!column.first || !(column.has_long || has_points_ || separator == ',')) continue;
    const std::string_view cell = column.first->cell;
    const std::string thousands = without_comma(cell, ""), decimal = without_comma(cell, ".");
    return CommaDoubt{
        *column.first,
        fmt::format("\"{}\" may be {} or {}: each comma is in front of three digits, and {}", cell, thousands, decimal,
                    column.has_long ? "other numbers of the column have three digits or more without one"
                    : has_points_   ? "other numbers of the file have decimal points"
                                    : "commas separate the columns"),
        fmt::format("if it is {}, write thousands without commas; if it is {}, write decimal points, or four decimals",
                    thousands, decimal)};
  }
  return std::nullopt;
}

void CellPairs::see(const CellInText& cell, std::size_t place) {
  if (!may_be_) return;
  has_any_ = true;
  const bool is_second = place % 2 == 1;
  may_be_ = are_digits(is_second ? cell.cell : without_sign(cell.cell));
  const bool is_shown = is_second ? cell.cell.size() > 1 && cell.cell.front() == '0' : cell.cell == "-0";
  if (is_shown && !shown_) shown_ = cell;
}

std::optional<CommaDoubt> CellPairs::doubt(std::size_t n_columns) const {
  if (!may_be_numbers() || !shown_ || n_columns % 2 != 0) return std::nullopt;
  return CommaDoubt{*shown_,
                    fmt::format("\"{}\" is not a whole number: the {} values of a row may be {} with decimal commas",
                                shown_->cell, n_columns, n_columns / 2),
                    n_columns == 2 ? kPairRemedy
                                   : "with decimal commas, separate the columns by semicolons; else name each column "
                                     "with --columns"};
}

}  // namespace ringfilm::io
