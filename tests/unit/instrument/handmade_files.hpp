#pragma once
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Files written byte by byte, without a line of the readers and writers that they test.
namespace ringfilm::instrument::handmade {

class Bytes {
 public:
  explicit Bytes(bool high_byte_first = false) : high_first_(high_byte_first) {}

  Bytes& text(const std::string& value) {
    bytes_ += value;
    return *this;
  }
  Bytes& text(const std::string& value, std::size_t length, char fill = ' ') {
    std::string field = value;
    field.resize(length, fill);
    return text(field);
  }
  Bytes& whole(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) {
      const int place = high_first_ ? size - 1 - i : i;
      bytes_ += static_cast<char>(value >> (8 * place) & 0xFF);
    }
    return *this;
  }
  Bytes& i16(std::int64_t value) { return whole(static_cast<std::uint64_t>(value), 2); }
  Bytes& i32(std::int64_t value) { return whole(static_cast<std::uint64_t>(value), 4); }
  Bytes& f32(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, 4);
    return whole(bits, 4);
  }
  Bytes& f64(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, 8);
    return whole(bits, 8);
  }
  Bytes& zeros(std::size_t count) { return text(std::string(count, '\0')); }

  const std::string& str() const { return bytes_; }
  operator const std::string&() const { return bytes_; }

 private:
  bool high_first_;
  std::string bytes_;
};

inline std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

/// A zip archive of stored entries.
inline std::string zip(const std::vector<std::pair<std::string, std::string>>& entries) {
  Bytes body, directory;
  for (const auto& [name, content] : entries) {
    const std::size_t place = body.str().size();
    const auto about = [&name, &content](Bytes& out) {
      out.i16(20).i16(0).i16(0).i16(0).i16(33).i32(crc32(content));
      out.i32(static_cast<std::int64_t>(content.size())).i32(static_cast<std::int64_t>(content.size()));
      out.i16(static_cast<std::int64_t>(name.size())).i16(0);
    };
    body.text("PK\x03\x04", 4);
    about(body);
    body.text(name).text(content);
    directory.text("PK\x01\x02", 4).i16(20);
    about(directory);
    directory.i16(0).i16(0).i16(0).i32(0).i32(static_cast<std::int64_t>(place)).text(name);
  }
  const auto count = static_cast<std::int64_t>(entries.size());
  Bytes end;
  end.text("PK\x05\x06", 4).i16(0).i16(0).i16(count).i16(count);
  end.i32(static_cast<std::int64_t>(directory.str().size())).i32(static_cast<std::int64_t>(body.str().size())).i16(0);
  return body.str() + directory.str() + end.str();
}

/// What is in the header of a .sur; heights follow.
struct Sur {
  bool high_byte_first = false;
  int bits = 32;
  int type = 2;
  int objects = 1;
  int special_points = 0;
  int points_x = 3, points_y = 2;
  std::optional<int> points = {};  ///< points_x * points_y
  std::int64_t smallest = 0;
  int inverted = 0;
  int comment_size = 0;
  float step_x = 2.0f, step_y = 3.0f, step_z = 0.25f, offset_z = 5.0f;
  std::string unit_xy = "um", unit_z = "nm";
  std::string unit_y = {};  ///< unit_xy
  std::vector<std::int64_t> heights = {10, 20, 30, 40, 50, 60};

  std::string bytes() const {
    Bytes out(high_byte_first);
    out.text("DIGITAL SURF").i16(high_byte_first ? 1 : 0).i16(objects).i16(1).i16(type);
    out.text("a scratch", 30).text("somebody", 30).i16(0).i16(0).i16(0).i16(special_points).i16(1);
    out.f32(0).i32(0).i16(bits).i32(smallest).i32(60).i32(points_x).i32(points_y).i32(
        points.value_or(points_x * points_y));
    out.f32(step_x).f32(step_y).f32(step_z).text("X", 16).text("Y", 16).text("Z", 16);
    out.text(unit_xy, 16).text(unit_y.empty() ? unit_xy : unit_y, 16).text(unit_z, 16);
    out.text(unit_xy, 16).text(unit_xy, 16).text(unit_z, 16);
    out.f32(1).f32(1).f32(1).i16(0).i16(inverted).i16(0).zeros(12);
    out.i16(0).i16(0).i16(0).i16(7).i16(3).i16(2019).i16(0).f32(0).zeros(10).i16(comment_size).i16(0).zeros(128);
    out.f32(0).f32(0).f32(offset_z).zeros(34).text(std::string(static_cast<std::size_t>(comment_size), 'c'));
    for (const std::int64_t height : heights) out.whole(static_cast<std::uint64_t>(height), bits / 8);
    return out;
  }

  /// The same with its heights packed in streams of so many bytes each. @param pack makes a zlib stream
  template <class Pack>
  std::string compressed(std::size_t each, const Pack& pack) const {
    std::string whole = bytes();
    const std::size_t head = whole.size() - heights.size() * static_cast<std::size_t>(bits / 8);
    const std::string data = whole.substr(head);
    whole.resize(head);
    whole.replace(0, 12, "DSCOMPRESSED");
    Bytes table(high_byte_first), streams;
    const std::size_t count = (data.size() + each - 1) / each;
    table.i32(static_cast<std::int64_t>(count));
    for (std::size_t i = 0; i < data.size(); i += each) {
      const std::string part = data.substr(i, each), packed = pack(part);
      table.i32(static_cast<std::int64_t>(part.size())).i32(static_cast<std::int64_t>(packed.size()));
      streams.text(packed);
    }
    return whole + table.str() + streams.str();
  }
};

/// The header of a binary SDF.
inline Bytes sdf_header(int type, int points_x, int points_y, double scale_z = 1e-9, int compression = 0) {
  Bytes out;
  out.text("bISO-1.0").text("MAKER", 10).text("070320191200").text("070320191200").i16(points_x).i16(points_y);
  out.f64(2e-6).f64(3e-6).f64(scale_z).f64(-1).whole(static_cast<std::uint64_t>(compression), 1);
  out.whole(static_cast<std::uint64_t>(type), 1).whole(0, 1);
  return out;
}

inline std::string sdf_text(const std::string& numbers, int points_x, int points_y) {
  return "aISO-1.0\r\nManufacID = MAKER\r\nCreateDate = 070320191200\r\nModDate = 070320191200\r\nNumPoints = " +
         std::to_string(points_x) + "\r\nNumProfiles = " + std::to_string(points_y) +
         "\r\nXscale = 2e-6\r\nYscale = 3e-6\r\nZscale = 1e-9\r\nZresolution = -1\r\nCompression = 0\r\nDataType = "
         "7\r\n"
         "CheckType = 0\r\n*\r\n" +
         numbers + "\r\n*\r\n";
}

/// The main.xml of an X3P, and the archive around it.
struct X3p {
  std::string feature = "SUR";
  std::string axis_x = "<AxisType>I</AxisType><DataType>D</DataType><Increment>2e-6</Increment><Offset>1</Offset>";
  std::string axis_y = "<AxisType>I</AxisType><DataType>D</DataType><Increment>3e-6</Increment>";
  std::string axis_z = "<AxisType>A</AxisType><DataType>D</DataType>";
  std::string dimension = "<MatrixDimension><SizeX>3</SizeX><SizeY>2</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
  std::string data = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>";
  std::string before_root;
  std::string root = "p:ISO5436_2";
  std::string points;  ///< bindata/data.bin
  std::string valid;   ///< bindata/valid.bin
  std::string checksum = "right";

  std::string xml() const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>" + before_root + "<" + root +
           " xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1><Revision>ISO5436 - 2000</Revision>"
           "<FeatureType>" +
           feature + "</FeatureType><Axes><CX>" + axis_x + "</CX><CY>" + axis_y + "</CY><CZ>" + axis_z +
           "</CZ></Axes></Record1><Record2><Date>2019-03-07T12:00:00</Date><Instrument><Manufacturer>Maker"
           "</Manufacturer><Model>One</Model></Instrument></Record2><Record3>" +
           dimension + data + "</Record3></" + root + ">";
  }
};

}  // namespace ringfilm::instrument::handmade
