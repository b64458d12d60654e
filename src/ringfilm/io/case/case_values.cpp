#include "ringfilm/io/case/case_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "ringfilm/base/number_text.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_table.hpp"

namespace ringfilm::io {
namespace {

using Kind = TomlValue::Kind;

double within_cycle(double angle_deg) {
  const double wrapped = std::fmod(angle_deg, 720.0);
  return wrapped < 0 ? wrapped + 720.0 : wrapped + 0.0;
}

/// Does the text start with a number, and is it no file name?
bool is_quantity(const std::string& text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool file_name = text.size() > 4 && text.compare(text.size() - 4, 4, ".csv") == 0;
  return error == std::errc{} && !file_name;
}

class Setter {
 public:
  Setter(cycle::Case& c, const cycle::Field& field, const TomlEntry& entry, const Units& units,
         std::vector<Fault>& faults)
      : case_(c),
        field_(field),
        entry_(entry),
        value_(entry.value),
        units_(units),
        faults_(faults),
        n_before_(faults.size()) {}

  void operator()(const cycle::NumberKind& kind) {
    if (const auto x = quantity(value_, field_.unit, field_.example)) kind.ref(case_) = *x;
  }
  void operator()(const cycle::OptionalNumberKind& kind) {
    if (const auto x = quantity(value_, field_.unit, field_.example)) kind.ref(case_) = *x;
  }
  void operator()(const cycle::CountKind& kind) {
    if (value_.kind != Kind::kInteger) {
      refuse(value_, "is not a whole number", "a whole number is required here, for example " + field_.example);
    } else if (in_range(value_, value_.number)) {
      kind.ref(case_) = static_cast<int>(value_.number);
    }
  }
  void operator()(const cycle::ChoiceKind& kind) {
    const auto found = std::find(kind.names.begin(), kind.names.end(), value_.text);
    if (value_.kind == Kind::kText && found != kind.names.end()) {
      kind.choose(case_, static_cast<int>(found - kind.names.begin()));
      return;
    }
    std::string names;
    for (const std::string& name : kind.names) names += (names.empty() ? "" : ", ") + quoted(name);
    const std::string near = nearest_word(value_.text, kind.names);
    refuse(value_, near.empty() ? "is not known" : "is not known; did you mean " + quoted(near) + "?",
           kind.names.size() == 1 ? "the only choice is " + names : "choose one of " + names);
  }
  void operator()(const cycle::TextKind& kind) {
    constexpr std::size_t kMax = 1000;
    if (!is_text()) return;
    if (value_.text.size() > kMax) {
      refuse(value_, "has " + std::to_string(value_.text.size()) + " characters",
             "at the most " + std::to_string(kMax) + " are kept with a result; a longer text can be a comment");
    } else {
      kind.ref(case_) = value_.text;
    }
  }
  void operator()(const cycle::OptionalTextKind& kind) {
    if (!is_text()) return;
    kind.ref(case_) = field_.key == "lubricant.file" ? located() : value_.text;
  }
  void operator()(const cycle::FileKind& kind) {
    if (is_text()) kind.ref(case_) = located();
  }
  void operator()(const cycle::OptionalFileKind& kind) {
    if (is_text()) kind.ref(case_) = located();
  }
  void operator()(const cycle::NumberOrFileKind& kind) {
    if (value_.kind == Kind::kText && !value_.text.empty() && !is_quantity(value_.text)) {
      if (is_text()) kind.file(case_) = located();
    } else if (const auto x = quantity(value_, field_.unit, field_.example)) {
      kind.number(case_) = *x;
    }
  }
  void operator()(const cycle::OptionalNumberOrFileKind& kind) {
    if (value_.kind == Kind::kText && !value_.text.empty() && !is_quantity(value_.text)) {
      if (is_text()) kind.ref(case_) = {std::nullopt, located(), std::nullopt, std::nullopt};
    } else if (const auto x = quantity(value_, field_.unit, field_.example)) {
      kind.ref(case_) = {*x, std::nullopt, std::nullopt, std::nullopt};
    }
  }
  void operator()(const cycle::UnitNameKind& kind) {
    if (!is_text()) return;
    try {
      const double size = is_quantity(value_.text) ? units_.quantity(value_.text, field_.unit, field_.example)
                                                   : units_.scale(value_.text, field_.unit).to_si(1);
      if (in_range(value_, size)) kind.ref(case_) = size;
    } catch (const UnitError& problem) {
      refuse(value_, problem.what(), dimension_words(field_.unit) + " is required here, for example " + field_.example);
    }
  }
  void operator()(const cycle::NumberListKind& kind) {
    std::vector<double> numbers;
    for (const TomlValue& item : list("a list of numbers")) {
      if (!item.is_number()) {
        refuse(item, "is not a number", "bare numbers are required here");
      } else if (finite(item)) {
        numbers.push_back(item.number);
      }
    }
    if (good()) kind.ref(case_) = numbers;
  }
  void operator()(const cycle::TemperatureValuesKind& kind) {
    std::vector<cycle::TemperatureValue> points;
    for (const TomlValue& item : list("a list of values at temperatures")) points.push_back(temperature_value(item));
    std::stable_sort(points.begin(), points.end(),
                     [](const auto& a, const auto& b) { return a.temperature < b.temperature; });
    if (good()) kind.ref(case_) = points;
  }
  void operator()(const cycle::ConstantOrTemperatureValuesKind& kind) {
    if (value_.kind == Kind::kList) {
      (*this)(cycle::TemperatureValuesKind{kind.ref});
      if (good()) kind.constant(case_).reset();
    } else if (const auto x = quantity(value_, field_.unit, "\"850 kg/m3\"")) {
      kind.constant(case_) = *x;
      kind.ref(case_).clear();
    }
  }
  void operator()(const cycle::StrokeValuesKind& kind) {
    std::vector<cycle::StrokeValue> points;
    if (value_.kind == Kind::kList) {
      for (const TomlValue& item : list("a list of distances and values")) {
        if (item.kind != Kind::kList || item.items.size() != 2) {
          refuse(item, "is not a distance and a value", "for example " + field_.example);
          continue;
        }
        const auto distance = plain_quantity(item.items[0], "m", "\"79.5 mm\"");
        const auto value = quantity(item.items[1], field_.unit, field_.example);
        if (distance && value) points.push_back({*distance, *value});
      }
    } else if (const auto value = quantity(value_, field_.unit, field_.example)) {
      points.push_back({0, *value});
    }
    if (good()) kind.ref(case_) = points;
  }
  void operator()(const cycle::FourierTermsKind& kind) {
    std::vector<cycle::FourierTerm> terms;
    for (const TomlValue& item : list("a list of orders")) terms.push_back(fourier_term(item, kind));
    if (good()) kind.ref(case_) = terms;
  }
  void operator()(const cycle::DistillationKind& kind) {
    std::vector<models::OilFraction> fractions;
    for (const TomlValue& item : list("a list of fractions")) fractions.push_back(oil_fraction(item));
    if (good()) kind.ref(case_) = fractions;
  }
  void operator()(const cycle::CornersKind& kind) {
    models::SectionPolygon corners;
    for (const TomlValue& item : list("a list of corners")) {
      if (item.kind != Kind::kList || item.items.size() != 2) {
        refuse(item, "is not an axial and a radial length", "for example " + field_.example);
        continue;
      }
      const auto axial = quantity(item.items[0], field_.unit, "\"1.2 mm\"");
      const auto radial = quantity(item.items[1], field_.unit, "\"3.5 mm\"");
      if (axial && radial) corners.push_back({*axial, *radial});
    }
    if (good()) kind.ref(case_) = corners;
  }
  void operator()(const cycle::AnglesKind&) {
    if (value_.kind == Kind::kList) {
      const std::vector<double> listed = angles();
      if (good()) case_.output.crank_angles_deg = listed;
    } else if (const auto step = quantity(value_, field_.unit, field_.example)) {
      case_.output.crank_angle_step_deg = *step;
    }
  }
  void operator()(const cycle::FieldAnglesKind&) {
    if (value_.kind == Kind::kText && (value_.text == "none" || value_.text == "all")) {
      case_.output.fields = value_.text == "all" ? cycle::FieldOutput::kAll : cycle::FieldOutput::kNone;
    } else if (value_.kind == Kind::kList) {
      const std::vector<double> listed = angles();
      if (!good()) return;
      case_.output.fields = cycle::FieldOutput::kListed;
      case_.output.field_angles_deg = listed;
    } else {
      refuse(value_, "is not known",
             "write \"none\", \"all\", or a list of angles such as [\"0 degree\", \"20 degree\"]");
    }
  }

  bool good() const { return faults_.size() == n_before_; }

 private:
  void refuse(const TomlValue& value, const std::string& predicate, const std::string& remedy) {
    faults_.push_back(value_fault(entry_.key, value, predicate, remedy));
  }

  std::string located() const { return locate(value_.text, entry_.folder).shown; }

  bool is_text() {
    const std::string control = control_character_words(value_.text, LinesAndTabs::kRefused);
    if (!control.empty()) {
      refuse(value_, control, kControlCharacterRemedy);
      return false;
    }
    if (value_.kind == Kind::kText && !value_.text.empty()) return true;
    refuse(value_, value_.kind == Kind::kText ? "is empty" : "is not text",
           "text in quotes is required here, for example " + field_.example);
    return false;
  }

  bool finite(const TomlValue& value) {
    if (std::isfinite(value.number)) return true;
    refuse(value, "is not a finite number", "for example " + field_.example);
    return false;
  }

  bool in_range(const TomlValue& value, double number) {
    if (!field_.range || field_.range->contains(number)) return true;
    refuse(value, "is out of range",
           "allowed is " + range_words(field_, units_) + omission_words(number) + share_words(number));
    return false;
  }

  /// A share that was written in percent.
  std::string share_words(double number) const {
    constexpr double kWhole = 100;  // [%]
    const bool is_share = field_.unit == "1" && field_.range->low >= 0 && field_.range->high == 1;
    if (!is_share || !(number >= 2 && number <= kWhole)) return "";
    return "; it is a share: write " + number_text(number / kWhole, 4) + " for " + number_text(number, 4) + " %";
  }

  /// "0.8" of "80 %".
  static std::optional<std::string> number_of_percentage(const std::string& text) {
    char* end = nullptr;
    const double percentage = std::strtod(text.c_str(), &end);
    const std::string rest = end;
    if (end == text.c_str() || rest.find_first_not_of(' ') == std::string::npos ||
        rest.substr(rest.find_first_not_of(' ')) != "%") {
      return std::nullopt;
    }
    return number_text(percentage / 100, 4);
  }

  /// What happens without the key, of an optional one that is stated as zero where that is not allowed.
  std::string omission_words(double number) const {
    const std::string begin = "if omitted, ";
    const std::size_t at = field_.help.find(begin);
    if (number != 0 || at == std::string::npos) return "";
    return "; omit it where it is not there: then " + field_.help.substr(at + begin.size());
  }

  /// A number with its unit in SI, checked against nothing but its dimension.
  std::optional<double> plain_quantity(const TomlValue& value, const std::string& unit, const std::string& example) {
    try {
      if (unit == "1" && value.kind == Kind::kText) {
        throw UnitError("is text", "a number without unit is required here, for example " +
                                       number_of_percentage(value.text).value_or(example));
      }
      return quantity_of(value, unit, example, units_);
    } catch (const UnitError& problem) {
      refuse(value, problem.what(), problem.remedy);
      return std::nullopt;
    }
  }

  std::optional<double> quantity(const TomlValue& value, const std::string& unit, const std::string& example) {
    const auto x = plain_quantity(value, unit, example);
    return x && in_range(value, *x) ? x : std::nullopt;
  }

  const std::vector<TomlValue>& list(const std::string& what) {
    if (value_.kind != Kind::kList) {
      refuse(value_, "is not " + what, "for example " + field_.example);
    } else if (value_.items.empty()) {
      refuse(value_, "is empty", "for example " + field_.example);
    }
    return value_.items;
  }

  std::vector<double> angles() {
    std::vector<double> angles;
    for (const TomlValue& item : list("a list of crank angles")) {
      // The one place where a bare number has a unit: crank angles are degrees on every axis and in every file.
      const auto angle = item.is_number() ? plain_quantity(item, "1", "20")
                                          : plain_quantity(item, "degree", "[\"0 degree\", \"20 degree\"]");
      if (!angle) continue;
      if (std::abs(*angle) > 720) {
        refuse(item, "is more than a cycle", "angles from -360 to 360 or from 0 to 720 degree are required here");
      }
      angles.push_back(within_cycle(*angle));
    }
    std::sort(angles.begin(), angles.end());
    const auto twice = std::adjacent_find(angles.begin(), angles.end());
    if (good() && twice != angles.end()) {
      refuse(value_, "has the angle " + exact_text(*twice) + " degree twice", "keep one of them");
    }
    return angles;
  }

  cycle::TemperatureValue temperature_value(const TomlValue& item) {
    const TomlValue *temperature = item.find("temperature"), *value = item.find("value");
    const std::string remedy = "for example " + field_.example;
    refuse_unknown_keys(item, field_.key, {"temperature", "value"}, faults_);
    if (temperature == nullptr || value == nullptr) {
      refuse(item, "requires a temperature and a value", remedy);
      return {};
    }
    const auto T = plain_quantity(*temperature, "K", "\"40 degC\"");
    if (T && (*T < 150 || *T > 800)) refuse(*temperature, "is out of range", "allowed is -123 degC to 527 degC");
    const auto x = quantity(*value, field_.unit, "\"1 " + field_.display_unit + "\"");
    return T && x ? cycle::TemperatureValue{*T, *x} : cycle::TemperatureValue{};
  }

  cycle::FourierTerm fourier_term(const TomlValue& item, const cycle::FourierTermsKind& kind) {
    std::vector<std::string> known = {"order", "amplitude", "phase"};
    if (kind.place == cycle::FourierTermsKind::Place::kAlongStroke) known.emplace_back("height");
    refuse_unknown_keys(item, field_.key, known, faults_);
    const TomlValue *order = item.find("order"), *amplitude = item.find("amplitude");
    if (order == nullptr || amplitude == nullptr) {
      refuse(item, "requires an order and an amplitude", "for example " + field_.example);
      return {};
    }
    cycle::FourierTerm term;
    term.order = whole_order(*order, kind.lowest_order);
    const std::string example = field_.unit == "1" ? "0.25" : "\"15 " + field_.display_unit + "\"";
    term.amplitude = quantity(*amplitude, field_.unit, example).value_or(0);
    if (const TomlValue* phase = item.find("phase")) term.phase_deg = within_turn(*phase);
    if (const TomlValue* height = item.find("height")) term.height = plain_quantity(*height, "m", "\"20 mm\"");
    return term;
  }

  models::OilFraction oil_fraction(const TomlValue& item) {
    refuse_unknown_keys(item, field_.key, {"share", "boiling_point", "molar_mass"}, faults_);
    const TomlValue *share = item.find("share"), *boiling_point = item.find("boiling_point");
    if (share == nullptr || boiling_point == nullptr) {
      refuse(item, "requires a share and a boiling point", "for example " + field_.example);
      return {};
    }
    models::OilFraction fraction;
    if (const auto x = plain_quantity(*share, "1", "0.3")) {
      if (!(*x > 0 && *x <= 1)) refuse(*share, "is out of range", "allowed is above 0 to 1");
      fraction.share = *x;
    }
    if (const auto T = plain_quantity(*boiling_point, "K", "\"440 degC\"")) {
      if (!(*T > 300 && *T < models::kMaxBoilingPoint)) {
        refuse(*boiling_point, "is out of range", "allowed is above 26.85 degC to below 806.85 degC");
      }
      fraction.boiling_point = *T;
    }
    if (const TomlValue* molar_mass = item.find("molar_mass")) {
      const auto M = plain_quantity(*molar_mass, "kg/mol", "\"380 g/mol\"");
      if (M && !(*M >= 0.01 && *M <= 10)) refuse(*molar_mass, "is out of range", "allowed is 10 to 10000 g/mol");
      fraction.molar_mass = M;
    }
    return fraction;
  }

  int whole_order(const TomlValue& value, int lowest) {
    constexpr int kMax = 60;
    if (value.kind == Kind::kInteger && value.number >= lowest && value.number <= kMax) {
      return static_cast<int>(value.number);
    }
    refuse(value, "is not an order",
           "a whole number from " + std::to_string(lowest) + " to " + std::to_string(kMax) + " is required here");
    return lowest;
  }

  double within_turn(const TomlValue& value) {
    const auto angle = plain_quantity(value, "degree", "\"30 degree\"");
    if (angle && std::abs(*angle) > 360) {
      refuse(value, "is more than a turn", "angles from -360 to 360 degree are required here");
    }
    return angle.value_or(0);
  }

  cycle::Case& case_;
  const cycle::Field& field_;
  const TomlEntry& entry_;
  const TomlValue& value_;
  const Units& units_;
  std::vector<Fault>& faults_;
  std::size_t n_before_;
};

}  // namespace

bool set_value(cycle::Case& c, const cycle::Field& field, const TomlEntry& entry, const Units& units,
               std::vector<Fault>& faults) {
  Setter setter(c, field, entry, units, faults);
  std::visit(setter, field.kind);
  return setter.good();
}

std::string range_words(const cycle::Field& field, const Units& units) {
  if (!field.range) return "";
  const cycle::Range& range = *field.range;
  const std::string low = units.shown(range.low, field.unit, field.display_unit);
  const std::string high = units.shown(range.high, field.unit, field.display_unit);
  return (range.low_open ? "above " : "") + low.substr(0, low.find(' ')) + (range.high_open ? " to below " : " to ") +
         high;
}

}  // namespace ringfilm::io
