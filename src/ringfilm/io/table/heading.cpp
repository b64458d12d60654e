#include "ringfilm/io/table/heading.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/io/table/text_cells.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {
namespace {

/// The unit that a cell of the row of units states; nothing where it states none.
std::optional<std::string> unit_of(std::string cell) {
  if (cell.size() >= 2 &&
      ((cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')'))) {
    cell = trimmed(cell.substr(1, cell.size() - 2));
  }
  if (cell.empty()) return std::nullopt;
  return cell == "-" ? "1" : cell;
}

/// Where the parenthesis opens that ends a text; nothing where none does, or nothing is before it.
std::optional<std::size_t> last_parenthesis(const std::string& text) {
  int depth = 0;
  for (std::size_t i = text.size(); i-- > 1;) {
    depth += text[i] == ')' ? 1 : text[i] == '(' ? -1 : 0;
    if (depth == 0) return text[i] == '(' ? std::optional(i) : std::nullopt;
  }
  return std::nullopt;
}

/// Without the signs that part a name from its unit.
std::string bare_name(std::string name) {
  name = trimmed(name);
  while (!name.empty() && (name.back() == '_' || name.back() == ',' || name.back() == '/')) {
    name = trimmed(name.substr(0, name.size() - 1));
  }
  return name;
}

}  // namespace

Heading heading_of(std::string_view cell) {
  const std::string text(cell);
  const std::size_t open = text.find('['), close = text.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return {text, std::nullopt, text, 1, 1};
  return {bare_name(text.substr(0, open)), trimmed(text.substr(open + 1, close - open - 1)), text, 1, 1};
}

bool is_validity(const std::string& name) { return lower(name) == "valid" || lower(name) == "validity"; }

bool is_any_unit(const std::string& text) {
  static constexpr const char* kDimensions[] = {"m",   "degree", "Pa",    "s",  "K",    "N",    "rad/s", "m/s",
                                                "m-2", "Pa s",   "kg/m3", "m3", "m2/s", "Pa-1", "K-1",   "N/m"};
  const Units units;
  const auto measures = [&units](const std::string& unit) {
    return std::any_of(std::begin(kDimensions), std::end(kDimensions),
                       [&](const char* of) { return units.measures(unit, of); });
  };
  if (text.size() > 3 && text.back() == 'g' && units.measures(text.substr(0, text.size() - 1), "Pa")) return true;
  return measures(text);
}

std::optional<Heading> with_unit_of_name(const Heading& heading,
                                         const std::function<bool(const std::string&)>& is_unit) {
  if (heading.unit) return std::nullopt;
  const std::string& name = heading.name;
  const auto parted = [&](std::size_t end_of_name, const std::string& unit) -> std::optional<Heading> {
    const std::string before = bare_name(name.substr(0, end_of_name));
    if (before.empty() || unit.empty() || !is_unit(unit)) return std::nullopt;
    return Heading{before, unit, heading.text, heading.column, heading.unit_column};
  };
  if (const std::optional<std::size_t> open = last_parenthesis(name)) {
    return parted(*open, trimmed(name.substr(*open + 1, name.size() - *open - 2)));
  }
  for (const char sign : {'/', ',', '_', ' '}) {
    // The first slash, since a unit may have one of its own: "speed / m/s".
    const std::size_t at = sign == '/' ? name.find(sign) : name.rfind(sign);
    if (at == std::string::npos) continue;
    if (std::optional<Heading> found = parted(at, trimmed(name.substr(at + 1)))) return found;
  }
  return std::nullopt;
}

std::optional<StatedUnits> row_of_units(const std::vector<std::string>& cells, std::size_t n_columns) {
  const bool ends_with_separator = cells.size() == n_columns + 1 && cells.back().empty();
  const auto end = cells.end() - (ends_with_separator ? 1 : 0);
  const auto holds_digits = [](const std::string& cell) { return is_number(cell) || starts_number(cell); };
  const auto is_empty = [](const std::string& cell) { return cell.empty(); };
  if (static_cast<std::size_t>(end - cells.begin()) != n_columns || std::any_of(cells.begin(), end, holds_digits) ||
      std::all_of(cells.begin(), end, is_empty)) {
    return std::nullopt;
  }
  StatedUnits units;
  std::transform(cells.begin(), end, std::back_inserter(units), unit_of);
  return units;
}

}  // namespace ringfilm::io
