#include "text/pad_summary.hpp"

#include <fmt/format.h>

#include <cmath>

#include "text/engineering_text.hpp"
#include "text/summary.hpp"

namespace ringfilm::app {
namespace {

constexpr int kPadValueWidth = 14;

std::string values_table(const pad::Sample& sample, const cycle::Pad& pad) {
  const EngineeringText in_words;
  std::string text;
  const auto append = [&](const std::vector<pad::PadQuantity>& quantities) {
    for (const pad::PadQuantity& quantity : quantities) {
      const double value = sample.*quantity.value;
      if (std::isnan(value) || quantity.name == "time") continue;
      text += fmt::format("{:>{}}   {}\n", in_words(quantity, value), kPadValueWidth, quantity.long_name);
    }
  };
  append(pad::pad_quantities());
  if (pad.width) append(pad::width_quantities());
  for (const pad::FrontQuantity& quantity : pad::front_quantities()) {
    for (const double place : sample.*quantity.value) {
      text += fmt::format("{:>{}}   {}\n", in_words(quantity, place), kPadValueWidth, quantity.long_name);
    }
  }
  return text;
}

std::string solver_line(const pad::Effort& effort) {
  std::string text = fmt::format("solver: {} Newton iterations", effort.newton_iterations);
  if (effort.time_steps > 0) text += fmt::format(" in {} time steps", effort.time_steps);
  return text + "\n";
}

}  // namespace

std::string pad_summary(const cycle::Case& input, const io::PadDocument& document) {
  const pad::PadResult& result = document.result;
  const pad::Sample& last = result.samples.back();
  const cycle::Pad& pad = input.pad;
  const std::string size =
      pad.width ? fmt::format("{:.6g} x {}", number_in(pad.length, kMillimetre), text_in(*pad.width, kMillimetre))
                : text_in(pad.length, kMillimetre);
  std::string text =
      fmt::format("{}\npad of {}, {:.6g} m/s towards {}; {}\n\n", document.title, size, pad.speed,
                  pad.direction == cycle::Direction::kPlusX ? "+x" : "-x",
                  pad.width ? "what is reported per metre of width is the mean over it" : "all per metre of width");
  if (result.effort.time_steps > 0)
    text += fmt::format("at {:.6g} s, the last of {} instants\n", last.time, result.samples.size());
  text += values_table(last, pad) + "\n" + solver_line(result.effort) + default_input_lines(document.inputs);
  for (const std::string& note : document.input_notes) text += "note: " + note + "\n";
  for (const auto& [topic, message, count] : result.notes) {
    text += "note: " + message + (count > 1 ? fmt::format(" ({} times)", count) : "") + "\n";
  }
  return text;
}

}  // namespace ringfilm::app
