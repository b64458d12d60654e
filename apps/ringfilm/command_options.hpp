#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "commands/commands.hpp"
#include "faults.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/surface/friction_loop/lateral_force_calibration.hpp"

namespace ringfilm::app {

/// A whole number from 0 on; nothing for any other text.
std::optional<std::uint64_t> whole_number(std::string_view text);

/// "3x2" as two whole numbers; nothing for any other text.
std::optional<std::pair<std::uint64_t, std::uint64_t>> two_whole_numbers(std::string_view text);

/// The texts between the commas of a list.
std::vector<std::string> comma_separated(const std::string& text);

/// Words with what they stand for.
template <class Choice>
using Choices = std::vector<std::pair<std::string, Choice>>;

/// What a target holds once it is chosen.
template <class Target>
struct ChoiceOf {
  using Type = Target;
};
template <class Target>
struct ChoiceOf<std::optional<Target>> {
  using Type = Target;
};

/// Is the option on the command line?
inline bool is_stated(const CLI::Option* option) { return option->count() > 0; }
bool is_any_stated(const std::vector<const CLI::Option*>& options);

/// The options of one command. Each is declared once: name, target, unit or choices, help. Parsing the command line
/// fills the targets, which must live as long as this; what is wrong with values is kept.
class CommandOptions {
 public:
  explicit CommandOptions(CLI::App& app) : app_(app) {}
  CommandOptions(const CommandOptions&) = delete;
  CommandOptions& operator=(const CommandOptions&) = delete;

  const CLI::App& app() const { return app_; }

  /// What is checked or filled in once all options are read, in the order of these calls. It may throw InputError.
  void rule(std::function<void(Faults&)> rule) { rules_.push_back(std::move(rule)); }
  /// Refuses a command line without the option.
  void require(const CLI::Option* option, const std::string& message, const std::string& remedy);
  /// Applies the rules. Throws InputError with all that is wrong.
  void check();

  /// A text, or several, as they are. @param type how the help calls the value
  template <class Target>
  CLI::Option* text(const std::string& name, Target& target, const std::string& type, const std::string& help) {
    return app_.add_option(name, target, help)->type_name(type);
  }
  /// An option that may be repeated, with one text each time.
  CLI::Option* texts(const std::string& name, std::vector<std::string>& target, const std::string& type,
                     const std::string& help) {
    return text(name, target, type, help)->allow_extra_args(false);
  }

  CLI::Option* flag(const std::string& name, bool& target, const std::string& help) {
    return app_.add_flag(name, target, help);
  }
  /// A flag that stands for one value of the target.
  template <class Target>
  CLI::Option* flag(const std::string& name, Target& target, std::type_identity_t<Target> value,
                    const std::string& help) {
    return app_.add_flag_callback(
        name, [&target, value] { target = value; }, help);
  }
  CLI::Option* json(SummaryForm& target, const std::string& help) {
    return flag("--json", target, SummaryForm::kJson, help);
  }

  /// An option whose text `put` takes; what it throws as InputError is kept.
  CLI::Option* read(const std::string& name, const std::string& type, const std::string& help,
                    std::function<void(const std::string& text)> put);
  /// An option that may be repeated, each text of which `put` takes; what it throws as InputError is kept.
  CLI::Option* read_each(const std::string& name, const std::string& type, const std::string& help,
                         std::function<void(const std::string& text)> put);

  /// A value in `si_unit`. @param example what one could have written
  template <class Target>
  CLI::Option* quantity(const std::string& name, Target& target, const std::string& si_unit, const std::string& example,
                        const std::string& type, const std::string& help) {
    return read(name, type, help,
                [=, this, &target](const std::string& text) { target = quantity_of(name, text, si_unit, example); });
  }
  /// A length above zero [m].
  template <class Target>
  CLI::Option* length(const std::string& name, Target& target, const std::string& example, const std::string& help) {
    return read(name, "LENGTH", help,
                [=, this, &target](const std::string& text) { target = length_of(name, text, example); });
  }
  /// A pressure above zero [Pa].
  template <class Target>
  CLI::Option* pressure(const std::string& name, Target& target, const std::string& example, const std::string& help) {
    return read(name, "PRESSURE", help,
                [=, this, &target](const std::string& text) { target = pressure_of(name, text, example); });
  }
  /// A number without unit between both, ends included; a whole one for a whole target. The help may show its default.
  template <class Target>
  CLI::Option* number(const std::string& name, Target& target, double least, double most, const std::string& example,
                      const std::string& type, const std::string& help) {
    CLI::Option* option = read(name, type, help, [=, this, &target](const std::string& text) {
      const double value = number_of(name, text, least, most, example);
      if (std::is_integral_v<Target> && value != std::floor(value)) {
        throw InputError(name + " " + text + " is not a whole number", "for example " + example);
      }
      target = static_cast<Target>(value);
    });
    option->default_function([&target] { return fmt::format("{}", target); });
    return option;
  }
  /// A whole number from 1 to `most`. @param what it is, with its article
  template <class Target>
  CLI::Option* count(const std::string& name, Target& target, std::uint64_t most, const std::string& what,
                     const std::string& remedy, const std::string& help) {
    return read(name, "N", help, [=, &target](const std::string& text) {
      target = static_cast<Target>(count_of(name, text, most, what, remedy));
    });
  }
  /// A number of threads.
  CLI::Option* threads(const std::string& name, int& target, const std::string& help);
  /// Two counts from 1 to 1000, "3x2".
  CLI::Option* counts(const std::string& name, std::size_t& across, std::size_t& down, const std::string& type,
                      const std::string& help);

  /// One of several words. The help may show that of the default.
  template <class Target>
  CLI::Option* choice(const std::string& name, Target& target, const Choices<typename ChoiceOf<Target>::Type>& choices,
                      const std::string& help, const std::string& type = "WORD") {
    CLI::Option* option =
        read(name, type, help, [=, &target](const std::string& word) { target = chosen(name, word, choices); });
    option->default_function([choices, &target] {
      for (const auto& [word, value] : choices) {
        if (target == value) return word;
      }
      return std::string();
    });
    return option;
  }

  // Values of texts. Each throws InputError with the name of the option.
  double quantity_of(const std::string& name, const std::string& text, const std::string& si_unit,
                     const std::string& example);
  double length_of(const std::string& name, const std::string& text, const std::string& example);
  double pressure_of(const std::string& name, const std::string& text, const std::string& example);
  double number_of(const std::string& name, const std::string& text, double least, double most,
                   const std::string& example);
  /// A value and its standard deviation in `si_unit`, "1" for none.
  surface::Uncertain uncertain_of(const std::string& name, const std::string& text, const std::string& si_unit,
                                  const std::string& example);
  static std::uint64_t count_of(const std::string& name, const std::string& text, std::uint64_t most,
                                const std::string& what, const std::string& remedy);
  template <class Choice>
  static Choice chosen(const std::string& name, const std::string& word, const Choices<Choice>& choices) {
    std::string words;
    for (const auto& [one, choice] : choices) {
      if (one == word) return choice;
      words += (words.empty() ? "" : ", ") + one;
    }
    throw not_a_choice(name, word, words);
  }

  /// Keeps what `read` throws as InputError, of one text among several.
  void collect(const std::function<void()>& read) { faults_.collect(read); }

  /// Those of the program. Built when they are required first, which takes some milliseconds.
  const io::Units& units();

 private:
  /// With the present name of a choice of an earlier version.
  static InputError not_a_choice(const std::string& name, const std::string& word, const std::string& words);

  CLI::App& app_;
  Faults faults_;
  std::vector<std::function<void(Faults&)>> rules_;
  std::optional<io::Units> units_;
};

/// The program, and what each of its commands does once the command line is read.
class Program {
 public:
  CLI::App app;

  template <class Request>
  using CarryOut = std::function<void(const std::type_identity_t<Request>&)>;

  /// Adds a command whose options fill a request. @param parent the program, or one of its commands
  template <class Request>
  void add(CLI::App& parent, const std::string& name, const std::string& description, const std::string& footer,
           void (*declare)(CommandOptions& add, Request& request), CarryOut<Request> carry_out) {
    struct Command {
      explicit Command(CLI::App& app) : options(app) {}
      CommandOptions options;
      Request request{};
    };
    CLI::App* added = parent.add_subcommand(name, description)->footer(footer);
    const auto command = std::make_shared<Command>(*added);
    declare(command->options, command->request);
    actions_.emplace_back(added, [command, carry_out = std::move(carry_out)] {
      command->options.check();
      carry_out(command->request);
    });
  }
  template <class Request>
  void add(const std::string& name, const std::string& description, const std::string& footer,
           void (*declare)(CommandOptions& add, Request& request), CarryOut<Request> carry_out) {
    add(app, name, description, footer, declare, std::move(carry_out));
  }

  /// What the command does that the parsed command line names.
  std::function<void()> action() const;

 private:
  std::vector<std::pair<CLI::App*, std::function<void()>>> actions_;
};

}  // namespace ringfilm::app
