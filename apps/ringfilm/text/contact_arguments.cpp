#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "commands/command_contact.hpp"
#include "ringfilm/base/error.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kContactFooter = R"(Examples:
  ringfilm contact --surface ring.x3p --surface liner.x3p --composite-modulus "134.8 GPa" --hardness "2.5 GPa" -o law.nc
  ringfilm contact --surface ring.x3p --surface liner.x3p --composite-modulus "134.8 GPa" --shifts 8 --html law.html
  ringfilm contact --surface wave.csv --unit um --step-x "0.5 um" --composite-modulus "134.8 GPa" --periodic \
      --separations "0.32 um, 0.27 um" --json

  ringfilm contact --case new.toml --lambda 1,1.286,2,3
  ringfilm contact --case new.toml --set contact.model=greenwood-williamson --set contact.summit_plane=nayak --json

The separation is the distance of the mean planes of the undeformed, levelled maps. One surface meets a smooth flat.
E' = 2 E*, with 1/E* = sum (1 - nu^2)/E. Without --hardness contact is elastic. Nothing is filtered without a cut-off.
)";

constexpr std::size_t kMostShifts = 1000;

/// The arguments of `contact`, as text.
struct ContactArguments {
  std::vector<std::string> surfaces, settings;
  MapArguments maps;
  std::optional<std::string> case_path, lambda, modulus, hardness, separations, shifts, grid;
  bool periodic = false, mirrored = false, flow = false;
  OutputArguments outputs;

  void add_to(CLI::App& command) {
    command.add_option("--surface", surfaces, "map of the ring's face, then that of the liner; one: against a flat")
        ->type_name("FILE");
    command.add_option("--case", case_path, "tabulate the law that a case uses, instead of that of maps")
        ->type_name("CASE.toml");
    command.add_option("--lambda", lambda, "lambda ratios of --case, separated by commas (default 0.5 to 4)")
        ->type_name("N,...");
    command.add_option("--set", settings, "a key of the case to replace; may be repeated")
        ->allow_extra_args(false)
        ->type_name("key=value");
    command.add_option("--composite-modulus", modulus, "E' of 2/E' = sum (1 - nu^2)/E")->type_name("PRESSURE");
    command.add_option("--hardness", hardness, "of the softer face; without it contact is elastic")
        ->type_name("PRESSURE");
    command
        .add_option("--separations", separations,
                    "distances of the mean planes, separated by commas; without it evenly from the highest point down")
        ->type_name("\"LENGTH, ...\"");
    command.add_flag("--periodic", periodic, "the maps repeat; only their mean is removed unless --form states more");
    command.add_flag("--mirrored", mirrored, "the maps continue by their mirror images (default)");
    command
        .add_option("--shifts", shifts, "relative positions of both maps over which the law is the mean (default 1)")
        ->type_name("N");
    command
        .add_option("--grid", grid,
                    "equal regions across and down whose laws scatter, from the mean plane of the whole")
        ->type_name("2x2");
    command.add_flag("--flow-factors", flow, "pressure and shear flow factors of the true gap, beyond contact, too");
    maps.add_to(command, "tilt; with --periodic mean");
    outputs.add_to(command, false);
  }

  ContactCommand command() const {
    const io::Units units;
    OptionValues values(units);
    ContactCommand of;
    of.outputs = outputs.selected();
    if (case_path) {
      fill_of_case(of, values);
      return of;
    }
    of.surfaces = surfaces;
    if (surfaces.empty())
      values.refuse("there is nothing to compute", "name maps with --surface, or a case with --case");
    if (lambda || !settings.empty()) values.refuse("--lambda and --set belong to --case", "name one with --case");
    if (surfaces.size() > 2)
      values.refuse("--surface is given more than twice", "name the ring's map, then the liner's");
    if (periodic && mirrored) values.refuse("--periodic and --mirrored contradict each other", "state one of them");
    of.reading = maps.selected_reading(values);
    of.analysis.edges = periodic ? surface::MapEdges::periodic : surface::MapEdges::mirrored;
    of.analysis.preparation =
        maps.selected_preparation(values, {periodic ? surface::FormKind::mean : surface::FormKind::tilt});
    of.analysis.has_flow = flow;
    if (modulus) {
      of.analysis.material.E_star = values.positive("--composite-modulus", *modulus, "Pa", "134.8 GPa") / 2;
    } else {
      values.refuse("--composite-modulus is missing", "for example --composite-modulus \"134.8 GPa\"");
    }
    if (hardness) of.analysis.material.hardness = values.positive("--hardness", *hardness, "Pa", "2.5 GPa");
    if (separations) of.analysis.separations_m = lengths(values);
    if (grid) std::tie(of.analysis.regions_across, of.analysis.regions_down) = counts_of("--grid", *grid);
    if (shifts) of.analysis.shifts = count_of_shifts(values);
    values.check();
    return of;
  }

 private:
  void fill_of_case(ContactCommand& of, OptionValues& values) const {
    const bool names_maps =
        !surfaces.empty() || modulus || hardness || separations || shifts || grid || periodic || mirrored || flow;
    if (names_maps) {
      values.refuse("--case has its own surfaces: --surface and its options do not belong to it",
                    "set keys of the case with --set, for example --set contact.hardness='2.5 GPa'");
    }
    of.case_path = case_path;
    for (const std::string& text : settings) of.settings.push_back(override_of(text));
    const double highest = 100;
    for (const std::string& word : parts(lambda.value_or("0.5,1,1.5,2,2.5,3,3.5,4"))) {
      of.lambda.push_back(values.number("--lambda", word, 0, highest, "1,1.286,2,3"));
    }
    values.check();
  }

  /// What lies between commas.
  static std::vector<std::string> parts(const std::string& text) {
    std::vector<std::string> of;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t comma = std::min(text.find(',', begin), text.size());
      of.push_back(text.substr(begin, comma - begin));
      begin = comma + 1;
    }
    return of;
  }

  std::vector<double> lengths(OptionValues& values) const {
    std::vector<double> of;
    for (const std::string& word : parts(*separations)) {
      of.push_back(values.length("--separations", word, "0.32 um, 0.27 um"));
      if (of.back() > 0 && std::count(of.begin(), of.end(), of.back()) > 1) {  // 0: refused
        values.refuse("--separations has " + word + " twice", "state each separation once");
      }
    }
    return of;
  }

  std::size_t count_of_shifts(OptionValues& values) const {
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(shifts->data(), shifts->data() + shifts->size(), count);
    if (error != std::errc() || end != shifts->data() + shifts->size() || count < 1 || count > kMostShifts) {
      values.refuse("--shifts " + *shifts + ": this is not a count from 1 to 1000", "for example --shifts 8");
    } else if (surfaces.size() < 2 && count > 1) {
      values.refuse("--shifts moves two maps over each other, and there is one", "name two with --surface");
    }
    return count;
  }
};

}  // namespace

void add_contact_command(CLI::App& program, Actions& actions) {
  CLI::App* command = program.add_subcommand(
      "contact", "Contact law of a measured pair: pressure, real area and gap against the separation");
  const auto arguments = std::make_shared<ContactArguments>();
  arguments->add_to(*command);
  command->footer(kContactFooter);
  actions.emplace_back(command, [arguments] { contact(arguments->command()); });
}

}  // namespace ringfilm::app
