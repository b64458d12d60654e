#include "case_values.hpp"

#include <cmath>

#include "arguments.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::python {
namespace {

using cycle::Case;
using cycle::Field;
using cycle::TemperatureValue;
using io::TomlValue;

py::list pairs(const std::vector<TemperatureValue>& values) {
  py::list list;
  for (const auto& [temperature, value] : values) list.append(py::make_tuple(temperature, value));
  return list;
}

std::vector<TemperatureValue> from_pairs(const py::handle& list) {
  std::vector<TemperatureValue> values;
  for (const auto& [temperature, value] : py::cast<std::vector<std::pair<double, double>>>(list))
    values.push_back({temperature, value});
  return values;
}

/// Angles in degrees, the rest in SI.
py::list terms(const std::vector<cycle::FourierTerm>& values) {
  py::list list;
  for (const cycle::FourierTerm& term : values) {
    py::dict one;
    one["order"] = term.order;
    one["amplitude"] = term.amplitude;
    one["phase"] = term.phase_deg;
    if (term.height) one["height"] = *term.height;
    list.append(one);
  }
  return list;
}

/// In SI.
py::list fractions(const std::vector<models::OilFraction>& values) {
  py::list list;
  for (const models::OilFraction& fraction : values) {
    py::dict one;
    one["share"] = fraction.share;
    one["boiling_point"] = fraction.boiling_point;
    if (fraction.molar_mass) one["molar_mass"] = *fraction.molar_mass;
    list.append(one);
  }
  return list;
}

/// The value of a key in SI.
class SiValue {
 public:
  explicit SiValue(const Case& c) : case_(c) {}

  template <class Plain>
  py::object operator()(const Plain& kind) const {
    return py::cast(kind.ref(case_));
  }
  py::object operator()(const cycle::ChoiceKind& kind) const { return py::str(kind.names.at(kind.index(case_))); }
  py::object operator()(const cycle::NumberOrFileKind& kind) const {
    if (const auto& file = kind.file(case_)) return py::str(*file);
    return py::float_(kind.number(case_));
  }
  py::object operator()(const cycle::OptionalNumberOrFileKind& kind) const {
    const cycle::LandPressure& pressure = kind.ref(case_);
    return pressure.file ? py::cast(*pressure.file) : py::cast(pressure.constant);
  }
  py::object operator()(const cycle::TemperatureValuesKind& kind) const { return pairs(kind.ref(case_)); }
  py::object operator()(const cycle::ConstantOrTemperatureValuesKind& kind) const {
    if (const auto& constant = kind.constant(case_)) return py::float_(*constant);
    return pairs(kind.ref(case_));
  }
  py::object operator()(const cycle::FourierTermsKind& kind) const { return terms(kind.ref(case_)); }
  py::object operator()(const cycle::DistillationKind& kind) const { return fractions(kind.ref(case_)); }
  py::object operator()(const cycle::StrokeValuesKind& kind) const {
    const auto& points = kind.ref(case_);
    if (points.size() == 1) return py::float_(points.front().value);
    py::list list;
    for (const auto& [distance, value] : points) list.append(py::make_tuple(distance, value));
    return list;
  }
  py::object operator()(const cycle::CornersKind& kind) const {
    py::list list;
    for (const auto& [axial, radial] : kind.ref(case_)) list.append(py::make_tuple(axial, radial));
    return list;
  }
  py::object operator()(const cycle::AnglesKind&) const {
    const cycle::Output& output = case_.output;
    if (output.crank_angles_deg.empty()) return py::float_(output.crank_angle_step_deg);
    return py::cast(output.crank_angles_deg);
  }
  py::object operator()(const cycle::FieldAnglesKind&) const {
    const cycle::Output& output = case_.output;
    if (output.fields == cycle::FieldOutput::kListed) return py::cast(output.field_angles_deg);
    return py::str(output.fields == cycle::FieldOutput::kAll ? "all" : "none");
  }

 private:
  const Case& case_;
};

/// What a pickle holds beyond SiValue, and how it comes back.
class Stored {
 public:
  explicit Stored(const Case& c) : case_(c) {}

  py::object operator()(const cycle::NumberOrFileKind& kind) const {
    return py::make_tuple(kind.number(case_), kind.file(case_));
  }
  py::object operator()(const cycle::OptionalNumberOrFileKind& kind) const {
    const cycle::LandPressure& pressure = kind.ref(case_);
    py::object trace = py::none();
    if (pressure.trace) {
      const cycle::SampledTrace& samples = **pressure.trace;
      trace = py::make_tuple(samples.crank_angle_deg, samples.value);
    }
    return py::make_tuple(pressure.constant, pressure.file, trace);
  }
  py::object operator()(const cycle::ConstantOrTemperatureValuesKind& kind) const {
    return py::make_tuple(kind.constant(case_), pairs(kind.ref(case_)));
  }
  py::object operator()(const cycle::StrokeValuesKind& kind) const {
    py::list list;
    for (const auto& [distance, value] : kind.ref(case_)) list.append(py::make_tuple(distance, value));
    return list;
  }
  py::object operator()(const cycle::AnglesKind&) const {
    return py::make_tuple(case_.output.crank_angle_step_deg, case_.output.crank_angles_deg);
  }
  py::object operator()(const cycle::FieldAnglesKind&) const {
    return py::make_tuple(static_cast<int>(case_.output.fields), case_.output.field_angles_deg);
  }
  template <class Other>
  py::object operator()(const Other& kind) const {
    return SiValue(case_)(kind);
  }

 private:
  const Case& case_;
};

class Restore {
 public:
  Restore(Case& c, const py::handle& value) : case_(c), value_(value) {}

  void operator()(const cycle::ChoiceKind& kind) const {
    const auto name = py::cast<std::string>(value_);
    for (std::size_t i = 0; i < kind.names.size(); ++i) {
      if (kind.names[i] == name) return kind.choose(case_, static_cast<int>(i));
    }
    throw py::value_error("this pickle of a case is from another version of ringfilm: unknown choice " + name);
  }
  void operator()(const cycle::NumberOrFileKind& kind) const {
    const auto [number, file] = py::cast<std::pair<double, std::optional<std::string>>>(value_);
    kind.number(case_) = number;
    kind.file(case_) = file;
  }
  void operator()(const cycle::OptionalNumberOrFileKind& kind) const {
    const auto all = py::cast<py::tuple>(value_);
    cycle::LandPressure& pressure = kind.ref(case_);
    pressure = {py::cast<std::optional<double>>(all[0]), py::cast<std::optional<std::string>>(all[1]), std::nullopt,
                std::nullopt};
    if (all[2].is_none()) return;
    const auto [angles, values] = py::cast<std::pair<std::vector<double>, std::vector<double>>>(all[2]);
    pressure.trace = cycle::SampledTrace{angles, values};
  }
  void operator()(const cycle::TemperatureValuesKind& kind) const { kind.ref(case_) = from_pairs(value_); }
  void operator()(const cycle::ConstantOrTemperatureValuesKind& kind) const {
    const auto both = py::cast<py::tuple>(value_);
    kind.constant(case_) = py::cast<std::optional<double>>(both[0]);
    kind.ref(case_) = from_pairs(both[1]);
  }
  void operator()(const cycle::FourierTermsKind& kind) const {
    kind.ref(case_).clear();
    for (const py::handle item : py::iter(value_)) {
      const auto one = py::cast<py::dict>(item);
      cycle::FourierTerm term{py::cast<int>(one["order"]), py::cast<double>(one["amplitude"]),
                              py::cast<double>(one["phase"]), std::nullopt};
      if (one.contains("height")) term.height = py::cast<double>(one["height"]);
      kind.ref(case_).push_back(term);
    }
  }
  void operator()(const cycle::DistillationKind& kind) const {
    kind.ref(case_).clear();
    for (const py::handle item : py::iter(value_)) {
      const auto one = py::cast<py::dict>(item);
      models::OilFraction fraction{py::cast<double>(one["share"]), py::cast<double>(one["boiling_point"]),
                                   std::nullopt};
      if (one.contains("molar_mass")) fraction.molar_mass = py::cast<double>(one["molar_mass"]);
      kind.ref(case_).push_back(fraction);
    }
  }
  void operator()(const cycle::StrokeValuesKind& kind) const {
    kind.ref(case_).clear();
    for (const auto& [distance, value] : py::cast<std::vector<std::pair<double, double>>>(value_)) {
      kind.ref(case_).push_back({distance, value});
    }
  }
  void operator()(const cycle::CornersKind& kind) const {
    kind.ref(case_).clear();
    for (const auto& [axial, radial] : py::cast<std::vector<std::pair<double, double>>>(value_)) {
      kind.ref(case_).push_back({axial, radial});
    }
  }
  void operator()(const cycle::AnglesKind&) const {
    const auto [step, angles] = py::cast<std::pair<double, std::vector<double>>>(value_);
    case_.output.crank_angle_step_deg = step;
    case_.output.crank_angles_deg = angles;
  }
  void operator()(const cycle::FieldAnglesKind&) const {
    const auto [choice, angles] = py::cast<std::pair<int, std::vector<double>>>(value_);
    case_.output.fields = static_cast<cycle::FieldOutput>(choice);
    case_.output.field_angles_deg = angles;
  }
  template <class Other>
  void operator()(const Other& kind) const {
    kind.ref(case_) = py::cast<std::decay_t<decltype(kind.ref(case_))>>(value_);
  }

 private:
  Case& case_;
  const py::handle& value_;
};

bool is_truth_value(const py::handle& value) {
  return PyBool_Check(value.ptr()) != 0 || py::str(py::type::of(value)).cast<std::string>() == "<class 'numpy.bool_'>";
}

bool is_in_si(const py::handle& value) {
  return py::isinstance(value, py::module_::import("ringfilm._values").attr("SI"));
}

TomlValue text(const std::string& words) {
  TomlValue value;
  value.kind = TomlValue::Kind::kText;
  value.text = words;
  return value;
}

TomlValue number(double x, TomlValue::Kind kind = TomlValue::Kind::kNumber) {
  TomlValue value;
  value.kind = kind;
  value.number = x;
  return value;
}

/// What a number means that has no unit.
enum class BareNumber { kAsInCaseFile, kSi };

class Toml {
 public:
  Toml(const py::handle& value, BareNumber bare, const Field& field) : value_(value), bare_(bare), field_(field) {}

  TomlValue operator()() const {
    if (py::isinstance<py::str>(value_)) return words(value_);
    if (py::hasattr(value_, "__fspath__")) return text(path_of(field_.key.c_str(), value_));
    if (is_truth_value(value_) || py::isinstance<py::bytes>(value_)) refuse();
    if (py::isinstance<py::dict>(value_)) refuse();
    if (py::hasattr(value_, "__len__") && py::hasattr(value_, "__getitem__") && !is_scalar_array(value_)) return list();
    return one_number(value_);
  }

 private:
  static bool is_scalar_array(const py::handle& value) {
    return py::hasattr(value, "ndim") && py::cast<int>(value.attr("ndim")) == 0;
  }

  [[noreturn]] void refuse() const {
    throw py::type_error(field_.key + " = " + py::cast<std::string>(py::repr(value_)) +
                         ": a text with its unit, a number, ringfilm.SI(number) or a list of them is expected");
  }

  TomlValue words(const py::handle& value) const {
    return text(text_of(field_.key.c_str(), value, field_.example.c_str()));
  }

  double plain(const py::handle& value) const {
    const double x = PyFloat_AsDouble(value.ptr());
    if (x == -1.0 && PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      refuse();
    }
    return x;
  }

  TomlValue one_number(const py::handle& value) const {
    const double x = plain(value);
    if (std::holds_alternative<cycle::CountKind>(field_.kind)) {
      return number(x, std::trunc(x) == x ? TomlValue::Kind::kInteger : TomlValue::Kind::kNumber);
    }
    return quantity(x, bare_, {field_.unit, field_.display_unit, field_.example});
  }

  struct Unit {
    std::string si, display, example;
  };

  /// A number with its unit, as a case file has it. A unit need not be stated where people write the SI unit, too.
  TomlValue quantity(double x, BareNumber bare, const Unit& unit) const {
    if (unit.si == "1" || unit.si.empty() || !std::isfinite(x)) return number(x);
    const std::string written = io::exact_text(x);
    if (bare == BareNumber::kSi || unit.si == unit.display) return text(written + " " + unit.si);
    throw InputError(field_.key + " = " + written + " has no unit",
                     io::dimension_words(unit.si) + " with its unit is expected, for example " + unit.example +
                         "; a number in " + unit.si + " is written ringfilm.SI(" + written + ")");
  }

  /// Pairs of temperature and value, or plain numbers: of a list of numbers, of crank angles [degree].
  TomlValue list() const {
    TomlValue list;
    list.kind = TomlValue::Kind::kList;
    const bool has_temperatures = std::holds_alternative<cycle::TemperatureValuesKind>(field_.kind) ||
                                  std::holds_alternative<cycle::ConstantOrTemperatureValuesKind>(field_.kind);
    for (const py::handle item : py::iter(value_)) {
      if (std::holds_alternative<cycle::StrokeValuesKind>(field_.kind)) {
        list.items.push_back(distance_and_value(item));
      } else if (std::holds_alternative<cycle::CornersKind>(field_.kind)) {
        list.items.push_back(corner(item));
      } else if (std::holds_alternative<cycle::FourierTermsKind>(field_.kind)) {
        list.items.push_back(fourier_term(item));
      } else if (std::holds_alternative<cycle::DistillationKind>(field_.kind)) {
        list.items.push_back(oil_fraction(item));
      } else if (has_temperatures) {
        list.items.push_back(temperature_value(item));
      } else if (py::isinstance<py::str>(item)) {
        list.items.push_back(words(item));
      } else {
        list.items.push_back(number(plain(item)));
      }
    }
    return list;
  }

  TomlValue corner(const py::handle& item) const {
    if (!py::hasattr(item, "__len__") || py::isinstance<py::str>(item) || py::len(item) != 2) refuse();
    TomlValue pair;
    pair.kind = TomlValue::Kind::kList;
    for (const int i : {0, 1}) {
      const py::object length = item.attr("__getitem__")(i);
      pair.items.push_back(part(length, {field_.unit, field_.display_unit, "\"1.2 mm\""}));
    }
    return pair;
  }

  TomlValue distance_and_value(const py::handle& item) const {
    if (!py::hasattr(item, "__len__") || py::isinstance<py::str>(item) || py::len(item) != 2) refuse();
    const py::object distance = item.attr("__getitem__")(0), value = item.attr("__getitem__")(1);
    TomlValue pair;
    pair.kind = TomlValue::Kind::kList;
    pair.items = {part(distance, {"m", "mm", "\"79.5 mm\""}),
                  part(value, {field_.unit, field_.display_unit, field_.example})};
    return pair;
  }

  TomlValue temperature_value(const py::handle& item) const {
    const Unit kelvin{"K", "degC", "\"40 degC\""};
    const Unit own{field_.unit, field_.display_unit, "\"1 " + field_.display_unit + "\""};
    TomlValue table;
    table.kind = TomlValue::Kind::kTable;
    if (py::isinstance<py::dict>(item)) {
      for (const auto& [name, value] : py::cast<py::dict>(item)) {
        const std::string key = text_of("a name in the list", name, "temperature");
        table.members.push_back({key, part(value, key == "temperature" ? kelvin : own)});
      }
      return table;
    }
    if (!py::hasattr(item, "__len__") || py::len(item) != 2) refuse();
    const py::object temperature = item.attr("__getitem__")(0), value = item.attr("__getitem__")(1);
    table.members = {{"temperature", part(temperature, kelvin)}, {"value", part(value, own)}};
    return table;
  }

  TomlValue oil_fraction(const py::handle& item) const {
    if (!py::isinstance<py::dict>(item)) refuse();
    const Unit share{"1", "1", "0.3"}, kelvin{"K", "degC", "\"440 degC\""}, mass{"kg/mol", "g/mol", "\"380 g/mol\""};
    TomlValue table;
    table.kind = TomlValue::Kind::kTable;
    for (const auto& [name, value] : py::cast<py::dict>(item)) {
      const std::string key = text_of("a name in the list", name, "share");
      table.members.push_back({key, part(value, key == "boiling_point" ? kelvin : key == "molar_mass" ? mass : share)});
    }
    return table;
  }

  TomlValue fourier_term(const py::handle& item) const {
    if (!py::isinstance<py::dict>(item)) refuse();
    TomlValue table;
    table.kind = TomlValue::Kind::kTable;
    for (const auto& [name, value] : py::cast<py::dict>(item)) {
      const std::string key = text_of("a name in the list", name, "order");
      if (key == "order") {
        const double x = plain(value);
        table.members.push_back(
            {key, number(x, std::trunc(x) == x ? TomlValue::Kind::kInteger : TomlValue::Kind::kNumber)});
      } else {
        const Unit own{field_.unit, field_.display_unit, "\"15 um\""};
        const Unit angle{"degree", "degree", "\"30 degree\""}, length{"m", "mm", "\"20 mm\""};
        table.members.push_back({key, part(value, key == "phase" ? angle : key == "height" ? length : own)});
      }
    }
    return table;
  }

  TomlValue part(const py::handle& value, const Unit& unit) const {
    if (py::isinstance<py::str>(value)) return words(value);
    if (is_in_si(value)) return quantity(plain(value.attr("value")), BareNumber::kSi, unit);
    return quantity(plain(value), bare_, unit);
  }

  const py::handle& value_;
  BareNumber bare_;
  const Field& field_;
};

}  // namespace

bool is_missing(const Field& field, const Case& c) {
  const bool is_required = field.need == cycle::Need::kRequired ||
                           (field.need == cycle::Need::kRequiredInCycle && c.problem == cycle::Problem::kCycle);
  return is_required && !c.stated.contains(field.key);
}

py::object si_value(const Field& field, const Case& c) {
  return is_missing(field, c) ? py::none() : std::visit(SiValue(c), field.kind);
}

std::optional<TomlValue> toml_value(const py::handle& value, const Field& field) {
  const bool is_si = is_in_si(value);
  const py::object given = is_si ? value.attr("value") : py::reinterpret_borrow<py::object>(value);
  if (given.is_none()) return std::nullopt;
  return Toml(given, is_si ? BareNumber::kSi : BareNumber::kAsInCaseFile, field)();
}

std::string written(const TomlValue& value) {
  std::string text;
  switch (value.kind) {
    case TomlValue::Kind::kText:
      return io::quoted(value.text);
    case TomlValue::Kind::kInteger:
      return std::to_string(static_cast<long long>(value.number));
    case TomlValue::Kind::kList:
      for (const TomlValue& item : value.items) text += (text.empty() ? "" : ", ") + written(item);
      return "[" + text + "]";
    case TomlValue::Kind::kTable:
      for (const auto& [key, member] : value.members)
        text += (text.empty() ? "" : ", ") + key + " = " + written(member);
      return "{ " + text + " }";
    default:
      text = io::exact_text(value.number);
      return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
  }
}

py::object stored_value(const Field& field, const Case& c) { return std::visit(Stored(c), field.kind); }

void restore_value(const Field& field, const py::handle& stored, Case& c) {
  std::visit(Restore(c, stored), field.kind);
}

}  // namespace ringfilm::python
