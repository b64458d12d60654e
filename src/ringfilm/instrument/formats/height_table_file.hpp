#pragma once
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"

/// Heights as text: a matrix, listed points x, y, z, or a profile x, z.
namespace ringfilm::instrument {

enum class TableLayout {
  /// By the names of the columns; a matrix where comments state Width and Height; else by the number of columns: one or
  /// two a profile, three points, more a matrix.
  kByContent,
  kMatrix,
  kPoints,
  kProfile
};

enum class TextKind {
  kNone,   ///< not text
  kTable,  ///< its first line with content could start a table of heights: a number, or x, y, z or height
  kOther   ///< other text
};

/// How a file begins.
struct TextHead {
  TextKind kind = TextKind::kNone;
  int line = 0;       ///< from 1, of the first line that is neither blank nor a comment
  std::string words;  ///< that line
};

TextHead text_head(const std::string& bytes);

/// Reads values parted by semicolon, tabulator, comma or blanks; decimal commas where they cannot part. Lines that
/// start with '#' or '%' state nothing but what Gwyddion and SPIP write: width, height and unit of the values. Where
/// one of them comes again behind rows, another channel begins. An empty cell, nan, BAD or "No Data" is a missing
/// height. A header names the columns x, y and z (or height), each with its unit in brackets or in the row below if it
/// has one. Points may come in any order on an even grid; row 0 is the smallest y. Throws InputError with line and
/// column.
/// @param file name for messages
InstrumentFile read_height_table(const std::string& file, const std::string& bytes, TableLayout layout);

}  // namespace ringfilm::instrument
