#include "ringfilm/instrument/table/text_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/instrument/grid/number_from.hpp"

namespace ringfilm::instrument {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

constexpr std::string_view kMissingWords[] = {"nan",     "-nan",    "bad", "no data", "nodata",
                                              "no_data", "missing", "n/a", "invalid", "---"};

}  // namespace

std::optional<std::string> from_utf16(std::string_view bytes) {
  const bool low_first = bytes.substr(0, 2) == "\xFF\xFE";
  if (!low_first && bytes.substr(0, 2) != "\xFE\xFF") return std::nullopt;
  const auto unit = [&](std::size_t i) {
    return std::uint32_t{number_at<std::uint16_t>(bytes.data() + i, low_first ? ByteOrder::kLittle : ByteOrder::kBig)};
  };
  std::string text;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code >= 0xD800 && code < 0xDC00 && i + 3 < bytes.size()) {  // the first of two
      code = 0x10000 + ((code - 0xD800) << 10) + ((unit(i + 2) - 0xDC00) & 0x3FF);
      i += 2;
    }
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xC0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
      if (code >= 0x10000) {
        text += static_cast<char>(0xF0 | code >> 18);
        text += static_cast<char>(0x80 | (code >> 12 & 0x3F));
      } else {
        text += static_cast<char>(0xE0 | code >> 12);
      }
      text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return text;
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view stripped(std::string_view text) {
  text = without_blanks(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

bool is_comment(std::string_view line) {
  line = without_blanks(line);
  if (line.empty()) return false;
  return line.front() == '#' || line.front() == '%' || (line.size() <= 5 && lower(line.substr(0, 4)) == "sep=");
}

bool is_missing_word(std::string_view cell) {
  if (cell.empty()) return true;
  if (cell.size() > 7) return false;
  const std::string word = lower(cell);
  return std::find(std::begin(kMissingWords), std::end(kMissingWords), word) != std::end(kMissingWords);
}

std::optional<double> number_of(std::string_view cell, bool decimal_commas) {
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  char turned[64];
  if (decimal_commas && cell.size() < sizeof turned && cell.find(',') != std::string_view::npos) {
    std::copy(cell.begin(), cell.end(), turned);
    *std::find(turned, turned + cell.size(), ',') = '.';
    cell = std::string_view(turned, cell.size());
  }
  const std::optional<double> value = number_from<double>(cell);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

char separator_of(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return ';';
  const std::string_view inner = stripped(line);
  if (inner.find('\t') != std::string_view::npos) return '\t';
  if (inner.find(',') == std::string_view::npos) return ' ';
  if (inner.find(' ') == std::string_view::npos) return ',';
  // "0,5 0,7": each comma is between two digits, and blanks part the numbers.
  const auto digit = [inner](std::size_t i) { return i < inner.size() && inner[i] >= '0' && inner[i] <= '9'; };
  for (std::size_t i = inner.find(','); i != std::string_view::npos; i = inner.find(',', i + 1)) {
    if (i == 0 || !digit(i - 1) || !digit(i + 1)) return ',';
  }
  return ' ';
}

bool Cells::next(std::string_view& cell) {
  if (separator_ == ' ') {
    while (place_ < line_.size() && is_blank(line_[place_])) ++place_;
    if (place_ >= line_.size()) return false;
    start_ = place_;
    while (place_ < line_.size() && !is_blank(line_[place_])) ++place_;
    cell = stripped(line_.substr(start_, place_ - start_));
    return true;
  }
  if (place_ > line_.size()) return false;
  start_ = place_;
  const std::size_t end = std::min(line_.find(separator_, place_), line_.size());
  place_ = end + 1;
  cell = stripped(line_.substr(start_, end - start_));
  return true;
}

int Cells::column() const { return static_cast<int>(std::min<std::size_t>(start_, 1000000)) + 1; }

Column column_of(std::string_view header) {
  for (const auto& [opening, closing] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t first = header.find(opening), last = header.rfind(closing);
    if (first != std::string_view::npos && last != std::string_view::npos && first < last) {
      return {lower(stripped(header.substr(0, first))), trimmed(utf8_from(header.substr(first + 1, last - first - 1)))};
    }
  }
  return {lower(stripped(header)), ""};
}

}  // namespace ringfilm::instrument
