#include <CLI/CLI.hpp>
#include <memory>

#include "life/command_life.hpp"
#include "option_values.hpp"
#include "ringfilm/base/error.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kLifeFooter =
    "Examples:\n"
    "  ringfilm life cases/life/styles2014.toml\n"
    "  ringfilm life my_life.toml --json\n"
    "  ringfilm life my_life.toml --output my_life.nc --html my_life.html\n"
    "  ringfilm life faces new.toml run-in.toml embedded.toml\n"
    "What a life file holds: docs/manual/guide/life.md";

struct LifeArguments {
  std::vector<std::string> alone;
  std::optional<std::string> output, page, threads;
  bool json = false;

  void run() const {
    const SummaryForm summary = json ? SummaryForm::kJson : SummaryForm::kTable;
    if (alone.front() == "faces") {
      if (output || page || threads) {
        throw InputError("ringfilm life faces takes no other option than --json", "leave the others out");
      }
      return compare_faces({{alone.begin() + 1, alone.end()}, summary});
    }
    if (alone.size() > 1) {
      throw InputError("ringfilm life " + alone[1] + ": this is one word too many",
                       "one life at a time; ringfilm life faces A.toml B.toml compares faces");
    }
    run_life({alone.front(), output, page, summary, threads ? thread_count("--threads", *threads) : 0});
  }
};

}  // namespace

void add_life_command(CLI::App& program, Actions& actions) {
  CLI::App* command = program.add_subcommand("life", "Friction, oil and film of a ring over its running hours");
  const auto arguments = std::make_shared<LifeArguments>();
  constexpr int kMostWords = 64;
  command->add_option("LIFE.toml", arguments->alone, "the life's file; or faces, and cases whose faces are compared")
      ->required()
      ->expected(1, kMostWords)
      ->type_name("");
  command->add_option("-o,--output", arguments->output, "write all values over the hours as NetCDF")->type_name("X.nc");
  command->add_option("--html", arguments->page, "write the same as a web page")->type_name("X.html");
  command->add_flag("--json", arguments->json, "print JSON, SI units, instead of the table");
  command->add_option("--threads", arguments->threads, "1 to 1024; without it as many as the machine runs at once")
      ->type_name("N");
  command->footer(kLifeFooter);
  actions.emplace_back(command, [arguments] { arguments->run(); });
}

}  // namespace ringfilm::app
