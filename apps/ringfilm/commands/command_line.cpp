#include "commands/command_line.hpp"

#include <algorithm>
#include <iostream>
#include <memory>

#include "command_options.hpp"
#include "commands/commands.hpp"
#include "exit_codes.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/text/suggestion.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kProgramFooter = R"(Examples:
  ringfilm new my_engine.toml
  ringfilm check my_engine.toml
  ringfilm run my_engine.toml --output my_engine.nc
  ringfilm run my_engine.toml --set operating.speed='3000 rpm' --json
  ringfilm gas cases/ring-pack/two_rings.toml --json
  ringfilm report my_engine.nc --output my_engine.html
  ringfilm reproduce styles2014
  ringfilm verify
  ringfilm surface liner.x3p --form cylinder --html liner.html
  ringfilm pair --ring ring.x3p --liner liner.x3p --form tilt --fragment contact.toml
  ringfilm contact --surface ring.x3p --surface liner.x3p --composite-modulus "134.8 GPa" --hardness "2.5 GPa" -o law.nc
  ringfilm conform cases/distorted-bore/followed.toml --html conform.html
  ringfilm face trace.csv --heights material --width "1.2 mm" --fragment face.toml
  ringfilm lateral-force new.csv --silicon silicon.csv --reference ahimou2007 --fragment shear.toml
  ringfilm synthetic honed liner.x3p --hatch-angle "45 degree" --seed 7
  ringfilm reproduce measured
  ringfilm study cases/studies/new_ring_uncertainty.toml -o uncertainty
  ringfilm fit cases/inverse/fit_friction.toml -o fit
  ringfilm optimise cases/inverse/rayleigh_step.toml -o step

Exit codes: 0 done, 1 internal error, 2 bad input, 3 no balance found, 4 a check failed, 5 could not write.
)";

std::string version_text() {
  const io::Provenance provenance = io::this_program();
  return provenance.program + " (commit " + provenance.commit + "; " + provenance.compiler + ")";
}

/// Settings as the ledger prints them, key = value, are three arguments: joins them to one.
std::vector<std::string> with_joined_settings(int argc, const char* const* argv) {
  std::vector<std::string> joined;
  bool may_be_setting = false;
  for (int i = 0; i < argc; ++i) {
    const std::string word = argv[i];
    may_be_setting = may_be_setting || word == "--set";
    if (may_be_setting && word == "=" && i + 1 < argc && joined.back() != "--set") {
      joined.back() += "=" + std::string(argv[++i]);
    } else {
      joined.push_back(word);
    }
  }
  return joined;
}

/// All commands, in the order in which the help lists them.
void add_commands(Program& program) {
  add_run_command(program);
  add_gas_command(program);
  add_check_command(program);
  add_conform_command(program);
  add_report_command(program);
  add_reproduce_command(program);
  add_verify_command(program);
  add_study_command(program);
  add_sweep_command(program);
  add_fit_command(program);
  add_optimise_command(program);
  add_serve_command(program);
  add_life_command(program);
  add_surface_commands(program);
  add_contact_command(program);
  add_land_command(program);
  add_face_command(program);
  add_lateral_force_command(program);
  add_synthetic_command(program);
  add_data_commands(program);
  add_new_command(program);
  add_cite_command(program);
  add_completion_command(program);
}

/// The first of the arguments after a command that begins as an option and is not one of its options.
std::optional<InputError> unknown_option(const CLI::App& command, const std::vector<std::string>& arguments) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const std::string& word : arguments) {
    if (word == "--") return std::nullopt;  // what follows is for another program
    const std::string name = word.substr(0, word.find('='));
    if (name.rfind("--", 0) != 0 || std::find(names.begin(), names.end(), name) != names.end()) continue;
    return InputError(name + ": ringfilm " + command.get_name() + " has no such option" + io::did_you_mean(name, names),
                      "ringfilm " + command.get_name() + " --help lists its options");
  }
  return std::nullopt;
}

/// An option that takes one value and is given more often.
std::optional<InputError> repeated_option(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::size_t n = option->results().size();
    if (option->get_positional() || option->get_items_expected_max() != 1 || n < 2) continue;
    const std::string times = n == 2 ? "twice" : std::to_string(n) + " times";
    return InputError(option->get_name() + " is given " + times, "give it once");
  }
  return std::nullopt;
}

/// An option at the end or before another one, without the value that it takes.
std::optional<InputError> option_without_value(const std::string& refusal) {
  const std::string needs = ": 1 required ", missing = " missing";
  const std::size_t at = refusal.find(needs), end = refusal.rfind(missing);
  if (at == std::string::npos || end == std::string::npos || end < at + needs.size()) return std::nullopt;
  const std::string option = refusal.substr(0, at);
  const std::string value = refusal.substr(at + needs.size(), end - at - needs.size());
  return InputError(option + " has no value", "write " + option + " " + value);
}

/// The command that the first arguments name: a command of the program, or one of its own ("synthetic gaussian").
const CLI::App& named_command(const CLI::App& program, const std::vector<std::string>& arguments) {
  const CLI::App* command = &program;
  for (const std::string& word : arguments) {
    const auto inner = command->get_subcommands([&word](const CLI::App* one) { return one->get_name() == word; });
    if (inner.empty()) break;
    command = inner.front();
  }
  return *command;
}

/// What CLI11 states of numbers of values, in the terms of a user.
std::optional<InputError> wrong_number_of_values(const CLI::App& program, const std::vector<std::string>& arguments,
                                                 const CLI::ParseError& refusal) {
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&refusal) == nullptr) return std::nullopt;
  if (const auto repeated = repeated_option(named_command(program, arguments))) return repeated;
  return option_without_value(refusal.what());
}

/// What is wrong with a line that CLI11 refuses, where a word of it may be misspelt.
std::optional<InputError> misspelt_word(const CLI::App& program, const std::vector<std::string>& arguments) {
  if (arguments.empty()) return std::nullopt;
  const std::string& first = arguments.front();
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() == first) return unknown_option(*command, arguments);
    names.push_back(command->get_name());
  }
  if (first.rfind('-', 0) == 0) return std::nullopt;
  return InputError("ringfilm " + first + ": this is not a command" + io::did_you_mean(first, names),
                    "one of: " + joined(names, ", "));
}

}  // namespace

Request read_command_line(int argc, const char* const* argv) {
  const auto program = std::make_shared<Program>();
  program->app.name("ringfilm")
      ->description(
          "Friction, film and oil flow of a piston ring over one engine cycle, from measured surfaces; films of pads, "
          "too.");
  program->app.set_version_flag("--version", version_text());
  program->app.require_subcommand(1)->footer(kProgramFooter);
  add_commands(*program);
  const std::vector<std::string> words = with_joined_settings(argc, argv);
  std::vector<const char*> word_starts;
  for (const std::string& word : words) word_starts.push_back(word.c_str());
  try {
    program->app.parse(static_cast<int>(word_starts.size()), word_starts.data());
  } catch (const CLI::ParseError& refusal) {
    if (refusal.get_exit_code() != 0) {
      const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
      auto error = misspelt_word(program->app, arguments);
      if (!error) error = wrong_number_of_values(program->app, arguments, refusal);
      if (error) return {[error] { throw InputError(*error); }, kBadInput};
    }
    return {{}, program->app.exit(refusal) == 0 ? kFine : kBadInput};
  }
  // The program, of which the action asks what is stated, lives as long as the action.
  return {[program, action = program->action()] { action(); }, kFine};
}

}  // namespace ringfilm::app
