#include "commands/command_surface.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

#include "output_names.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/contact_measurement.hpp"
#include "ringfilm/io/case/contact_fragment.hpp"
#include "ringfilm/io/measurement/contact_law_file.hpp"
#include "ringfilm/io/measurement/measurement_netcdf.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::app {
namespace {

/// x, y, z in metres, row after row, z empty where a point is missing.
void write_heights(const std::string& path, const surface::HeightMap& map) {
  io::AsideFile aside(path);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(aside.path().c_str(), "wb"), std::fclose);
  if (!file) io::fail_to_write(path, errno);
  const auto put = [&](const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) io::fail_to_write(path, errno);
  };
  put("x [m],y [m],z [m]\n");
  std::vector<std::string> x;
  for (std::size_t i = 0; i < map.points_x; ++i) x.push_back(io::exact_text(static_cast<double>(i) * map.step_x_m));
  for (std::size_t j = 0; j < map.points_y; ++j) {
    const std::string y = io::exact_text(static_cast<double>(j) * map.step_y_m);
    std::string lines;
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const std::size_t point = map.index(i, j);
      lines +=
          x[i] + "," + y + "," + (map.measured(point) ? io::exact_text(map.height_m[point]) : std::string()) + "\n";
    }
    put(lines);
  }
  if (std::fflush(file.get()) != 0) io::fail_to_write(path, errno);
  aside.put_in_place();
}

/// What the file holds, before anything is removed.
io::NamedNumbers numbers_as_read(const surface::HeightMap& map) {
  double lowest = INFINITY, highest = -INFINITY;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) continue;
    lowest = std::min(lowest, map.height_m[i]);
    highest = std::max(highest, map.height_m[i]);
  }
  const auto length = [](std::size_t points, double step) { return static_cast<double>(points) * step; };
  return {{"points_x", static_cast<double>(map.points_x)},
          {"points_y", static_cast<double>(map.points_y)},
          {"step_x", map.step_x_m},
          {"step_y", map.is_profile() ? 0.0 : map.step_y_m},
          {"width", length(map.points_x, map.step_x_m)},
          {"height", map.is_profile() ? 0.0 : length(map.points_y, map.step_y_m)},
          {"missing", static_cast<double>(map.points() - measured_points(map))},
          {"min", lowest},
          {"max", highest}};
}

std::optional<instrument::SurfaceFile> read_flat(const SurfaceCommand& command, const io::Units& units) {
  if (!command.noise) return std::nullopt;
  return instrument::read_surface_file(*command.noise, command.reading, units);
}

/// Throws InputError where the law would replace a file that is read, or another output.
void check_law_output(const SurfaceCommand& command, std::vector<std::string> inputs) {
  const std::string& path = command.law->path;
  for (const auto& other : {command.outputs.netcdf, command.outputs.page, command.outputs.fragment}) {
    if (other) inputs.push_back(*other);
  }
  for (const std::string& input : inputs) {
    if (is_same_file(input, path))
      throw InputError("--law " + path + " names another file of this command", "name another file");
  }
  io::check_can_write(path, io::Sink::kFile);
  check_suffix("--law", path, OutputKind::kNetcdf);
}

/// Writes the contact law of two maps. @returns the fragment that names it
std::string write_law(const instrument::SurfaceFile& ring, const instrument::SurfaceFile& liner,
                      const SurfaceCommand& command) {
  instrument::ContactAnalysis analysis;
  analysis.preparation = command.analysis.preparation;
  if (analysis.preparation.form.kind == surface::FormKind::none) analysis.preparation.form = {surface::FormKind::tilt};
  analysis.material = {command.law->E_prime / 2, command.analysis.hardness};
  analysis.shifts = command.law->shifts;
  analysis.regions_across = std::max<std::size_t>(command.analysis.regions.across, 1);
  analysis.regions_down = std::max<std::size_t>(command.analysis.regions.down, 1);
  analysis.has_flow = true;
  const io::Measurement law = contact_measurement(ring, &liner, analysis);
  io::check_contact_law(law);
  io::write_measurement(command.law->path, law, io::this_program());
  namespace fs = std::filesystem;
  const fs::path folder = command.outputs.fragment ? fs::absolute(*command.outputs.fragment).parent_path() : fs::path();
  std::vector<std::string> heading = {law.title};
  for (const std::string& note : law.notes) heading.push_back("note: " + note);
  const std::string name =
      folder.empty() ? command.law->path : fs::proximate(fs::absolute(command.law->path), folder).string();
  return io::contact_law_fragment(name, heading);
}

}  // namespace

void surface(const std::vector<std::string>& paths, const std::optional<std::string>& heights,
             const SurfaceCommand& command) {
  std::vector<std::string> inputs = paths;
  if (heights && paths.size() > 1) {
    throw InputError("--heights writes the heights of one file, and there are " + std::to_string(paths.size()),
                     "name one file");
  }
  if (command.noise) inputs.push_back(*command.noise);
  MeasurementOutputs outputs = command.outputs;
  outputs.heights = heights;
  const auto claimed = claimed_outputs(outputs, inputs);
  const io::Units units;
  const auto flat = read_flat(command, units);
  if (paths.size() > 1) {
    std::vector<instrument::SurfaceFile> files;
    for (const std::string& path : paths) files.push_back(instrument::read_surface_file(path, command.reading, units));
    const io::Measurement all = surfaces_measurement(files, command.analysis, flat ? &*flat : nullptr);
    return deliver(all, outputs, numbers_of(all));
  }
  const instrument::SurfaceFile file = instrument::read_surface_file(paths.front(), command.reading, units);
  const io::Measurement measurement = surface_measurement(file, command.analysis, flat ? &*flat : nullptr);
  if (heights) write_heights(*heights, file.map);
  io::NamedNumbers numbers = numbers_as_read(file.map), measured = numbers_of(measurement);
  numbers.insert(numbers.end(), measured.begin(), measured.end());
  deliver(measurement, outputs, numbers);
}

void pair(const std::vector<std::string>& ring, const std::vector<std::string>& liner, const SurfaceCommand& command) {
  std::vector<std::string> inputs = ring;
  inputs.insert(inputs.end(), liner.begin(), liner.end());
  if (command.noise) inputs.push_back(*command.noise);
  const auto claimed = claimed_outputs(command.outputs, inputs);
  const io::Units units;
  const auto read = [&](const std::vector<std::string>& paths) {
    std::vector<instrument::SurfaceFile> files;
    for (const std::string& path : paths) files.push_back(instrument::read_surface_file(path, command.reading, units));
    return files;
  };
  if (command.law) {
    if (ring.size() > 1 || liner.size() > 1) {
      throw InputError("--law presses one map of each side against the other", "name one --ring and one --liner");
    }
    check_law_output(command, inputs);
  }
  const auto claimed_law = claims({command.law ? std::optional(command.law->path) : std::nullopt});
  const auto flat = read_flat(command, units);
  const std::vector<instrument::SurfaceFile> rings = read(ring), liners = read(liner);
  io::Measurement measurement = pair_measurement(rings, liners, command.analysis, flat ? &*flat : nullptr);
  if (command.law) measurement.fragment = write_law(rings.front(), liners.front(), command);
  deliver(measurement, command.outputs, numbers_of(measurement));
  if (command.law && command.outputs.summary == SummaryForm::kTable) std::cout << "wrote " << command.law->path << "\n";
}

}  // namespace ringfilm::app
