#include "ringfilm/instrument/formats/height_table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/instrument/formats/binary_reader.hpp"
#include "ringfilm/instrument/regular_grid.hpp"
#include "ringfilm/io/text/csv_file.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kSniffed = 65536;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view stripped(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

bool is_missing_word(std::string_view cell) {
  if (cell.empty()) return true;
  if (cell.size() > 4) return false;
  const std::string word = lower(cell);
  return word == "nan" || word == "bad" || word == "-nan";
}

/// The number of a cell; nothing if it is not a number.
std::optional<double> number_of(std::string_view cell, bool decimal_commas) {
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  char turned[64];
  if (decimal_commas && cell.size() < sizeof turned && cell.find(',') != std::string_view::npos) {
    std::copy(cell.begin(), cell.end(), turned);
    *std::find(turned, turned + cell.size(), ',') = '.';
    cell = std::string_view(turned, cell.size());
  }
  double value = 0;
  const auto [rest, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || rest != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// What parts the cells: ';', '\t', ',' or ' ' for any blanks.
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

/// Walks over the cells of a line. An empty cell at the end of a line, after its last separator, does not count.
class Cells {
 public:
  Cells(std::string_view line, char separator) : line_(line), separator_(separator) {}

  /// @returns false behind the last cell
  bool next(std::string_view& cell) {
    if (separator_ == ' ') {
      while (place_ < line_.size() && is_blank(line_[place_])) ++place_;
      if (place_ >= line_.size()) return false;
      start_ = place_;
      while (place_ < line_.size() && !is_blank(line_[place_])) ++place_;
      cell = line_.substr(start_, place_ - start_);
      return true;
    }
    if (place_ > line_.size()) return false;
    start_ = place_;
    const std::size_t end = std::min(line_.find(separator_, place_), line_.size());
    place_ = end + 1;
    cell = stripped(line_.substr(start_, end - start_));
    return true;
  }

  int column() const { return static_cast<int>(std::min<std::size_t>(start_, 1000000)) + 1; }

 private:
  std::string_view line_;
  char separator_;
  std::size_t place_ = 0;
  std::size_t start_ = 0;
};

struct Column {
  std::string name;  ///< in lower case
  std::string unit;
};

Column column_of(std::string_view header) {
  for (const auto& [opening, closing] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t first = header.find(opening), last = header.rfind(closing);
    if (first != std::string_view::npos && last != std::string_view::npos && first < last) {
      return {lower(stripped(header.substr(0, first))), trimmed(utf8_from(header.substr(first + 1, last - first - 1)))};
    }
  }
  return {lower(stripped(header)), ""};
}

/// "10.0 um" of a comment.
struct StatedLength {
  double value = 0;
  double rounding = 0;  ///< half a unit of its last digit
  std::string unit;
};

/// The same in metres; nothing where the unit is not a length.
std::optional<StatedLength> in_metres(const StatedLength& length, const io::Units& units) {
  if (!units.measures(length.unit, "m")) return std::nullopt;
  const io::Scale scale = units.scale(length.unit, "m");
  return StatedLength{scale.to_si(length.value), scale.to_si(length.rounding), "m"};
}

/// Half a unit of the last digit that a number was written with.
double rounding_of(std::string_view number) {
  const std::size_t power = std::min(number.find_first_of("eE"), number.size());
  const std::size_t point = number.substr(0, power).find('.');
  const double decimals = point == std::string_view::npos ? 0 : static_cast<double>(power - point - 1);
  const double exponent = power < number.size() ? number_of(number.substr(power + 1), false).value_or(0) : 0;
  return 0.5 * std::pow(10.0, exponent - decimals);
}

class TableReader {
 public:
  TableReader(const std::string& file, const std::string& bytes) : file_(file), text_(bytes) {
    if (bytes.rfind("\xEF\xBB\xBF", 0) == 0) text_.remove_prefix(3);
  }

  ChannelValues read(TableLayout layout, std::string& format) {
    if (!next_line()) refuse(file_, "the file has no row of numbers", "is it the right file?");
    separator_ = separator_of(line_);
    decimal_commas_ = separator_ != ',';
    read_header();
    if (header_.empty()) {
      n_columns_ = count_cells();
    } else {
      n_columns_ = header_.size();
      const auto next_row = [this] {
        if (!next_line()) refuse(file_, "the file has no row of numbers", "is it the right file?");
      };
      next_row();
      if (read_units()) next_row();
    }
    if (layout == TableLayout::kByContent) layout = layout_by_content();
    ChannelValues values = read_heights(layout, format);
    values.notes.insert(values.notes.begin(), notes_.begin(), notes_.end());
    return values;
  }

 private:
  ChannelValues read_heights(TableLayout layout, std::string& format) {
    if (layout == TableLayout::kMatrix) {
      format = "text, matrix of heights";
      return read_matrix();
    }
    if (layout == TableLayout::kPoints) {
      format = "text, points x, y, z";
      return read_points();
    }
    format = "text, profile";
    return read_profile();
  }

  /// Goes to the next line with content; comments are looked into.
  bool next_line() {
    while (place_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', place_), text_.size());
      line_ = text_.substr(place_, end - place_);
      place_ = end + 1;
      ++number_;
      const std::string_view content = stripped(line_);
      // Of values that tabulators part, a line of tabulators is a row of missing heights.
      const bool row_of_none = content.empty() && separator_ == '\t' && line_.find('\t') != std::string_view::npos;
      if (content.empty() && !row_of_none) continue;
      if (row_of_none || content.front() != '#') return true;
      read_comment(content);
    }
    return false;
  }

  void read_comment(std::string_view content) {
    const std::size_t colon = content.find(':');
    if (colon == std::string_view::npos || content.size() > 200) return;
    const std::string key = lower(stripped(content.substr(1, colon - 1)));
    const std::string value = trimmed(utf8_from(content.substr(colon + 1)));
    if (key == "value units") {
      stated_unit_ = value;
    } else if (key == "width" || key == "height") {
      read_side(key == "width" ? width_ : height_, trimmed(utf8_from(content.substr(1, colon - 1))), value);
    }
  }

  /// A side of the map, "10.0 um". What is wrong with it is reported where the step of the map is needed.
  void read_side(std::optional<StatedLength>& side, const std::string& name, const std::string& value) {
    const std::size_t blank = value.find(' ');
    const std::string_view number = std::string_view(value).substr(0, blank);
    const std::optional<double> length = number_of(number, false);
    if (!length || blank == std::string::npos) return;
    side = StatedLength{*length, rounding_of(number), trimmed(std::string_view(value).substr(blank))};
    std::string wrong;
    if (!(*length > 0)) {
      wrong = fmt::format("{} is {}, but the side of a map is longer than 0", name, value);
    } else if (const io::Units units; units.measures(side->unit, "s")) {
      wrong = fmt::format("{} is {}, a time and not a length", name, value);
    } else if (!units.measures(side->unit, "m")) {
      wrong = fmt::format("{} is {}, and \"{}\" is not a unit of length", name, value, side->unit);
    }
    if (wrong.empty()) return;
    step_faults_.push_back(
        {{file_, number_, 1, utf8_from(line_.substr(0, 2000))}, wrong, "correct the header of the file"});
  }

  void read_header() {
    Cells cells(line_, separator_);
    std::string_view cell;
    bool numbers = true, first = true;
    std::vector<Column> header;
    // A unit in brackets may be separate from its name: "x [um] z [um]" is two columns.
    while (cells.next(cell)) {
      if (first) numbers = is_missing_word(cell) || number_of(cell, decimal_commas_).has_value();
      first = false;
      if (separator_ == ' ' && !header.empty() && (cell.front() == '[' || cell.front() == '(')) {
        header.back().unit = column_of(cell).unit;
      } else {
        header.push_back(column_of(cell));
      }
    }
    if (!numbers) header_ = std::move(header);
  }

  /// Does the line below the header state units? They are taken over.
  bool read_units() {
    std::vector<std::string> texts;
    std::vector<int> places;
    Cells cells(line_, separator_);
    for (std::string_view cell; cells.next(cell);) {
      if (!cell.empty() && is_missing_word(cell)) return false;
      texts.push_back(utf8_from(cell));
      places.push_back(cells.column());
    }
    const std::optional<io::StatedUnits> units = io::row_of_units(texts, header_.size());
    if (!units) return false;
    for (std::size_t k = 0; k < units->size(); ++k) {
      const std::optional<std::string>& below = (*units)[k];
      std::string& unit = header_[k].unit;
      if (below && !unit.empty() && unit != *below) {
        refuse_here(
            places[k],
            fmt::format("the unit of {} is {} here and {} in the header", utf8_from(header_[k].name), *below, unit),
            "keep the right one; below the header a row of text is read as units");
      }
      if (below) unit = *below;
    }
    notes_.push_back(fmt::format("the row of units in line {} was used", number_));
    return true;
  }

  std::size_t count_cells() const {
    Cells cells(line_, separator_);
    std::string_view cell;
    std::size_t count = 0;
    while (cells.next(cell)) ++count;
    const bool ends = separator_ != ' ' && count > 1 && cell.empty() && stripped(line_).back() == separator_;
    return ends && separators_end_rows() ? count - 1 : count;
  }

  /// Does a separator end each of the rows to come? If not, an empty cell at the end is a missing height.
  bool separators_end_rows() const {
    for (std::size_t begin = place_; begin < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      const std::string_view row = stripped(text_.substr(begin, end - begin));
      begin = end + 1;
      if (!row.empty() && row.front() != '#' && row.back() != separator_) return false;
    }
    return true;
  }

  TableLayout layout_by_content() const {
    if (!header_.empty()) return find({"y"}) && find({"x"}) ? TableLayout::kPoints : TableLayout::kProfile;
    if (width_ && height_) return TableLayout::kMatrix;  // a header of Gwyddion, whatever the number of columns
    if (n_columns_ <= 2) return TableLayout::kProfile;
    return n_columns_ == 3 ? TableLayout::kPoints : TableLayout::kMatrix;
  }

  std::optional<std::size_t> find(std::initializer_list<const char*> names) const {
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (std::any_of(names.begin(), names.end(), [&](const char* name) { return header_[i].name == name; })) return i;
    }
    return std::nullopt;
  }

  [[noreturn]] void refuse_here(int column, const std::string& message, const std::string& remedy) const {
    throw InputError(std::vector<Fault>{{{file_, number_, column, utf8_from(line_.substr(0, 2000))}, message, remedy}});
  }

  /// All cells of the line as numbers, NaN where a height is missing.
  void read_cells(std::vector<double>& row) const {
    row.clear();
    Cells cells(line_, separator_);
    std::string_view cell;
    while (cells.next(cell)) {
      if (is_missing_word(cell)) {
        row.push_back(kMissing);
        continue;
      }
      const std::optional<double> value = number_of(cell, decimal_commas_);
      if (!value) {
        refuse_here(cells.column(), fmt::format("\"{}\" is not a finite number", utf8_from(cell.substr(0, 40))),
                    "a number is required here, or nothing where no height was measured");
      }
      row.push_back(*value);
    }
    if (row.size() == n_columns_ + 1 && cell.empty()) row.pop_back();
    if (row.size() != n_columns_) {
      refuse_here(1, fmt::format("the row has {} values, and {} are required", row.size(), n_columns_),
                  separator_ == ',' && row.size() == 2 * n_columns_
                      ? "with decimal commas, part the columns by semicolons"
                      : "give every row as many values as the first");
    }
  }

  ChannelValues read_matrix() {
    if (!header_.empty()) {
      refuse_here(1, "a matrix of heights has no header",
                  "take the names of the columns out, or start the line with #");
    }
    ChannelValues values;
    std::vector<double> row;
    do {
      read_cells(row);
      values.value.insert(values.value.end(), row.begin(), row.end());
      ++values.channel.points_y;
      if (values.value.size() > kMostPoints) refuse_here(1, "the matrix has too many points", "cut it into parts");
    } while (next_line());
    values.channel.points_x = n_columns_;
    values.channel.unit = stated_unit_;
    take_missing(values);
    share_unit_of_sides();
    values.step_faults = step_faults_;
    const bool is_positive = width_ && height_ && width_->value > 0 && height_->value > 0;
    if (is_positive && width_->unit == height_->unit) {
      values.step_x = width_->value / static_cast<double>(values.channel.points_x);
      values.step_y = height_->value / static_cast<double>(values.channel.points_y);
      values.step_unit = width_->unit;
      note_uneven_steps(values);
    }
    return values;
  }

  /// Gwyddion writes each side in a unit that suits its size: "Width: 10 um", "Height: 10 mm".
  void share_unit_of_sides() {
    if (!width_ || !height_ || width_->unit == height_->unit) return;
    const io::Units units;
    const std::optional<StatedLength> width = in_metres(*width_, units), height = in_metres(*height_, units);
    if (!width || !height) return;
    width_ = width;
    height_ = height;
  }

  /// A matrix that was cut behind a row shows only in this: its stated height spreads over fewer rows.
  void note_uneven_steps(ChannelValues& values) const {
    const double rounding = width_->rounding / static_cast<double>(values.channel.points_x) +
                            height_->rounding / static_cast<double>(values.channel.points_y);
    if (std::abs(values.step_x - values.step_y) <= rounding) return;
    values.notes.push_back(fmt::format(
        "{} columns over the stated width of {:.6g} {} and {} rows over the stated height of {:.6g} {} give "
        "steps of {:.6g} and {:.6g} {}: if they should be equal, the file lacks rows or columns",
        values.channel.points_x, width_->value, width_->unit, values.channel.points_y, height_->value, height_->unit,
        values.step_x, values.step_y, values.step_unit));
  }

  static void take_missing(ChannelValues& values) {
    for (std::size_t i = 0; i < values.value.size(); ++i) {
      if (!std::isnan(values.value[i])) continue;
      if (values.missing.empty()) values.missing.assign(values.value.size(), 0);
      values.missing[i] = 1;
      values.value[i] = 0;
    }
  }

  /// The column of that name, or the one of that place where the file names none.
  std::size_t column(std::initializer_list<const char*> names, std::size_t place) const {
    if (header_.empty()) return place;
    const std::optional<std::size_t> found = find(names);
    if (!found) {
      std::string all;
      for (const Column& c : header_) all += (all.empty() ? "" : ", ") + utf8_from(c.name);
      refuse(file_, fmt::format("there is no column {} among: {}", *names.begin(), all.substr(0, 400)),
             "name the columns x, y and z, for example: x [um],y [um],z [nm]");
    }
    return *found;
  }

  std::string unit_of(std::size_t column) const { return column < header_.size() ? header_[column].unit : ""; }

  void check_place(double place, const char* name) const {
    if (std::isnan(place))
      refuse_here(1, fmt::format("the row has no {}", name), "a place is required for each height");
  }

  ChannelValues read_points() {
    if (n_columns_ < 3) refuse_here(1, "points need three columns", "x, y and the height");
    const std::size_t x = column({"x"}, 0), y = column({"y"}, 1), z = column({"z", "height", "h"}, 2);
    if (unit_of(x) != unit_of(y)) {
      refuse(file_, fmt::format("x is in \"{}\" and y in \"{}\"", unit_of(x), unit_of(y)), "give both the same unit");
    }
    ListedPoints points;
    std::vector<double> row;
    do {
      read_cells(row);
      check_place(row[x], "x");
      check_place(row[y], "y");
      points.x.push_back(row[x]);
      points.y.push_back(row[y]);
      points.value.push_back(row[z]);
    } while (next_line());
    ChannelValues values = on_regular_grid(file_, points);
    values.channel.unit = unit_of(z);
    values.step_unit = unit_of(x);
    return values;
  }

  ChannelValues read_profile() {
    const bool has_places = header_.empty() ? n_columns_ > 1 : find({"x"}).has_value();
    const std::size_t x = has_places ? column({"x"}, 0) : 0;
    const std::size_t z = column({"z", "height", "h"}, has_places ? 1 : 0);
    ChannelValues values;
    std::vector<double> row;
    do {
      read_cells(row);
      if (has_places) {
        check_place(row[x], "x");
        if (!values.x.empty() && !(row[x] > values.x.back())) {
          refuse_here(1, fmt::format("x falls or repeats: {} after {}", row[x], values.x.back()),
                      "sort the rows by x; give each place one height");
        }
        values.x.push_back(row[x]);
      }
      values.value.push_back(row[z]);
    } while (next_line());
    values.channel.points_x = values.value.size();
    values.channel.points_y = 1;
    values.channel.unit = unit_of(z);
    values.step_unit = has_places ? unit_of(x) : "";
    take_missing(values);
    return values;
  }

  std::string file_;
  std::string_view text_;
  std::size_t place_ = 0;
  std::string_view line_;
  int number_ = 0;
  char separator_ = ',';
  bool decimal_commas_ = false;
  std::vector<Column> header_;
  std::size_t n_columns_ = 0;
  std::string stated_unit_;
  std::optional<StatedLength> width_, height_;
  std::vector<Fault> step_faults_;  ///< of width and height
  std::vector<std::string> notes_;
};

}  // namespace

TextHead text_head(const std::string& bytes) {
  const std::string_view head = std::string_view(bytes).substr(0, kSniffed);
  for (const char c : head) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F) return {};
  }
  TextHead found{TextKind::kOther, 0, ""};
  for (std::size_t start = head.rfind("\xEF\xBB\xBF", 0) == 0 ? 3 : 0; start < head.size();) {
    const std::size_t end = std::min(head.find('\n', start), head.size());
    const std::string_view line = stripped(head.substr(start, end - start));
    start = end + 1;
    ++found.line;
    if (line.empty() || line.front() == '#') continue;
    std::string_view cell;
    Cells cells(line, separator_of(line));
    if (!cells.next(cell)) continue;
    const std::string name = column_of(cell).name;
    if (is_missing_word(cell) || number_of(cell, true) || name == "x" || name == "y" || name == "z" ||
        name == "height" || name == "h") {
      found.kind = TextKind::kTable;
    }
    found.words = utf8_from(line.substr(0, 200));
    return found;
  }
  return found;
}

InstrumentFile read_height_table(const std::string& file, const std::string& bytes, TableLayout layout) {
  InstrumentFile result;
  const auto parsed = std::make_shared<ChannelValues>(TableReader(file, bytes).read(layout, result.format));
  checked_points(file, parsed->channel.points_x, parsed->channel.points_y);
  parsed->channel.name = "heights";
  result.channels.push_back(parsed->channel);
  result.values = [parsed](std::size_t) { return *parsed; };
  return result;
}

}  // namespace ringfilm::instrument
