#pragma once
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"
#include "ringfilm/io/table/text_table.hpp"

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
  kTable,  ///< its first line with content could start a table of heights: numbers, or x, y, z or height right above
           ///< the first numbers
  kOther   ///< other text
};

/// How a file begins.
struct TextHead {
  TextKind kind = TextKind::kNone;
  int line = 0;          ///< from 1, of the first line that is neither blank nor a comment
  std::string words;     ///< that line
  int numbers_line = 0;  ///< first line of numbers alone, from 1; 0: none was found
};

/// @param stated what the user states of the table
TextHead text_head(const std::string& bytes, const io::TableReading& stated = {});

/// Reads a text of numbers (io/table/text_table.hpp). Comments state nothing but what Gwyddion and SPIP write: width,
/// height and unit of the values. Where one of them comes again behind rows, another channel begins. An empty cell,
/// nan, BAD or "No Data" is a missing height. A header names the columns x, y and z (or height), each with its unit in
/// brackets or in the row below if it has one. Points may come in any order on an even grid; row 0 is the smallest y.
/// Throws InputError with line and column.
/// @param file name for messages
/// @param stated what the user states of the table
InstrumentFile read_height_table(const std::string& file, const std::string& bytes, TableLayout layout,
                                 const io::TableReading& stated = {});

}  // namespace ringfilm::instrument
