#include "command_options.hpp"

#include <algorithm>
#include <charconv>
#include <tuple>

#include "ringfilm/base/renamed.hpp"
#include "ringfilm/io/text/uncertain_quantity.hpp"

namespace ringfilm::app {

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<std::pair<std::uint64_t, std::uint64_t>> two_whole_numbers(std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto first = whole_number(text.substr(0, cross)), second = whole_number(text.substr(cross + 1));
  return first && second ? std::optional(std::pair(*first, *second)) : std::nullopt;
}

std::vector<std::string> comma_separated(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, comma - begin));
    begin = comma + 1;
  }
  return parts;
}

bool is_any_stated(const std::vector<const CLI::Option*>& options) {
  return std::any_of(options.begin(), options.end(), is_stated);
}

void CommandOptions::require(const CLI::Option* option, const std::string& message, const std::string& remedy) {
  rule([=](Faults& faults) {
    if (!is_stated(option)) faults.refuse(message, remedy);
  });
}

void CommandOptions::check() {
  for (const auto& rule : rules_) collect([&] { rule(faults_); });
  faults_.check();
}

CLI::Option* CommandOptions::read(const std::string& name, const std::string& type, const std::string& help,
                                  std::function<void(const std::string&)> put) {
  const std::function<void(const std::string&)> keep = [this, put = std::move(put)](const std::string& text) {
    collect([&] { put(text); });
  };
  return app_.add_option_function(name, keep, help)->type_name(type);
}

CLI::Option* CommandOptions::read_each(const std::string& name, const std::string& type, const std::string& help,
                                       std::function<void(const std::string&)> put) {
  const std::function<void(const std::vector<std::string>&)> keep =
      [this, put = std::move(put)](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) collect([&] { put(text); });
      };
  return app_.add_option_function(name, keep, help)->type_name(type)->allow_extra_args(false);
}

CLI::Option* CommandOptions::threads(const std::string& name, int& target, const std::string& help) {
  return count(name, target, 1024, "a number of threads", "leave it out for as many as the machine runs at once", help);
}

CLI::Option* CommandOptions::counts(const std::string& name, std::size_t& across, std::size_t& down,
                                    const std::string& type, const std::string& help) {
  return read(name, type, help, [name, &across, &down](const std::string& text) {
    const auto is_count = [](std::uint64_t number) { return number >= 1 && number <= 1000; };
    const auto numbers = two_whole_numbers(text);
    if (!numbers || !is_count(numbers->first) || !is_count(numbers->second)) {
      throw InputError(name + " " + text + ": these are not two counts from 1 to 1000", "for example " + name + " 3x2");
    }
    std::tie(across, down) = *numbers;
  });
}

double CommandOptions::quantity_of(const std::string& name, const std::string& text, const std::string& si_unit,
                                   const std::string& example) {
  try {
    return units().quantity(text, si_unit, "\"" + example + "\"");
  } catch (const io::UnitError& problem) {
    throw InputError(name + " \"" + text + "\" " + problem.what(), problem.remedy);
  }
}

double CommandOptions::length_of(const std::string& name, const std::string& text, const std::string& example) {
  const double value = quantity_of(name, text, "m", example);
  if (value > 0) return value;
  throw InputError(name + " \"" + text + "\" is not a length above zero", "for example \"" + example + "\"");
}

double CommandOptions::pressure_of(const std::string& name, const std::string& text, const std::string& example) {
  const double value = quantity_of(name, text, "Pa", example);
  if (value > 0) return value;
  throw InputError(name + " \"" + text + "\" is not above 0", "for example \"" + example + "\"");
}

double CommandOptions::number_of(const std::string& name, const std::string& text, double least, double most,
                                 const std::string& example) {
  const double value = uncertain_of(name, text, "1", example).value;
  if (value >= least && value <= most) return value;
  throw InputError(fmt::format("{} {} is not between {} and {}", name, text, least, most), "for example " + example);
}

surface::Uncertain CommandOptions::uncertain_of(const std::string& name, const std::string& text,
                                                const std::string& si_unit, const std::string& example) {
  try {
    return io::uncertain_quantity(text, si_unit, "\"" + example + "\"", units());
  } catch (const io::UnitError& problem) {
    throw InputError(name + " \"" + text + "\" " + problem.what(), problem.remedy);
  }
}

std::uint64_t CommandOptions::count_of(const std::string& name, const std::string& text, std::uint64_t most,
                                       const std::string& what, const std::string& remedy) {
  const auto value = whole_number(text);
  if (value && *value >= 1 && *value <= most) return *value;
  throw InputError(fmt::format("{} {}: this is not {} from 1 to {}", name, text, what, most), remedy);
}

const io::Units& CommandOptions::units() {
  if (!units_) units_.emplace();
  return *units_;
}

InputError CommandOptions::not_a_choice(const std::string& name, const std::string& word, const std::string& words) {
  const std::string present(present_name(name + " " + word));
  return InputError(name + " " + word + ": this is not a choice",
                    (present.empty() ? "" : "did you mean " + present + "? ") + ("one of: " + words));
}

std::function<void()> Program::action() const {
  for (const auto& [command, action] : actions_) {
    if (command->parsed()) return action;
  }
  return {};
}

}  // namespace ringfilm::app
