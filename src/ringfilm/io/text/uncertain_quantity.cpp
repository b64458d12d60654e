#include "ringfilm/io/text/uncertain_quantity.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "ringfilm/base/trimmed.hpp"

namespace ringfilm::io {
namespace {

/// The words before and after the sign; the second is empty where there is none.
std::pair<std::string, std::string> halves(const std::string& text) {
  constexpr std::array kSigns{"+-", "+/-", "\u00B1"};
  for (const std::string sign : kSigns) {
    const std::size_t at = text.find(sign);
    if (at != std::string::npos) return {trimmed(text.substr(0, at)), trimmed(text.substr(at + sign.size()))};
  }
  return {trimmed(text), ""};
}

/// What follows the number.
std::string unit_behind_number(const std::string& text) {
  double value = 0;
  const char* begin = text.c_str() + (text.rfind('+', 0) == 0 ? 1 : 0);
  const char* end = text.c_str() + text.size();
  return trimmed(std::string(std::from_chars(begin, end, value).ptr, end));
}

double number_of(const std::string& text, const std::string& example) {
  const std::string requested = "a number without unit is required here, for example " + example;
  const auto [value, rest] = leading_number(text, requested);
  if (!rest.empty()) throw UnitError("has more than a number", requested);
  return value;
}

}  // namespace

surface::Uncertain uncertain_quantity(const std::string& text, const std::string& si_unit, const std::string& example,
                                      const Units& units) {
  std::string written = trimmed(text), common_unit;
  if (written.rfind('(', 0) == 0) {
    const std::size_t close = written.find(')');
    if (close == std::string::npos) throw UnitError("has a bracket that is not closed", "for example " + example);
    common_unit = trimmed(written.substr(close + 1));
    written = written.substr(1, close - 1);
  }
  auto [value, deviation] = halves(written);
  if (deviation.empty() && value != trimmed(written)) {
    throw UnitError("has nothing after +-", "for example " + example);
  }
  const bool relative = !deviation.empty() && unit_behind_number(deviation) == "%";
  if (common_unit.empty() && !deviation.empty() && !relative && unit_behind_number(value).empty())
    common_unit = unit_behind_number(deviation);
  const auto read = [&](const std::string& one) {
    const std::string whole = unit_behind_number(one).empty() && !common_unit.empty() ? one + " " + common_unit : one;
    return si_unit == "1" ? number_of(whole, example) : units.quantity(whole, si_unit, example);
  };
  surface::Uncertain result{read(value), 0};
  if (deviation.empty()) return result;
  if (relative) {
    result.deviation =
        number_of(trimmed(deviation.substr(0, deviation.find('%'))), example) / 100 * std::abs(result.value);
  } else {
    result.deviation = read(deviation);
  }
  if (result.deviation < 0) throw UnitError("has a deviation below zero", "for example " + example);
  return result;
}

}  // namespace ringfilm::io
