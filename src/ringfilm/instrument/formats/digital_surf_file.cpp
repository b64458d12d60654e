#include "ringfilm/instrument/formats/digital_surf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/binary_writer.hpp"
#include "ringfilm/instrument/formats/digital_surf_streams.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"

namespace ringfilm::instrument {
namespace {

constexpr std::size_t kHeaderSize = 512;
constexpr std::size_t kMaxComment = 2000;
constexpr char kSurfSignature[] = "DIGITAL SURF";
constexpr char kCompressed[] = "DSCOMPRESSED";

/// Offsets of the fields in the header [byte].
enum Offset : std::size_t {
  kByteOrder = 12,
  kObjects = 14,
  kType = 18,
  kName = 20,
  kSpecialPoints = 86,
  kPointBits = 98,
  kMin = 100,
  kMax = 104,
  kPointsX = 108,
  kPointsY = 112,
  kPoints = 116,
  kStepX = 120,
  kStepY = 124,
  kStepZ = 128,
  kAxisX = 132,
  kAxisY = 148,
  kAxisZ = 164,
  kUnitX = 180,
  kUnitY = 196,
  kUnitZ = 212,
  kLengthUnitX = 228,
  kLengthUnitY = 244,
  kLengthUnitZ = 260,
  kRatioX = 276,
  kRatioY = 280,
  kRatioZ = 284,
  kInverted = 290,
  kDay = 312,
  kCommentSize = 334,
  kPrivateSize = 336,
  kOffsetZ = 474
};

enum class Mirror { kNone, kHeights, kHeightsAndRows, kHeightsAndOrderOfRows };

struct Header {
  std::size_t points_x = 0;
  std::size_t points_y = 0;
  std::size_t point_bytes = 0;
  std::size_t comment = 0;              ///< size of the text behind the header [byte]
  std::size_t data = 0;                 ///< offset of the first height, or of the table of packed streams
  std::optional<PackedHeights> packed;  ///< heights of a compressed file
  std::vector<Doubt> doubts;            ///< what the file holds besides the heights
  double step_x = 0, step_y = 0, step_z = 0, offset_z = 0;
  std::string unit_x, unit_y, unit_z;
  bool has_missing = false;
  std::int64_t missing_value = 0;
  Mirror mirror = Mirror::kNone;
};

/// Kinds of objects from 3 on, as Digital Surf numbers them.
constexpr const char* kKinds[] = {"a binary image",
                                  "a series of profiles",
                                  "a series of surfaces",
                                  "a meridian disc",
                                  "a profile of several layers",
                                  "a surface of several layers",
                                  "a parallel disc",
                                  "an intensity image",
                                  "a surface with an intensity image",
                                  "an image in colours",
                                  "a surface in colours",
                                  "a force curve",
                                  "a series of force curves",
                                  "a surface with an image in colours",
                                  "a contour profile",
                                  "a series of images in colours"};

std::string kind_words(int type) {
  const auto place = static_cast<std::size_t>(type - 3);
  return type >= 3 && place < std::size(kKinds) ? kKinds[place] : "an object of unknown kind";
}

/// Kinds of several layers whose first one is the topography: surfaces of several layers, with an intensity image,
/// with an image in colours.
constexpr int kLayered[] = {8, 11, 16};

bool is_layered(int type) { return std::find(std::begin(kLayered), std::end(kLayered), type) != std::end(kLayered); }

/// What follows the heights: layers of their kind, or bytes that the header does not describe. Whole rows of a single
/// map are heights that its header does not count.
void doubt_tail(const BinaryReader& in, std::size_t end, int type, Header& header) {
  if (end >= in.size()) return;
  const std::size_t more = in.size() - end;
  const std::string map = fmt::format("the map of {} x {} points", header.points_x, header.points_y);
  if (is_layered(type)) {
    header.doubts.push_back(
        {fmt::format("byte {}: the file holds {} (kind {}); its first layer, the topography, was read, and {} bytes of "
                     "further layers were not",
                     end, kind_words(type), type, more),
         "export any other layer alone"});
    return;
  }
  if (!header.packed && more % (header.points_x * header.point_bytes) == 0) in.end_at(end, map);
  header.doubts.push_back(
      {fmt::format("byte {}: {} ends here, and the {} bytes behind it were not read", end, map, more),
       "if a part of the surface is missing, export the file again"});
}

Header read_header(const BinaryReader& in, bool is_packed) {
  const int objects = in.number<std::int16_t>(kObjects, "the number of objects");
  const int type = in.number<std::int16_t>(kType, "the kind of object");
  if (type != 1 && type != 2 && !is_layered(type)) {
    in.refuse_at(kType, fmt::format("the file holds {} (kind {})", kind_words(type), type),
                 "export a single surface (kind 2) or profile (kind 1), or as X3P");
  }
  if (objects != 1 && !is_layered(type)) {
    in.refuse_at(kObjects, fmt::format("the file holds {} objects, and one is read", objects),
                 "export the surface alone, or as X3P");
  }
  Header header;
  const int bits = in.number<std::int16_t>(kPointBits, "the size of a height");
  if (bits != 16 && bits != 32) {
    in.refuse_at(kPointBits, fmt::format("a height has {} bits; 16 or 32 are known", bits),
                 "the header is damaged, or the file is of a later kind: export it as X3P");
  }
  header.point_bytes = static_cast<std::size_t>(bits) / 8;
  const auto points_x = in.number<std::int32_t>(kPointsX, "the points of a row");
  const auto points_y = in.number<std::int32_t>(kPointsY, "the number of rows");
  if (points_x < 1 || points_y < 1) {
    in.refuse_at(kPointsX, fmt::format("the header states {} x {} points", points_x, points_y),
                 "the header is damaged: copy the file again");
  }
  const std::size_t points = checked_points(in.file(), points_x, points_y);
  // Some writers leave the number of all points at 0.
  const auto total = in.number<std::int32_t>(kPoints, "the number of all points");
  if (total != 0 && (total < 0 || static_cast<std::size_t>(total) != points)) {
    in.refuse_at(
        kPoints,
        fmt::format("the header states {} points in all, and {} x {} are {}", total, points_x, points_y, points),
        "the header is damaged: copy or export the file again");
  }
  header.points_x = static_cast<std::size_t>(points_x);
  header.points_y = static_cast<std::size_t>(points_y);
  const auto comment = in.number<std::int16_t>(kCommentSize, "the size of the comment");
  const auto own = in.number<std::int16_t>(kPrivateSize, "the size of the private zone");
  if (comment < 0 || own < 0) {
    in.refuse_at(kCommentSize, "the comment or the private zone has a negative size", "the header is damaged");
  }
  header.comment = static_cast<std::size_t>(comment);
  header.data = kHeaderSize + static_cast<std::size_t>(comment) + static_cast<std::size_t>(own);
  const std::size_t length = points * header.point_bytes;
  if (is_packed) {
    header.packed = packed_heights(in, header.data, length);
  } else {
    in.at(header.data, length, fmt::format("the map of {} x {} points", points_x, points_y));
  }
  doubt_tail(in, is_packed ? header.packed->end : header.data + length, type, header);

  header.step_x = in.number<float>(kStepX, "the step x");
  header.step_y = in.number<float>(kStepY, "the step y");
  header.step_z = in.number<float>(kStepZ, "the step z");
  header.offset_z = in.number<float>(kOffsetZ, "the offset z");
  const std::string remedy = "the header is damaged, or its byte order is not the one it states: export the file again";
  for (const auto& [offset, name, step] :
       {std::tuple(kStepX, "x", header.step_x), std::tuple(kStepY, "y", header.step_y)}) {
    if (std::isfinite(step) && step >= 0) continue;  // 0: not stated, and asked for where it is needed
    in.refuse_at(offset, fmt::format("the step along {} is {}; a number above zero is expected", name, step), remedy);
  }
  // A negative step would turn peaks into pits; the mark of inversion is there for that.
  if (!(std::isfinite(header.step_z) && header.step_z > 0 && std::isfinite(header.offset_z))) {
    in.refuse_at(kStepZ,
                 fmt::format("the step of the heights is {}, their offset {}; a step above zero is expected",
                             header.step_z, header.offset_z),
                 remedy);
  }
  header.unit_x = in.text(kUnitX, 16, "the unit of x");
  header.unit_y = in.text(kUnitY, 16, "the unit of y");
  header.unit_z = in.text(kUnitZ, 16, "the unit of z");
  header.has_missing = in.number<std::int16_t>(kSpecialPoints, "the mark of special points") == 1;
  header.missing_value = std::int64_t{in.number<std::int32_t>(kMin, "the smallest height")} - 2;
  const int inverted = in.number<std::int16_t>(kInverted, "the mark of inversion");
  if (inverted >= 1 && inverted <= 3) header.mirror = static_cast<Mirror>(inverted);
  return header;
}

/// The number of rows or points may be turned, so that the same order of operations is kept: heights, then places.
void apply_mirror(Mirror mirror, ChannelValues& values) {
  if (mirror == Mirror::kNone) return;
  double sum = 0;
  std::size_t measured = 0;
  for (std::size_t i = 0; i < values.value.size(); ++i) {
    if (values.is_missing(i)) continue;
    sum += values.value[i];
    ++measured;
  }
  const double twice_mean = measured > 0 ? 2 * (sum / static_cast<double>(measured)) : 0;
  for (std::size_t i = 0; i < values.value.size(); ++i) {
    if (!values.is_missing(i)) values.value[i] = twice_mean - values.value[i];
  }
  const auto n_x = static_cast<std::ptrdiff_t>(values.channel.points_x);
  const auto n_y = static_cast<std::ptrdiff_t>(values.channel.points_y);
  const auto turn = [&](auto& points) {
    if (points.empty()) return;
    if (mirror == Mirror::kHeightsAndRows) {
      for (std::ptrdiff_t j = 0; j < n_y; ++j) {
        std::reverse(points.begin() + j * n_x, points.begin() + (j + 1) * n_x);
      }
    } else if (mirror == Mirror::kHeightsAndOrderOfRows) {
      for (std::ptrdiff_t j = 0; j < n_y / 2; ++j) {
        std::swap_ranges(points.begin() + j * n_x, points.begin() + (j + 1) * n_x,
                         points.begin() + (n_y - 1 - j) * n_x);
      }
    }
  };
  turn(values.value);
  turn(values.missing);
  values.notes.push_back(
      "the header states that the surface is inverted; its heights were turned back about their mean");
}

/// Heights two below the smallest one of the header mark missing points, and the header reports none.
/// @param whole one height as stored, by its number
template <class Whole>
void doubt_unreported(const Header& header, const Whole& whole, ChannelValues& values) {
  std::size_t count = 0, first = 0;
  for (std::size_t i = values.value.size(); i-- > 0;) {
    const std::int64_t height = whole(i);
    if (height == header.missing_value) {
      first = i;
      ++count;
    } else if (height < header.missing_value + 2) {
      return;  // the header does not state the range of these heights
    }
  }
  if (count == 0) return;
  values.doubts.push_back(
      {fmt::format("{} hold{} {}, two below the smallest height of the header, the first of them in row {}, column {}: "
                   "the mark of missing points, which the header does not report",
                   count == 1 ? "1 point" : fmt::format("{} points", count), count == 1 ? "s" : "",
                   header.missing_value, first / header.points_x + 1, first % header.points_x + 1),
       "they were read as heights; mask them in the program that wrote the file"});
}

template <class Whole>
void read_heights(const BinaryReader& in, const Header& header, ChannelValues& values) {
  const std::size_t points = header.points_x * header.points_y;
  const std::size_t length = points * sizeof(Whole);
  const std::string unpacked = header.packed ? unpacked_heights(in, *header.packed, length) : std::string();
  const char* raw = header.packed ? unpacked.data() : in.at(header.data, length, "the map").data();
  const auto whole = [raw, order = in.order()](std::size_t i) {
    return number_at<Whole>(raw + i * sizeof(Whole), order);
  };
  values.value.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    const Whole height = whole(i);
    if (header.has_missing && height == header.missing_value) {
      values.set_missing(i);
    } else {
      values.value[i] = height * header.step_z + header.offset_z;
    }
  }
  if (!header.has_missing) doubt_unreported(header, whole, values);
}

}  // namespace

InstrumentFile read_digital_surf(const std::string& file, std::shared_ptr<const std::string> bytes) {
  const BinaryReader probe(file, *bytes);
  const std::string_view signature = probe.at(0, 12, "the signature");
  const bool is_packed = signature == kCompressed;
  if (!is_packed && signature != kSurfSignature) {
    probe.refuse_at(0, "a file of Digital Surf starts with \"DIGITAL SURF\"", "is it the right file?");
  }
  probe.at(0, kHeaderSize, "the header");
  const bool big = probe.number<std::int16_t>(kByteOrder, "the byte order") != 0;
  const BinaryReader in(file, *bytes, big ? ByteOrder::kBig : ByteOrder::kLittle);
  const Header header = read_header(in, is_packed);

  InstrumentFile result;
  result.format = fmt::format("Digital Surf, {}{} bit, {}", is_packed ? "compressed, " : "", header.point_bytes * 8,
                              big ? "high byte first" : "low byte first");
  result.instrument = "";
  const int day = in.number<std::int16_t>(kDay, "the day");
  const int month = in.number<std::int16_t>(kDay + 2, "the month");
  const int year = in.number<std::int16_t>(kDay + 4, "the year");
  if (day >= 1 && day <= 31 && month >= 1 && month <= 12 && year > 0) {
    result.date = fmt::format("{:04}-{:02}-{:02}", year, month, day);
  }
  const std::string comment = in.text(kHeaderSize, std::min(header.comment, kMaxComment), "the comment");
  if (!comment.empty()) result.notes.push_back("comment in the file: " + comment);
  const std::string name = in.text(kName, 30, "the name");
  result.channels.push_back({name.empty() ? "Z" : name, header.unit_z, header.points_x, header.points_y});
  result.values = [file, bytes, header, order = in.order(), channel = result.channels[0]](std::size_t) {
    const BinaryReader data(file, *bytes, order);
    ChannelValues values;
    values.channel = channel;
    values.step_x = header.step_x;
    values.step_y = header.step_y;
    values.step_unit = header.unit_x;
    if (header.points_y > 1 && header.unit_x != header.unit_y) values.step_unit_y = header.unit_y;
    values.doubts = header.doubts;
    if (header.point_bytes == 2) {
      read_heights<std::int16_t>(data, header, values);
    } else {
      read_heights<std::int32_t>(data, header, values);
    }
    apply_mirror(header.mirror, values);
    return values;
  };
  return result;
}

std::string digital_surf_bytes(const surface::HeightMap& map, double resolution_m, const std::string& name,
                               const std::string& comment) {
  const double step_z_um = static_cast<float>(number_in(resolution_m, kMicrometre));
  std::vector<std::int32_t> whole(map.points());
  std::int32_t smallest = std::numeric_limits<std::int32_t>::max(), largest = std::numeric_limits<std::int32_t>::min();
  bool any_missing = false;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) {
      any_missing = true;
      continue;
    }
    const double steps = std::round(number_in(map.height_m[i], kMicrometre) / step_z_um);
    if (!(std::abs(steps) < 2147483000.0)) {
      throw InputError(
          fmt::format("a height of {} m has no place in 32 bit at a resolution of {} m", map.height_m[i], resolution_m),
          "write it with a coarser resolution");
    }
    whole[i] = static_cast<std::int32_t>(steps);
    smallest = std::min(smallest, whole[i]);
    largest = std::max(largest, whole[i]);
  }
  if (smallest > largest) throw InputError("the map has no measured point", "write a map that has one");
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) whole[i] = smallest - 2;
  }
  const std::string_view kept = std::string_view(comment).substr(0, kMaxComment);
  BinaryWriter out(kHeaderSize + kept.size());
  out.text(0, 12, kSurfSignature);
  out.number<std::int16_t>(kCommentSize, static_cast<std::int16_t>(kept.size()));
  out.text(kHeaderSize, kept.size(), kept);
  out.number<std::int16_t>(kObjects, 1);
  out.number<std::int16_t>(16, 1);  // version
  out.number<std::int16_t>(kType, map.is_profile() ? 1 : 2);
  out.text(kName, 30, name);
  out.text(50, 30, "");  // who measured
  out.number<std::int16_t>(kSpecialPoints, any_missing ? 1 : 0);
  out.number<std::int16_t>(88, 1);  // heights are absolute
  out.number<std::int16_t>(kPointBits, 32);
  out.number<std::int32_t>(kMin, smallest);
  out.number<std::int32_t>(kMax, largest);
  out.number<std::int32_t>(kPointsX, static_cast<std::int32_t>(map.points_x));
  out.number<std::int32_t>(kPointsY, static_cast<std::int32_t>(map.points_y));
  out.number<std::int32_t>(kPoints, static_cast<std::int32_t>(map.points()));
  const double step_y_m = map.is_profile() ? map.step_x_m : map.step_y_m;
  out.number<float>(kStepX, static_cast<float>(number_in(map.step_x_m, kMicrometre)));
  out.number<float>(kStepY, static_cast<float>(number_in(step_y_m, kMicrometre)));
  out.number<float>(kStepZ, static_cast<float>(step_z_um));
  const std::size_t axes[] = {kAxisX, kAxisY, kAxisZ};
  const char* const names[] = {"X", "Y", "Z"};
  for (std::size_t i = 0; i < 3; ++i) out.text(axes[i], 16, names[i]);
  for (const std::size_t unit : {kUnitX, kUnitY, kUnitZ, kLengthUnitX, kLengthUnitY, kLengthUnitZ}) {
    out.text(unit, 16, "um");
  }
  for (const std::size_t ratio : {kRatioX, kRatioY, kRatioZ}) out.number<float>(ratio, 1.0f);
  for (const std::int32_t height : whole) out.append(height);
  return out.take();
}

}  // namespace ringfilm::instrument
