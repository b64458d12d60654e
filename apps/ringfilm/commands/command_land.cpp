#include <algorithm>
#include <optional>

#include "commands/commands.hpp"
#include "measurement_outputs.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/land_measurement.hpp"
#include "ringfilm/io/measurement/land_law_file.hpp"
#include "ringfilm/io/text/units.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

/// What `land` was asked for.
struct LandCommand {
  std::vector<std::string> surfaces;  ///< files: liner, and land
  instrument::SurfaceOptions reading;
  instrument::LandAnalysis analysis;
  MeasurementOutputs outputs;
};

/// Computes the film of a land on a liner, and writes what was asked for.
void land(const LandCommand& command) {
  const auto claimed = claimed_outputs(command.outputs, command.surfaces);
  const io::Units units;
  const auto liner = instrument::read_surface_file(command.surfaces.front(), command.reading, units);
  std::optional<instrument::SurfaceFile> own;
  if (command.surfaces.size() > 1) own = read_surface_file(command.surfaces.back(), command.reading, units);
  const io::Measurement measurement = land_measurement(liner, own ? &*own : nullptr, command.analysis);
  if (command.outputs.netcdf) io::check_land_law(measurement);  // a file is for a case to read
  deliver(measurement, command.outputs, {{}, lists_of(measurement, io::kLandLawTable), {}});
}

constexpr const char* kLandFooter = R"(Examples:
  ringfilm land --surface liner.x3p --width "0.15 mm" --speed "8 m/s" --viscosity "6 mPa s" \
      --separations "1 um, 1.4 um, 2 um, 3 um" -o land.nc
  ringfilm land --surface liner.x3p --surface rail.x3p --width "0.2 mm" --speed "5 m/s" --viscosity "8 mPa s" \
      --separations "1.5 um, 2 um, 3 um" --patches 8 --json

The separation is the distance of the mean planes of the levelled maps; the motion is along their rows. A case takes
the file with film.land_lift = "table" and film.land_law = "land.nc". Pressures are absolute.
)";

void read_land_separations(CommandOptions& add, const std::string& list, std::vector<double>& separations_m) {
  for (const std::string& word : comma_separated(list)) {
    add.collect([&] {
      const double one = add.length_of("--separations", word, "1 um, 1.4 um, 2 um");
      if (!(one > 0))
        throw InputError("--separations " + word + " is not above 0", "for example \"1 um, 1.4 um, 2 um\"");
      if (std::find(separations_m.begin(), separations_m.end(), one) != separations_m.end()) {
        throw InputError("--separations has " + word + " twice", "state each separation once");
      }
      separations_m.push_back(one);
    });
  }
}

void declare_land(CommandOptions& add, LandCommand& command) {
  using surface::FormKind, surface::MapEdges;
  instrument::LandAnalysis& analysis = command.analysis;
  const CLI::Option* surfaces =
      add.text("--surface", command.surfaces, "FILE", "map of the liner, then that of the land; one: a smooth land");
  const CLI::Option* width = add.length("--width", analysis.width, "0.15 mm", "of the land along the motion");
  const CLI::Option* speed =
      add.quantity("--speed", analysis.speed, "m s-1", "8 m/s", "\"8 m/s\"", "sliding speed, above 0");
  const CLI::Option* viscosity = add.quantity("--viscosity", analysis.viscosity, "Pa s", "6 mPa s", "\"6 mPa s\"",
                                              "viscosity of the oil, above 0");
  const CLI::Option* separations = add.read(
      "--separations", "\"LENGTH, ...\"", "distances of the mean planes, separated by commas",
      [&add, &analysis](const std::string& list) { read_land_separations(add, list, analysis.separations_m); });
  add.pressure("--ambient-pressure", analysis.ambient_pressure, "1 bar",
               "absolute, at both edges of the land (default 1 atm)");
  add.pressure("--cavitation-pressure", analysis.cavitation_pressure, "0.5 bar",
               "absolute, of cavities (default 0, assumed)");
  const CLI::Option* periodic = add.flag("--periodic", analysis.edges, MapEdges::periodic,
                                         "the maps repeat; only their mean is removed unless --form states more");
  const CLI::Option* mirrored =
      add.flag("--mirrored", analysis.edges, MapEdges::mirrored, "patches continue by their mirror images (default)");
  add.count("--patches", analysis.patches, 1000, "a count", "for example --patches 8",
            "patches of the map over which the lift is the mean, at most (default 4)");
  const CLI::Option* form = add_map_options(add, command.reading, analysis.preparation, "tilt; with --periodic mean");
  add_outputs(add, command.outputs, false);

  add.rule([=, &command, &analysis](Faults& faults) {
    if (!is_stated(surfaces)) faults.refuse("there is nothing to compute", "name the map of a liner with --surface");
    if (command.surfaces.size() > 2) {
      faults.refuse("--surface is given more than twice", "name the liner's map, then that of the land");
    }
    if (is_stated(periodic) && is_stated(mirrored)) {
      faults.refuse("--periodic and --mirrored contradict each other", "state one of them");
    }
    if (!is_stated(form)) {
      analysis.preparation.form = {analysis.edges == MapEdges::periodic ? FormKind::mean : FormKind::tilt};
    }
    if (!is_stated(separations)) {
      faults.refuse("--separations is missing", "for example --separations \"1 um, 1.4 um, 2 um\"");
    }
    if (!is_stated(width) || !(analysis.width > 0)) {
      faults.refuse("--width is missing or not above 0", "for example --width \"0.15 mm\"");
    }
    if (!is_stated(speed) || !(analysis.speed > 0)) {
      faults.refuse("--speed is missing or not above 0", "for example --speed \"8 m/s\"");
    }
    if (!is_stated(viscosity) || !(analysis.viscosity > 0)) {
      faults.refuse("--viscosity is missing or not above 0", "for example --viscosity \"6 mPa s\"");
    }
    if (!(analysis.cavitation_pressure >= 0) || analysis.cavitation_pressure > analysis.ambient_pressure) {
      faults.refuse("--cavitation-pressure is below 0 or above --ambient-pressure",
                    "omit it for cavities of vapour, or state at most the pressure of the edges");
    }
  });
}

}  // namespace

void add_land_command(Program& program) {
  program.add("land", "Lift, friction and flow of a flat land on a rough liner against the separation", kLandFooter,
              declare_land, land);
}

}  // namespace ringfilm::app
