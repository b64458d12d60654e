#include <CLI/CLI.hpp>

#include "commands/command_conform.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kConformFooter = R"(Examples:
  ringfilm conform cases/distorted-bore/followed.toml
  ringfilm conform case.toml --set ring.gap_position='45 degree' --json
  ringfilm conform case.toml --set conform.gas_pressure='3 bar' --csv around.csv --html conform.html

The case needs engine.bore, [ring] with face_width, radial_thickness and tension, and [liner] with its distortion;
keys of film and cycle may be stated or missing. Angles count from the middle of the gap.
)";

/// The arguments of `conform`, as text.
struct ConformArguments {
  std::string case_path;
  std::vector<std::string> settings;
  OutputArguments outputs;

  void add_to(CLI::App& command) {
    command.add_option("CASE.toml", case_path, "the case file")->required()->type_name("");
    command.add_option("--set", settings, "a key of the case to replace; may be repeated")
        ->allow_extra_args(false)
        ->type_name("key=value");
    command.add_option("--csv", outputs.outputs.csv, "write a row a degree: bore, clearance, forces, moment, SI units")
        ->type_name("X.csv");
    outputs.add_to(command, false);
  }

  ConformCommand command() const {
    ConformCommand of{case_path, {}, outputs.selected()};
    for (const std::string& text : settings) of.settings.push_back(override_of(text));
    return of;
  }
};

}  // namespace

void add_conform_command(CLI::App& program, Actions& actions) {
  CLI::App* command = program.add_subcommand(
      "conform", "Static closure of a ring in its bore: clearance, open area, contact arcs and force of the wall");
  const auto arguments = std::make_shared<ConformArguments>();
  arguments->add_to(*command);
  command->footer(kConformFooter);
  actions.emplace_back(command, [arguments] { conform(arguments->command()); });
}

}  // namespace ringfilm::app
