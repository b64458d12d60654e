#include "commands/command_face.hpp"

#include <filesystem>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/face_measurement.hpp"
#include "ringfilm/io/case/contact_fragment.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/text/units.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

/// The file of the points beside the fragment. Throws InputError where there can be none.
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

constexpr const char* kFaceFooter = R"(Examples:
  ringfilm face trace.csv --heights material --width "1.2 mm"
  ringfilm face cases/measured/face_new.csv --heights material --width "1.2 mm" --start "0.1 mm" --tilt "2 mrad"
  ringfilm face trace.csv --heights material --width "1.2 mm" --fragment face.toml --html face.html
  ringfilm face trace.x3p --heights material --width "1.2 mm" --start "0.35 mm" --direction turned
  ringfilm face sprayed.csv --heights material --width "1.2 mm" --pore-depth "1 um" --as points --fragment face.toml

A trace as text has the columns x and z with their units: x [mm],z [um]. A stylus counts heights away from the ring:
--heights material. What a case calls the gap to a straight liner is --heights gap. Neither is guessed.
A round running surface is as round when it is tilted: state the --tilt of the holder, or take --levelling none.
The case reads the fragment with include = ["face.toml"]; with --as points the points are next to it in face.csv.
)";

void declare_face(CommandOptions& add, FaceCommand& command) {
  using surface::FaceDirection, surface::FaceLevelling, surface::FaceZero, surface::HeightSense;
  surface::FaceRule& rule = command.rule;
  add.text("TRACE", command.trace, "", "the trace over the face: text, X3P, SDF, SUR; others through gwyddion")
      ->required();
  const CLI::Option* heights =
      add.choice("--heights", rule.sense, {{"material", HeightSense::kMaterial}, {"gap", HeightSense::kGap}},
                 "what the heights of the trace are: material (away from the ring) or gap");
  const CLI::Option* width = add.length("--width", rule.width_m, "1.2 mm", "width of the face");
  add.quantity("--start", rule.start_m, "m", "0.35 mm", "LENGTH",
               "where in the trace the face begins; without it: where its mean gap is least");
  add.choice("--direction", rule.direction,
             {{"as-measured", FaceDirection::kAsMeasured}, {"turned", FaceDirection::kTurned}},
             "as-measured, or turned: x = 0 is the end of the trace")
      ->capture_default_str();
  const CLI::Option* levelling =
      add.choice("--levelling", rule.levelling,
                 {{"running-surface", FaceLevelling::kRunningSurface}, {"none", FaceLevelling::kNone}},
                 "running-surface: the running surface is made level (default); none: tilt stays as measured");
  const CLI::Option* tilt = add.quantity("--tilt", rule.tilt, "rad", "2 mrad", "\"2 mrad\"",
                                         "a tilt to remove instead, by which the profile rises along the trace");
  add.length("--running-surface-height", rule.running_surface_height_m, "1 um",
             "the running surface is where the gap is at most this above its least (default 1 um)");
  add.choice("--zero", rule.zero, {{"lowest-point", FaceZero::kMinPoint}, {"as-measured", FaceZero::kAsMeasured}},
             "of the gap: lowest-point or as-measured")
      ->capture_default_str();
  add.length("--pore-depth", rule.pore_depth_m, "1 um",
             "points deeper than this below the spline are pores and omitted");
  add.length("--spline-cutoff", rule.spline_cutoff_m, "100 um",
             "stiffness of the spline: the wave of which half passes (default a tenth of the width)");
  add.number("--degree", rule.degree, 1, 12, "6", "N", "of the polynomial, 1 to 12")->capture_default_str();
  add.choice("--as", command.as, {{"polynomial", FaceAs::kPolynomial}, {"points", FaceAs::kPoints}},
             "what the fragment gives to the case: polynomial, or points of the spline")
      ->capture_default_str();
  add_channel_and_unit(add, command.reading);
  add.text("--lateral-unit", command.reading.lateral_unit, "UNIT", "unit of x, where the file does not state it");
  add.text("--step-x", command.reading.step_x, "LENGTH", "distance of points, where the file does not state it");
  add_outputs(add, command.outputs, true);

  add.require(heights, "--heights is missing: a trace does not state which way its heights count",
              "--heights material for a stylus (away from the ring), --heights gap for the gap to a liner");
  add.require(width, "--width is missing: a trace does not state how wide the face is",
              "for example --width \"1.2 mm\"");
  add.rule([=, &rule](Faults& faults) {
    if (!is_stated(tilt)) return;
    if (is_stated(levelling)) faults.refuse("--tilt and --levelling are two rules for one tilt", "give one of them");
    rule.levelling = FaceLevelling::kStated;
  });
}

}  // namespace

void face(const FaceCommand& command) {
  std::optional<std::string> points, points_name;
  if (command.as == FaceAs::kPoints) {
    points = points_path(command);
    points_name = fs::path(*points).filename().string();
  }
  const auto claimed = claimed_outputs(command.outputs, {command.trace}, {{"--as points", points, OutputKind::kCsv}});
  const io::Units units;
  const instrument::TraceFile file = instrument::read_trace_file(command.trace, command.reading, units);
  const surface::FaceFit fit = surface::fit_face(file.trace, command.rule);
  const io::Measurement measurement = instrument::face_measurement(file, command.rule, fit, points_name);
  if (points) io::write_atomically(*points, io::face_points_csv(fit));  // before the fragment that names it
  deliver(measurement, command.outputs);
}

void add_face_command(Program& program) {
  program.add("face", "Fit a measured ring face: polynomial and spline for a case", kFaceFooter, declare_face, face);
}

}  // namespace ringfilm::app
