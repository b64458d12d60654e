#pragma once
#include <string>

#include "ringfilm/instrument/channel.hpp"

/// Heights as text: a matrix, listed points x, y, z, or a profile x, z.
namespace ringfilm::instrument {

enum class TableLayout {
  kByContent,  ///< by the names of the columns, else by their number: one or two a profile, three points, more a matrix
  kMatrix,
  kPoints,
  kProfile
};

/// Is this text whose first line of numbers or names could start a table of heights?
bool looks_like_table(const std::string& bytes);

/// Reads values parted by semicolon, tabulator, comma or blanks; decimal commas where they cannot part. Lines that
/// start with '#' say nothing but "Width", "Height" and "Value units" as Gwyddion writes them. An empty cell, nan or
/// BAD is a missing height. A header names the columns x, y and z (or height), each with its unit in brackets if it has
/// one. Points may come in any order on an even grid; row 0 is the smallest y. Throws InputError with line and column.
/// @param file name for messages
InstrumentFile read_height_table(const std::string& file, const std::string& bytes, TableLayout layout);

}  // namespace ringfilm::instrument
