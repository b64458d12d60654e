#include "ringfilm/instrument/table/height_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "ringfilm/io/table/text_cells.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::instrument {
namespace {

enum class Meaning { kX, kY, kZ };

/// A name of a column in small letters; the names of the first rows go before those of the last.
struct KnownName {
  std::string_view name;
  Meaning meaning;
};
constexpr KnownName kKnownNames[] = {{"x", Meaning::kX},
                                     {"y", Meaning::kY},
                                     {"z", Meaning::kZ},
                                     {"height", Meaning::kZ},
                                     {"h", Meaning::kZ},
                                     {"altitude", Meaning::kZ},
                                     {"total profile", Meaning::kZ},
                                     {"lateral", Meaning::kX},
                                     {"encoder1", Meaning::kX},
                                     {"encoder2", Meaning::kY}};

std::optional<std::size_t> find_name(const std::vector<io::Heading>& columns, std::string_view name) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (io::lower(columns[i].name) == name) return i;
  }
  return std::nullopt;
}

/// "name [unit]" as in the file.
std::string shown_name(const io::Heading& column) {
  return column.name + (column.unit ? " [" + *column.unit + "]" : "");
}

/// The names of the columns that are neither taken nor put aside with -.
std::string unused_columns(const std::vector<io::Heading>& columns, const HeightColumns& taken) {
  std::string names;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool is_taken = taken.x == i || taken.y == i || taken.z == i || taken.valid == i;
    if (is_taken || columns[i].name == "-" || columns[i].name.empty()) continue;
    names += (names.empty() ? "" : ", ") + shown_name(columns[i]);
  }
  return names;
}

/// Programs write A for angstrom; a current is not among the columns of places and heights.
void read_angstrom(io::Heading& column) {
  const std::string name = io::lower(column.name);
  const bool is_length = std::any_of(std::begin(kKnownNames), std::end(kKnownNames),
                                     [&name](const KnownName& known) { return known.name == name; });
  if (is_length && column.unit == "A") column.unit = "angstrom";
}

}  // namespace

HeightColumns height_columns(const std::vector<io::Heading>& columns) {
  HeightColumns found;
  for (const KnownName& known : kKnownNames) {
    std::optional<std::size_t>& place = known.meaning == Meaning::kX   ? found.x
                                        : known.meaning == Meaning::kY ? found.y
                                                                       : found.z;
    if (!place) place = find_name(columns, known.name);
  }
  for (std::size_t i = 0; i < columns.size() && !found.valid; ++i) {
    if (io::is_validity(columns[i].name)) found.valid = i;
  }
  if (!found.z && found.x) {  // x and y alone are a profile
    if (!found.y) found.y = find_name(columns, "y1");
    std::swap(found.y, found.z);
  }
  const auto add = [&](const std::optional<std::size_t>& place, std::string_view usual, const char* what) {
    if (!place || io::lower(columns[*place].name) == usual) return;
    found.account += fmt::format("{}{}: column {} ({})", found.account.empty() ? "" : ", ", what, *place + 1,
                                 shown_name(columns[*place]));
  };
  add(found.x, "x", "x");
  add(found.y, "y", "y");
  if (found.z && io::lower(columns[*found.z].name) != "height") add(found.z, "z", "heights");
  add(found.valid, "", "measured where 1");
  found.unused = unused_columns(columns, found);
  return found;
}

std::vector<io::Heading> with_lengths_in_names(std::vector<io::Heading> columns) {
  const io::Units units;
  const auto is_length = [&units](const std::string& unit) { return units.measures(unit, "m"); };
  for (io::Heading& column : columns) {
    if (column.unit) {
      read_angstrom(column);
      continue;
    }
    const std::size_t open = column.name.find('('), close = column.name.rfind(')');
    if (open != std::string::npos && close != std::string::npos && open < close && open > 0) {
      // Whatever is in parentheses is the unit: that it is not a length is reported with it.
      io::Heading in_brackets =
          io::heading_of(column.name.substr(0, open) + "[" + column.name.substr(open + 1, close - open - 1) + "]");
      column.name = in_brackets.name;
      column.unit = in_brackets.unit;
      read_angstrom(column);
    } else if (const std::optional<io::Heading> parted = io::with_unit_of_name(column, is_length)) {
      column = *parted;
    }
  }
  return columns;
}

bool name_heights(const std::vector<io::Heading>& columns) {
  const std::vector<io::Heading> named = with_lengths_in_names(columns);
  std::size_t n_known = 0;
  for (const KnownName& known : kKnownNames) n_known += find_name(named, known.name).has_value() ? 1 : 0;
  if (n_known >= 2) return true;
  if (named.empty()) return false;
  // x and another column, or a column of heights alone.
  const std::string first = io::lower(named.front().name);
  return std::any_of(std::begin(kKnownNames), std::end(kKnownNames),
                     [&](const KnownName& known) { return known.name == first; });
}

}  // namespace ringfilm::instrument
