#include "commands/command_surface.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/contact_measurement.hpp"
#include "ringfilm/io/case/contact_fragment.hpp"
#include "ringfilm/io/measurement/contact_law_file.hpp"
#include "ringfilm/io/measurement/measurement_netcdf.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/surface/topography/roughness.hpp"
#include "text/shared_options.hpp"

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

std::optional<instrument::SurfaceFile> read_flat(const MeasuringCommand& command, const io::Units& units) {
  if (!command.noise) return std::nullopt;
  return instrument::read_surface_file(*command.noise, command.reading, units);
}

std::vector<instrument::SurfaceFile> read_maps(const std::vector<std::string>& paths, const MeasuringCommand& command,
                                               const io::Units& units) {
  std::vector<instrument::SurfaceFile> files;
  for (const std::string& path : paths) files.push_back(instrument::read_surface_file(path, command.reading, units));
  return files;
}

/// Writes the contact law of two maps. @returns the fragment that names it
std::string write_law(const instrument::SurfaceFile& ring, const instrument::SurfaceFile& liner,
                      const PairCommand& command) {
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

constexpr const char* kSurfaceFooter = R"(Examples:
  ringfilm surface liner.x3p
  ringfilm surface liner.x3p --form cylinder --short-cutoff "2.5 um" --long-cutoff "250 um" --html liner.html
  ringfilm surface scan.csv --unit nm --step-x "0.5 um" --form tilt --json
  ringfilm surface ring.sur --form tilt --prominent "4 of 50 um" --output ring.nc
  ringfilm surface liner.x3p --heights heights.csv
  ringfilm surface honed.x3p --form tilt --fragment plateau.toml

Nothing is removed from the heights unless it is requested, except for the S-F and S-L surfaces of a map, each of
whose values has its form, S-filter and L-filter beside it. Lengths are written with their unit.
--heights writes the heights as they were read: x, y, z in metres, z empty where a point is missing.
The file can be read again without any option.
--fragment writes [contact.plateau] of a surface made in two steps.
)";

constexpr const char* kPairFooter = R"(Examples:
  ringfilm pair --ring ring.x3p --liner liner.x3p --form tilt --short-cutoff "2.5 um" --fragment contact.toml
  ringfilm pair --ring r1.sur r2.sur r3.sur --liner l1.x3p l2.x3p --form cylinder --grid 3x3 --sigma Rq

  ringfilm pair --ring ring.x3p --liner liner.x3p --form tilt --hardness "2.5 GPa" --composite-modulus "134.8 GPa" \
      --law law.nc --fragment contact.toml

  ringfilm pair --ring ring.x3p --liner honed.x3p --form tilt --plateau --fragment contact.toml

Every file and region of a side is one sample of that surface; the means go into the case, the scatter with them.
)";

InputError not_a_rectangle(const std::string& text) {
  return InputError("--region " + text + ": these are not four numbers and a unit of length",
                    "for example --region \"0, 0, 100, 50 um\"");
}

/// "0,0,100,50 um" as four lengths.
std::array<double, 4> rectangle_of(const std::string& text, const io::Units& units) {
  std::vector<std::string> words = comma_separated(text);
  if (words.size() != 4) throw not_a_rectangle(text);
  const std::size_t last = words[3].find_last_of("0123456789.");
  if (last == std::string::npos) throw not_a_rectangle(text);
  const std::string unit = words[3].substr(last + 1);
  words[3].resize(last + 1);
  std::array<double, 4> rectangle{};
  for (std::size_t k = 0; k < 4; ++k) {
    try {
      rectangle[k] = units.quantity(words[k] + unit, "m", "100 um");
    } catch (const io::UnitError&) {
      throw not_a_rectangle(text);
    }
  }
  return rectangle;
}

void read_prominent(CommandOptions& add, const std::string& text, instrument::RegionChoice& regions) {
  const std::string of = " of ";
  const std::size_t word = text.find(of);
  const auto count = word == std::string::npos ? std::nullopt : whole_number(text.substr(0, word));
  if (!count || *count < 1 || *count > 1000) {
    throw InputError("--prominent " + text + ": this is not a count and a size",
                     "for example --prominent \"4 of 50 um\"");
  }
  regions.prominent = *count;
  regions.size_m = add.length_of("--prominent", text.substr(word + of.size()), "50 um");
}

/// What `surface` and `pair` have in common. @returns the option of sigma
const CLI::Option* add_measuring(CommandOptions& add, MeasuringCommand& command, const std::string& usual_sigma) {
  using surface::DifferenceScheme, surface::MomentDirection, surface::SigmaRule;
  instrument::SurfaceAnalysis& analysis = command.analysis;
  add_map_options(add, command.reading, analysis.preparation, "none");
  add.choice("--direction", analysis.direction,
             {{"x", MomentDirection::x},
              {"y", MomentDirection::y},
              {"mean", MomentDirection::mean},
              {"geometric", MomentDirection::geometric}},
             "of slopes and curvatures: x, y, mean or geometric")
      ->capture_default_str();
  add.choice("--scheme", analysis.scheme,
             {{"neighbours", DifferenceScheme::neighbours}, {"seven-point", DifferenceScheme::seven_point}},
             "of slopes and curvatures: neighbours or seven-point")
      ->capture_default_str();
  add.quantity("--angle", analysis.angle_rad, "rad", "30 deg", "ANGLE",
               "report slopes and curvatures of a map at this angle to x, too");
  add.length("--cavity-depth", analysis.cavity_depth_m, "2.5 um", "what lies deeper below the median is a cavity");
  add.length("--ratio-depth", analysis.ratio_depth_m, "1 um",
             "of the material ratio Rmr (Smr): below the height at 5 %");
  const CLI::Option* sigma = add.choice("--sigma", analysis.sigma_rule, {{"Ra", SigmaRule::ra}, {"Rq", SigmaRule::rq}},
                                        "which roughness is used as sigma: Ra or Rq")
                                 ->default_str(usual_sigma);
  instrument::RegionChoice& regions = analysis.regions;
  add.read_each("--region", "\"X,Y,W,H um\"",
                "a rectangle to be measured by itself: x, y, width, height with their unit; may be repeated",
                [&](const std::string& text) { regions.rectangles_m.push_back(rectangle_of(text, add.units())); });
  add.counts("--grid", regions.across, regions.down, "3x2", "so many equal regions across and down");
  add.read("--prominent", "\"N of LENGTH\"", "so many squares of this size that stand out most",
           [&](const std::string& text) { read_prominent(add, text, regions); });
  add.text("--noise", command.noise, "FILE", "a flat measured likewise: its moments are subtracted");
  return sigma;
}

void declare_surface(CommandOptions& add, SurfaceCommand& command) {
  add.text("FILE", command.files, "...",
           "X3P, SDF, SUR, GSF, CSV; other formats through the program gwyddion; several files of one surface give a "
           "mean and its scatter")
      ->required();
  add_measuring(add, command, "Ra");
  using instrument::StandardSurfaces;
  add.choice("--standard-surfaces", command.analysis.standard_surfaces,
             {{"S-F+S-L", StandardSurfaces::kSfAndSl}, {"none", StandardSurfaces::kNone}},
             "of a map: report the S-F and S-L surfaces of ISO 25178-2, too, or none")
      ->capture_default_str();
  add_outputs(add, command.outputs, true);
  add.text("--heights", command.outputs.heights, "OUT.csv", "write the heights as read: x, y, z in metres");
}

void declare_pair(CommandOptions& add, PairCommand& command) {
  add.text("--ring", command.ring, "FILE ...", "maps of the ring's face")->required();
  add.text("--liner", command.liner, "FILE ...", "maps of the liner")->required();
  const CLI::Option* sigma = add_measuring(add, command, "Ra, with --hardness or --plateau Rq");
  add_outputs(add, command.outputs, true);
  const CLI::Option* hardness =
      add.pressure("--hardness", command.analysis.hardness, "2.5 GPa",
                   "of the softer face: the fragment states the law of new cases, which counts from the summits");
  const CLI::Option* plateau =
      add.flag("--plateau", command.analysis.liner, instrument::CarryingPart::kPlateau,
               "the liner was made in two steps: N, beta and sigma of its plateau, with [contact.plateau]");
  LawRequest& request = command.law.emplace();
  const CLI::Option* law =
      add.text("--law", request.path, "LAW.nc",
               "write the contact law and the flow factors of both maps, which the fragment names");
  const CLI::Option* modulus =
      add.pressure("--composite-modulus", request.E_prime, "134.8 GPa", "of --law: E' of 2/E' = sum (1 - nu^2)/E");
  add.text("--shifts", request.shifts, "N", "of --law: relative positions")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));

  add.rule([=, &command](Faults& faults) {
    if (is_stated(law) != is_stated(modulus)) {
      faults.refuse("--law and --composite-modulus belong together", "state both, or neither");
    }
    if (is_stated(law) && is_stated(plateau)) {
      faults.refuse("--law and --plateau exclude each other", "the law of both maps has their plateau: leave one out");
    }
    if (!is_stated(law)) command.law.reset();
    if ((is_stated(hardness) || is_stated(plateau)) && !is_stated(sigma))
      command.analysis.sigma_rule = surface::SigmaRule::rq;
  });
}

}  // namespace

void surface(const SurfaceCommand& command) {
  const std::vector<std::string>& paths = command.files;
  std::vector<std::string> inputs = paths;
  const MeasurementOutputs& outputs = command.outputs;
  if (outputs.heights && paths.size() > 1) {
    throw InputError("--heights writes the heights of one file, and there are " + std::to_string(paths.size()),
                     "name one file");
  }
  if (outputs.fragment && paths.size() > 1) {
    throw InputError("--fragment states the plateau of one file, and there are " + std::to_string(paths.size()),
                     "name one file, or all of a pair: ringfilm pair --plateau");
  }
  if (command.noise) inputs.push_back(*command.noise);
  const auto claimed = claimed_outputs(outputs, inputs);
  const io::Units units;
  const auto flat = read_flat(command, units);
  if (paths.size() > 1) {
    const io::Measurement all =
        surfaces_measurement(read_maps(paths, command, units), command.analysis, flat ? &*flat : nullptr);
    return deliver(all, outputs);
  }
  const instrument::SurfaceFile file = instrument::read_surface_file(paths.front(), command.reading, units);
  const io::Measurement measurement = surface_measurement(file, command.analysis, flat ? &*flat : nullptr);
  if (outputs.fragment && measurement.fragment.empty()) {
    throw InputError(paths.front() + " has no plateau over deeper valleys, which --fragment would state",
                     "over normal probability one line describes its material ratio curve as well as two: leave "
                     "--fragment out; N, beta and sigma of a pair: ringfilm pair");
  }
  if (outputs.heights) write_heights(*outputs.heights, file.map);
  deliver(measurement, outputs, {numbers_as_read(file.map), {}, {}});
}

void pair(const PairCommand& command) {
  std::vector<std::string> inputs = command.ring;
  inputs.insert(inputs.end(), command.liner.begin(), command.liner.end());
  if (command.noise) inputs.push_back(*command.noise);
  if (command.law && (command.ring.size() > 1 || command.liner.size() > 1)) {
    throw InputError("--law presses one map of each side against the other", "name one --ring and one --liner");
  }
  const NamedOutput law{"--law", command.law ? std::optional(command.law->path) : std::nullopt, OutputKind::kNetcdf};
  const auto claimed = claimed_outputs(command.outputs, inputs, {law});
  const io::Units units;
  const auto flat = read_flat(command, units);
  const std::vector<instrument::SurfaceFile> rings = read_maps(command.ring, command, units);
  const std::vector<instrument::SurfaceFile> liners = read_maps(command.liner, command, units);
  io::Measurement measurement = pair_measurement(rings, liners, command.analysis, flat ? &*flat : nullptr);
  if (command.law) measurement.fragment = write_law(rings.front(), liners.front(), command);
  deliver(measurement, command.outputs);
  if (command.outputs.summary == SummaryForm::kTable) print_written({law});
}

void add_surface_commands(Program& program) {
  program.add("surface", "Measure a surface: roughness, material ratio curve, asperities", kSurfaceFooter,
              declare_surface, surface);
  program.add("pair", "Two surfaces in contact: N, beta and sigma for a case", kPairFooter, declare_pair, pair);
}

}  // namespace ringfilm::app
