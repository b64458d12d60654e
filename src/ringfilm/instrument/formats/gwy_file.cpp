#include "ringfilm/instrument/formats/gwy_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"

namespace ringfilm::instrument {
namespace {

constexpr std::string_view kGwySignature = "GWYP";
/// Objects lie in objects; a real file has four levels.
constexpr int kDeepest = 16;

/// A named value of an object: where its bytes lie.
struct Component {
  char type = 0;
  std::size_t offset = 0;  ///< offset of the value, or of the first element of an array [byte]
  std::size_t count = 0;   ///< number of elements, or of bytes of a text or an object
};

using Object = std::map<std::string, Component>;

class GwyReader {
 public:
  explicit GwyReader(const BinaryReader& in) : in_(in) {}

  /// The component of that name and type; nullptr where there is none.
  static const Component* find(const Object& parent, const std::string& key, char type) {
    const auto found = parent.find(key);
    return found == parent.end() || found->second.type != type ? nullptr : &found->second;
  }

  /// The components of an object in another one, which is of the kind `name`.
  Object object(const Component& component, const std::string& name) const {
    return object(component.offset, component.offset + component.count, name);
  }

  /// The components of the object at `offset`, which is of the kind `name`.
  Object object(std::size_t offset, std::size_t end, const std::string& name) const {
    const std::string found = name_at(offset, end);
    if (found != name) {
      refuse_damaged(offset, fmt::format("a {} is required here, not a {}", name, utf8_from(found)));
    }
    offset += found.size() + 1;
    const std::size_t size = in_.number<std::uint32_t>(offset, "the size of an object");
    offset += 4;
    in_.at(offset, size, "an object");
    check_end(offset, size, end);
    const std::size_t own_end = offset + size;
    Object result;
    while (offset < own_end) {
      const std::string key = name_at(offset, own_end);
      offset += key.size() + 1;
      Component component;
      component.type = in_.at(offset, 1, "the type of a component")[0];
      ++offset;
      offset = skip(component, offset, own_end, 0);
      result[key] = component;
    }
    return result;
  }

  std::string text(const Object& parent, const std::string& key) const {
    const Component* const component = find(parent, key, 's');
    return component ? trimmed(utf8_from(in_.at(component->offset, component->count, "a text"))) : "";
  }

  /// The first text of a list of texts; empty if there is none.
  std::string first_text(const Object& parent, const std::string& key) const {
    const Component* const component = find(parent, key, 'S');
    if (!component || component->count == 0) return "";
    const std::size_t start = component->offset;
    return utf8_from(in_.at(start, in_.size() - start, "a text").substr(0, 1000)).substr(0, 1000);
  }

  /// The objects of a list, which are of the kind `name`.
  std::vector<Object> objects(const Object& parent, const std::string& key, const std::string& name) const {
    std::vector<Object> result;
    const Component* const list = find(parent, key, 'O');
    if (!list) return result;
    std::size_t offset = list->offset;
    for (std::size_t i = 0; i < list->count; ++i) {
      Component element;
      const std::size_t start = offset;
      offset = skip_object(element, offset, in_.size(), 0);
      result.push_back(object(start, offset, name));
    }
    return result;
  }

  template <class Number>
  Number number(const Object& parent, const std::string& key, char type) const {
    const Component* const component = find(parent, key, type);
    if (!component) refuse_damaged(0, fmt::format("an image has no {}", key));
    return in_.number<Number>(component->offset, key);
  }

  [[noreturn]] void refuse_damaged(std::size_t offset, const std::string& message) const {
    in_.refuse_at(offset, message, "the file is damaged: save it again");
  }

  const BinaryReader& in() const { return in_; }

 private:
  std::string name_at(std::size_t offset, std::size_t end) const {
    const std::string_view rest = in_.at(offset, end - offset, "a name");
    const std::size_t length = rest.substr(0, 4096).find('\0');
    if (length == std::string_view::npos) refuse_damaged(offset, "a name has no end");
    return std::string(rest.substr(0, length));
  }

  void check_end(std::size_t offset, std::size_t size, std::size_t end) const {
    if (offset > end || size > end - offset) {
      refuse_damaged(offset, fmt::format("{} bytes reach past the end of what holds them", size));
    }
  }

  /// Notes where the value lies. @returns the offset behind it
  std::size_t skip(Component& component, std::size_t offset, std::size_t end, int depth) const {
    const auto fixed = [&](std::size_t size) {
      component.offset = offset;
      component.count = 1;
      check_end(offset, size, end);
      return offset + size;
    };
    switch (component.type) {
      case 'b':
      case 'c':
        return fixed(1);
      case 'i':
        return fixed(4);
      case 'q':
      case 'd':
        return fixed(8);
      case 's':
        return skip_text(component, offset, end);
      case 'o':
        return skip_object(component, offset, end, depth);
      case 'C':
        return skip_array(component, offset, end, 1);
      case 'I':
        return skip_array(component, offset, end, 4);
      case 'Q':
      case 'D':
        return skip_array(component, offset, end, 8);
      case 'S':
      case 'O':
        return skip_list(component, offset, end, depth);
      default:
        refuse_damaged(offset, fmt::format("a value of the unknown type {}", static_cast<int>(component.type)));
    }
  }

  std::size_t skip_text(Component& component, std::size_t offset, std::size_t end) const {
    check_end(offset, 0, end);
    const std::size_t length = in_.at(offset, end - offset, "a text").find('\0');
    if (length == std::string_view::npos) refuse_damaged(offset, "a text has no end");
    component.offset = offset;
    component.count = length;
    return offset + length + 1;
  }

  std::size_t skip_object(Component& component, std::size_t offset, std::size_t end, int depth) const {
    if (depth > kDeepest) in_.refuse_at(offset, "objects lie too deep in each other", "the file is damaged");
    component.offset = offset;
    const std::size_t after_name = offset + name_at(offset, end).size() + 1;
    check_end(after_name, 4, end);
    const std::size_t size = in_.number<std::uint32_t>(after_name, "the size of an object");
    check_end(after_name + 4, size, end);
    component.count = after_name + 4 + size - offset;
    return after_name + 4 + size;
  }

  std::size_t skip_array(Component& component, std::size_t offset, std::size_t end, std::size_t element) const {
    check_end(offset, 4, end);
    component.count = in_.number<std::uint32_t>(offset, "the length of an array");
    component.offset = offset + 4;
    check_end(component.offset, component.count * element, end);
    return component.offset + component.count * element;
  }

  std::size_t skip_list(Component& component, std::size_t offset, std::size_t end, int depth) const {
    check_end(offset, 4, end);
    component.count = in_.number<std::uint32_t>(offset, "the length of a list");
    offset += 4;
    component.offset = offset;
    for (std::size_t i = 0; i < component.count; ++i) {
      Component element;
      offset = component.type == 'S' ? skip_text(element, offset, end) : skip_object(element, offset, end, depth + 1);
    }
    return offset;
  }

  const BinaryReader& in_;
};

/// Where an image lies, and what its header states.
struct Image {
  Channel channel;
  double step_x = 0, step_y = 0;
  std::string step_unit;
  std::size_t data = 0;  ///< [byte]
  std::size_t mask = 0;  ///< [byte]; 0 where there is none
};

std::string unit_of(const GwyReader& reader, const Object& field, const std::string& key) {
  const Component* const unit = GwyReader::find(field, key, 'o');
  return unit ? reader.text(reader.object(*unit, "GwySIUnit"), "unitstr") : "";
}

Image read_image(const GwyReader& reader, const Component& component) {
  const Object field = reader.object(component, "GwyDataField");
  const auto points_x = reader.number<std::int32_t>(field, "xres", 'i');
  const auto points_y = reader.number<std::int32_t>(field, "yres", 'i');
  if (points_x < 1 || points_y < 1) {
    reader.refuse_damaged(component.offset, fmt::format("an image of {} x {} points", points_x, points_y));
  }
  const std::size_t points = checked_points(reader.in().file(), points_x, points_y);
  const auto data = field.find("data");
  if (data == field.end() || data->second.type != 'D' || data->second.count != points) {
    reader.refuse_damaged(component.offset, fmt::format("an image of {} x {} points has {} values", points_x, points_y,
                                                        data == field.end() ? 0 : data->second.count));
  }
  Image image;
  image.channel.points_x = static_cast<std::size_t>(points_x);
  image.channel.points_y = static_cast<std::size_t>(points_y);
  image.channel.unit = unit_of(reader, field, "si_unit_z");
  image.step_x = reader.number<double>(field, "xreal", 'd') / points_x;
  image.step_y = reader.number<double>(field, "yreal", 'd') / points_y;
  image.step_unit = unit_of(reader, field, "si_unit_xy");
  if (!(image.step_x > 0) || !(image.step_y > 0) || !std::isfinite(image.step_x) || !std::isfinite(image.step_y)) {
    reader.refuse_damaged(component.offset, "an image has no size above zero");
  }
  image.data = data->second.offset;
  return image;
}

/// The number of a key such as "/12/data"; nothing else ends so.
bool image_number(const std::string& key, int& number) {
  if (key.size() < 7 || key[0] != '/') return false;
  const auto [rest, error] = std::from_chars(key.data() + 1, key.data() + key.size(), number);
  return error == std::errc{} &&
         std::string_view(rest, static_cast<std::size_t>(key.data() + key.size() - rest)) == "/data";
}

std::map<int, Image> read_images(const GwyReader& reader, const Object& all) {
  std::map<int, Image> images;
  for (const auto& [key, component] : all) {
    int number = 0;
    if (component.type != 'o' || !image_number(key, number)) continue;
    Image image = read_image(reader, component);
    image.channel.name = reader.text(all, key + "/title");
    if (const Component* const mask = GwyReader::find(all, fmt::format("/{}/mask", number), 'o')) {
      const Image covered = read_image(reader, *mask);
      if (covered.channel.points_x == image.channel.points_x && covered.channel.points_y == image.channel.points_y) {
        image.mask = covered.data;
      }
    }
    images[number] = image;
  }
  return images;
}

/// A curve of a graph, as gwyddion shows the profiles of styli.
struct Curve {
  Channel channel;
  std::string unit_x;
  std::size_t x = 0, y = 0;  ///< first number of the places and of the heights [byte]
};

/// The number of a key such as "/0/graph/graph/3"; nothing else begins so.
bool graph_number(const std::string& key, int& number) {
  constexpr std::string_view kBefore = "/0/graph/graph/";
  if (key.rfind(kBefore, 0) != 0) return false;
  const auto [rest, error] = std::from_chars(key.data() + kBefore.size(), key.data() + key.size(), number);
  return error == std::errc{} && rest == key.data() + key.size();
}

/// Curves of fewer than two points are omitted.
std::vector<Curve> read_curves(const GwyReader& reader, const Object& all) {
  std::map<int, Component> graphs;
  for (const auto& [key, component] : all) {
    int number = 0;
    if (component.type == 'o' && graph_number(key, number)) graphs[number] = component;
  }
  std::vector<Curve> curves;
  for (const auto& [number, component] : graphs) {
    const Object graph = reader.object(component, "GwyGraphModel");
    for (const Object& model : reader.objects(graph, "curves", "GwyGraphCurveModel")) {
      const Component *const x = GwyReader::find(model, "xdata", 'D'), *const y = GwyReader::find(model, "ydata", 'D');
      if (x == nullptr || y == nullptr || x->count != y->count) {
        reader.refuse_damaged(component.offset, "a curve has not as many heights as places");
      }
      if (x->count < 2) continue;
      checked_points(reader.in().file(), x->count, 1);
      Curve curve;
      curve.channel = {reader.text(model, "description"), unit_of(reader, graph, "y_unit"), x->count, 1};
      curve.unit_x = unit_of(reader, graph, "x_unit");
      curve.x = x->offset;
      curve.y = y->offset;
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

/// The points of a curve in the order of their places; those that are not numbers are omitted.
ChannelValues values_of(const std::string& file, const std::string& bytes, const Curve& curve) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < curve.channel.points_x; ++i) {
    const double x = number_at<double>(bytes.data() + curve.x + 8 * i, ByteOrder::kLittle);
    const double y = number_at<double>(bytes.data() + curve.y + 8 * i, ByteOrder::kLittle);
    if (std::isfinite(x) && std::isfinite(y)) points.emplace_back(x, y);
  }
  if (points.size() > 1 && points.front().first > points.back().first) std::reverse(points.begin(), points.end());
  ChannelValues values;
  values.channel = curve.channel;
  values.channel.points_x = points.size();
  values.step_unit = curve.unit_x;
  for (const auto& [x, y] : points) {
    if (!values.x.empty() && !(x > values.x.back())) {
      refuse(file, fmt::format("curve \"{}\": its places do not rise at {:g} {}", curve.channel.name, x, curve.unit_x),
             "a profile requires places that rise or fall: export a single trace");
    }
    values.x.push_back(x);
    values.value.push_back(y);
  }
  checked_points(file, points.size(), 1);
  return values;
}

/// The kind of file that gwyddion read an image from, by its log: "file::nanoscope(...)" gives "nanoscope".
std::string source_of(const GwyReader& reader, const Object& all, int number) {
  const Component* const log = GwyReader::find(all, fmt::format("/{}/data/log", number), 'o');
  if (!log) return "";
  const std::string first = reader.first_text(reader.object(*log, "GwyStringList"), "strings");
  const std::size_t bracket = first.find('(');
  if (first.rfind("file::", 0) != 0 || bracket == std::string::npos || bracket > 60) return "";
  return first.substr(6, bracket - 6);
}

ChannelValues values_of(const std::string& bytes, const Image& image) {
  ChannelValues values;
  values.channel = image.channel;
  values.step_x = image.step_x;
  values.step_y = image.step_y;
  values.step_unit = image.step_unit;
  const std::size_t points = image.channel.points_x * image.channel.points_y;
  values.value.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    values.value[i] = number_at<double>(bytes.data() + image.data + 8 * i, ByteOrder::kLittle);
    const bool masked =
        image.mask != 0 && !(number_at<double>(bytes.data() + image.mask + 8 * i, ByteOrder::kLittle) < 0.5);
    if (masked || std::isnan(values.value[i])) values.set_missing(i);
  }
  return values;
}

}  // namespace

InstrumentFile read_gwy(const std::string& file, std::shared_ptr<const std::string> bytes) {
  const BinaryReader in(file, *bytes);
  if (in.at(0, kGwySignature.size(), "the signature") != kGwySignature) {
    in.refuse_at(0, "a file of Gwyddion starts with \"GWYP\"", "is it the right file?");
  }
  const GwyReader reader(in);
  const Object all = reader.object(kGwySignature.size(), in.size(), "GwyContainer");
  InstrumentFile result;
  result.format = "Gwyddion (.gwy)";
  std::vector<Image> images;
  for (const auto& [number, image] : read_images(reader, all)) {
    if (images.empty()) {
      const std::string source = source_of(reader, all, number);
      if (!source.empty()) result.format += ", read by gwyddion from " + source;
      if (const Component* const meta = GwyReader::find(all, fmt::format("/{}/meta", number), 'o')) {
        const Object about = reader.object(*meta, "GwyContainer");
        result.date = reader.text(about, "Date");
        for (const char* key :
             {"Instrument", "Instrument name", "Description", "CreatingApplication", "Software type"}) {
          if (result.instrument.empty()) result.instrument = reader.text(about, key);
        }
      }
    }
    images.push_back(image);
    result.channels.push_back(image.channel);
  }
  std::vector<Curve> curves;
  if (images.empty()) curves = read_curves(reader, all);  // with images they are sections and analyses of them
  for (const Curve& curve : curves) result.channels.push_back(curve.channel);
  if (result.channels.empty()) {
    refuse(file, "the file holds no image and no curve",
           "volumes and lists of points are not read: export them as text");
  }
  result.values = [file, bytes, images, curves](std::size_t index) {
    return images.empty() ? values_of(file, *bytes, curves.at(index)) : values_of(*bytes, images.at(index));
  };
  return result;
}

}  // namespace ringfilm::instrument
