#include "ringfilm/instrument/formats/x3p_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/binary_writer.hpp"
#include "ringfilm/instrument/formats/zip_archive.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::instrument {
namespace {

std::string md5(const std::string& bytes) {
  io::RunningDigest digest(io::RunningDigest::Kind::kMd5);
  digest.add(bytes);
  return digest.digits();
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else {
      result += c;
    }
  }
  return result;
}

struct Scaling {
  double increment = 1;
  double offset = 0;
};

/// 16 bit hold the whole range and leave the lowest number unused.
Scaling scaling_for_int16(const surface::HeightMap& map) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) continue;
    lowest = std::min(lowest, map.height_m[i]);
    highest = std::max(highest, map.height_m[i]);
  }
  if (!(lowest <= highest)) throw InputError("the map has no measured point", "write a map that has one");
  if (lowest == highest) return {1e-12, lowest};
  return {(highest - lowest) / 65000, 0.5 * (lowest + highest)};
}

std::string axis_xml(const char* name, double increment) {
  return fmt::format(
      "      <{0}>\n        <AxisType>I</AxisType>\n        <DataType>D</DataType>\n"
      "        <Increment>{1}</Increment>\n        <Offset>0</Offset>\n      </{0}>\n",
      name, io::exact_text(increment));
}

std::string main_xml(const surface::HeightMap& map, X3pHeights heights, const Scaling& scaling, const X3pOrigin& origin,
                     const std::string& points_md5, const std::string& valid_md5) {
  const bool whole = heights == X3pHeights::kInt16;
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n  <Record1>\n"
      "    <Revision>ISO5436 - 2000</Revision>\n";
  xml += fmt::format("    <FeatureType>{}</FeatureType>\n    <Axes>\n", map.is_profile() ? "PRF" : "SUR");
  xml += axis_xml("CX", map.step_x_m) + axis_xml("CY", map.is_profile() ? map.step_x_m : map.step_y_m);
  xml +=
      fmt::format("      <CZ>\n        <AxisType>A</AxisType>\n        <DataType>{}</DataType>\n", whole ? "I" : "D");
  xml += fmt::format("        <Increment>{}</Increment>\n        <Offset>{}</Offset>\n",
                     io::exact_text(scaling.increment), io::exact_text(scaling.offset));
  xml += "      </CZ>\n    </Axes>\n  </Record1>\n  <Record2>\n";
  xml += fmt::format(
      "    <Date>{0}</Date>\n    <Instrument>\n      <Manufacturer>{1}</Manufacturer>\n      <Model>{2}</Model>\n"
      "      <Serial>not available</Serial>\n      <Version>1</Version>\n    </Instrument>\n"
      "    <CalibrationDate>{0}</CalibrationDate>\n    <ProbingSystem>\n      <Type>Software</Type>\n"
      "      <Identification>not available</Identification>\n    </ProbingSystem>\n    <Comment>{3}</Comment>\n",
      escaped(origin.date), escaped(origin.manufacturer), escaped(origin.model), escaped(origin.comment));
  xml += fmt::format(
      "  </Record2>\n  <Record3>\n    <MatrixDimension>\n      <SizeX>{}</SizeX>\n      <SizeY>{}</SizeY>\n"
      "      <SizeZ>1</SizeZ>\n    </MatrixDimension>\n    <DataLink>\n"
      "      <PointDataLink>bindata/data.bin</PointDataLink>\n"
      "      <MD5ChecksumPointData>{}</MD5ChecksumPointData>\n",
      map.points_x, map.points_y, points_md5);
  if (!valid_md5.empty()) {
    xml += fmt::format(
        "      <ValidPointsLink>bindata/valid.bin</ValidPointsLink>\n"
        "      <MD5ChecksumValidPoints>{}</MD5ChecksumValidPoints>\n",
        valid_md5);
  }
  return xml +
         "    </DataLink>\n  </Record3>\n  <Record4>\n    <ChecksumFile>md5checksum.hex</ChecksumFile>\n  </Record4>\n"
         "</p:ISO5436_2>\n";
}

}  // namespace

std::string x3p_bytes(const surface::HeightMap& map, X3pHeights heights, const X3pOrigin& origin) {
  const bool whole = heights == X3pHeights::kInt16;
  const Scaling scaling = whole ? scaling_for_int16(map) : Scaling{};
  BinaryWriter points(0);
  std::string valid;
  for (std::size_t i = 0; i < map.points(); ++i) {
    const bool measured = map.measured(i);
    if (!whole) {
      points.append(measured ? map.height_m[i] : std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const double steps = measured ? std::round((map.height_m[i] - scaling.offset) / scaling.increment) : 0.0;
    points.append(static_cast<std::int16_t>(steps));
    if (map.missing.empty()) continue;
    if (i % 8 == 0) valid += '\0';
    if (measured) valid.back() = static_cast<char>(static_cast<unsigned char>(valid.back()) | 1u << i % 8);
  }
  const std::string point_bytes = points.take();
  const std::string xml = main_xml(map, heights, scaling, origin, md5(point_bytes), valid.empty() ? "" : md5(valid));
  std::vector<std::pair<std::string, std::string>> entries = {
      {"main.xml", xml}, {"bindata/data.bin", point_bytes}, {"md5checksum.hex", md5(xml) + " *main.xml\n"}};
  if (!valid.empty()) entries.push_back({"bindata/valid.bin", valid});
  return zip_bytes(entries);
}

}  // namespace ringfilm::instrument
