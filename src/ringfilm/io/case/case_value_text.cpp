#include "ringfilm/io/case/case_value_text.hpp"

#include <fmt/format.h>

#include <functional>
#include <limits>

#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {
namespace {

using cycle::Case;
using cycle::Field;

/// How a quantity [SI unit] is put into words.
using Write = std::function<std::string(double value, const std::string& si_unit, const std::string& display_unit)>;

std::string exact_quantity(double value, const std::string& si_unit, const std::string&) {
  return si_unit == "1" ? exact_text(value) : fmt::format("\"{} {}\"", exact_text(value), si_unit);
}

std::string bracketed(const std::vector<std::string>& parts) { return fmt::format("[{}]", fmt::join(parts, ", ")); }

/// Walks the kinds of keys; text, file names and choices come out in quotes.
class Writer {
 public:
  Writer(const Field& field, const Case& c, Write write) : field_(field), case_(c), write_(std::move(write)) {}

  std::string operator()(const cycle::NumberKind& kind) { return number(kind.ref(case_)); }
  std::string operator()(const cycle::OptionalNumberKind& kind) {
    const auto& value = kind.ref(case_);
    return value ? number(*value) : "";
  }
  std::string operator()(const cycle::CountKind& kind) { return std::to_string(kind.ref(case_)); }
  std::string operator()(const cycle::ChoiceKind& kind) { return io::quoted(kind.names[kind.index(case_)]); }
  std::string operator()(const cycle::TextKind& kind) { return text(kind.ref(case_)); }
  std::string operator()(const cycle::OptionalTextKind& kind) { return text(kind.ref(case_).value_or("")); }
  std::string operator()(const cycle::FileKind& kind) { return text(kind.ref(case_)); }
  std::string operator()(const cycle::OptionalFileKind& kind) { return text(kind.ref(case_).value_or("")); }
  std::string operator()(const cycle::NumberOrFileKind& kind) {
    return kind.file(case_) ? io::quoted(*kind.file(case_)) : number(kind.number(case_));
  }
  std::string operator()(const cycle::OptionalNumberOrFileKind& kind) {
    const cycle::LandPressure& pressure = kind.ref(case_);
    if (pressure.file) return io::quoted(*pressure.file);
    return pressure.constant ? number(*pressure.constant) : "";
  }
  std::string operator()(const cycle::UnitNameKind& kind) { return number(kind.ref(case_)); }
  std::string operator()(const cycle::NumberListKind& kind) {
    std::vector<std::string> parts;
    for (const double value : kind.ref(case_)) parts.push_back(exact_text(value));
    return parts.empty() ? "" : bracketed(parts);
  }
  std::string operator()(const cycle::TemperatureValuesKind& kind) {
    std::vector<std::string> parts;
    for (const auto& [temperature, value] : kind.ref(case_)) {
      parts.push_back(
          fmt::format("{{ temperature = {}, value = {} }}", write_(temperature, "K", "degC"), number(value)));
    }
    return parts.empty() ? "" : bracketed(parts);
  }
  std::string operator()(const cycle::ConstantOrTemperatureValuesKind& kind) {
    const auto& constant = kind.constant(case_);
    return constant ? number(*constant) : (*this)(cycle::TemperatureValuesKind{kind.ref});
  }
  std::string operator()(const cycle::StrokeValuesKind& kind) {
    const auto& points = kind.ref(case_);
    if (points.size() == 1) return number(points.front().value);
    std::vector<std::string> parts;
    for (const auto& [distance, value] : points) {
      parts.push_back(fmt::format("[{}, {}]", write_(distance, "m", "mm"), number(value)));
    }
    return parts.empty() ? "" : bracketed(parts);
  }
  std::string operator()(const cycle::FourierTermsKind& kind) {
    std::vector<std::string> parts;
    for (const cycle::FourierTerm& term : kind.ref(case_)) {
      parts.push_back(fmt::format("{{ order = {}, amplitude = {}, phase = {}{} }}", term.order, number(term.amplitude),
                                  write_(term.phase_deg, "degree", "degree"),
                                  term.height ? ", height = " + write_(*term.height, "m", "mm") : ""));
    }
    return parts.empty() ? "" : bracketed(parts);
  }
  std::string operator()(const cycle::DistillationKind& kind) {
    std::vector<std::string> parts;
    for (const models::OilFraction& fraction : kind.ref(case_)) {
      parts.push_back(
          fmt::format("{{ share = {}, boiling_point = {}{} }}", exact_text(fraction.share),
                      write_(fraction.boiling_point, "K", "degC"),
                      fraction.molar_mass ? ", molar_mass = " + write_(*fraction.molar_mass, "kg/mol", "g/mol") : ""));
    }
    return parts.empty() ? "" : bracketed(parts);
  }
  std::string operator()(const cycle::CornersKind& kind) {
    std::vector<std::string> parts;
    for (const auto& [axial, radial] : kind.ref(case_)) {
      parts.push_back(fmt::format("[{}, {}]", number(axial), number(radial)));
    }
    return parts.empty() ? "" : bracketed(parts);
  }
  std::string operator()(const cycle::AnglesKind&) {
    const cycle::Output& output = case_.output;
    return output.crank_angles_deg.empty() ? number(output.crank_angle_step_deg) : angles(output.crank_angles_deg);
  }
  std::string operator()(const cycle::FieldAnglesKind&) {
    const cycle::Output& output = case_.output;
    if (output.fields == cycle::FieldOutput::kListed) return angles(output.field_angles_deg);
    return output.fields == cycle::FieldOutput::kAll ? "\"all\"" : "\"none\"";
  }

 private:
  std::string number(double value) const { return write_(value, field_.unit, field_.display_unit); }
  static std::string text(const std::string& words) { return words.empty() ? "" : io::quoted(words); }
  std::string angles(const std::vector<double>& angles_deg) const {
    std::vector<std::string> parts;
    for (const double angle : angles_deg) parts.push_back(write_(angle, "degree", "degree"));
    return bracketed(parts);
  }

  const Field& field_;
  const Case& case_;
  Write write_;
};

/// The number that a key holds in its SI unit; NaN where it holds another thing.
class SiNumber {
 public:
  explicit SiNumber(const Case& c) : case_(c) {}

  double operator()(const cycle::NumberKind& kind) { return kind.ref(case_); }
  double operator()(const cycle::OptionalNumberKind& kind) { return number(kind.ref(case_)); }
  double operator()(const cycle::CountKind& kind) { return kind.ref(case_); }
  double operator()(const cycle::NumberOrFileKind& kind) { return kind.file(case_) ? kNaN : kind.number(case_); }
  double operator()(const cycle::OptionalNumberOrFileKind& kind) { return number(kind.ref(case_).constant); }
  double operator()(const cycle::UnitNameKind& kind) { return kind.ref(case_); }
  double operator()(const cycle::ConstantOrTemperatureValuesKind& kind) { return number(kind.constant(case_)); }
  double operator()(const cycle::StrokeValuesKind& kind) {
    const auto& points = kind.ref(case_);
    return points.size() == 1 ? points.front().value : kNaN;
  }
  double operator()(const cycle::AnglesKind&) {
    return case_.output.crank_angles_deg.empty() ? case_.output.crank_angle_step_deg : kNaN;
  }
  template <class Other>
  double operator()(const Other&) {
    return kNaN;
  }

 private:
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static double number(const std::optional<double>& value) { return value.value_or(kNaN); }

  const Case& case_;
};

Write in_display_units(const Units& units) {
  return [&units](double value, const std::string& si_unit, const std::string& display_unit) {
    const std::string shown = units.shown(value, si_unit, display_unit);
    return si_unit == "1" ? shown : fmt::format("\"{}\"", shown);
  };
}

}  // namespace

std::string exact_value(const Field& field, const Case& c) {
  return std::visit(Writer(field, c, exact_quantity), field.kind);
}

double si_number(const Field& field, const Case& c) { return std::visit(SiNumber(c), field.kind); }

std::string written_value(const Field& field, const Case& c, const Units& units) {
  return std::visit(Writer(field, c, in_display_units(units)), field.kind);
}

std::string shown_value(const Field& field, const Case& c, const Units& units) {
  const auto* points = std::get_if<cycle::TemperatureValuesKind>(&field.kind);
  const auto* either = std::get_if<cycle::ConstantOrTemperatureValuesKind>(&field.kind);
  if (points != nullptr || (either != nullptr && !either->constant(c))) {
    std::string text;
    for (const auto& [temperature, value] : (points != nullptr ? points->ref : either->ref)(c)) {
      text += (text.empty() ? "" : "; ") + units.shown(value, field.unit, field.display_unit) + " at " +
              units.shown(temperature, "K", "degC");
    }
    return text;
  }
  std::string text = written_value(field, c, units);
  std::erase(text, '"');
  return text;
}

}  // namespace ringfilm::io
