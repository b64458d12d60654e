#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "command_options.hpp"
#include "commands/commands.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/case/keys/case_fields.hpp"

namespace ringfilm::app {
namespace {

enum class Shell { kBash, kZsh, kFish, kManual };

struct CompletionOptions {
  Shell shell = Shell::kBash;
};

/// The commands with their options, as the program declares them.
std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(program)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> keys() {
  std::vector<std::string> names;
  for (const cycle::Field& field : cycle::case_fields()) names.push_back(field.key + "=");
  return names;
}

/// For bash; zsh reads the same through bashcompinit.
std::string bash_text(const CLI::App& program) {
  std::string text = "_ringfilm() {\n  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words\n";
  text += "  if [ \"$COMP_CWORD\" = 1 ]; then\n    words=\"" + joined(command_names(program), " ") + "\"\n";
  text += "  elif [ \"$before\" = --set ]; then\n    compopt -o nospace 2>/dev/null\n";
  text += "    words=\"" + joined(keys(), " ") + "\"\n  else\n    case ${COMP_WORDS[1]} in\n";
  for (const CLI::App* command : commands_of(program)) {
    text += "      " + command->get_name() + ") words=\"" + joined(option_names(*command), " ") + "\" ;;\n";
  }
  text += "    esac\n  fi\n  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n}\n";
  return text + "complete -o default -F _ringfilm ringfilm\n";
}

std::string quoted_for_fish(std::string text) {
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return "'" + text + "'";
}

std::string fish_text(const CLI::App& program) {
  std::string text;
  for (const CLI::App* command : commands_of(program)) {
    text += fmt::format("complete -c ringfilm -n __fish_use_subcommand -a {} -d {}\n", command->get_name(),
                        quoted_for_fish(command->get_description()));
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) {
        const bool has_value = option->get_items_expected_max() > 0;
        text +=
            fmt::format("complete -c ringfilm -n '__fish_seen_subcommand_from {}' -l {}{} -d {}\n", command->get_name(),
                        name, has_value ? " -r" : "", quoted_for_fish(option->get_description()));
      }
    }
  }
  return text;
}

/// Text of a page of the manual: backslashes and points at the begin of a line mean something there.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (escaped.empty() || escaped.back() == '\n')) escaped += "\\&";
    escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return escaped;
}

std::string manual_text(const CLI::App& program) {
  std::string text = ".TH RINGFILM 1\n.SH NAME\nringfilm \\- mixed lubrication of piston rings\n.SH SYNOPSIS\n";
  text += ".B ringfilm\nCOMMAND [OPTION]...\n.SH COMMANDS\n";
  for (const CLI::App* command : commands_of(program)) {
    text += ".SS ringfilm " + roff(command->get_name()) + "\n" + roff(command->get_description()) + ".\n";
    for (const CLI::Option* option : command->get_options()) {
      text += ".TP\n.B " + roff(option->get_name(true, true)) + "\n" + roff(option->get_description()) + "\n";
    }
    if (!command->get_footer().empty()) text += ".PP\n.nf\n" + roff(command->get_footer()) + ".fi\n";
  }
  return text;
}

constexpr const char* kFooter = R"(Examples:
  ringfilm completion bash > ~/.local/share/bash-completion/completions/ringfilm
  source <(ringfilm completion zsh)
  ringfilm completion fish > ~/.config/fish/completions/ringfilm.fish
  ringfilm completion man > ~/.local/share/man/man1/ringfilm.1

Commands and options are completed, with bash and zsh the keys of a case after --set, too.
)";

void declare(CommandOptions& add, CompletionOptions& options) {
  add.choice("SHELL", options.shell,
             {{"bash", Shell::kBash}, {"zsh", Shell::kZsh}, {"fish", Shell::kFish}, {"man", Shell::kManual}},
             "bash, zsh, fish, or man for the page of the manual", "")
      ->required();
}

}  // namespace

void add_completion_command(Program& program) {
  program.add<CompletionOptions>("completion", "Print what a shell completes, or the page of the manual", kFooter,
                                 declare, [&app = program.app](const CompletionOptions& options) {
                                   switch (options.shell) {
                                     case Shell::kBash:
                                       std::cout << bash_text(app);
                                       break;
                                     case Shell::kZsh:
                                       std::cout << "autoload -U bashcompinit && bashcompinit\n" << bash_text(app);
                                       break;
                                     case Shell::kFish:
                                       std::cout << fish_text(app);
                                       break;
                                     case Shell::kManual:
                                       std::cout << manual_text(app);
                                       break;
                                   }
                                 });
}

}  // namespace ringfilm::app
