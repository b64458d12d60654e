#include "commands/command_face.hpp"

#include <filesystem>

#include "output_names.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/face_measurement.hpp"
#include "ringfilm/io/case/contact_fragment.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

/// The file of the points beside the fragment. Throws InputError where it cannot be written there.
std::string points_path(const FaceCommand& command) {
  if (!command.outputs.fragment) {
    throw InputError("--as points writes a file of points beside the fragment, but there is no fragment",
                     "for example --fragment face.toml: the points are then written to face.csv");
  }
  const fs::path fragment = *command.outputs.fragment;
  if (fs::exists(fragment) && !fs::is_regular_file(fragment)) {
    throw InputError("--as points: " + fragment.string() + " is not a file, nothing can lie next to it",
                     "name a file, for example --fragment face.toml");
  }
  const std::string points = fs::path(fragment).replace_extension(".csv").string();
  io::check_can_write(points, io::Sink::kFile);
  const auto refuse = [&](const std::string& what, const std::string& path) {
    if (is_same_file(points, path)) {
      throw InputError("--as points would write " + points + ", which is " + what, "give the fragment another name");
    }
  };
  refuse("the trace", command.trace);
  refuse("the fragment itself", *command.outputs.fragment);
  if (command.outputs.netcdf) refuse("the file of --output", *command.outputs.netcdf);
  if (command.outputs.page) refuse("the file of --html", *command.outputs.page);
  return points;
}

}  // namespace

void face(const FaceCommand& command) {
  const auto claimed = claimed_outputs(command.outputs, {command.trace});
  std::optional<std::string> points, points_name;
  if (command.as == FaceAs::kPoints) {
    points = points_path(command);
    points_name = fs::path(*points).filename().string();
  }
  const auto claimed_points = claims({points});
  const io::Units units;
  const instrument::TraceFile file = instrument::read_trace_file(command.trace, command.reading, units);
  const surface::FaceFit fit = surface::fit_face(file.trace, command.rule);
  const io::Measurement measurement = instrument::face_measurement(file, command.rule, fit, points_name);
  if (points) io::write_atomically(*points, io::face_points_csv(fit));  // before the fragment that names it
  deliver(measurement, command.outputs, numbers_of(measurement));
}

}  // namespace ringfilm::app
