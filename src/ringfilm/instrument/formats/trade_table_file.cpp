#include "ringfilm/instrument/formats/trade_table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/instrument/formats/zygo_text_file.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/instrument/grid/regular_grid.hpp"
#include "ringfilm/io/table/table_head.hpp"
#include "ringfilm/io/table/text_cells.hpp"
#include "ringfilm/io/table/text_table.hpp"

namespace ringfilm::instrument {
namespace {

constexpr int kMaxHeadOfTrade = 200;

/// What a program writes in front of the heights.
struct TradeHead {
  std::string format;
  int last_line = 0;  ///< behind which the numbers begin, from 1
  std::string unit;   ///< unit of the heights; may be empty
  double height_factor = 1;
  double step_x = 0, step_y = 0;
  std::string step_unit;
  std::size_t points_x = 0, points_y = 0;  ///< 0: not stated
  bool numbers_rows = false;               ///< does the first column count the rows?
  std::vector<std::string> notes;
};

/// The lines of a head by the name that each begins with, in small letters.
class HeadEntries {
 public:
  void add(std::string_view line) {
    std::vector<std::string> cells;
    for (const io::PlacedCell& cell : io::cells_of(line, io::separator_of(line))) cells.push_back(cell.text);
    if (!cells.empty()) entries_.emplace(io::lower(cells.front()), cells);
  }
  bool has(const std::string& name) const { return entries_.contains(name); }
  /// The cell behind the name; empty where there is none.
  std::string cell(const std::string& name, std::size_t place = 1) const {
    const auto found = entries_.find(name);
    return found != entries_.end() && place < found->second.size() ? found->second[place] : "";
  }
  double number(const std::string& name) const { return io::number_of(cell(name), true).value_or(0); }

 private:
  std::map<std::string, std::vector<std::string>> entries_;
};

/// "nm/pixel" as "nm".
std::string length_unit_of(const std::string& text) { return trimmed(text.substr(0, text.find('/'))); }

std::size_t count_of(double number) {
  return number >= 1 && number <= static_cast<double>(kMaxPoints) ? static_cast<std::size_t>(number) : 0;
}

TradeHead keyence_head(const HeadEntries& entries, int line) {
  TradeHead head;
  head.format = "text, Keyence CSV";
  head.last_line = line;
  head.unit = entries.cell("unit");
  head.step_x = head.step_y = entries.number("xy calibration");
  head.step_unit = length_unit_of(entries.cell("xy calibration", 2));
  head.points_x = count_of(entries.number("horizontal"));
  head.points_y = count_of(entries.number("vertical"));
  return head;
}

TradeHead olympus_head(const HeadEntries& entries, int line) {
  TradeHead head;
  head.format = "text, Olympus CSV";
  head.last_line = line;
  head.step_x = entries.number("xresolution");
  head.step_y = entries.has("yresolution") ? entries.number("yresolution") : head.step_x;
  head.step_unit = length_unit_of(entries.cell("xresolution", 2));
  if (entries.has("yresolution") && length_unit_of(entries.cell("yresolution", 2)) != head.step_unit) {
    head.step_x = head.step_y = 0;  // to be stated
  }
  head.unit = length_unit_of(entries.cell("zresolution", 2));
  head.numbers_rows = true;
  return head;
}

/// Values of "name=value" of a head of such lines; several may be in one line, parted by blanks: "h=6 w=8".
std::string value_of_name(const std::string& line, const std::string& name) {
  const std::size_t at = line.find(name + "=");
  if (at == std::string::npos || (at > 0 && line[at - 1] != ' ')) return "";
  return trimmed(line.substr(at + name.size() + 1));
}

/// The head of a phase map: lines "h=6 w=8", "pixel size=1e-6 m", "height conversion factor (-> m)=6e-8".
std::optional<TradeHead> phase_head(const std::vector<io::TextLines::Line>& lines) {
  TradeHead head;
  for (const io::TextLines::Line& line : lines) {
    const std::string text = io::lower(io::without_blanks(line.text));
    if (text.find('=') == std::string::npos) break;
    head.last_line = line.number;
    const auto number = [](const std::string& value) {
      return io::number_of(value.substr(0, value.find(' ')), true).value_or(0);
    };
    if (const std::string h = value_of_name(text, "h"); !h.empty()) head.points_y = count_of(number(h));
    if (const std::string w = value_of_name(text, "w"); !w.empty()) head.points_x = count_of(number(w));
    if (const std::string size = value_of_name(text, "pixel size"); !size.empty()) {
      head.step_x = head.step_y = number(size);
      const std::size_t blank = size.find(' ');
      head.step_unit = blank == std::string::npos ? "" : trimmed(size.substr(blank));
    }
    const std::size_t factor = text.rfind('=');
    if (text.starts_with("height conversion factor") && text.find("-> m)") != std::string::npos) {
      head.height_factor = number(trimmed(text.substr(factor + 1)));
      head.unit = "m";
      head.notes.push_back(fmt::format("the numbers of the file times {} are heights in m, as line {} states",
                                       trimmed(text.substr(factor + 1)), line.number));
    }
  }
  if (head.points_x == 0 || head.points_y == 0 || head.unit.empty() || !(head.height_factor > 0)) return std::nullopt;
  head.format = "text, map with its size and height conversion factor";
  return head;
}

std::optional<TradeHead> head_of(const std::string& text) {
  io::TextLines lines(text);
  HeadEntries entries;
  std::vector<io::TextLines::Line> read;
  for (int i = 0; i < kMaxHeadOfTrade; ++i) {
    const std::optional<io::TextLines::Line> line = lines.next_row(',');
    if (!line) break;
    read.push_back(*line);
    const std::string first = io::lower(io::cells_of(line->text, io::separator_of(line->text)).front().text);
    if (i == 0 && first.starts_with("h=")) {
      while (read.size() < 20) {
        const std::optional<io::TextLines::Line> next = lines.next_row(',');
        if (!next) break;
        read.push_back(*next);
      }
      return phase_head(read);
    }
    if (first == "height" && entries.has("xy calibration")) return keyence_head(entries, line->number);
    if (first == "dataline" && entries.has("xresolution")) return olympus_head(entries, line->number);
    entries.add(line->text);
  }
  return std::nullopt;
}

/// Takes the column out that counts the rows.
void drop_row_numbers(const std::string& file, io::TextTable& table) {
  std::vector<double> kept;
  for (std::size_t j = 0; j < table.rows(); ++j) {
    if (!(table.at(j, 0) == table.at(0, 0) + static_cast<double>(j))) {
      throw InputError(std::vector<Fault>{
          {{file, table.row_lines[j], 1, ""},
           fmt::format("the row is numbered {:.6g} behind {:.6g}", table.at(j, 0), j > 0 ? table.at(j - 1, 0) : 0),
           "rows without a hole are required: export the file again"}});
    }
    for (std::size_t i = 1; i < table.n_columns; ++i) kept.push_back(table.at(j, i));
  }
  table.cells = std::move(kept);
  --table.n_columns;
}

io::TextTable numbers_behind(const std::string& file, const std::string& text, int line) {
  io::TableReading behind;
  behind.skip_lines = static_cast<std::size_t>(line);
  return std::move(io::read_text_tables(file, text, {io::TableHeader::kOptional, io::Gaps::kKept}, behind).front());
}

ChannelValues map_of(const std::string& file, const std::string& text, const TradeHead& head) {
  io::TextTable table = numbers_behind(file, text, head.last_line);
  ChannelValues values;
  values.notes = head.notes;
  if (head.numbers_rows) {
    drop_row_numbers(file, table);
    values.notes.push_back("the first column numbers the rows and was omitted");
  }
  values.channel = {"heights", head.unit, table.n_columns, table.rows()};
  values.value = std::move(table.cells);
  values.set_missing_where_nan();
  for (double& height : values.value) height *= head.height_factor;
  const bool are_counts = head.numbers_rows && std::all_of(values.value.begin(), values.value.end(),
                                                           [](double height) { return height == std::round(height); });
  if (are_counts) values.channel.unit = "";  // heights or numbers of ZResolution: to be stated
  if (head.step_x > 0 && head.step_y > 0) {
    values.step_x = head.step_x;
    values.step_y = head.step_y;
    values.step_unit = head.step_unit;
  }
  const Channel& found = values.channel;
  if ((head.points_x > 0 && head.points_x != found.points_x) ||
      (head.points_y > 0 && head.points_y != found.points_y)) {
    values.doubts.push_back({fmt::format("the head states {} x {} points, and the file has {} x {}", head.points_x,
                                         head.points_y, found.points_x, found.points_y),
                             "copy or export the file again"});
  }
  return values;
}

/// Points of Alicona: GPoint3DVector { 48 n { x y z nx ny nz ... } }.
ChannelValues alicona_points(const std::string& file, const std::string& text, int line) {
  const io::TextTable table = numbers_behind(file, text, line);
  if (table.n_columns < 3) refuse(file, "points need three columns", "x, y and the height");
  ListedPoints points;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    points.x.push_back(table.at(i, 0));
    points.y.push_back(table.at(i, 1));
    points.value.push_back(table.at(i, 2));
    if (std::isnan(points.x.back()) || std::isnan(points.y.back())) {
      refuse(file, fmt::format("point {} has no place", i + 1), "a place is required for each height");
    }
  }
  ChannelValues values = on_regular_grid(file, points);
  values.channel.name = "heights";
  // The list has no place for a unit. Steps are between 1 nm and 1 mm in what instruments measure.
  constexpr double kMaxStepInMetres = 1e-3;
  values.assumed_unit = values.step_x < kMaxStepInMetres ? "m" : "um";
  if (table.n_columns > 3) values.notes.push_back("x, y, z: columns 1 to 3; the normals behind them were omitted");
  return values;
}

}  // namespace

std::optional<InstrumentFile> read_trade_table(const std::string& file, const std::string& text) {
  InstrumentFile result;
  ChannelValues values;
  io::TextLines lines(text);
  const std::optional<io::TextLines::Line> first = lines.next_row(',');
  if (!first) return std::nullopt;
  if (is_zygo_text(text)) return read_zygo_text(file, text);
  if (io::without_blanks(first->text).starts_with("GPoint3DVector")) {
    result.format = "text, Alicona points";
    values = alicona_points(file, text, first->number);
  } else {
    const std::optional<TradeHead> head = head_of(text);
    if (!head) return std::nullopt;
    result.format = head->format;
    values = map_of(file, text, *head);
  }
  checked_points(file, values.channel.points_x, values.channel.points_y);
  result.channels.push_back(values.channel);
  const auto read = std::make_shared<const ChannelValues>(std::move(values));
  result.values = [read](std::size_t) { return *read; };
  return result;
}

}  // namespace ringfilm::instrument
