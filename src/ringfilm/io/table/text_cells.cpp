#include "ringfilm/io/table/text_cells.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace ringfilm::io {
namespace {

bool is_blank_sign(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::string_view kMissingWords[] = {
    "nan",  "-nan", "bad",  "no data", "nodata",  "no_data",  "missing", "n/a",     "invalid",  "na",        "null",
    "none", "#n/a", "void", "#nv",     "1.#qnan", "-1.#qnan", "1.#ind",  "-1.#ind", "nan(ind)", "-nan(ind)", "masked",
    "inf",  "-inf", "+inf", "#num!",   "#div/0!", "1.#inf",   "-1.#inf", "-",       "."};

/// The number that fills a text, also one that is not finite; nothing: the text is not a number.
std::optional<double> whole_number_of(std::string_view text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank_sign(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank_sign(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view stripped(std::string_view text) {
  text = without_blanks(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = without_blanks(text.substr(1, text.size() - 2));
  }
  return text;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

std::optional<char> stated_separator(std::string_view line) {
  line = stripped(line);
  if (line.size() < 4 || line.size() > 6 || lower(line.substr(0, 4)) != "sep=") return std::nullopt;
  return line.size() == 4 ? '\t' : line[4];
}

bool is_comment(std::string_view line) {
  line = without_blanks(line);
  if (line.empty()) return false;
  if (line.front() == '#' || line.front() == '%' || line.starts_with("//")) return true;
  if (line.size() <= 7 && stated_separator(line)) return true;
  if (line.front() != ';') return false;
  const std::string_view second = stripped(line.substr(1, line.find(';', 1) - 1));
  return !second.empty() && !is_missing_word(second) && !number_of(second, true);
}

bool is_missing_word(std::string_view cell) {
  if (cell.empty()) return true;
  if (cell.size() > 9) return false;
  if (cell.size() >= 2 && cell.find_first_not_of(cell.front() == '*' ? '*' : '-') == std::string_view::npos)
    return true;
  const std::string word = lower(cell);
  return std::find(std::begin(kMissingWords), std::end(kMissingWords), word) != std::end(kMissingWords);
}

std::optional<double> truth_of(std::string_view cell) {
  if (cell.size() < 4 || cell.size() > 5) return std::nullopt;
  const std::string word = lower(cell);
  return word == "true" ? std::optional(1.0) : word == "false" ? std::optional(0.0) : std::nullopt;
}

std::optional<double> number_of(std::string_view cell, bool decimal_commas) {
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  if (std::optional<double> value = whole_number_of(cell)) return std::isfinite(*value) ? value : std::nullopt;
  char turned[64];
  if (cell.empty() || cell.size() >= sizeof turned) return std::nullopt;
  char* const end = std::copy(cell.begin(), cell.end(), turned);
  if (decimal_commas) {
    char* const comma = std::find(turned, end, ',');
    if (comma != end) *comma = '.';
  }
  // 1.0D-3 of Fortran: an exponent follows a digit or a point.
  char* const power = std::find_if(turned, end, [](char c) { return c == 'd' || c == 'D'; });
  if (power != end && power != turned && (is_digit(power[-1]) || power[-1] == '.')) *power = 'e';
  const std::optional<double> value = whole_number_of({turned, static_cast<std::size_t>(end - turned)});
  return value && std::isfinite(*value) ? value : std::nullopt;
}

bool is_number(std::string_view cell) { return whole_number_of(cell).has_value(); }

bool starts_number(std::string_view cell) {
  const std::size_t first = cell.find_first_not_of("+-.");
  return first != std::string_view::npos && is_digit(cell[first]);
}

char separator_of(std::string_view line) {
  // What lies between quotes parts nothing: "Crank angle, deg";"Pressure, bar".
  std::string bare;
  bool is_quoted = false;
  if (line.find('"') != std::string_view::npos && std::count(line.begin(), line.end(), '"') % 2 == 0) {
    for (const char c : line) {
      is_quoted = is_quoted != (c == '"');
      bare += is_quoted ? '"' : c;
    }
    line = bare;
  }
  if (line.find(';') != std::string_view::npos) return ';';
  const std::string_view inner = stripped(line);
  if (inner.find('\t') != std::string_view::npos) return '\t';
  if (inner.find(',') == std::string_view::npos) return ' ';
  if (inner.find(' ') == std::string_view::npos) return ',';
  // "0,5 0,7": each comma is between two digits, and blanks part the numbers.
  const auto digit = [inner](std::size_t i) { return i < inner.size() && is_digit(inner[i]); };
  for (std::size_t i = inner.find(','); i != std::string_view::npos; i = inner.find(',', i + 1)) {
    if (i == 0 || !digit(i - 1) || !digit(i + 1)) return ',';
  }
  return ' ';
}

std::size_t Cells::end_of_cell() const {
  std::size_t first = place_;
  while (first < line_.size() && line_[first] != separator_ && is_blank_sign(line_[first])) ++first;
  const std::size_t closing = first < line_.size() && line_[first] == '"' ? line_.find('"', first + 1) : line_.npos;
  if (closing != line_.npos) {
    std::size_t behind = closing + 1;
    const auto is_end = [&] {
      return behind == line_.size() || line_[behind] == separator_ ||
             (separator_ == ' ' && is_blank_sign(line_[behind]));
    };
    while (!is_end() && is_blank_sign(line_[behind])) ++behind;
    if (is_end()) return behind;
  }
  return std::min(line_.find(separator_, place_), line_.size());
}

bool Cells::next(std::string_view& cell) {
  std::size_t end = 0;
  if (separator_ == ' ') {
    while (place_ < line_.size() && is_blank_sign(line_[place_])) ++place_;
    if (place_ >= line_.size()) return false;
    start_ = place_;
    if (line_[place_] == '"') {
      end = end_of_cell();
    } else {
      end = place_;
      while (end < line_.size() && !is_blank_sign(line_[end])) ++end;
    }
    place_ = end;
  } else {
    if (place_ > line_.size()) return false;
    start_ = place_;
    end = end_of_cell();
    place_ = end + 1;
  }
  const std::string_view whole = without_blanks(line_.substr(start_, end - start_));
  cell = stripped(whole);
  is_quoted_ = cell.size() < whole.size();
  start_ = cell.empty() ? start_ : static_cast<std::size_t>(cell.data() - line_.data());
  return true;
}

int Cells::column() const { return static_cast<int>(std::min<std::size_t>(start_, 1000000)) + 1; }

std::vector<PlacedCell> cells_of(std::string_view line, char separator) {
  std::vector<PlacedCell> found;
  Cells cells(line, separator);
  for (std::string_view cell; cells.next(cell);) found.push_back({std::string(cell), cells.column()});
  return found;
}

}  // namespace ringfilm::io
