#include "ringfilm/instrument/formats/simple_field_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/instrument/formats/binary_writer.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/instrument/grid/number_from.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::instrument {
namespace {

constexpr std::string_view kSignature = "Gwyddion Simple Field 1.0\n";
/// A header is some lines; a file without its closing zero must not be searched to the end.
constexpr std::size_t kMaxHeader = std::size_t{1} << 20;

struct Entry {
  std::string value;
  std::size_t offset = 0;  ///< offset of the line [byte]
};

class SimpleFieldHeader {
 public:
  explicit SimpleFieldHeader(const BinaryReader& in) : in_(in) {
    const std::string_view all = in.at(0, std::min(in.size(), kMaxHeader), "the header");
    end_ = all.find('\0');
    if (end_ == std::string_view::npos) {
      in.refuse_at(all.size(), "no zero byte ends the header", "the file was cut short: copy it again");
    }
    for (std::size_t start = kSignature.size(); start < end_;) {
      const std::size_t stop = std::min(all.find('\n', start), end_);
      const std::string_view line = all.substr(start, stop - start);
      const std::size_t equals = line.find('=');
      if (equals == std::string_view::npos) {
        in.refuse_at(start, "a line of the header has no \"=\"", "write it as \"XRes = 512\"");
      }
      entries_[trimmed(line.substr(0, equals))] = {trimmed(utf8_from(line.substr(equals + 1))), start};
      start = stop + 1;
    }
  }

  std::size_t data() const { return (end_ / 4 + 1) * 4; }

  std::string text(const std::string& key) const {
    const auto entry = entries_.find(key);
    return entry == entries_.end() ? "" : entry->second.value;
  }

  /// The length of a side; nothing if the file omits it.
  std::optional<double> length(const std::string& key) const {
    const auto entry = entries_.find(key);
    if (entry == entries_.end()) return std::nullopt;
    const double value = number<double>(key, entry->second);
    if (!std::isfinite(value) || value <= 0) {
      in_.refuse_at(entry->second.offset, fmt::format("{} = {} is not a length", key, entry->second.value),
                    "a number above zero is required");
    }
    return value;
  }

  std::uint64_t count(const std::string& key) const {
    const auto entry = entries_.find(key);
    if (entry == entries_.end()) {
      in_.refuse_at(end_, fmt::format("the header has no {}", key), "the number of points is required: XRes and YRes");
    }
    return number<std::uint32_t>(key, entry->second);
  }

 private:
  template <class Number>
  Number number(const std::string& key, const Entry& entry) const {
    const std::optional<Number> value = number_from<Number>(entry.value);
    if (!value) {
      in_.refuse_at(entry.offset, fmt::format("{} = {} is not a number", key, entry.value), "a number is required");
    }
    return *value;
  }

  const BinaryReader& in_;
  std::map<std::string, Entry> entries_;
  std::size_t end_ = 0;
};

}  // namespace

InstrumentFile read_simple_field(const std::string& file, std::shared_ptr<const std::string> bytes) {
  const BinaryReader in(file, *bytes);
  if (in.at(0, kSignature.size(), "the signature") != kSignature) {
    in.refuse_at(0, "a simple field starts with \"Gwyddion Simple Field 1.0\"", "is it the right file?");
  }
  const SimpleFieldHeader header(in);
  const std::uint64_t points_x = header.count("XRes"), points_y = header.count("YRes");
  const std::size_t points = checked_points(file, points_x, points_y);
  const std::string map = fmt::format("the map of {} x {} points", points_x, points_y);
  in.at(header.data(), points * sizeof(float), map);
  in.end_at(header.data() + points * sizeof(float), map);
  const std::optional<double> length_x = header.length("XReal"), length_y = header.length("YReal");

  InstrumentFile result;
  result.format = "Gwyddion Simple Field";
  result.channels.push_back({header.text("Title"), header.text("ZUnits"), static_cast<std::size_t>(points_x),
                             static_cast<std::size_t>(points_y)});
  ChannelValues described;
  described.channel = result.channels[0];
  described.step_x = length_x ? *length_x / static_cast<double>(points_x) : 0.0;
  described.step_y = length_y ? *length_y / static_cast<double>(points_y) : 0.0;
  described.step_unit = header.text("XYUnits");
  result.values = [bytes, points, described, data = header.data()](std::size_t) {
    ChannelValues values = described;
    values.value.resize(points);
    for (std::size_t i = 0; i < points; ++i) {
      values.value[i] = number_at<float>(bytes->data() + data + i * sizeof(float), ByteOrder::kLittle);
    }
    values.set_missing_where_nan();
    return values;
  };
  return result;
}

std::string simple_field_bytes(const surface::HeightMap& map, const std::string& title) {
  const double step_y_m = map.is_profile() ? map.step_x_m : map.step_y_m;
  std::string header =
      fmt::format("{}XRes = {}\nYRes = {}\nXReal = {}\nYReal = {}\nXYUnits = m\nZUnits = m\n", kSignature, map.points_x,
                  map.points_y, io::exact_text(map.step_x_m * static_cast<double>(map.points_x)),
                  io::exact_text(step_y_m * static_cast<double>(map.points_y)));
  if (!title.empty()) header += "Title = " + title + "\n";
  BinaryWriter out((header.size() / 4 + 1) * 4);
  out.text(0, header.size(), header);
  for (std::size_t i = 0; i < map.points(); ++i) {
    out.append(map.measured(i) ? static_cast<float>(map.height_m[i]) : std::numeric_limits<float>::quiet_NaN());
  }
  return out.take();
}

}  // namespace ringfilm::instrument
