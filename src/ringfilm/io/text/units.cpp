#include "ringfilm/io/text/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/printable_text.hpp"
#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/empirical_units.hpp"

namespace ringfilm::io {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};

// UDUNITS keeps the state of its parser and its last status in static variables: one caller at a time.
std::mutex& udunits_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// Names that engineers write and UDUNITS does not contain, by the names that it contains.
constexpr std::array<std::pair<const char*, const char*>, 18> kOurNames{{{"cP", "0.001 Pa.s"},
                                                                         {"deg", "degree"},
                                                                         {"degCA", "degree"},
                                                                         {"degreeCA", "degree"},
                                                                         {"degKW", "degree"},
                                                                         {"degreeKW", "degree"},
                                                                         {"CAD", "degree"},
                                                                         {"rev", "revolution"},
                                                                         {"gon", "0.9 degree"},
                                                                         {"bara", "bar"},
                                                                         {"psia", "psi"},
                                                                         {"mPas", "0.001 Pa.s"},
                                                                         {"thou", "0.001 inch"},
                                                                         {"Msi", "1e6 psi"},
                                                                         {"HV", "9.80665e6 Pa"},
                                                                         {"HB", "9.80665e6 Pa"},
                                                                         {"HBS", "9.80665e6 Pa"},
                                                                         {"HBW", "9.80665e6 Pa"}}};

/// The degree as German exports name it; UDUNITS would read Grad as 1e9 rad. Case matters: the grad of English texts is
/// another unit, and is refused.
constexpr std::array<const char*, 2> kGermanDegrees{"Grad", "GRAD"};

/// Words that name the crank behind the unit of its angle: "Grad KW", "deg CA".
constexpr std::array<const char*, 2> kOfTheCrank{" KW", " CA"};

bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&word](const char* w) { return word == w; });
}

/// Signs that a keyboard or a word processor puts into units, as UDUNITS writes them in ASCII.
std::string in_ascii(std::string text) {
  constexpr std::array<std::pair<const char*, const char*>, 10> kSigns{{{"\u00B0C", "degC"},
                                                                        {"\u00B0F", "degF"},
                                                                        {"\u00B0", "degree"},
                                                                        {"\u00B5", "u"},
                                                                        {"\u03BC", "u"},
                                                                        {"\u00B2", "2"},
                                                                        {"\u00B3", "3"},
                                                                        {"\u207B\u00B9", "-1"},
                                                                        {"\u207B", "-"},
                                                                        {"\u00B7", "."}}};
  for (const auto& [sign, ascii] : kSigns) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign)) {
      text.replace(at, std::string_view(sign).size(), ascii);
    }
  }
  return text;
}

/// Spaces that a word processor puts between number and unit, as plain ones.
std::string with_plain_spaces(std::string text) {
  for (const std::string_view space : {"\u00A0", "\u202F", "\u2009"}) {
    for (std::size_t at = text.find(space); at != std::string::npos; at = text.find(space))
      text.replace(at, space.size(), " ");
  }
  return text;
}

/// "degree KW" as "degree".
std::string without_crank(std::string unit) {
  const bool is_angle = std::any_of(kGermanDegrees.begin(), kGermanDegrees.end(),
                                    [&](const char* word) { return unit.starts_with(word); }) ||
                        unit.starts_with("deg");
  for (const std::string_view word : kOfTheCrank) {
    if (is_angle && unit.ends_with(word)) unit.resize(unit.size() - word.size());
  }
  return trimmed(unit);
}

/// A hardness without the load of its test: "HV10", "HV 0.3" and "HBW 2.5/187.5" as "HV" and "HBW".
std::string without_test_load(const std::string& unit) {
  for (const std::string_view name : {"HV", "HBW", "HBS", "HB"}) {
    if (!unit.starts_with(name)) continue;
    return unit.find_first_not_of("0123456789./ ", name.size()) == std::string::npos ? std::string(name) : unit;
  }
  return unit;
}

/// The pound of a force: where a force is required, "lb" and "lbs" mean "lbf".
std::string with_pound_force(const std::string& unit, const std::string& si_unit) {
  if (!is_one_of(si_unit, {"N", "N/m", "Pa", "N m"})) return unit;
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  std::string result;
  for (std::size_t i = 0; i < unit.size();) {
    std::size_t end = i;
    while (end < unit.size() && is_letter(unit[end])) ++end;
    const std::string word = unit.substr(i, std::max<std::size_t>(end - i, 1));
    result += word == "lb" || word == "lbs" ? "lbf" : word;
    i += word.size();
  }
  return result;
}

/// A unit as people write it that is not read, and the unit that it most likely means.
struct Mistaken {
  const char* written;  ///< in small letters
  const char* unit;
  const char* si_unit;
};
constexpr std::array<Mistaken, 16> kMistaken{{{"grad", "degree, or gon", "degree"},
                                              {"grad", "degree, or gon", "rad"},
                                              {"rpm", "rpm", "rad/s"},
                                              {"u/min", "rpm", "rad/s"},
                                              {"umdr/min", "rpm", "rad/s"},
                                              {"r/min", "rpm", "rad/s"},
                                              {"tr/min", "rpm", "rad/s"},
                                              {"1/min", "rpm", "rad/s"},
                                              {"min-1", "rpm", "rad/s"},
                                              {"bar", "bar", "Pa"},
                                              {"kpa", "kPa", "Pa"},
                                              {"mpa", "MPa", "Pa"},
                                              {"gpa", "GPa", "Pa"},
                                              {"psi", "psi", "Pa"},
                                              {"mm", "mm", "m"},
                                              {"micron", "um", "m"}}};

/// What to write instead of a unit that is not read as `si_unit`; empty where it is not known.
std::string unit_remedy(std::string unit, const std::string& si_unit) {
  for (char& c : unit) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const Mistaken& one : kMistaken) {
    if (unit == one.written && si_unit == one.si_unit) return std::string("write ") + one.unit;
  }
  return "";
}

bool is_gauge(const std::string& unit) {
  return is_one_of(unit, {"barg", "bar g", "bar(g)", "bar (g)", "barG", "psig", "psi g", "psi(g)", "kPag", "kPa(g)",
                          "kPa g", "mbarg", "MPag", "MPa(g)"});
}

/// A second number inside a unit ("1 500 rpm") would be read as a scale.
bool holds_number(const std::string& unit) {
  bool word_starts = true;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const char c = unit[i];
    const bool reciprocal = i == 0 && unit.rfind("1/", 0) == 0;
    if (word_starts && !reciprocal && ((c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == ',')) {
      return true;
    }
    word_starts = c == ' ' || c == '(';
  }
  return unit.find('@') != std::string::npos;
}

bool names_rotation(const std::string& unit) {
  constexpr std::array kWords{"rpm", "rps", "rev", "rad", "RAD", "deg", "gon", "turn", "CAD", "arc"};
  return std::any_of(kWords.begin(), kWords.end(),
                     [&unit](const char* word) { return unit.find(word) != std::string::npos; });
}

double snapped(double scale) {
  const double nearest = std::round(scale);
  return std::abs(scale - nearest) <= 1e-12 * std::abs(scale) ? nearest : scale;
}

UnitError wrong_dimension(const std::string& unit, const std::string& si_unit) {
  return {"is not " + dimension_words(si_unit) + ": \"" + unit + "\" measures something else",
          unit_remedy(unit, si_unit)};
}

Scale temperature_scale(const std::string& unit) {
  if (is_one_of(unit, {"K", "kelvin", "Kelvin", "degK"})) return {};
  if (is_one_of(unit, {"degC", "celsius", "Celsius", "degree_Celsius", "degrees_Celsius", "degree_C", "deg_C"})) {
    return {1, 1, base::kZeroCelsius};
  }
  if (is_one_of(unit, {"degF", "fahrenheit", "Fahrenheit", "degree_Fahrenheit", "degree_F", "deg_F"})) {
    return {5, 9, 459.67 * 5 / 9};
  }
  const bool letter = is_one_of(unit, {"C", "F", "c"});
  throw UnitError("is not a temperature: \"" + unit + "\"" + (letter ? " is not a unit of temperature" : ""),
                  "write degC, K or degF");
}

/// The table of UDUNITS that a program carries with it where the system has none; the user's own choice comes first.
std::optional<std::string> shipped_table_of_units() {
  if (std::getenv("UDUNITS2_XML_PATH") != nullptr) return std::nullopt;
  const std::optional<std::string> shipped = find_shipped_folder();
  if (!shipped) return std::nullopt;
  const std::filesystem::path table = std::filesystem::path(*shipped) / "udunits" / "udunits2.xml";
  std::error_code error;
  if (!std::filesystem::is_regular_file(table, error)) return std::nullopt;
  return table.string();
}

}  // namespace

struct Units::System {
  ut_system* system = nullptr;

  System() {
    const std::lock_guard lock(udunits_mutex());
    ut_set_error_message_handler(ut_ignore);
    const std::optional<std::string> shipped = shipped_table_of_units();
    system = ut_read_xml(shipped ? shipped->c_str() : nullptr);
    if (system == nullptr) {
      throw InputError("the table of units of UDUNITS-2 is not found",
                       "install the package libudunits2-data, or set UDUNITS2_XML_PATH");
    }
    for (const auto& [name, definition] : kOurNames) {
      const Unit unit(ut_parse(system, definition, UT_ASCII));
      ut_map_name_to_unit(name, UT_ASCII, unit.get());
    }
    const Unit degree(ut_parse(system, "degree", UT_ASCII));
    for (const char* name : kGermanDegrees) ut_map_symbol_to_unit(name, UT_ASCII, degree.get());
  }
  ~System() {
    const std::lock_guard lock(udunits_mutex());
    ut_free_system(system);
  }
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  Unit parse(const std::string& text) const { return Unit(ut_parse(system, text.c_str(), UT_ASCII)); }

  /// Equal dimensions; UDUNITS itself would also turn um2 over into um-2.
  bool same_dimension(const ut_unit* a, const ut_unit* b) const {
    const Unit ratio(ut_divide(a, b));
    return ratio != nullptr && ut_is_dimensionless(ratio.get()) != 0;
  }
};

Units::Units()
    : system_([] {
        static const auto system = std::make_shared<const System>();
        return system;
      }()) {}

Scale Units::scale(const std::string& written, const std::string& si_unit) const {
  const std::string named = without_crank(in_ascii(trimmed(with_plain_spaces(written))));
  if (named == si_unit || (named == "-" && si_unit == "1")) return {};
  const std::string unit = with_pound_force(without_test_load(named), si_unit);
  if (is_empirical_unit(unit)) {
    throw UnitError("has the unit \"" + unit + "\", which no factor converts",
                    unit == "HRC" ? "write HV, HB or GPa" : "write mm2/s");
  }
  if (is_gauge(unit)) {
    throw UnitError("is a gauge pressure",
                    "pressures are absolute here: add the atmosphere (1.01325 bar) and write bar");
  }
  if (si_unit == "K") return temperature_scale(unit);
  constexpr std::size_t kMaxUnit = 60;
  if (unit.size() > kMaxUnit) throw UnitError("has a text in place of its unit", "");
  if (find_control_character(unit) != std::string::npos) throw UnitError("has a control character in its unit", "");
  if (unit == "1") throw UnitError("is dimensionless, not " + dimension_words(si_unit), "write its unit");
  if (holds_number(unit))
    throw UnitError("has a second number in its unit \"" + unit + "\"", "write one number, one unit");

  const std::lock_guard lock(udunits_mutex());
  const Unit given = system_->parse(unit);
  if (given == nullptr) throw UnitError("has an unknown unit \"" + unit + "\"", unit_remedy(unit, si_unit));
  const Unit si = system_->parse(si_unit);
  if (si == nullptr) throw std::logic_error("unit " + si_unit);
  if (!system_->same_dimension(given.get(), si.get())) throw wrong_dimension(unit, si_unit);
  const bool rotation = si_unit == "degree" || si_unit == "rad/s";
  if (rotation && !names_rotation(unit)) {
    throw UnitError("could mean turns or radians: \"" + unit + "\" is ambiguous",
                    si_unit == "degree" ? "write degree or rad" : "write rpm or rad/s");
  }
  const std::unique_ptr<cv_converter, FreeConverter> converter(ut_get_converter(given.get(), si.get()));
  if (converter == nullptr) throw wrong_dimension(unit, si_unit);
  const double factor = cv_convert_double(converter.get(), 1.0) - cv_convert_double(converter.get(), 0.0);
  if (!(std::isfinite(factor) && factor > 0)) throw wrong_dimension(unit, si_unit);
  const double revolution = si_unit == "degree" ? 360 : 2 * std::numbers::pi;
  if ((si_unit == "degree" || si_unit == "rad") && factor > revolution * (1 + 1e-9)) {
    throw UnitError("has the unit \"" + unit + "\", of which one is more than a revolution",
                    "write degree, rad or rev");
  }
  const double inverse = snapped(1 / factor);
  return factor < 1 && inverse == std::round(inverse) ? Scale{1, inverse, 0} : Scale{snapped(factor), 1, 0};
}

bool Units::measures(const std::string& unit, const std::string& si_unit) const {
  try {
    scale(unit, si_unit);
    return true;
  } catch (const UnitError&) {
    return false;
  }
}

double Units::quantity(const std::string& text, const std::string& si_unit, const std::string& example) const {
  const std::string requested = dimension_words(si_unit) + " is required here, for example " + example;
  const auto [value, unit] = leading_number(trimmed(with_plain_spaces(text)), requested);
  if (unit.rfind(',', 0) == 0) throw UnitError("has a decimal comma", "write a decimal point; " + requested);
  if (unit.empty()) throw UnitError(si_unit == "1" ? "is a number in quotes" : "has no unit", requested);
  try {
    const auto by_table = empirical_quantity(value, in_ascii(unit), si_unit);
    const double value_in_si = by_table ? *by_table : scale(unit, si_unit).to_si(value);
    if (!std::isfinite(value_in_si)) throw UnitError("is out of the range of numbers", requested);
    return value_in_si;
  } catch (const UnitError& problem) {
    throw UnitError(problem.what(), problem.remedy.empty() ? requested : problem.remedy);
  }
}

std::string Units::shown(double value_in_si, const std::string& si_unit, const std::string& display_unit,
                         int max_digits) const {
  const std::string number = number_text(scale(display_unit, si_unit).from_si(value_in_si), max_digits);
  return display_unit.empty() || display_unit == "1" ? number : number + " " + display_unit;
}

std::pair<double, std::string> leading_number(const std::string& text, const std::string& requested) {
  const char* begin = text.c_str() + (text.rfind('+', 0) == 0 ? 1 : 0);
  const char* end = text.c_str() + text.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range) throw UnitError("is out of the range of numbers", requested);
  if (error != std::errc{}) throw UnitError("does not start with a number", requested);
  if (!std::isfinite(value)) throw UnitError("is not a finite number", requested);
  return {value, trimmed(std::string(rest, end))};
}

std::string dimension_words(const std::string& si_unit) {
  const std::map<std::string, std::string> words{{"m", "a length"},
                                                 {"N", "a force"},
                                                 {"N/m", "a load per width or a surface tension"},
                                                 {"s", "a time"},
                                                 {"m/s", "a speed"},
                                                 {"Pa", "a pressure"},
                                                 {"K", "a temperature"},
                                                 {"rad/s", "a speed of rotation"},
                                                 {"degree", "an angle"},
                                                 {"m-2", "a number per area"},
                                                 {"m2/s", "a kinematic viscosity"},
                                                 {"kg/m3", "a density"},
                                                 {"Pa s", "a viscosity"},
                                                 {"Pa-1", "a coefficient per pressure"},
                                                 {"K-1", "a coefficient per kelvin"},
                                                 {"W/(m K)", "a thermal conductivity"},
                                                 {"J/(kg K)", "a specific heat"},
                                                 {"%", "a share"},
                                                 {"1", "a number without unit"}};
  const auto found = words.find(si_unit);
  return found == words.end() ? "a quantity in " + si_unit : found->second;
}

std::string exact_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.size() > 2 && text.compare(text.size() - 2, 2, ".0") == 0) text.resize(text.size() - 2);
  return text;
}

}  // namespace ringfilm::io
