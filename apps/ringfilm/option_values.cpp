#include "option_values.hpp"

#include <fmt/format.h>

#include <charconv>

#include "ringfilm/base/renamed.hpp"
#include "ringfilm/io/text/uncertain_quantity.hpp"

namespace ringfilm::app {

double OptionValues::quantity(const std::string& option, const std::string& text, const std::string& si_unit,
                              const std::string& example) {
  try {
    return units_.quantity(text, si_unit, "\"" + example + "\"");
  } catch (const io::UnitError& problem) {
    refuse(option + " \"" + text + "\" " + problem.what(), problem.remedy);
    return 0;
  }
}

double OptionValues::positive(const std::string& option, const std::string& text, const std::string& si_unit,
                              const std::string& example) {
  const std::size_t before = faults_.size();
  const double value = quantity(option, text, si_unit, example);
  if (faults_.size() == before && !(value > 0)) {
    refuse(option + " \"" + text + "\" is not above 0", "for example \"" + example + "\"");
  }
  return value;
}

double OptionValues::length(const std::string& option, const std::string& text, const std::string& example) {
  const std::size_t before = faults_.size();
  const double value = quantity(option, text, "m", example);
  if (faults_.size() == before && !(value > 0)) {
    refuse(option + " \"" + text + "\" is not a length above zero", "for example \"" + example + "\"");
  }
  return value;
}

double OptionValues::number(const std::string& option, const std::string& text, double least, double most,
                            const std::string& example) {
  const std::size_t before = faults_.size();
  const double value = uncertain(option, text, "1", example).value;
  if (faults_.size() == before && !(value >= least && value <= most)) {
    refuse(fmt::format("{} {} is not between {} and {}", option, text, least, most), "for example " + example);
  }
  return value;
}

surface::Uncertain OptionValues::uncertain(const std::string& option, const std::string& text,
                                           const std::string& si_unit, const std::string& example) {
  try {
    return io::uncertain_quantity(text, si_unit, "\"" + example + "\"", units_);
  } catch (const io::UnitError& problem) {
    refuse(option + " \"" + text + "\" " + problem.what(), problem.remedy);
    return {};
  }
}

void OptionValues::refuse(const std::string& message, const std::string& remedy) {
  faults_.push_back(Fault{SourceMark{}, message, remedy});
}

std::string OptionValues::renamed_remedy(const std::string& option, const std::string& word,
                                         const std::string& remedy) {
  const std::string present(present_name(option + " " + word));
  return present.empty() ? remedy : "did you mean " + present + "? " + remedy;
}

void OptionValues::check() const {
  if (!faults_.empty()) throw InputError(faults_);
}

int thread_count(const std::string& option, const std::string& text) {
  constexpr int kMost = 1024;
  int threads = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), threads);
  if (error != std::errc() || end != text.data() + text.size() || threads < 1 || threads > kMost) {
    throw InputError(option + " " + text + ": this is not a number of threads from 1 to " + std::to_string(kMost),
                     "leave it out for as many as the machine runs at once");
  }
  return threads;
}

}  // namespace ringfilm::app
