#include "ringfilm/instrument/formats/x3p_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <pugixml.hpp>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/instrument/formats/x3p_entries.hpp"
#include "ringfilm/instrument/formats/x3p_float_scale.hpp"
#include "ringfilm/instrument/formats/zip_archive.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/instrument/grid/number_from.hpp"
#include "ringfilm/instrument/grid/regular_grid.hpp"
#include "ringfilm/io/storage/digest.hpp"

namespace ringfilm::instrument {
namespace {

/// A million points within the XML take about 30 MB; parsed, some ten times that.
constexpr std::uint64_t kMaxXml = std::uint64_t{32} << 20;

/// Names may carry a prefix of their name space.
std::string local_name(const pugi::xml_node& node) {
  const std::string name = node.name();
  const std::size_t colon = name.rfind(':');
  return colon == std::string::npos ? name : name.substr(colon + 1);
}

pugi::xml_node find(const pugi::xml_node& parent, const std::string& name) {
  for (const pugi::xml_node& child : parent.children()) {
    if (local_name(child) == name) return child;
  }
  return {};
}

struct X3pAxis {
  bool by_step = false;
  char type = 'D';  ///< I, L, F, D: 16 and 32 bit whole numbers, single and double precision
  double increment = 1;
  double offset = 0;

  std::size_t bytes() const { return type == 'I' ? 2 : type == 'D' ? 8 : 4; }

  double value(const char* raw) const {
    switch (type) {
      case 'I':
        return number_at<std::int16_t>(raw, ByteOrder::kLittle) * increment + offset;
      case 'L':
        return number_at<std::int32_t>(raw, ByteOrder::kLittle) * increment + offset;
      case 'F':
        return double{number_at<float>(raw, ByteOrder::kLittle)} * increment + offset;
      default:
        return number_at<double>(raw, ByteOrder::kLittle) * increment + offset;
    }
  }
};

struct Description {
  std::string path;
  std::string folder;     ///< folder of main.xml in the archive, with its slash
  X3pFloatScale heights;  ///< scale of heights of the types F and D
  std::vector<Doubt> doubts;
  X3pAxis x, y, z;
  std::size_t points_x = 0, points_y = 0, layers = 1;
  bool is_profile = false;
  bool is_list = false;  ///< points without an order of rows
  std::string point_entry, point_checksum, valid_entry, valid_checksum;
  std::shared_ptr<const pugi::xml_document> document;  ///< kept where the points lie within the XML

  std::size_t points() const { return points_x * points_y; }
};

[[noreturn]] void refuse_element(const Description& about, const std::string& element, const std::string& message,
                                 const std::string& remedy) {
  refuse(about.path, fmt::format("main.xml, {}: {}", element, message), remedy);
}

double number_in(const Description& about, const std::string& element, const std::string& written) {
  std::string text = trimmed(written);
  if (const std::size_t comma = text.find(','); comma != std::string::npos) text[comma] = '.';  // check_commas notes it
  const std::optional<double> value = signed_number_from<double>(text);
  if (!value || !std::isfinite(*value)) {
    refuse_element(about, element,
                   fmt::format("\"{}\" is not a finite number", utf8_from(trimmed(written).substr(0, 40))),
                   "a number is required");
  }
  return *value;
}

pugi::xml_node child_of(const Description& about, const pugi::xml_node& parent, const std::string& name) {
  const pugi::xml_node node = find(parent, name);
  if (!node) {
    refuse_element(about, local_name(parent), "there is no element " + name,
                   "the standard requires it: export the file again");
  }
  return node;
}

std::string text_of(const pugi::xml_node& parent, const std::string& name) {
  return trimmed(utf8_from(find(parent, name).text().get()));
}

/// Are its characters of two bytes, or of four?
bool is_wide(const std::string& xml) {
  return xml.rfind("\xFE\xFF", 0) == 0 || xml.rfind("\xFF\xFE", 0) == 0 || xml.substr(0, 2).find('\0') < 2;
}

[[noreturn]] void refuse_doctype(const Description& about) {
  refuse(about.path, "main.xml has a DOCTYPE, which may hide entities that unfold without end",
         "no X3P needs one: export the file again");
}

std::shared_ptr<pugi::xml_document> parsed(const Description& about, const std::string& xml) {
  auto document = std::make_shared<pugi::xml_document>();
  // UTF-16 by its mark or its first characters, else UTF-8. Latin-1 passes too: its markup is ASCII, and utf8_from
  // reads its texts.
  const pugi::xml_parse_result result =
      document->load_buffer(xml.data(), xml.size(), pugi::parse_default | pugi::parse_doctype,
                            is_wide(xml) ? pugi::encoding_auto : pugi::encoding_utf8);
  if (!result) {
    refuse(about.path, fmt::format("main.xml, byte {}: {}", result.offset, result.description()),
           "the file was damaged on its way: copy it again from the instrument");
  }
  for (const pugi::xml_node& node : document->children()) {
    if (node.type() == pugi::node_doctype) refuse_doctype(about);
  }
  if (local_name(document->document_element()).rfind("ISO5436", 0) != 0) {
    refuse_element(about, local_name(document->document_element()), "the root is not ISO5436_2",
                   "is it the right file?");
  }
  return document;
}

/// Hexadecimal digits without capitals.
std::string lower_case(std::string digits) {
  for (char& c : digits) c = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
  return digits;
}

/// The check sum of main.xml is stored in an entry of its own. An archive without it, or with another one, is let
/// through with a note: main.xml is edited by hand, and its points have a check sum of their own.
void check_main(Description& about, const ZipArchive& archive, const std::string& xml,
                std::vector<std::string>& notes) {
  if (const std::size_t zero = xml.find('\0'); zero != std::string::npos && !is_wide(xml)) {
    refuse(about.path,
           fmt::format("main.xml, byte {}: a zero byte, so that it is written neither in UTF-8 nor in UTF-16", zero),
           "export the file again, with main.xml in UTF-8");
  }
  if (xml.find("<!DOCTYPE") != std::string::npos) refuse_doctype(about);
  const std::string sum = stored_entry(archive, about.folder + "md5checksum.hex");
  if (!archive.size(sum)) {
    notes.push_back("the archive has no md5checksum.hex: main.xml could not be verified");
    return;
  }
  const std::string line = archive.read(sum, 4096);
  const std::string stated = lower_case(trimmed(line).substr(0, 32));
  io::RunningDigest digest(io::RunningDigest::Kind::kMd5);
  digest.add(xml);
  const std::string found = digest.digits();
  if (stated != found) {
    about.doubts.push_back(
        {fmt::format("main.xml has the check sum {}, and md5checksum.hex states {}", found, utf8_from(stated)),
         "main.xml was edited after the measurement or damaged: compare sizes, steps and instrument with its "
         "protocol"});
  }
}

/// Numbers of XML have points. The first one that has a comma in its place is named.
void check_commas(const pugi::xml_node& root, Description& about) {
  struct FirstComma : pugi::xml_tree_walker {
    std::string element, text;
    bool for_each(pugi::xml_node& node) override {
      const std::string name = local_name(node);
      if (name != "Increment" && name != "Offset" && name != "Datum") return true;
      const std::string value = node.text().get();
      if (value.find(',') == std::string::npos) return true;
      element = name;
      text = value;
      return false;
    }
  } first;
  pugi::xml_node(root).traverse(first);
  if (first.element.empty()) return;
  about.doubts.push_back(
      {fmt::format("main.xml, {}: \"{}\" has a decimal comma, which was read as a point; so were all "
                   "others",
                   first.element, utf8_from(first.text.substr(0, 40))),
       "where a comma parts numbers, export the file again: XML requires points"});
}

/// Heights in floating-point numbers are in metres, and the increment has no purpose: it is applied to the whole set of
/// them or not at all, when they are known.
void set_aside_float_scale(Description& about) {
  if (about.z.type != 'F' && about.z.type != 'D') return;
  about.heights = {about.z.type, about.z.increment, about.z.offset};
  about.z.increment = 1;
  about.z.offset = 0;
}

X3pAxis read_axis(const Description& about, const pugi::xml_node& axes, const std::string& name) {
  const pugi::xml_node node = child_of(about, axes, name);
  const std::string kind = text_of(node, "AxisType"), type = text_of(node, "DataType");
  X3pAxis axis;
  if (kind != "I" && kind != "A") {
    refuse_element(about, name + "/AxisType", fmt::format("\"{}\" is neither I nor A", kind),
                   "I is an axis of even steps, A one of places");
  }
  axis.by_step = kind == "I";
  if (!type.empty()) {
    if (type != "I" && type != "L" && type != "F" && type != "D") {
      refuse_element(about, name + "/DataType", fmt::format("\"{}\" is not known", type), "I, L, F and D are");
    }
    axis.type = type[0];
  } else if (!axis.by_step) {
    refuse_element(about, name, "there is no DataType", "I, L, F or D is required");
  }
  const auto take = [&](const char* element, double& value) {  // an empty element states nothing
    const std::string text = text_of(node, element);
    if (!text.empty()) value = number_in(about, name + "/" + element, text);
  };
  take("Increment", axis.increment);
  take("Offset", axis.offset);
  return axis;
}

std::uint64_t size_in(const Description& about, const pugi::xml_node& node, const std::string& name) {
  const double value = number_in(about, name, child_of(about, node, name).text().get());
  if (value < 1 || value > 4294967295.0 || value != std::floor(value)) {
    refuse_element(about, name, fmt::format("{} is not a number of points", value), "a whole number of 1 or more");
  }
  return static_cast<std::uint64_t>(value);
}

void read_sizes(Description& about, const pugi::xml_node& record3) {
  std::uint64_t layers = 1;
  if (const pugi::xml_node matrix = find(record3, "MatrixDimension")) {
    const std::uint64_t points_x = size_in(about, matrix, "SizeX"), points_y = size_in(about, matrix, "SizeY");
    layers = size_in(about, matrix, "SizeZ");
    checked_points(about.path, points_x, points_y);
    about.points_x = points_x;
    about.points_y = points_y;
  } else {
    about.is_list = true;
    about.points_x = size_in(about, record3, "ListDimension");
    about.points_y = 1;
    checked_points(about.path, about.points_x, 1);
  }
  if (layers > 1000 || layers * about.points() > kMaxPoints) {
    refuse_element(about, "SizeZ", fmt::format("{} layers are too many", layers), "export single layers");
  }
  about.layers = layers;
}

/// Checks the increments of the axes. The step across a single row or column has no meaning: instruments write 0 there.
/// A negative increment of the heights would turn peaks into pits.
void check_increments(const Description& about) {
  const auto check = [&about](const X3pAxis& axis, std::size_t points, const char* name) {
    if (axis.increment > 0 || (axis.by_step && points == 1)) return;
    refuse_element(about, fmt::format("{}/Increment", name), fmt::format("{} is not a step", axis.increment),
                   "a number above zero is required: export the file again");
  };
  check(about.x, about.points_x, "CX");
  check(about.y, about.points_y, "CY");
  if (!(about.z.increment > 0)) {
    refuse_element(about, "CZ/Increment", fmt::format("{} is not a step of heights", about.z.increment),
                   "a number above zero is expected: export the file again");
  }
}

void read_links(Description& about, const pugi::xml_node& record3) {
  if (const pugi::xml_node link = find(record3, "DataLink")) {
    about.point_entry = entry_name(text_of(link, "PointDataLink"));
    about.point_checksum = text_of(link, "MD5ChecksumPointData");
    about.valid_entry = entry_name(text_of(link, "ValidPointsLink"));
    about.valid_checksum = text_of(link, "MD5ChecksumValidPoints");
    if (about.point_entry.empty()) refuse_element(about, "DataLink", "PointDataLink is empty", "a name is required");
  } else if (!find(record3, "DataList")) {
    refuse_element(about, "Record3", "there is neither DataLink nor DataList", "the standard requires one of them");
  }
}

void read_origin(const pugi::xml_node& record2, InstrumentFile& result) {
  result.date = text_of(record2, "Date");
  const pugi::xml_node instrument = find(record2, "Instrument");
  result.instrument = trimmed(text_of(instrument, "Manufacturer") + " " + text_of(instrument, "Model"));
}

std::size_t point_bytes(const Description& about) {
  return about.z.bytes() + (about.x.by_step ? 0 : about.x.bytes()) + (about.y.by_step ? 0 : about.y.bytes());
}

void compare_digest(const Description& about, const std::string& entry, std::string stated, io::RunningDigest& digest) {
  if (stated.empty()) return;
  stated = lower_case(std::move(stated));
  const std::string found = digest.digits();
  if (found != stated) {
    refuse(about.path, fmt::format("{} has the check sum {}, and main.xml states {}", entry, found, stated),
           "the file was damaged or edited: copy or export it again");
  }
}

/// Finds the entries of the points and of the mask, whose links may count from the folder of main.xml.
void find_entries(Description& about, const ZipArchive& archive) {
  const auto find_entry = [&](std::string& entry) {
    if (entry.empty()) return;
    const std::string beside = stored_entry(archive, about.folder + entry);
    entry = archive.size(beside) ? beside : stored_entry(archive, entry);
  };
  find_entry(about.point_entry);
  find_entry(about.valid_entry);
}

/// Compares the stated size with what is there, before any memory is taken for it.
void check_size(const Description& about, const ZipArchive& archive) {
  const std::size_t points = about.points() * about.layers;
  if (!about.point_entry.empty()) {
    const std::size_t total = point_bytes(about) * points;
    const std::optional<std::uint64_t> found = archive.size(about.point_entry);
    if (found && *found == total) return;
    refuse(about.path,
           found ? fmt::format("{} has {} bytes, and {} points of {} bytes need {}", about.point_entry, *found, points,
                               point_bytes(about), total)
                 : "the archive has no entry " + about.point_entry,
           "the sizes in main.xml and the points contradict each other: copy or export the file again");
  }
  const pugi::xml_node list = find(find(about.document->document_element(), "Record3"), "DataList");
  std::size_t found = 0;
  for (const pugi::xml_node& node : list.children()) found += local_name(node) == "Datum" ? 1 : 0;
  if (found != points) {
    refuse_element(about, "DataList", fmt::format("there are {} points, and {} are stated", found, points),
                   "the sizes contradict each other: copy or export the file again");
  }
}

/// Takes the points one after the other and keeps those of one layer.
class Collector {
 public:
  Collector(const Description& about, std::size_t layer) : about_(about), first_(layer * about.points()) {
    value_.resize(about.points());
    if (!about.x.by_step) x_.resize(about.points());
    if (!about.y.by_step && !about.is_profile) y_.resize(about.points());
  }

  void add(double x, double y, double z) {
    const std::size_t i = next_++ - first_;  // huge before the layer begins
    if (i >= value_.size()) return;
    if (!x_.empty()) x_[i] = x;
    if (!y_.empty()) y_[i] = y;
    if (std::isinf(z)) z = std::numeric_limits<double>::quiet_NaN();
    value_[i] = z;
  }

  void mark_missing(std::size_t point) {
    const std::size_t i = point - first_;
    if (i < value_.size()) value_[i] = std::numeric_limits<double>::quiet_NaN();
  }

  ChannelValues finish() {
    if (!x_.empty() && about_.is_profile) return profile();
    if (!x_.empty() || !y_.empty() || about_.is_list) return scattered();
    ChannelValues values;
    values.value = std::move(value_);
    values.set_missing_where_nan();
    values.step_x = about_.x.increment;
    values.step_y = about_.points_y > 1 ? about_.y.increment : 0;
    return values;
  }

 private:
  /// A stylus may report its places: points that were not measured are omitted.
  ChannelValues profile() {
    ChannelValues values;
    for (std::size_t i = 0; i < value_.size(); ++i) {
      if (std::isnan(value_[i]) || std::isnan(x_[i])) continue;
      values.x.push_back(x_[i]);
      values.value.push_back(value_[i]);
    }
    if (values.x.size() > 1 && values.x.front() > values.x.back()) {
      std::reverse(values.x.begin(), values.x.end());
      std::reverse(values.value.begin(), values.value.end());
    }
    values.channel.points_x = values.x.size();
    values.channel.points_y = 1;
    return values;
  }

  ChannelValues scattered() {
    ListedPoints points;
    for (std::size_t i = 0; i < value_.size(); ++i) {
      const double column = static_cast<double>(i % about_.points_x), row = static_cast<double>(i / about_.points_x);
      const double x = x_.empty() ? column * about_.x.increment : x_[i];
      const double y = y_.empty() ? row * about_.y.increment : y_[i];
      if (std::isnan(x) || std::isnan(y)) continue;
      points.x.push_back(x);
      points.y.push_back(y);
      points.value.push_back(value_[i]);
    }
    return on_regular_grid(about_.path, points);
  }

  const Description& about_;
  std::size_t first_;
  std::size_t next_ = 0;
  std::vector<double> x_, y_, value_;
};

void read_binary(const Description& about, Collector& collector) {
  const ZipArchive archive(about.path);
  const std::size_t size = point_bytes(about), total = size * about.points() * about.layers;
  io::RunningDigest digest(io::RunningDigest::Kind::kMd5);
  std::string rest;
  archive.read_pieces(about.point_entry, total, [&](std::string_view piece) {
    digest.add(piece);
    if (!rest.empty()) {
      const std::size_t fill = std::min(size - rest.size(), piece.size());
      rest += piece.substr(0, fill);
      piece.remove_prefix(fill);
    }
    const auto take = [&](const char* raw) {
      const double x = about.x.by_step ? 0 : about.x.value(raw);
      raw += about.x.by_step ? 0 : about.x.bytes();
      const double y = about.y.by_step ? 0 : about.y.value(raw);
      raw += about.y.by_step ? 0 : about.y.bytes();
      collector.add(x, y, about.z.value(raw));
    };
    if (rest.size() == size) {
      take(rest.data());
      rest.clear();
    }
    std::size_t place = 0;
    for (; place + size <= piece.size(); place += size) take(piece.data() + place);
    rest += piece.substr(place);
  });
  compare_digest(about, about.point_entry, about.point_checksum, digest);
  if (about.valid_entry.empty()) return;
  const std::size_t points = about.points() * about.layers;
  io::RunningDigest valid_digest(io::RunningDigest::Kind::kMd5);
  std::size_t point = 0;
  archive.read_pieces(about.valid_entry, (points + 7) / 8, [&](std::string_view piece) {
    valid_digest.add(piece);
    for (const char c : piece) {
      for (unsigned bit = 0; bit < 8 && point < points; ++bit, ++point) {
        if ((static_cast<unsigned char>(c) >> bit & 1u) == 0) collector.mark_missing(point);
      }
    }
  });
  compare_digest(about, about.valid_entry, about.valid_checksum, valid_digest);
}

/// A datum is "z", "x;z" or "x;y;z": the axes of even steps may be omitted or empty. An empty one is a missing point.
void read_datum(const Description& about, std::size_t number, const std::string& text, Collector& collector) {
  constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();
  if (text.find_first_not_of(" \t\r\n;") == std::string::npos) {
    collector.add(kNoHeight, kNoHeight, kNoHeight);
    return;
  }
  const std::string element = fmt::format("Datum {}", number + 1);
  std::vector<double> numbers;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(';', start), text.size());
    const std::string part = trimmed(std::string_view(text).substr(start, end - start));
    if (!part.empty()) numbers.push_back(part == "NaN" ? kNoHeight : number_in(about, element, part));
    start = end + 1;
    if (numbers.size() > 3) break;
  }
  const std::size_t requested = 1 + (about.x.by_step ? 0 : 1) + (about.y.by_step ? 0 : 1);
  if (numbers.size() != requested && numbers.size() != 3) {
    refuse_element(about, element, fmt::format("{} numbers, and {} are required", numbers.size(), requested),
                   "places of the axes of type A, then the height, parted by semicolons");
  }
  std::size_t i = 0;
  const bool all = numbers.size() == 3;
  const auto next = [&](const X3pAxis& axis) {
    if (axis.by_step && !all) return 0.0;
    return numbers[i++] * (axis.by_step ? 1.0 : axis.increment) + (axis.by_step ? 0.0 : axis.offset);
  };
  const double x = next(about.x), y = next(about.y);
  collector.add(x, y, numbers.back() * about.z.increment + about.z.offset);
}

void read_list(const Description& about, Collector& collector) {
  const pugi::xml_node list = find(find(about.document->document_element(), "Record3"), "DataList");
  std::size_t number = 0;
  for (const pugi::xml_node& node : list.children()) {
    if (local_name(node) == "Datum") read_datum(about, number++, node.text().get(), collector);
  }
}

}  // namespace

bool is_x3p(const std::string& path) { return !main_entry(ZipArchive(path)).empty(); }

InstrumentFile read_x3p(const std::string& path) {
  Description about;
  about.path = path;
  InstrumentFile result;
  result.format = "X3P (ISO 25178-72)";
  std::shared_ptr<pugi::xml_document> document;
  {
    const ZipArchive archive(path);
    const std::string entry = main_entry(archive), name = entry_name(entry);
    about.folder = name.substr(0, name.size() - std::string_view("main.xml").size());
    if (!about.folder.empty()) result.notes.push_back("main.xml lies in a folder of the archive: " + about.folder);
    const std::string xml = archive.read(entry, kMaxXml);
    check_main(about, archive, xml, result.notes);
    document = parsed(about, xml);
    check_commas(document->document_element(), about);
  }
  const pugi::xml_node root = document->document_element();
  const pugi::xml_node record1 = child_of(about, root, "Record1"), record3 = child_of(about, root, "Record3");
  const pugi::xml_node axes = child_of(about, record1, "Axes");
  about.x = read_axis(about, axes, "CX");
  about.y = read_axis(about, axes, "CY");
  about.z = read_axis(about, axes, "CZ");
  if (about.z.by_step) {
    refuse_element(about, "CZ/AxisType", "even steps are not allowed for heights", "A is required for CZ");
  }
  about.is_profile = text_of(record1, "FeatureType") == "PRF";
  read_sizes(about, record3);
  check_increments(about);
  set_aside_float_scale(about);
  read_links(about, record3);
  read_origin(find(root, "Record2"), result);
  for (std::size_t layer = 0; layer < about.layers; ++layer) {
    const std::string name = about.layers == 1 ? "heights" : fmt::format("layer {}", layer + 1);
    result.channels.push_back({name, "m", about.points_x, about.points_y});
  }
  if (about.point_entry.empty()) about.document = document;
  const ZipArchive points(path);
  find_entries(about, points);
  check_size(about, points);
  result.values = [about, channels = result.channels](std::size_t layer) {
    Collector collector(about, layer);
    if (about.point_entry.empty()) {
      read_list(about, collector);
    } else {
      read_binary(about, collector);
    }
    ChannelValues values = collector.finish();
    const Channel found = values.channel;
    values.channel = channels.at(layer);
    if (found.points_x > 0) {
      values.channel.points_x = found.points_x;
      values.channel.points_y = found.points_y;
    }
    values.step_unit = values.channel.unit;  // the standard allows metres only
    values.doubts = about.doubts;
    apply_float_scale(about.heights, values);
    return values;
  };
  return result;
}

}  // namespace ringfilm::instrument
