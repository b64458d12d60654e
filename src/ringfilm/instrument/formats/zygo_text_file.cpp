#include "ringfilm/instrument/formats/zygo_text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/io/table/text_cells.hpp"

namespace ringfilm::instrument {
namespace {

constexpr const char* kAscii = "Zygo ASCII Data File";
constexpr const char* kXyz = "Zygo XYZ Data File";
constexpr double kFirstInvalidPhase = 2147483640;
constexpr std::array<double, 3> kPhaseResolutions{4096, 32768, 131072};
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

constexpr std::size_t kPhaseLine = 4, kScaleLine = 8, kResolutionLine = 11;  // lines of the head, from 1
constexpr std::size_t kMaxHead = 60;

/// Lines of a text one after the other.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  std::optional<std::string_view> next() {
    if (place_ >= text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', place_), text_.size());
    const std::string_view line = text_.substr(place_, end - place_);
    place_ = end + 1;
    ++number_;
    return io::without_blanks(line);
  }
  int number() const { return number_; }  ///< number of the last line, from 1

 private:
  std::string_view text_;
  std::size_t place_ = 0;
  int number_ = 0;
};

class ZygoText {
 public:
  ZygoText(const std::string& file, const std::string& text) : file_(file), lines_(text) {
    is_xyz_ = text.starts_with(kXyz);
    read_head();
    if (checked_points(file_, points_x_, points_y_) <= text.size()) return;
    refuse(file_,
           fmt::format("line {} states {} x {} points, more than the file can hold", kPhaseLine, points_x_, points_y_),
           "the file is cut: export it again");
  }

  ChannelValues values() {
    ChannelValues values;
    values.channel = {"heights", is_xyz_ ? "um" : "m", points_x_, points_y_};
    values.step_x = values.step_y = pixel_;
    values.step_unit = pixel_ > 0 ? "m" : "";
    values.value.assign(points_x_ * points_y_, kMissing);
    if (is_xyz_) {
      read_points(values);
    } else {
      skip_intensities();
      read_phases(values);
      values.notes.push_back(
          fmt::format("heights are phases times {:.6g} m: scale {:g}, wavelength {:.6g} m, "
                      "obliquity {:g}, {:g} steps a fringe",
                      height_of_phase_, scale_, wavelength_, obliquity_, resolution_));
    }
    values.set_missing_where_nan();
    return values;
  }

 private:
  [[noreturn]] void refuse_line(const std::string& message, const std::string& remedy) const {
    throw InputError(std::vector<Fault>{{{file_, lines_.number(), 1, ""}, message, remedy}});
  }

  /// The place-th number of a line of the head, from 0.
  double number(std::string_view line, std::size_t place) const {
    const std::vector<io::PlacedCell> cells = io::cells_of(line, ' ');
    const auto found = place < cells.size() ? io::number_of(cells[place].text, false) : std::nullopt;
    if (!found) {
      refuse_line(fmt::format("the head lacks its number {} in this line", place + 1),
                  "the head of the MetroPro reference guide is required: export the file again");
    }
    return *found;
  }

  std::size_t count(std::string_view line, std::size_t place) const {
    const double value = number(line, place);
    if (value >= 1 && value <= static_cast<double>(kMaxPoints) && value == std::floor(value)) {
      return static_cast<std::size_t>(value);
    }
    refuse_line(fmt::format("{:g} is not a number of points", value), "is it a file of heights?");
  }

  void read_head() {
    for (std::size_t i = 1; i <= kMaxHead; ++i) {
      const std::optional<std::string_view> line = lines_.next();
      if (!line) break;
      if (i == kPhaseLine) {
        left_ = number(*line, 0);
        top_ = number(*line, 1);
        points_x_ = count(*line, 2);
        points_y_ = count(*line, 3);
      } else if (i == kScaleLine) {
        scale_ = number(*line, 1);
        wavelength_ = number(*line, 2);
        obliquity_ = number(*line, 4);
        pixel_ = number(*line, 6);
      } else if (i == kResolutionLine) {
        set_resolution(number(*line, 0));
      } else if (i > kResolutionLine && line->starts_with('#')) {
        return;
      }
    }
    refuse_line("the head ends without #", "the head of the MetroPro reference guide is required: export it again");
  }

  void set_resolution(double code) {
    if (!(code >= 0 && code < static_cast<double>(kPhaseResolutions.size()) && code == std::floor(code))) {
      refuse_line(fmt::format("{:g} is not a phase resolution: 0, 1 or 2", code), "export the file again");
    }
    resolution_ = kPhaseResolutions[static_cast<std::size_t>(code)];
    height_of_phase_ = scale_ * wavelength_ * obliquity_ / resolution_;
    if (!is_xyz_ && !(height_of_phase_ > 0 && std::isfinite(height_of_phase_))) {
      refuse_line(fmt::format("scale {:g}, wavelength {:g} m and obliquity {:g} give no heights", scale_, wavelength_,
                              obliquity_),
                  "values above zero are required in line 8");
    }
  }

  void skip_intensities() {
    while (const std::optional<std::string_view> line = lines_.next()) {
      if (line->starts_with('#')) return;
    }
    refuse_line("there is no second #, behind which the phases are", "the file is cut: export it again");
  }

  void read_phases(ChannelValues& values) {
    std::size_t n = 0;
    while (const std::optional<std::string_view> line = lines_.next()) {
      if (line->starts_with('#')) break;
      if (line->empty()) continue;
      for (const io::PlacedCell& cell : io::cells_of(*line, ' ')) {
        const std::optional<double> phase = io::number_of(cell.text, false);
        if (!phase) refuse_line(fmt::format("\"{}\" is not a phase", cell.text.substr(0, 40)), "export the file again");
        if (n == values.value.size()) {
          refuse_line(fmt::format("there are more phases than {} x {}", points_x_, points_y_), "export the file again");
        }
        values.value[n++] = *phase >= kFirstInvalidPhase ? kMissing : *phase * height_of_phase_;
      }
    }
    if (n < values.value.size()) {
      refuse_line(fmt::format("there are {} phases of {} x {}", n, points_x_, points_y_),
                  "the file is cut: export it again");
    }
  }

  std::size_t place(std::string_view line, std::size_t cell, double origin, std::size_t points) const {
    const double at = number(line, cell) - origin;
    if (at >= 0 && at < static_cast<double>(points) && at == std::floor(at)) return static_cast<std::size_t>(at);
    refuse_line(fmt::format("the point lies outside of the {} x {} points of line 4", points_x_, points_y_),
                "export the file again");
  }

  void read_points(ChannelValues& values) {
    while (const std::optional<std::string_view> line = lines_.next()) {
      if (line->starts_with('#')) return;
      if (line->empty()) continue;
      const std::size_t i = place(*line, 0, left_, points_x_), j = place(*line, 1, top_, points_y_);
      const std::vector<io::PlacedCell> cells = io::cells_of(*line, ' ');
      const bool is_missing = cells.size() > 2 && cells[2].text == "No";  // No Data
      values.value[j * points_x_ + i] = is_missing ? kMissing : number(*line, 2);
    }
  }

  const std::string& file_;
  Lines lines_;
  bool is_xyz_ = false;
  std::size_t points_x_ = 0, points_y_ = 0;
  double left_ = 0, top_ = 0;  ///< first column and row of the camera
  double scale_ = 0, wavelength_ = 0, obliquity_ = 0, resolution_ = 0, height_of_phase_ = 0;
  double pixel_ = 0;  ///< [m]; 0 where the instrument was not calibrated
};

}  // namespace

bool is_zygo_text(const std::string& text) { return text.starts_with(kAscii) || text.starts_with(kXyz); }

InstrumentFile read_zygo_text(const std::string& file, const std::string& text) {
  const auto read = std::make_shared<const ChannelValues>(ZygoText(file, text).values());
  InstrumentFile result;
  result.format = text.starts_with(kXyz) ? "text, Zygo XYZ" : "text, Zygo ASCII";
  result.channels.push_back(read->channel);
  result.values = [read](std::size_t) { return *read; };
  return result;
}

}  // namespace ringfilm::instrument
