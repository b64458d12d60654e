#include "ringfilm/instrument/formats/smd_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/io/table/text_cells.hpp"

namespace ringfilm::instrument {
namespace {

constexpr char kEndOfSection = '\x03';
constexpr std::size_t kMaxSmdHeader = 4096;
constexpr std::uint64_t kModulus = 65535;

/// A line without the NUL that end its words.
std::string words_of(std::string_view line) {
  std::string words(line);
  std::replace(words.begin(), words.end(), '\0', ' ');
  return std::string(io::without_blanks(words));
}

/// One axis of the header.
struct Axis {
  std::string type, unit;
  std::size_t points = 0;
  double scale = 1, increment = 0;
};

class SmdText {
 public:
  SmdText(const std::string& file, const std::string& bytes) : file_(file), bytes_(bytes) {}

  InstrumentFile read() {
    InstrumentFile result;
    result.format = "SMD (ISO 5436-2)";
    read_header();
    read_keywords(result);
    const auto values = std::make_shared<const ChannelValues>(read_heights());
    result.channels.push_back(values->channel);
    result.values = [values](std::size_t) { return *values; };
    return result;
  }

 private:
  [[noreturn]] void refuse_line(const std::string& message, const std::string& remedy) const {
    throw InputError(std::vector<Fault>{{{file_, line_, 1, ""}, message, remedy}});
  }

  /// The next line of the section; nothing behind its last one.
  std::optional<std::string> next() {
    if (place_ >= bytes_.size()) refuse_line("the file ends within a section", "the file is cut: export it again");
    const std::size_t end = std::min(bytes_.find('\n', place_), bytes_.size());
    const std::string words = words_of(std::string_view(bytes_).substr(place_, end - place_));
    place_ = end + 1;
    ++line_;
    if (words.starts_with(kEndOfSection)) return std::nullopt;
    return words;
  }

  Axis axis_of(const std::string& line) const {
    std::vector<std::string> cells;
    for (const io::PlacedCell& cell : io::cells_of(line, ' ')) cells.push_back(cell.text);
    constexpr std::size_t kType = 1, kPoints = 2, kUnit = 3, kScale = 4, kIncrement = 6;
    const auto number = [&](std::size_t place) {
      const auto found = place < cells.size() ? io::number_of(cells[place], false) : std::nullopt;
      if (!found) {
        refuse_line(fmt::format("the axis lacks its number {}", place),
                    "CX and CZ have a type, the number of points, unit, scale, type of data and increment");
      }
      return *found;
    };
    Axis axis;
    const double points = number(kPoints);
    if (!(points >= 1 && points <= static_cast<double>(kMaxPoints) && points == std::floor(points))) {
      refuse_line(fmt::format("{:g} is not a number of points", points), "export the file again");
    }
    axis.points = static_cast<std::size_t>(points);
    axis.type = cells[kType];
    axis.unit = io::lower(cells[kUnit]);
    axis.scale = number(kScale);
    if (cells.size() > kIncrement) axis.increment = number(kIncrement);
    return axis;
  }

  void read_header() {
    bool has_x = false, has_z = false;
    while (const std::optional<std::string> line = next()) {
      if (line->starts_with("SUR") || line->starts_with("CY")) {
        refuse_line("this is a surface", "SMD files of profiles (PRF) are read: export it as X3P or SDF");
      }
      if (line->starts_with("CX")) {
        x_ = axis_of(*line);
        has_x = true;
        if (x_.type != "I" || !(x_.increment * x_.scale > 0)) {
          refuse_line("the x axis is not incremental with a step above 0",
                      "export the profile with a constant step, or as text with the columns x and z");
        }
      } else if (line->starts_with("CZ")) {
        z_ = axis_of(*line);
        has_z = true;
      }
    }
    if (!has_x || !has_z) refuse_line("the header has no axis CX or CZ", "a profile of ISO 5436-2 is required");
  }

  void read_keywords(InstrumentFile& result) {
    while (const std::optional<std::string> line = next()) {
      const std::size_t blank = line->find(' ');
      if (blank == std::string::npos) continue;
      const std::string word = line->substr(0, blank);
      if (word == "DATE") result.date = line->substr(blank + 1);
      if (word == "INSTRUMENT_ID") result.instrument = line->substr(blank + 1);
    }
  }

  ChannelValues read_heights() {
    ChannelValues values;
    while (const std::optional<std::string> line = next()) {
      if (line->empty()) continue;
      const std::optional<double> height = io::number_of(*line, false);
      if (!height && !io::is_missing_word(*line)) {
        refuse_line(fmt::format("\"{}\" is not a height", line->substr(0, 40)), "one height a line is required");
      }
      values.value.push_back(height ? *height * z_.scale : std::numeric_limits<double>::quiet_NaN());
    }
    if (values.value.size() != z_.points || x_.points != z_.points) {
      refuse_line(
          fmt::format("there are {} heights, and CX and CZ state {} and {}", values.value.size(), x_.points, z_.points),
          "the file is cut: export it again");
    }
    values.channel = {"heights", z_.unit, values.value.size(), 1};
    values.step_x = x_.increment * x_.scale;
    values.step_unit = x_.unit;
    values.set_missing_where_nan();
    check_sum(values);
    return values;
  }

  void check_sum(ChannelValues& values) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < std::min(place_, bytes_.size()); ++i) sum += static_cast<unsigned char>(bytes_[i]);
    const std::size_t end = place_ < bytes_.size() ? std::min(bytes_.find('\n', place_), bytes_.size()) : bytes_.size();
    const auto stated = place_ < bytes_.size()
                            ? io::number_of(words_of(std::string_view(bytes_).substr(place_, end - place_)), false)
                            : std::nullopt;
    if (stated && *stated == static_cast<double>(sum % kModulus)) return;
    values.doubts.push_back(
        {stated ? fmt::format("line {} states the check sum {:.0f}, and the bytes have {}", line_ + 1, *stated,
                              sum % kModulus)
                : "the file has no check sum",
         "if it was edited or its line ends were converted, compare its heights with the original"});
  }

  const std::string& file_;
  const std::string& bytes_;
  std::size_t place_ = 0;
  int line_ = 0;  ///< number of the last line that was read, from 1
  Axis x_, z_;
};

}  // namespace

bool is_smd(const std::string& bytes) {
  const std::string_view head = std::string_view(bytes).substr(0, kMaxSmdHeader);
  const std::size_t end = head.find(kEndOfSection);
  if (end == std::string_view::npos) return false;
  const std::size_t feature = head.find('\n'), axis = head.find("\nCX");
  return feature != std::string_view::npos && axis != std::string_view::npos && feature < axis && axis < end;
}

InstrumentFile read_smd(const std::string& file, const std::string& bytes) { return SmdText(file, bytes).read(); }

}  // namespace ringfilm::instrument
