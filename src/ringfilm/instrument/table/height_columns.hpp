#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/table/heading.hpp"

/// Which columns of a table of points or of a profile are places, and which are heights.
namespace ringfilm::instrument {

/// The columns of a table by their names.
struct HeightColumns {
  std::optional<std::size_t> x, y, z;
  std::optional<std::size_t> valid;  ///< 1 where the point was measured
  std::string account;               ///< names that are not x, y and z, and what they were taken for; may be empty
  std::string unused;                ///< names of the other columns; may be empty

  bool has_heights() const { return z.has_value(); }
};

/// Known names are x, y, z, height, and those of programs: altitude, lateral, total profile, encoder1, encoder2, valid.
/// Where there is no z, the only other column beside x is the height where it is named y or y1.
HeightColumns height_columns(const std::vector<io::Heading>& columns);

/// With the units of lengths in names as programs write them taken out of these: X_(microns), Z / nm, x_um. The unit A
/// of a place or a height is the angstrom.
std::vector<io::Heading> with_lengths_in_names(std::vector<io::Heading> columns);

/// Do the names show a table of points or a profile?
bool name_heights(const std::vector<io::Heading>& columns);

}  // namespace ringfilm::instrument
