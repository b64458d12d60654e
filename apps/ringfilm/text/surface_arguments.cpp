#include <CLI/CLI.hpp>
#include <charconv>

#include "commands/command_surface.hpp"
#include "option_values.hpp"
#include "ringfilm/base/error.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kSurfaceFooter = R"(Examples:
  ringfilm surface liner.x3p
  ringfilm surface liner.x3p --form cylinder --short-cutoff "2.5 um" --long-cutoff "250 um" --html liner.html
  ringfilm surface scan.csv --unit nm --step-x "0.5 um" --form tilt --json
  ringfilm surface ring.sur --form tilt --prominent "4 of 50 um" --output ring.nc
  ringfilm surface liner.x3p --heights heights.csv

Nothing is removed from the heights unless it is requested. Lengths are written with their unit.
--heights writes the heights as they were read: x, y, z in metres, z empty where a point is missing.
The file can be read again without any option.
)";

constexpr const char* kPairFooter = R"(Examples:
  ringfilm pair --ring ring.x3p --liner liner.x3p --form tilt --short-cutoff "2.5 um" --fragment contact.toml
  ringfilm pair --ring r1.sur r2.sur r3.sur --liner l1.x3p l2.x3p --form cylinder --grid 3x3 --sigma Rq

  ringfilm pair --ring ring.x3p --liner liner.x3p --form tilt --hardness "2.5 GPa" --composite-modulus "134.8 GPa" \
      --law law.nc --fragment contact.toml

Every file and region of a side is one sample of that surface; the means go into the case, the scatter with them.
)";

/// The arguments of a surface command, as text.
struct SurfaceArguments {
  MapArguments maps;
  std::optional<std::string> grid, prominent, noise, angle, cavity_depth, sigma;
  std::vector<std::string> rectangles;
  std::string direction = "mean", scheme = "neighbours";
  OutputArguments outputs;

  void add_to(CLI::App& command, const std::string& usual_sigma) {
    maps.add_to(command, "none");
    command.add_option("--direction", direction, "of slopes and curvatures: x, y, mean or geometric")
        ->capture_default_str()
        ->type_name("WORD");
    command.add_option("--scheme", scheme, "of slopes and curvatures: neighbours or seven-point")
        ->capture_default_str()
        ->type_name("WORD");
    command.add_option("--angle", angle, "report slopes and curvatures of a map at this angle to x, too")
        ->type_name("ANGLE");
    command.add_option("--cavity-depth", cavity_depth, "what lies deeper below the median is a cavity")
        ->type_name("LENGTH");
    command.add_option("--sigma", sigma, "which roughness is used as sigma: Ra or Rq")
        ->default_str(usual_sigma)
        ->type_name("WORD");
    command
        .add_option("--region", rectangles,
                    "a rectangle to be measured by itself: x, y, width, height with their unit; may be repeated")
        ->allow_extra_args(false)
        ->type_name("\"X,Y,W,H um\"");
    command.add_option("--grid", grid, "so many equal regions across and down")->type_name("3x2");
    command.add_option("--prominent", prominent, "so many squares of this size that stand out most")
        ->type_name("\"N of LENGTH\"");
    command.add_option("--noise", noise, "a flat measured likewise: its moments are subtracted")->type_name("FILE");
  }

  SurfaceCommand command() const {
    SurfaceCommand of;
    const io::Units units;
    OptionValues values(units);
    of.reading = maps.selected_reading(values);
    of.noise = noise;
    of.outputs = outputs.selected();
    of.analysis.preparation = maps.selected_preparation(values, {surface::FormKind::none});
    if (cavity_depth) of.analysis.cavity_depth_m = values.length("--cavity-depth", *cavity_depth, "2.5 um");
    if (angle) of.analysis.angle_rad = values.quantity("--angle", *angle, "rad", "30 deg");
    using surface::MomentDirection;
    of.analysis.direction = values.chosen<MomentDirection>("--direction", direction,
                                                           {{"x", MomentDirection::x},
                                                            {"y", MomentDirection::y},
                                                            {"mean", MomentDirection::mean},
                                                            {"geometric", MomentDirection::geometric}});
    using surface::DifferenceScheme;
    of.analysis.scheme = values.chosen<DifferenceScheme>(
        "--scheme", scheme,
        {{"neighbours", DifferenceScheme::neighbours}, {"seven-point", DifferenceScheme::seven_point}});
    if (sigma) {
      of.analysis.sigma_rule = values.chosen<surface::SigmaRule>(
          "--sigma", *sigma, {{"Ra", surface::SigmaRule::ra}, {"Rq", surface::SigmaRule::rq}});
    }
    for (const std::string& text : rectangles) of.analysis.regions.rectangles_m.push_back(rectangle(text, units));
    if (grid) std::tie(of.analysis.regions.across, of.analysis.regions.down) = counts_of("--grid", *grid);
    if (prominent) add_prominent(of.analysis.regions, values);
    values.check();
    return of;
  }

 private:
  /// "0,0,100,50 um" as four lengths.
  static std::array<double, 4> rectangle(const std::string& text, const io::Units& units) {
    const InputError refusal("--region " + text + ": these are not four numbers and a unit of length",
                             "for example --region \"0, 0, 100, 50 um\"");
    std::array<double, 4> of{};
    std::size_t begin = 0;
    std::vector<std::string> words;
    while (begin <= text.size()) {
      const std::size_t comma = std::min(text.find(',', begin), text.size());
      words.push_back(text.substr(begin, comma - begin));
      begin = comma + 1;
    }
    if (words.size() != 4) throw refusal;
    const std::size_t last = words[3].find_last_of("0123456789.");
    if (last == std::string::npos) throw refusal;
    const std::string unit = words[3].substr(last + 1);
    words[3].resize(last + 1);
    for (std::size_t k = 0; k < 4; ++k) {
      try {
        of[k] = units.quantity(words[k] + unit, "m", "100 um");
      } catch (const io::UnitError&) {
        throw refusal;
      }
    }
    return of;
  }

  void add_prominent(instrument::RegionChoice& to, OptionValues& values) const {
    const std::string of = " of ";
    const std::size_t word = prominent->find(of);
    const InputError refusal("--prominent " + *prominent + ": this is not a count and a size",
                             "for example --prominent \"4 of 50 um\"");
    if (word == std::string::npos) throw refusal;
    const auto [end, error] = std::from_chars(prominent->data(), prominent->data() + word, to.prominent);
    if (error != std::errc() || end != prominent->data() + word || to.prominent < 1 || to.prominent > 1000)
      throw refusal;
    to.size_m = values.length("--prominent", prominent->substr(word + of.size()), "50 um");
  }
};

/// What `pair` takes for laws beyond N, beta and sigma.
struct LawArguments {
  std::optional<std::string> hardness, law, modulus;
  std::size_t shifts = 8;

  void add_to(CLI::App& command) {
    command
        .add_option("--hardness", hardness,
                    "of the softer face: the fragment states the law of new cases, which counts from the summits")
        ->type_name("PRESSURE");
    command
        .add_option("--law", law, "write the contact law and the flow factors of both maps, which the fragment names")
        ->type_name("LAW.nc");
    command.add_option("--composite-modulus", modulus, "of --law: E' of 2/E' = sum (1 - nu^2)/E")
        ->type_name("PRESSURE");
    command.add_option("--shifts", shifts, "of --law: relative positions")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000))
        ->type_name("N");
  }

  void fill(SurfaceCommand& of) const {
    const io::Units units;
    OptionValues values(units);
    if (hardness) of.analysis.hardness = values.positive("--hardness", *hardness, "Pa", "2.5 GPa");
    if (law.has_value() != modulus.has_value()) {
      values.refuse("--law and --composite-modulus belong together", "state both, or neither");
    } else if (law) {
      of.law = LawRequest{*law, values.positive("--composite-modulus", *modulus, "Pa", "134.8 GPa"), shifts};
    }
    values.check();
  }
};

}  // namespace

std::pair<std::size_t, std::size_t> counts_of(const std::string& option, const std::string& text) {
  const std::size_t cross = text.find('x');
  std::size_t across = 0, down = 0;
  const auto read = [](std::string_view word, std::size_t& to) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), to);
    return error == std::errc() && end == word.data() + word.size() && to >= 1 && to <= 1000;
  };
  const std::string_view words = text;
  if (cross == std::string::npos || !read(words.substr(0, cross), across) || !read(words.substr(cross + 1), down)) {
    throw InputError(option + " " + text + ": these are not two counts from 1 to 1000",
                     "for example " + option + " 3x2");
  }
  return {across, down};
}

void add_surface_commands(CLI::App& program, Actions& actions) {
  {
    CLI::App* command =
        program.add_subcommand("surface", "Measure a surface: roughness, material ratio curve, asperities");
    const auto arguments = std::make_shared<SurfaceArguments>();
    const auto paths = std::make_shared<std::vector<std::string>>();
    const auto heights = std::make_shared<std::optional<std::string>>();
    command
        ->add_option(
            "FILE", *paths,
            "X3P, SDF, SUR, GSF, CSV; other formats through the program gwyddion; several files of one surface "
            "give a mean and its scatter")
        ->required()
        ->type_name("...");
    arguments->add_to(*command, "Ra");
    arguments->outputs.add_to(*command, false);
    command->add_option("--heights", *heights, "write the heights as read: x, y, z in metres")->type_name("OUT.csv");
    command->footer(kSurfaceFooter);
    actions.emplace_back(command, [arguments, paths, heights] { surface(*paths, *heights, arguments->command()); });
  }
  {
    CLI::App* command = program.add_subcommand("pair", "Two surfaces in contact: N, beta and sigma for a case");
    const auto arguments = std::make_shared<SurfaceArguments>();
    const auto ring = std::make_shared<std::vector<std::string>>();
    const auto liner = std::make_shared<std::vector<std::string>>();
    const auto law = std::make_shared<LawArguments>();
    command->add_option("--ring", *ring, "maps of the ring's face")->required()->type_name("FILE ...");
    command->add_option("--liner", *liner, "maps of the liner")->required()->type_name("FILE ...");
    arguments->add_to(*command, "Ra, with --hardness Rq");
    arguments->outputs.add_to(*command, true);
    law->add_to(*command);
    command->footer(kPairFooter);
    actions.emplace_back(command, [arguments, law, ring, liner] {
      SurfaceCommand of = arguments->command();
      law->fill(of);
      if (of.analysis.hardness && !arguments->sigma) of.analysis.sigma_rule = surface::SigmaRule::rq;
      pair(*ring, *liner, of);
    });
  }
}

}  // namespace ringfilm::app
