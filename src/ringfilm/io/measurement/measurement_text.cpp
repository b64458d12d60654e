#include "ringfilm/io/measurement/measurement_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ringfilm::io {
namespace {

constexpr std::size_t kLineLength = 100;
constexpr std::size_t kGap = 2;

/// Letters on a screen: a sign of several bytes in UTF-8 counts once.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Words between which a line may end: never after a number, so that its unit stays with it.
std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  bool after_number = false;
  for (std::string word; stream >> word;) {
    if (after_number) {
      words.back() += " " + word;
    } else {
      words.push_back(word);
    }
    after_number = word.find_first_not_of("0123456789.+-e") == std::string::npos;
  }
  return words;
}

/// Lines of at most `space` letters.
std::vector<std::string> broken(const std::string& text, std::size_t space) {
  std::vector<std::string> lines(1);
  for (const std::string& word : words(text)) {
    if (!lines.back().empty() && width(lines.back()) + 1 + width(word) > space) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

/// A paragraph after a head such as "note:", its further lines set in.
std::string paragraph(const std::string& head, const std::string& text) {
  constexpr const char* kIndent = "    ";
  std::string out;
  for (const std::string& line : broken(head + text, kLineLength - 4))
    out += (out.empty() ? "" : kIndent) + line + "\n";
  return out;
}

enum class Align { kLeft, kRight };

struct TableCell {
  std::string text;
  Align align = Align::kLeft;
};

using Row = std::vector<TableCell>;

std::string padded(const TableCell& cell, const std::string& text, std::size_t space) {
  const std::string blanks(space - std::min(space, width(text)), ' ');
  return cell.align == Align::kLeft ? text + blanks : blanks + text;
}

/// Rows under each other but empty ones; what is wider than its column continues in further lines of the row.
std::string set_out(const std::vector<Row>& rows, const std::vector<std::size_t>& widths) {
  std::string out;
  for (const Row& row : rows) {
    if (std::all_of(row.begin(), row.end(), [](const TableCell& cell) { return cell.text.empty(); })) continue;
    std::vector<std::vector<std::string>> lines;
    std::size_t n_lines = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      lines.push_back(broken(row[i].text, widths[i]));
      n_lines = std::max(n_lines, lines.back().size());
    }
    for (std::size_t k = 0; k < n_lines; ++k) {
      std::string line;
      for (std::size_t i = 0; i < row.size(); ++i) {
        line += std::string(kGap, ' ') + padded(row[i], k < lines[i].size() ? lines[i][k] : "", widths[i]);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      out += line + "\n";
    }
  }
  return out;
}

std::vector<std::size_t> natural_widths(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i].text));
  }
  return widths;
}

std::string shown_unit(const MeasuredValue& value) {
  const std::string& unit = value.display_unit.empty() ? value.unit : value.display_unit;
  return unit == "1" ? "" : unit;
}

const std::string& short_name(const MeasuredValue& value) { return value.symbol.empty() ? value.name : value.symbol; }

/// Symbol, value, unit, meaning, and what it holds for; the last two share the space that is left.
std::string group_lines(const MeasuredGroup& group, const Units& units) {
  std::vector<Row> rows;
  for (const MeasuredValue& value : group.values) {
    rows.push_back({{short_name(value)},
                    {measured_number(value, value.value, value.standard_error, units), Align::kRight},
                    {shown_unit(value)},
                    {value.long_name},
                    {value.remark}});
  }
  std::vector<std::size_t> widths = natural_widths(rows);
  if (widths.empty()) return "";
  const std::size_t used = widths[0] + widths[1] + widths[2] + 5 * kGap;
  constexpr std::size_t kMinOfWords = 40;
  const std::size_t space = std::max(kMinOfWords, kLineLength - std::min(kLineLength, used));
  if (widths[3] + widths[4] > space) {
    const std::size_t remark = std::min(widths[4], std::max(space / 2, space - std::min(space, widths[3])));
    widths[4] = remark;
    widths[3] = std::min(widths[3], space - remark);
  }
  return "\n" + group.title + "\n" + set_out(rows, widths);
}

/// Meaning of the heads of a table; a remark that holds for all columns is reported once.
std::string meanings(const std::vector<MeasuredValue>& columns) {
  const bool one_remark = std::all_of(columns.begin(), columns.end(),
                                      [&](const auto& column) { return column.remark == columns.front().remark; });
  std::string text;
  for (const MeasuredValue& column : columns) {
    const bool is_obvious = column.long_name.empty() || column.long_name == short_name(column);
    const std::string remark = one_remark || column.remark.empty() ? "" : fmt::format(" ({})", column.remark);
    if (is_obvious && remark.empty()) continue;
    text += fmt::format("{}{}:{}{}{}", text.empty() ? "" : "; ", short_name(column), is_obvious ? "" : " ",
                        is_obvious ? "" : column.long_name, remark);
  }
  if (one_remark && !columns.front().remark.empty()) text += (text.empty() ? "" : "; ") + columns.front().remark;
  return text.empty() ? "" : "  " + paragraph("", text);
}

/// As many columns beside each other as a line takes, the labels of the rows before each such block.
std::string table_lines(const MeasuredTable& table, const Units& units) {
  if (table.values.empty() || table.values.front().empty()) return "";
  const std::size_t n_rows = table.values.front().size();
  std::vector<Row> labels = {{{""}}, {{""}}};
  for (std::size_t k = 0; k < n_rows; ++k) {
    labels.push_back({{table.row_labels.empty() ? std::to_string(k + 1) : table.row_labels[k]}});
  }
  constexpr std::size_t kWidestLabel = 40;
  const std::size_t label_width = std::min(kWidestLabel, natural_widths(labels).front());
  std::string out = "\n" + table.title + "\n";
  for (std::size_t first = 0; first < table.columns.size();) {
    std::vector<Row> rows = labels;
    std::vector<std::size_t> widths = {label_width};
    std::size_t used = kGap + label_width, next = first;
    for (; next < table.columns.size(); ++next) {
      const MeasuredValue& column = table.columns[next];
      const std::string unit = shown_unit(column);
      std::vector<std::string> cells = {short_name(column), unit.empty() ? "" : fmt::format("[{}]", unit)};
      for (const double value : table.values[next])
        cells.push_back(measured_number(column, value, std::nan(""), units));
      std::size_t widest = 0;
      for (const std::string& cell : cells) widest = std::max(widest, width(cell));
      if (next > first && used + kGap + widest > kLineLength) break;
      used += kGap + widest;
      widths.push_back(widest);
      for (std::size_t k = 0; k < cells.size(); ++k) rows[k].push_back({cells[k], Align::kRight});
    }
    if (first > 0) out += "\n";
    out += set_out(rows, widths);
    first = next;
  }
  return out + meanings(table.columns);
}

/// Digits after the point at which a number of that size ends with so many significant ones.
int decimals_for(double size, int digits) {
  return size > 0 ? digits - 1 - static_cast<int>(std::floor(std::log10(size))) : digits - 1;
}

std::string decimal_text(double value, double error, bool has_error) {
  constexpr int kDigits = 4, kMaxDigits = 7;
  if (!has_error) return fmt::format("{:.{}f}", value, std::max(0, decimals_for(std::abs(value), kDigits)));
  const double first_place = std::pow(10, std::floor(std::log10(error)));
  const int requested = decimals_for(error, error < 2 * first_place * (1 - 1e-9) ? 2 : 1);
  const int decimals = value == 0 ? requested : std::min(requested, decimals_for(std::abs(value), kMaxDigits));
  const double place = std::pow(10, -decimals);
  const double shown_error = std::ceil(error / place * (1 - 1e-9)) * place;  // 0.02 is not more than 0.02
  return fmt::format("{:.{}f} +- {:.{}f}", std::round(value / place) * place, std::max(decimals, 0), shown_error,
                     std::max(decimals, 0));
}

}  // namespace

Scale display_scale(const std::string& unit, const std::string& display_unit, const Units& units) {
  return display_unit.empty() || display_unit == unit ? Scale{} : units.scale(display_unit, unit);
}

std::string measured_number(const MeasuredValue& described, double value, double standard_error, const Units& units) {
  const Scale scale = display_scale(described.unit, described.display_unit, units);
  const double shown = scale.from_si(value);
  if (!std::isfinite(shown)) return "none";
  const double error = scale.from_si(standard_error) - scale.from_si(0);
  const bool has_error = error > 0 && std::isfinite(error);
  constexpr double kMinPlain = 1e-3, kMaxPlain = 1e6;
  const double size = std::max(std::abs(shown), has_error ? error : 0);
  const bool is_count = shown_unit(described).empty() && shown == std::floor(shown);
  if (size == 0 || (size >= kMinPlain && size < kMaxPlain)) {
    if (is_count && !has_error) return fmt::format("{:.0f}", shown + 0.0);
    return shown == 0 && !has_error ? "0" : decimal_text(shown, error, has_error);
  }
  const int power = static_cast<int>(std::floor(std::log10(size)));
  const double unit = std::pow(10, power);
  const std::string mantissa = decimal_text(shown / unit, error / unit, has_error);
  return has_error ? fmt::format("({})e{}", mantissa, power) : fmt::format("{}e{}", mantissa, power);
}

std::string measurement_text(const Measurement& measurement, const Units& units) {
  check_measurement(measurement);
  std::string text = paragraph("", measurement.title);
  for (const std::string& source : measurement.sources) text += paragraph("read: ", source);
  for (const std::string& statement : measurement.statements) text += paragraph("done: ", statement);
  bool has_error = false;
  for (const MeasuredGroup& group : measurement.groups) {
    text += group_lines(group, units);
    for (const MeasuredValue& value : group.values) has_error = has_error || value.standard_error > 0;
  }
  if (has_error) text += "  +- is one standard error\n";
  for (const MeasuredTable& table : measurement.tables) text += table_lines(table, units);
  if (!measurement.notes.empty()) text += "\n";
  for (const std::string& note : measurement.notes) text += paragraph("note: ", note);
  return text;
}

}  // namespace ringfilm::io
