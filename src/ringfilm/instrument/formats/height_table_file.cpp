#include "ringfilm/instrument/formats/height_table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/instrument/grid/height_checks.hpp"
#include "ringfilm/instrument/grid/regular_grid.hpp"
#include "ringfilm/instrument/table/table_comments.hpp"
#include "ringfilm/instrument/table/text_cells.hpp"
#include "ringfilm/io/text/csv_file.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kSniffed = 65536;
constexpr std::size_t kMaxHeadColumns = 3;    // columns of a matrix whose first values may be counts
constexpr std::size_t kMaxPointColumns = 8;   // columns of points with normals, colours or numbers
constexpr std::size_t kMinListedPoints = 12;  // fewest points of a list: small whole numbers fill a grid by chance

bool names_place_or_height(const std::string& name) {
  return name == "x" || name == "y" || name == "z" || name == "height" || name == "h";
}

class TableReader {
 public:
  TableReader(const std::string& file, const std::string& bytes) : file_(file), text_(bytes) {
    if (bytes.rfind("\xEF\xBB\xBF", 0) == 0) text_.remove_prefix(3);
  }

  /// All tables of the file: a comment that repeats one of the comments in front of a table begins another.
  std::vector<ChannelValues> read(TableLayout layout, std::string& format) {
    std::vector<ChannelValues> tables;
    do {
      begin_table();
      if (!next_line()) {
        if (!tables.empty()) break;  // comments behind the last row
        refuse(file_, "the file has no row of numbers", "is it the right file?");
      }
      tables.push_back(read_table(layout, format));
    } while (place_ < text_.size());
    return tables;
  }

 private:
  void begin_table() {
    comments_ = TableComments(file_);
    has_rows_ = false;
    header_.clear();
    notes_.clear();
    blank_line_ = parted_at_ = 0;
    n_parted_ = 0;
    separator_ = ',';
  }

  ChannelValues read_table(TableLayout layout, std::string& format) {
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
    has_rows_ = true;
    stated_ = comments_.stated();
    if (layout == TableLayout::kByContent) layout = layout_by_content();
    ChannelValues values = read_heights(layout, format);
    values.channel.name = stated_.name.empty() ? "heights" : stated_.name;
    values.notes.insert(values.notes.begin(), notes_.begin(), notes_.end());
    return values;
  }

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

  /// Goes to the next line with content of the table; comments are looked into.
  bool next_line() {
    while (place_ < text_.size()) {
      const std::size_t begin = place_, end = std::min(text_.find('\n', place_), text_.size());
      line_ = text_.substr(place_, end - place_);
      place_ = end + 1;
      ++number_;
      const std::string_view content = without_blanks(line_);
      // Where tabulators separate the values, a line of tabulators is a row of missing heights.
      const bool row_of_none = content.empty() && separator_ == '\t' && line_.find('\t') != std::string_view::npos;
      if (content.empty() && !row_of_none) {
        blank_line_ = number_;
        continue;
      }
      if (row_of_none || !is_comment(content)) {
        if (has_rows_ && blank_line_ > 0) {
          ++n_parted_;
          if (parted_at_ == 0) parted_at_ = blank_line_;
        }
        blank_line_ = 0;
        return true;
      }
      if (has_rows_ && comments_.repeats(content)) {
        place_ = begin;
        --number_;
        return false;
      }
      comments_.add(content, number_);
    }
    return false;
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
      if (!row.empty() && !is_comment(row) && row.back() != separator_) return false;
    }
    return true;
  }

  TableLayout layout_by_content() const {
    if (!header_.empty()) return find({"y"}) && find({"x"}) ? TableLayout::kPoints : TableLayout::kProfile;
    if (stated_.width && stated_.height)
      return TableLayout::kMatrix;  // a header of Gwyddion, whatever the number of columns
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
                      : "give every row as many values as the first; start lines before the heights, for example one "
                        "of counts, with #");
    }
  }

  ChannelValues read_matrix() {
    if (!header_.empty()) {
      refuse_here(1, "a matrix of heights has no header",
                  "start the line of names with #, and remove columns and rows that number the heights");
    }
    ChannelValues values;
    std::vector<double> row;
    do {
      read_cells(row);
      values.value.insert(values.value.end(), row.begin(), row.end());
      ++values.channel.points_y;
      if (values.value.size() > kMaxPoints) refuse_here(1, "the matrix has too many points", "cut it into parts");
    } while (next_line());
    values.channel.points_x = n_columns_;
    values.channel.unit = stated_.unit;
    check_places_in_columns(values);
    values.set_missing_where_nan();
    for (double& height : values.value) height *= stated_.height_factor;
    values.notes = stated_.notes;
    values.doubts = stated_.doubts;
    values.step_faults = stated_.faults;
    const auto &width = stated_.width, &height = stated_.height;
    if (width && height && width->value > 0 && height->value > 0 && width->unit == height->unit) {
      values.step_x = width->value / static_cast<double>(values.channel.points_x);
      values.step_y = height->value / static_cast<double>(values.channel.points_y);
      values.step_unit = width->unit;
      doubt_uneven_steps(values);
    }
    doubt_size(values);
    if (n_columns_ <= kMaxHeadColumns) add_count_doubts(values);
    return values;
  }

  /// A matrix that was cut behind a row shows only in this: its stated height spreads over fewer rows.
  void doubt_uneven_steps(ChannelValues& values) const {
    const StatedLength &width = *stated_.width, &height = *stated_.height;
    const double rounding = width.rounding / static_cast<double>(values.channel.points_x) +
                            height.rounding / static_cast<double>(values.channel.points_y);
    if (std::abs(values.step_x - values.step_y) <= rounding) return;
    values.doubts.push_back(
        {fmt::format("{} columns over the stated width of {:.6g} {} and {} rows over the stated height of {:.6g} {} "
                     "give steps of {:.6g} and {:.6g} {}",
                     values.channel.points_x, width.value, width.unit, values.channel.points_y, height.value,
                     height.unit, values.step_x, values.step_y, values.step_unit),
         "if they should be equal, the file lacks rows or columns, or has those of several maps"});
  }

  void doubt_size(ChannelValues& values) const {
    const Channel& found = values.channel;
    if (stated_.points_x.value_or(found.points_x) != found.points_x ||
        stated_.points_y.value_or(found.points_y) != found.points_y) {
      values.doubts.push_back({fmt::format("the comments state {} x {} points, and the file has {} x {}",
                                           stated_.points_x.value_or(found.points_x),
                                           stated_.points_y.value_or(found.points_y), found.points_x, found.points_y),
                               "copy or export the file again"});
    }
    if (parted_at_ > 0 && 2 * n_parted_ < found.points_y) {  // else they part all rows
      values.doubts.push_back({fmt::format("the blank line {} parts rows that were read as one map", parted_at_),
                               "if several maps follow each other, write each to a file of its own"});
    }
  }

  /// Points with more columns than x, y, z would be rows of a matrix: two of their columns fill a grid of places.
  void check_places_in_columns(const ChannelValues& values) const {
    const std::size_t rows = values.channel.points_y;
    if (n_columns_ > kMaxPointColumns || rows < kMinListedPoints || stated_.width) return;
    for (std::size_t x = 0; x + 2 < n_columns_; ++x) {
      ListedPoints points;
      for (std::size_t j = 0; j < rows; ++j) {
        points.x.push_back(values.value[j * n_columns_ + x]);
        points.y.push_back(values.value[j * n_columns_ + x + 1]);
      }
      if (!fills_grid(points)) continue;
      refuse(file_,
             fmt::format("columns {} and {} of {} are the places of points on an even grid, and were read as heights",
                         x + 1, x + 2, n_columns_),
             x == 0 ? "state the layout of points: x, y, z are then the first three columns"
                    : "write the columns x, y and z alone");
    }
  }

  /// Before the heights are scaled, since counts are whole numbers in the file.
  static void add_count_doubts(ChannelValues& values) {
    for (Doubt& doubt : count_doubts(values.value)) values.doubts.push_back(std::move(doubt));
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
    check_head_of_points(points);
    ChannelValues values = on_regular_grid(file_, points);
    values.channel.unit = unit_of(z);
    values.step_unit = unit_of(x);
    return values;
  }

  /// Three numbers in front of the points may count them.
  void check_head_of_points(const ListedPoints& points) const {
    if (!header_.empty() || points.value.size() < 3) return;
    const double head[] = {points.x[0], points.y[0], points.value[0]};
    const auto rest = static_cast<double>(points.value.size() - 1);
    const auto outside = [](const std::vector<double>& of) {
      const auto [low, high] = std::minmax_element(of.begin() + 1, of.end());
      return of[0] < *low || of[0] > *high;
    };
    const bool counts =
        head[0] * head[1] == rest || std::find(std::begin(head), std::end(head), rest) != std::end(head);
    if (!counts || !(outside(points.x) || outside(points.y) || outside(points.value))) return;
    refuse(file_,
           fmt::format("the first point, {:.6g}, {:.6g}, {:.6g}, counts the {:.0f} points behind it", head[0], head[1],
                       head[2], rest),
           "start the line of counts with #");
  }

  ChannelValues read_profile() {
    const bool has_places = header_.empty() ? n_columns_ > 1 : find({"x"}).has_value();
    const std::size_t x = has_places ? column({"x"}, 0) : 0;
    const std::size_t z = column({"z", "height", "h"}, has_places ? 1 : 0);
    ChannelValues values;
    std::vector<double> row;
    bool falls = false;
    do {
      read_cells(row);
      if (has_places) {
        check_place(row[x], "x");
        if (values.x.size() == 1) falls = row[x] < values.x.back();
        if (!values.x.empty() && !(falls ? row[x] < values.x.back() : row[x] > values.x.back())) {
          refuse_here(1,
                      fmt::format("x {} or repeats: {} after {}", falls ? "rises" : "falls", row[x], values.x.back()),
                      values.x.size() <= 2 && header_.empty()
                          ? "if the first line is not part of the profile, start it with #; else sort the rows by x"
                          : "sort the rows by x; give each place one height");
        }
        values.x.push_back(row[x]);
      }
      values.value.push_back(row[z]);
    } while (next_line());
    if (falls) {
      std::reverse(values.x.begin(), values.x.end());
      std::reverse(values.value.begin(), values.value.end());
      values.notes.push_back("x falls in the file: the profile was turned about");
    }
    values.channel.points_x = values.value.size();
    values.channel.points_y = 1;
    values.channel.unit = unit_of(z);
    values.step_unit = has_places ? unit_of(x) : "";
    values.set_missing_where_nan();
    if (!has_places && header_.empty()) add_count_doubts(values);
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
  TableComments comments_{""};
  StatedMap stated_;
  bool has_rows_ = false;     ///< have the rows of the present table begun?
  int blank_line_ = 0;        ///< last blank line before the line; 0: none
  int parted_at_ = 0;         ///< first blank line between rows; 0: none
  std::size_t n_parted_ = 0;  ///< how often blank lines part rows
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
    const std::string_view line = without_blanks(head.substr(start, end - start));
    start = end + 1;
    ++found.line;
    if (line.empty() || is_comment(line)) continue;
    std::size_t n_cells = 0, named = 0;
    bool is_number = false;
    Cells cells(line, separator_of(line));
    for (std::string_view cell; cells.next(cell); ++n_cells) {
      if (n_cells == 0) is_number = is_missing_word(cell) || number_of(cell, true);
      const bool is_name = names_place_or_height(column_of(cell).name);
      if (is_name) named += n_cells == 0 ? 2 : 1;
    }
    if (n_cells == 0) continue;
    // The first name alone, or two behind a column of another name, as in "id,x,y,z".
    if (is_number || named >= 2) found.kind = TextKind::kTable;
    found.words = utf8_from(line.substr(0, 200));
    return found;
  }
  return found;
}

InstrumentFile read_height_table(const std::string& file, const std::string& bytes, TableLayout layout) {
  InstrumentFile result;
  const auto parsed =
      std::make_shared<const std::vector<ChannelValues>>(TableReader(file, bytes).read(layout, result.format));
  for (const ChannelValues& table : *parsed) {
    checked_points(file, table.channel.points_x, table.channel.points_y);
    result.channels.push_back(table.channel);
  }
  result.values = [parsed](std::size_t index) { return parsed->at(index); };
  return result;
}

}  // namespace ringfilm::instrument
