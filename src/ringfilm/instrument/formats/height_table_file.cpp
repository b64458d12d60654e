#include "ringfilm/instrument/formats/height_table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/instrument/grid/height_checks.hpp"
#include "ringfilm/instrument/grid/regular_grid.hpp"
#include "ringfilm/instrument/table/height_columns.hpp"
#include "ringfilm/instrument/table/table_comments.hpp"
#include "ringfilm/io/table/number_commas.hpp"
#include "ringfilm/io/table/text_table.hpp"

namespace ringfilm::instrument {
namespace {

constexpr std::size_t kSniffed = 65536;
constexpr std::size_t kMaxHeadColumns = 3;    // columns of a matrix whose first values may be counts
constexpr std::size_t kMaxPointColumns = 8;   // columns of points with normals, colours or numbers
constexpr std::size_t kMinListedPoints = 12;  // fewest points of a list: small whole numbers fill a grid by chance

/// Heights of one table of a text.
class TableHeights {
 public:
  TableHeights(const std::string& file, io::TextTable table)
      : file_(file),
        table_(std::move(table)),
        stated_(TableComments(file, table_.comments).stated()),
        n_columns_(table_.n_columns) {
    table_.columns = with_lengths_in_names(std::move(table_.columns));
    columns_ = height_columns(table_.columns);
  }

  ChannelValues read(TableLayout layout, std::string& format) {
    if (layout == TableLayout::kByContent) layout = layout_by_content();
    ChannelValues values = read_heights(layout, format);
    values.channel.name = stated_.name.empty() ? "heights" : stated_.name;
    std::vector<std::string> notes;
    if (table_.units_line > 0) notes.push_back(fmt::format("the row of units in line {} was used", table_.units_line));
    if (const std::string account = table_.account(); !account.empty()) notes.push_back(account);
    if (layout != TableLayout::kMatrix && !columns_.account.empty()) {
      notes.push_back("taken by their names: " + columns_.account);
    }
    if (!columns_.unused.empty()) notes.push_back("columns that were not used: " + columns_.unused);
    values.notes.insert(values.notes.begin(), notes.begin(), notes.end());
    return values;
  }

 private:
  bool is_named() const { return !table_.columns.empty(); }

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

  TableLayout layout_by_content() const {
    if (is_named()) {
      return columns_.y && columns_.x && !is_one_row() ? TableLayout::kPoints : TableLayout::kProfile;
    }
    if (stated_.width && stated_.height)
      return TableLayout::kMatrix;  // a header of Gwyddion, whatever the number of columns
    if (n_columns_ <= 2) return TableLayout::kProfile;
    return n_columns_ == 3 ? TableLayout::kPoints : TableLayout::kMatrix;
  }

  /// A second encoder that did not move: a profile.
  bool is_one_row() const {
    if (io::heading_of(table_.columns[*columns_.y].name).name.size() < 2) return false;  // y itself
    for (std::size_t i = 1; i < table_.rows(); ++i) {
      if (table_.at(i, *columns_.y) != table_.at(0, *columns_.y)) return false;
    }
    return true;
  }

  [[noreturn]] void refuse_row(std::size_t row, const std::string& message, const std::string& remedy) const {
    throw InputError(std::vector<Fault>{{{file_, table_.row_lines[row], 1, ""}, message, remedy}});
  }

  ChannelValues read_matrix() {
    if (is_named()) {
      throw InputError(
          std::vector<Fault>{{{file_, table_.header_line, 1, ""},
                              "a matrix of heights has no header",
                              "start the line of names with #, and remove columns and rows that number the heights"}});
    }
    ChannelValues values;
    values.channel.points_x = n_columns_;
    values.channel.points_y = table_.rows();
    values.channel.unit = stated_.unit;
    values.value = std::move(table_.cells);
    if (values.value.size() > kMaxPoints) refuse(file_, "the matrix has too many points", "cut it into parts");
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
    if (table_.parted_at > 0 && 2 * table_.n_parted < found.points_y) {  // else they part all rows
      values.doubts.push_back({fmt::format("the blank line {} parts rows that were read as one map", table_.parted_at),
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
                    : "name the columns: --columns \"" + columns_from(x) + "\", where - is one that is not used");
    }
  }

  /// The columns for --columns where x, y and z follow each other from place `x` on.
  std::string columns_from(std::size_t x) const {
    static constexpr const char* kPoint[] = {"x [um]", "y [um]", "z [um]"};
    std::string columns;
    for (std::size_t i = 0; i < n_columns_; ++i) {
      columns += std::string(i > 0 ? ", " : "") + (i >= x && i - x < std::size(kPoint) ? kPoint[i - x] : "-");
    }
    return columns;
  }

  /// Before the heights are scaled, since counts are whole numbers in the file.
  static void add_count_doubts(ChannelValues& values) {
    for (Doubt& doubt : count_doubts(values.value)) values.doubts.push_back(std::move(doubt));
  }

  /// The column of that meaning, or the one of that place where the file names none.
  std::size_t column(const std::optional<std::size_t>& named, const char* name, std::size_t place) const {
    if (!is_named()) return place;
    if (named) return *named;
    std::string all;
    for (const io::Heading& c : table_.columns) all += (all.empty() ? "" : ", ") + c.name;
    refuse(file_, fmt::format("there is no column {} among: {}", name, all.substr(0, 400)),
           "name the columns x, y and z, for example: x [um],y [um],z [nm]; or state their names with --columns");
  }

  std::string unit_of(std::size_t column) const {
    return column < table_.columns.size() ? table_.columns[column].unit.value_or("") : "";
  }

  double place_at(std::size_t row, std::size_t column, const char* name) const {
    const double place = table_.at(row, column);
    if (std::isnan(place))
      refuse_row(row, fmt::format("the row has no {}", name), "a place is required for each height");
    return place;
  }

  /// NaN where the column of validity is 0.
  double height_at(std::size_t row, std::size_t column) const {
    const bool is_valid = !columns_.valid || table_.at(row, *columns_.valid) != 0;
    return is_valid ? table_.at(row, column) : std::numeric_limits<double>::quiet_NaN();
  }

  ChannelValues read_points() {
    if (n_columns_ < 3) refuse_row(0, "points need three columns", "x, y and the height");
    const std::size_t x = column(columns_.x, "x", 0), y = column(columns_.y, "y", 1), z = column(columns_.z, "z", 2);
    if (unit_of(x) != unit_of(y)) {
      refuse(file_, fmt::format("x is in \"{}\" and y in \"{}\"", unit_of(x), unit_of(y)), "give both the same unit");
    }
    ListedPoints points;
    for (std::size_t i = 0; i < table_.rows(); ++i) {
      points.x.push_back(place_at(i, x, "x"));
      points.y.push_back(place_at(i, y, "y"));
      points.value.push_back(height_at(i, z));
    }
    check_head_of_points(points);
    ChannelValues values = on_regular_grid(file_, points);
    values.channel.unit = unit_of(z);
    values.step_unit = unit_of(x);
    return values;
  }

  /// Three numbers in front of the points may count them.
  void check_head_of_points(const ListedPoints& points) const {
    if (is_named() || points.value.size() < 3) return;
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

  std::string remedy_of_order(std::size_t row) const {
    const std::string remedy =
        row <= 2 && !is_named()
            ? "if the first line is not part of the profile, start it with #; else sort the rows by x"
            : "sort the rows by x; give each place one height";
    return table_.may_be_pairs ? remedy + "; or " + io::kPairRemedy : remedy;
  }

  ChannelValues read_profile() {
    const bool has_places = is_named() ? columns_.x.has_value() : n_columns_ > 1;
    const std::size_t x = has_places ? column(columns_.x, "x", 0) : 0;
    const std::size_t z = column(columns_.z, "z", has_places ? 1 : 0);
    ChannelValues values;
    bool falls = false;
    for (std::size_t i = 0; i < table_.rows(); ++i) {
      values.value.push_back(height_at(i, z));
      if (!has_places) continue;
      const double place = place_at(i, x, "x");
      if (i == 1) falls = place < values.x.back();
      if (i > 0 && !(falls ? place < values.x.back() : place > values.x.back())) {
        refuse_row(i, fmt::format("x {} or repeats: {} after {}", falls ? "rises" : "falls", place, values.x.back()),
                   remedy_of_order(i));
      }
      values.x.push_back(place);
    }
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
    if (!has_places && !is_named()) add_count_doubts(values);
    return values;
  }

  const std::string& file_;
  io::TextTable table_;
  StatedMap stated_;
  std::size_t n_columns_;
  HeightColumns columns_;
};

}  // namespace

TextHead text_head(const std::string& bytes, const io::TableReading& stated) {
  const std::string_view head = std::string_view(bytes).substr(0, kSniffed);
  for (const char c : head) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F) return {};
  }
  // The last line may be cut.
  const std::size_t end = head.size() < bytes.size() ? head.rfind('\n') : head.size();
  const io::TextOutline outline = io::outline_of_text(head.substr(0, end), stated);
  const bool is_table = outline.starts_with_numbers || stated.columns ||
                        (stated.skip_lines && outline.numbers_line > 0) || name_heights(outline.columns);
  return {is_table ? TextKind::kTable : TextKind::kOther, outline.line, outline.words, outline.numbers_line};
}

InstrumentFile read_height_table(const std::string& file, const std::string& bytes, TableLayout layout,
                                 const io::TableReading& stated) {
  InstrumentFile result;
  std::vector<ChannelValues> channels;
  for (io::TextTable& table :
       io::read_text_tables(file, bytes, {io::TableHeader::kOptional, io::Gaps::kKept}, stated)) {
    channels.push_back(TableHeights(file, std::move(table)).read(layout, result.format));
  }
  const auto parsed = std::make_shared<const std::vector<ChannelValues>>(std::move(channels));
  for (const ChannelValues& table : *parsed) {
    checked_points(file, table.channel.points_x, table.channel.points_y);
    result.channels.push_back(table.channel);
  }
  result.values = [parsed](std::size_t index) { return parsed->at(index); };
  return result;
}

}  // namespace ringfilm::instrument
