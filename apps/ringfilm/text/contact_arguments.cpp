#include <CLI/CLI.hpp>
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

The separation is the distance of the mean planes of the undeformed, levelled maps. One surface meets a smooth flat.
E' = 2 E*, with 1/E* = sum (1 - nu^2)/E. Without --hardness contact is elastic. Nothing is filtered without a cut-off.
)";

constexpr std::size_t kMostShifts = 1000;

/// The arguments of `contact`, as text.
struct ContactArguments {
  std::vector<std::string> surfaces;
  MapArguments maps;
  std::optional<std::string> modulus, hardness, separations, shifts;
  bool periodic = false, mirrored = false;
  OutputArguments outputs;

  void add_to(CLI::App& command) {
    command.add_option("--surface", surfaces, "map of the ring's face, then that of the liner; one: against a flat")
        ->required()
        ->type_name("FILE");
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
    maps.add_to(command, "tilt; with --periodic mean");
    outputs.add_to(command, false);
  }

  ContactCommand command() const {
    const io::Units units;
    OptionValues values(units);
    ContactCommand of;
    of.surfaces = surfaces;
    if (surfaces.size() > 2)
      values.refuse("--surface is given more than twice", "name the ring's map, then the liner's");
    if (periodic && mirrored) values.refuse("--periodic and --mirrored contradict each other", "state one of them");
    of.outputs = outputs.selected();
    of.reading = maps.selected_reading(values);
    of.analysis.edges = periodic ? surface::MapEdges::periodic : surface::MapEdges::mirrored;
    of.analysis.preparation =
        maps.selected_preparation(values, {periodic ? surface::FormKind::mean : surface::FormKind::tilt});
    if (modulus) {
      of.analysis.material.E_star = pressure(values, "--composite-modulus", *modulus, "134.8 GPa") / 2;
    } else {
      values.refuse("--composite-modulus is missing", "for example --composite-modulus \"134.8 GPa\"");
    }
    if (hardness) of.analysis.material.hardness = pressure(values, "--hardness", *hardness, "2.5 GPa");
    if (separations) of.analysis.separations_m = lengths(values);
    if (shifts) of.analysis.shifts = count_of_shifts(values);
    values.check();
    return of;
  }

 private:
  static double pressure(OptionValues& values, const std::string& option, const std::string& text,
                         const std::string& example) {
    const double value = values.quantity(option, text, "Pa", example);
    if (!(value > 0)) values.refuse(option + " \"" + text + "\" is not above 0", "for example \"" + example + "\"");
    return value;
  }

  std::vector<double> lengths(OptionValues& values) const {
    std::vector<double> of;
    for (std::size_t begin = 0; begin <= separations->size();) {
      const std::size_t comma = std::min(separations->find(',', begin), separations->size());
      of.push_back(values.length("--separations", separations->substr(begin, comma - begin), "0.32 um, 0.27 um"));
      begin = comma + 1;
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
