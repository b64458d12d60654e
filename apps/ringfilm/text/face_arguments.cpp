#include <CLI/CLI.hpp>
#include <cmath>

#include "commands/command_face.hpp"
#include "option_values.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

using surface::FaceDirection;
using surface::FaceLevelling;
using surface::FaceZero;
using surface::HeightSense;

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

struct FaceArguments {
  FaceCommand command;
  std::optional<std::string> heights, width, start, levelling, tilt, running_surface_height, pore_depth, spline_cutoff;
  std::string direction = "as-measured", zero = "lowest-point", degree = "6", as = "polynomial";
  OutputArguments outputs;

  void add_to(CLI::App& app) {
    const auto add = [&app](const char* name, auto& to, const char* help, const char* type) {
      return app.add_option(name, to, help)->type_name(type);
    };
    add("TRACE", command.trace, "the trace over the face: text, X3P, SDF, SUR; others through gwyddion", "")
        ->required();
    add("--heights", heights, "what the heights of the trace are: material (away from the ring) or gap", "WORD");
    add("--width", width, "width of the face", "LENGTH");
    add("--start", start, "where in the trace the face begins; without it: where its mean gap is least", "LENGTH");
    add("--direction", direction, "as-measured, or turned: x = 0 is the end of the trace", "WORD")
        ->capture_default_str();
    add("--levelling", levelling,
        "running-surface: the running surface is made level (default); none: tilt stays as measured", "WORD");
    add("--tilt", tilt, "a tilt to remove instead, by which the profile rises along the trace", "\"2 mrad\"");
    add("--running-surface-height", running_surface_height,
        "the running surface is where the gap is at most this above its least (default 1 um)", "LENGTH");
    add("--zero", zero, "of the gap: lowest-point or as-measured", "WORD")->capture_default_str();
    add("--pore-depth", pore_depth, "points deeper than this below the spline are pores and omitted", "LENGTH");
    add("--spline-cutoff", spline_cutoff,
        "stiffness of the spline: the wave of which half passes (default a tenth of the width)", "LENGTH");
    add("--degree", degree, "of the polynomial, 1 to 12", "N")->capture_default_str();
    add("--as", as, "what the fragment gives to the case: polynomial, or points of the spline", "WORD")
        ->capture_default_str();
    add("--channel", command.reading.channel, "which channel of the file: its number from 1, or its name", "N");
    add("--unit", command.reading.height_unit, "unit of the heights, where the file does not state it", "UNIT");
    add("--lateral-unit", command.reading.lateral_unit, "unit of x, where the file does not state it", "UNIT");
    add("--step-x", command.reading.step_x, "distance of points, where the file does not state it", "LENGTH");
    outputs.add_to(app, true);
    app.footer(kFaceFooter);
  }

  FaceCommand read() const {
    FaceCommand of = command;
    const io::Units units;
    OptionValues values(units);
    if (heights) {
      of.rule.sense = values.chosen<HeightSense>("--heights", *heights,
                                                 {{"material", HeightSense::kMaterial}, {"gap", HeightSense::kGap}});
    } else {
      values.refuse("--heights is missing: a trace does not state which way its heights count",
                    "--heights material for a stylus (away from the ring), --heights gap for the gap to a liner");
    }
    if (width) {
      of.rule.width_m = values.length("--width", *width, "1.2 mm");
    } else {
      values.refuse("--width is missing: a trace does not state how wide the face is",
                    "for example --width \"1.2 mm\"");
    }
    if (start) of.rule.start_m = values.quantity("--start", *start, "m", "0.35 mm");
    of.rule.direction = values.chosen<FaceDirection>(
        "--direction", direction, {{"as-measured", FaceDirection::kAsMeasured}, {"turned", FaceDirection::kTurned}});
    read_levelling(of.rule, values);
    if (running_surface_height)
      of.rule.running_surface_height_m = values.length("--running-surface-height", *running_surface_height, "1 um");
    of.rule.zero = values.chosen<FaceZero>(
        "--zero", zero, {{"lowest-point", FaceZero::kLowestPoint}, {"as-measured", FaceZero::kAsMeasured}});
    if (pore_depth) of.rule.pore_depth_m = values.length("--pore-depth", *pore_depth, "1 um");
    if (spline_cutoff) of.rule.spline_cutoff_m = values.length("--spline-cutoff", *spline_cutoff, "100 um");
    const double whole = values.number("--degree", degree, 1, 12, "6");
    if (whole != std::floor(whole)) values.refuse("--degree " + degree + " is not a whole number", "for example 6");
    of.rule.degree = static_cast<int>(whole);
    of.as = values.chosen<FaceAs>("--as", as, {{"polynomial", FaceAs::kPolynomial}, {"points", FaceAs::kPoints}});
    values.check();
    of.outputs = outputs.selected();
    return of;
  }

 private:
  void read_levelling(surface::FaceRule& rule, OptionValues& values) const {
    if (levelling) {
      rule.levelling = values.chosen<FaceLevelling>(
          "--levelling", *levelling,
          {{"running-surface", FaceLevelling::kRunningSurface}, {"none", FaceLevelling::kNone}});
    }
    if (!tilt) return;
    if (levelling) {
      values.refuse("--tilt and --levelling are two rules for one tilt", "give one of them");
    }
    rule.levelling = FaceLevelling::kStated;
    rule.tilt = values.quantity("--tilt", *tilt, "rad", "2 mrad");
  }
};

}  // namespace

void add_face_command(CLI::App& program, Actions& actions) {
  CLI::App* command = program.add_subcommand("face", "Fit a measured ring face: polynomial and spline for a case");
  const auto arguments = std::make_shared<FaceArguments>();
  arguments->add_to(*command);
  actions.emplace_back(command, [arguments] { face(arguments->read()); });
}

}  // namespace ringfilm::app
