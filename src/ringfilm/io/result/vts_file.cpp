#include "ringfilm/io/result/vts_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <system_error>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/text/base64.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

// The values go to the file as they lie in memory.
static_assert(std::endian::native == std::endian::little, "VTK files are written with the low byte first");

/// An array as VTK reads it inline: the number of its bytes, then these, in one piece of base64.
template <class Number>
std::string inline_array(const std::vector<Number>& values) {
  const std::uint64_t n_bytes = values.size() * sizeof(Number);
  std::string bytes(sizeof n_bytes + n_bytes, '\0');
  std::memcpy(bytes.data(), &n_bytes, sizeof n_bytes);
  if (n_bytes > 0) std::memcpy(bytes.data() + sizeof n_bytes, values.data(), n_bytes);
  return base64(bytes);
}

bool is_closed(const cycle::UnrolledFields& fields) { return fields.end_gap == 0; }

/// y of the strips that are drawn [m]: of a closed ring the first is repeated at the end.
std::vector<double> drawn_strips(const cycle::UnrolledFields& fields) {
  std::vector<double> y = fields.y;
  if (is_closed(fields)) y.push_back(fields.circumference);
  return y;
}

std::vector<double> points(const cycle::UnrolledFields& fields, VtsShape shape) {
  const double radius = fields.circumference / (2 * std::numbers::pi);
  std::vector<double> points;
  for (const double y : drawn_strips(fields)) {
    const double angle = fields.gap_position + (fields.end_gap / 2 + y) / radius;
    for (const double x : fields.x) {
      if (shape == VtsShape::kPlane) {
        points.insert(points.end(), {x, y, 0.0});
      } else {
        points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), -x});
      }
    }
  }
  return points;
}

/// @param n_across values of a strip: one for each node, or one for all
std::vector<float> drawn_values(const cycle::UnrolledFields& fields, const cycle::UnrolledField& field,
                                std::size_t angle, std::size_t n_across) {
  const std::vector<float>& all = fields.*field.values;
  const std::size_t n_values = n_across * fields.y.size();
  if (all.size() != n_values * fields.crank_angle_deg.size()) {
    throw InputError(fmt::format("{} has {} values, not one for each of {} crank angles, {} strips and {} nodes",
                                 field.name, all.size(), fields.crank_angle_deg.size(), fields.y.size(), n_across),
                     "the result is damaged; run its case again");
  }
  const std::size_t repeats = fields.x.size() / n_across;
  std::vector<float> values;
  for (std::size_t k = 0; k < n_values; ++k) values.insert(values.end(), repeats, all[angle * n_values + k]);
  if (is_closed(fields)) {
    const std::vector<float> first(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(fields.x.size()));
    values.insert(values.end(), first.begin(), first.end());
  }
  return values;
}

/// A file name, whose characters the user chose, escaped for an attribute of XML.
std::string in_quotes(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe.append("&amp;");
        break;
      case '<':
        safe.append("&lt;");
        break;
      case '"':
        safe.append("&quot;");
        break;
      default:
        safe.push_back(c);
    }
  }
  return safe;
}

/// Files of an older, longer series that its list names; others of that look may be somebody's own.
std::vector<fs::path> left_of_older(const fs::path& folder, const std::string& stem, std::size_t n_files) {
  std::ifstream list(folder / fmt::format("{}.pvd", stem));
  std::vector<fs::path> left;
  const std::string before = fmt::format("file=\"{}_", in_quotes(stem)), after = ".vts\"";
  for (std::string line; std::getline(list, line);) {
    const std::size_t begin = line.find(before), end = line.find(after);
    if (begin == std::string::npos || end == std::string::npos || end < begin + before.size()) continue;
    const std::string number = line.substr(begin + before.size(), end - begin - before.size());
    constexpr std::size_t kMaxDigits = 9;
    const bool is_number =
        !number.empty() && number.size() <= kMaxDigits && number.find_first_not_of("0123456789") == std::string::npos;
    if (is_number && std::stoul(number) >= n_files) left.push_back(folder / fmt::format("{}_{}.vts", stem, number));
  }
  return left;
}

/// All files are full and on the disk before the first takes its name.
std::string write_series(const fs::path& folder, const std::string& stem, const cycle::UnrolledFields& fields,
                         VtsShape shape) {
  std::vector<std::string> names;
  std::vector<std::unique_ptr<AsideFile>> files;
  const auto write = [&](const std::string& name, const std::string& text) {
    const std::string path = (folder / name).string();
    if (fs::is_directory(path)) fail_to_write(path, EISDIR);
    files.push_back(std::make_unique<AsideFile>(path));
    files.back()->fill(text);
  };
  for (std::size_t k = 0; k < fields.crank_angle_deg.size(); ++k) {
    names.push_back(fmt::format("{}_{:04}.vts", stem, k));
    write(names.back(), vts_text(fields, k, shape));
  }
  const std::string collection = fmt::format("{}.pvd", stem);
  write(collection, pvd_text(names, fields.crank_angle_deg));
  const std::vector<fs::path> left = left_of_older(folder, stem, names.size());
  for (const auto& file : files) file->put_in_place();
  std::error_code error;
  for (const fs::path& file : left) fs::remove(file, error);
  return (folder / collection).string();
}

}  // namespace

std::string vts_text(const cycle::UnrolledFields& fields, std::size_t angle, VtsShape shape) {
  const std::string extent =
      fmt::format("0 {} 0 {} 0 0", fields.x.size() - 1, fields.y.size() - (is_closed(fields) ? 0 : 1));
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"StructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<StructuredGrid WholeExtent=\"{0}\">\n"
      "<FieldData>\n"
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{1}</DataArray>\n"
      "</FieldData>\n"
      "<Piece Extent=\"{0}\">\n"
      "<PointData Scalars=\"film_pressure\">\n",
      extent, fields.crank_angle_deg[angle]);
  const auto append = [&](const cycle::UnrolledField& field, std::size_t n_across) {
    text += fmt::format("<DataArray type=\"Float32\" Name=\"{}\" format=\"binary\">{}</DataArray>\n", field.name,
                        inline_array(drawn_values(fields, field, angle, n_across)));
  };
  for (const cycle::UnrolledField& field : cycle::unrolled_fields()) append(field, fields.x.size());
  // A ring that bends has the bore and the places where the ring leaves it. Each strip has one value, which all its
  // nodes repeat.
  if (!fields.strip_bore_deviation.empty()) {
    for (const cycle::UnrolledField& field : cycle::strip_fields()) append(field, 1);
  }
  text += fmt::format(
      "</PointData>\n"
      "<Points>\n"
      "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"binary\">{}</DataArray>\n"
      "</Points>\n"
      "</Piece>\n"
      "</StructuredGrid>\n"
      "</VTKFile>\n",
      inline_array(points(fields, shape)));
  return text;
}

std::string pvd_text(const std::vector<std::string>& names, const std::vector<double>& crank_angle_deg) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (std::size_t k = 0; k < names.size(); ++k) {
    text += fmt::format("<DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", crank_angle_deg[k],
                        in_quotes(names[k]));
  }
  return text + "</Collection>\n</VTKFile>\n";
}

void check_can_write_series(const std::string& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) {
    if (::access(folder.c_str(), W_OK | X_OK) == 0) return;
    throw InputError(fmt::format("{}: the folder is not writable: {}", folder, std::strerror(errno)),
                     "name a folder in which you may write");
  }
  if (fs::exists(folder, error)) {
    throw InputError(fmt::format("{}: this is not a folder", folder), "name a folder; it is made if it does not exist");
  }
  // What is true of a file that is to be made in the folder above is true of a folder.
  const fs::path path(folder);
  check_can_write((path.has_filename() ? path : path.parent_path()).string(), Sink::kFile);
}

std::string write_vts_series(const std::string& folder, const std::string& stem, const cycle::UnrolledFields& fields,
                             VtsShape shape) {
  if (fields.empty() || fields.film_pressure.empty()) {
    throw InputError("there are no fields over crank angle and around the ring to write as VTS",
                     "run the case with film.dimension = \"unrolled\", output.reduction = \"none\" and crank angles in "
                     "output.fields");
  }
  check_can_write_series(folder);
  std::error_code error;
  const bool is_made = fs::create_directory(folder, error);
  if (error) fail_to_write(folder, error.value());
  try {
    return write_series(folder, stem, fields, shape);
  } catch (...) {
    if (is_made) fs::remove(folder, error);  // nothing is in it
    throw;
  }
}

}  // namespace ringfilm::io
