#include "ringfilm/instrument/formats/sdf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/instrument/grid/number_from.hpp"

namespace ringfilm::instrument {
namespace {

constexpr std::size_t kVersionSize = 8;
constexpr std::size_t kMaxTextHeader = std::size_t{1} << 16;

struct SdfHeader {
  std::string version, manufacturer, date;
  std::uint64_t points_x = 0, points_y = 0;
  double step_x = 0, step_y = 0, scale_z = 0;
  int compression = 0, type = 0, check = 0;
  std::size_t data = 0;  ///< offset of the first height [byte]
};

template <class Number>
bool is_missing(Number value) {
  using Limits = std::numeric_limits<Number>;
  if constexpr (std::is_floating_point_v<Number>) {
    return std::isnan(value) || value == Limits::lowest();
  } else if constexpr (std::is_signed_v<Number>) {
    return value == Limits::lowest();
  } else {
    return sizeof(Number) > 1 && value == Limits::max();
  }
}

template <class Number>
void read_binary(const BinaryReader& in, const SdfHeader& header, ChannelValues& values) {
  const char* const raw = in.at(header.data, values.value.size() * sizeof(Number), "the map").data();
  for (std::size_t i = 0; i < values.value.size(); ++i) {
    const Number number = number_at<Number>(raw + i * sizeof(Number), ByteOrder::kLittle);
    if (is_missing(number)) {
      values.set_missing(i);
    } else {
      values.value[i] = static_cast<double>(number) * header.scale_z;
    }
  }
}

/// The kinds of numbers, in the order of DataType.
struct NumberType {
  std::size_t bytes;
  void (*read)(const BinaryReader&, const SdfHeader&, ChannelValues&);
};
template <class Number>
constexpr NumberType kTypeOf = {sizeof(Number), read_binary<Number>};
constexpr NumberType kTypes[] = {kTypeOf<std::uint8_t>, kTypeOf<std::uint16_t>, kTypeOf<std::uint32_t>,
                                 kTypeOf<float>,        kTypeOf<std::int8_t>,   kTypeOf<std::int16_t>,
                                 kTypeOf<std::int32_t>, kTypeOf<double>};

void check_header(const BinaryReader& in, const SdfHeader& header) {
  if (header.compression != 0) {
    in.refuse_at(0, fmt::format("the heights are compressed (Compression = {}), which is not read", header.compression),
                 "save the file without compression");
  }
  if (header.type < 0 || header.type > 7) {
    in.refuse_at(0, fmt::format("DataType = {} is not known; 0 to 7 are", header.type),
                 "the header is damaged, or the file is of a later kind: export it as X3P");
  }
  // A negative scale would turn peaks into pits.
  if (!(std::isfinite(header.scale_z) && header.scale_z > 0)) {
    in.refuse_at(0, fmt::format("Zscale = {} gives no heights; a number above zero is expected", header.scale_z),
                 "the header is damaged, or its byte order is not low byte first");
  }
  for (const double step : {header.step_x, header.step_y}) {
    if (!std::isfinite(step) || step < 0) {
      in.refuse_at(0, fmt::format("{} m is not a valid step", step),
                   "the header is damaged, or its byte order is not low byte first");
    }
  }
  checked_points(in.file(), header.points_x, header.points_y);
}

/// The heights of a binary file may be followed by a trailer: elements such as <OperatorName>, in text alone.
void check_trailer(const BinaryReader& in, std::size_t offset, const std::string& map) {
  const std::string_view rest = in.at(offset, in.size() - offset, "the trailer");
  const auto is_text = [](char c) { return (c >= ' ' && c <= '~') || c == '\t' || c == '\r' || c == '\n'; };
  const std::size_t first = rest.find_first_not_of(" \t\r\n*");
  const bool opens = first == std::string_view::npos || rest[first] == '<';
  if (!opens || !std::all_of(rest.begin(), rest.end(), is_text)) in.end_at(offset, map);
}

SdfHeader read_binary_header(const BinaryReader& in) {
  SdfHeader header;
  header.version = in.text(0, kVersionSize, "the version");
  header.manufacturer = in.text(8, 10, "the manufacturer");
  header.date = in.text(18, 12, "the date");
  const bool wide = header.version == "bISO-2.0";
  const std::size_t scales = wide ? 50 : 46;
  if (wide) {
    header.points_x = in.number<std::uint32_t>(42, "NumPoints");
    header.points_y = in.number<std::uint32_t>(46, "NumProfiles");
  } else {
    header.points_x = in.number<std::uint16_t>(42, "NumPoints");
    header.points_y = in.number<std::uint16_t>(44, "NumProfiles");
  }
  header.step_x = in.number<double>(scales, "Xscale");
  header.step_y = in.number<double>(scales + 8, "Yscale");
  header.scale_z = in.number<double>(scales + 16, "Zscale");
  header.compression = in.number<std::uint8_t>(scales + 32, "Compression");
  header.type = in.number<std::uint8_t>(scales + 33, "DataType");
  header.check = in.number<std::uint8_t>(scales + 34, "CheckType");
  header.data = scales + 35;
  check_header(in, header);
  const std::size_t needed = header.points_x * header.points_y * kTypes[header.type].bytes;
  const std::string map = fmt::format("the map of {} x {} points", header.points_x, header.points_y);
  in.at(header.data, needed, map);
  // Instruments of one maker put two numbers of 4 bytes behind the header that no standard defines.
  if (header.version == "bISO-1.0" && in.size() == header.data + needed + 8 &&
      in.number<std::uint32_t>(header.data, "an extra field") == 5 &&
      in.number<std::uint32_t>(header.data + 4, "an extra field") == 1) {
    header.data += 8;
  }
  check_trailer(in, header.data + needed, map);
  return header;
}

class TextHeader {
 public:
  explicit TextHeader(const BinaryReader& in) : in_(in) {
    const std::string_view all = in.at(0, std::min(in.size(), kMaxTextHeader), "the header");
    std::size_t start = all.find('\n');
    while (start != std::string_view::npos) {
      const std::size_t line_start = start + 1;
      start = all.find('\n', line_start);
      const std::string line =
          trimmed(all.substr(line_start, start == std::string_view::npos ? start : start - line_start));
      if (line == "*" && start != std::string_view::npos) {
        data_ = start + 1;
        return;
      }
      const std::size_t equals = line.find('=');
      if (line.empty()) continue;
      if (equals == std::string::npos) {
        in.refuse_at(line_start, "a line of the header has no \"=\"", "write it as \"NumPoints = 512\"");
      }
      entries_[trimmed(line.substr(0, equals))] = {trimmed(utf8_from(line.substr(equals + 1))), line_start};
    }
    in.refuse_at(all.size(), "no line \"*\" ends the header", "the file was cut short: copy it again");
  }

  std::size_t data() const { return data_; }

  std::string text(const std::string& key) const {
    const auto entry = entries_.find(key);
    return entry == entries_.end() ? "" : entry->second.first;
  }

  template <class Number>
  Number number(const std::string& key) const {
    const auto entry = entries_.find(key);
    if (entry == entries_.end()) {
      in_.refuse_at(0, fmt::format("the header has no {}", key), "the file is damaged or no SDF");
    }
    const std::string& text = entry->second.first;
    const std::optional<Number> value = signed_number_from<Number>(text);
    if (!value) {
      in_.refuse_at(entry->second.second, fmt::format("{} = {} is not a number of its kind", key, text),
                    "a number is required");
    }
    return *value;
  }

 private:
  const BinaryReader& in_;
  std::map<std::string, std::pair<std::string, std::size_t>> entries_;
  std::size_t data_ = 0;
};

SdfHeader read_text_header(const BinaryReader& in) {
  const TextHeader lines(in);
  SdfHeader header;
  header.version = in.text(0, kVersionSize, "the version");
  header.manufacturer = lines.text("ManufacID");
  header.date = lines.text("CreateDate");
  header.points_x = lines.number<std::uint32_t>("NumPoints");
  header.points_y = lines.number<std::uint32_t>("NumProfiles");
  header.step_x = lines.number<double>("Xscale");
  header.step_y = lines.number<double>("Yscale");
  header.scale_z = lines.number<double>("Zscale");
  header.compression = lines.number<int>("Compression");
  header.type = lines.number<int>("DataType");
  header.data = lines.data();
  check_header(in, header);
  // A height takes a digit and what parts it from the next.
  if (header.points_x * header.points_y > (in.size() - header.data + 1) / 2) {
    in.refuse_at(header.data,
                 fmt::format("{} x {} heights have no place in the {} bytes that follow", header.points_x,
                             header.points_y, in.size() - header.data),
                 "the file was cut short or its header is damaged: copy it again");
  }
  return header;
}

void read_text(const BinaryReader& in, const SdfHeader& header, ChannelValues& values) {
  const std::string_view all = in.at(0, in.size(), "the heights");
  const char* place = all.data() + header.data;
  const char* const end = all.data() + all.size();
  const auto skip_blanks = [&place, end] {
    while (place != end && (*place == ' ' || *place == '\t' || *place == '\r' || *place == '\n')) ++place;
  };
  for (std::size_t i = 0; i < values.value.size(); ++i) {
    skip_blanks();
    const auto offset = static_cast<std::size_t>(place - all.data());
    if (place == end || *place == '*') {
      in.refuse_at(offset, fmt::format("the heights end after {} of {}", i, values.value.size()),
                   "the file was cut short or its header is damaged: copy it again");
    }
    if (end - place >= 3 && std::string_view(place, 3) == "BAD") {
      values.set_missing(i);
      place += 3;
      continue;
    }
    double height = 0;
    const auto [rest, error] = std::from_chars(*place == '+' ? place + 1 : place, end, height);
    const bool ends = rest == end || *rest == ' ' || *rest == '\t' || *rest == '\r' || *rest == '\n' || *rest == '*';
    if (error != std::errc{} || !ends || std::isinf(height)) {
      in.refuse_at(offset, fmt::format("height {} is not a number", i + 1), "a number or BAD is required here");
    }
    if (std::isnan(height)) {
      values.set_missing(i);
    } else {
      values.value[i] = height * header.scale_z;
    }
    place = rest;
  }
  if (place == end) {
    in.refuse_at(all.size(), "the file ends within its last height: nothing shows whether a digit is missing",
                 "the file was cut short: copy it again; after the last height a line \"*\" is required");
  }
  skip_blanks();
  if (place == end) values.notes.push_back("the line \"*\" that ends the heights is missing; all heights are there");
  if (place != end && *place != '*') {
    in.refuse_at(
        static_cast<std::size_t>(place - all.data()),
        fmt::format("the map of {} x {} points ends here, and more follows", header.points_x, header.points_y),
        "after the last height a line \"*\" is required; else the size in the header is smaller than the data");
  }
}

}  // namespace

bool is_sdf(const std::string& bytes) {
  if (bytes.size() < kVersionSize || (bytes[0] != 'a' && bytes[0] != 'b')) return false;
  const std::string family = bytes.substr(1, 4);
  return family == "ISO-" || family == "BCR-" || bytes.compare(1, 5, "NIST-") == 0;
}

InstrumentFile read_sdf(const std::string& file, std::shared_ptr<const std::string> bytes) {
  const BinaryReader in(file, *bytes);
  if (!is_sdf(*bytes)) in.refuse_at(0, "an SDF starts with its version, e.g. \"aISO-1.0\"", "is it the right file?");
  const bool is_text = (*bytes)[0] == 'a';
  const SdfHeader header = is_text ? read_text_header(in) : read_binary_header(in);
  InstrumentFile result;
  result.format = fmt::format("SDF {} (ISO 25178-71, {})", header.version, is_text ? "text" : "binary");
  result.instrument = header.manufacturer;
  result.date = header.date;
  if (header.check != 0) result.notes.push_back("the file states a check sum, which is not verified");
  const auto points_x = static_cast<std::size_t>(header.points_x), points_y = static_cast<std::size_t>(header.points_y);
  result.channels.push_back({"heights", "m", points_x, points_y});
  result.values = [file, bytes, header, is_text, channel = result.channels[0]](std::size_t) {
    const BinaryReader data(file, *bytes);
    ChannelValues values;
    values.channel = channel;
    values.step_x = header.step_x;
    values.step_y = channel.points_y > 1 ? header.step_y : 0.0;
    values.step_unit = values.channel.unit;  // the standard allows metres only
    values.value.resize(channel.points_x * channel.points_y);
    if (is_text) {
      read_text(data, header, values);
    } else {
      kTypes[header.type].read(data, header, values);
    }
    return values;
  };
  return result;
}

}  // namespace ringfilm::instrument
