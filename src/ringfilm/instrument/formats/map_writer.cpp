#include "ringfilm/instrument/formats/map_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/digital_surf_file.hpp"
#include "ringfilm/instrument/formats/simple_field_file.hpp"
#include "ringfilm/instrument/formats/x3p_writer.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kMinStep_m = 1e-12;

/// A text that stays on its line.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7f'; }, ' ');
  return text;
}

std::string matrix_bytes(const surface::HeightMap& map, const std::string& title, const std::string& maker) {
  const double step_y_m = map.is_profile() ? map.step_x_m : map.step_y_m;
  std::string text = fmt::format("# {}\n# {}\n# Width: {} m\n# Height: {} m\n# Value units: m\n", title, maker,
                                 io::exact_text(map.step_x_m * static_cast<double>(map.points_x)),
                                 io::exact_text(step_y_m * static_cast<double>(map.points_y)));
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const std::size_t point = map.index(i, j);
      if (i > 0) text += ",";
      text += map.measured(point) ? io::exact_text(map.height_m[point]) : "nan";
    }
    text += "\n";
  }
  return text;
}

}  // namespace

MapFormat map_format_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  const std::string ending = dot == std::string::npos ? "" : path.substr(dot);
  if (ending == ".x3p") return MapFormat::kX3p;
  if (ending == ".sur") return MapFormat::kDigitalSurf;
  if (ending == ".gsf") return MapFormat::kSimpleField;
  if (ending == ".csv") return MapFormat::kMatrix;
  throw InputError(path + ": the ending of the name is not that of a supported format",
                   "end it in .x3p, .sur, .gsf or .csv");
}

std::string map_bytes(const surface::HeightMap& map, MapFormat format, const std::string& title,
                      const std::string& maker) {
  check_map(map);
  const std::string name = one_line(title), by = one_line(maker);
  switch (format) {
    case MapFormat::kX3p: {
      X3pOrigin origin;
      origin.manufacturer = name;
      origin.model = by;
      return x3p_bytes(map, X3pHeights::kDouble, origin);
    }
    case MapFormat::kDigitalSurf:
      return digital_surf_bytes(map, kMinStep_m, name, by);
    case MapFormat::kSimpleField:
      return simple_field_bytes(map, name + ", " + by);
    case MapFormat::kMatrix:
      return matrix_bytes(map, name, by);
  }
  throw std::logic_error("a format without a writer");
}

}  // namespace ringfilm::instrument
