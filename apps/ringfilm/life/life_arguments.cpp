#include <CLI/CLI.hpp>
#include <memory>

#include "life/command_life.hpp"
#include "option_values.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kLifeFooter =
    "Examples:\n"
    "  ringfilm life cases/life/styles2014.toml\n"
    "  ringfilm life my_life.toml --json\n"
    "  ringfilm life my_life.toml --output my_life.nc\n"
    "What a life file holds: docs/manual/guide/life.md";

struct LifeArguments {
  LifeOptions options;
  std::optional<std::string> threads;
  bool json = false;

  void run() {
    if (json) options.summary = SummaryForm::kJson;
    if (threads) options.threads = thread_count("--threads", *threads);
    run_life(options);
  }
};

}  // namespace

void add_life_command(CLI::App& program, Actions& actions) {
  CLI::App* command = program.add_subcommand("life", "Friction, oil and film of a ring over its running hours");
  const auto arguments = std::make_shared<LifeArguments>();
  command->add_option("LIFE.toml", arguments->options.life_path, "the life's file")->required()->type_name("");
  command->add_option("-o,--output", arguments->options.output, "write all values over the hours as NetCDF")
      ->type_name("X.nc");
  command->add_flag("--json", arguments->json, "print JSON, SI units, instead of the table");
  command->add_option("--threads", arguments->threads, "1 to 1024; without it as many as the machine runs at once")
      ->type_name("N");
  command->footer(kLifeFooter);
  actions.emplace_back(command, [arguments] { arguments->run(); });
}

}  // namespace ringfilm::app
