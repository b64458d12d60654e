#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ringfilm/base/display.hpp"
#include "ringfilm/case/keys/case_fields.hpp"

/// How the sections of the table of case keys are written down; only the files case_fields*.cpp include this.
namespace ringfilm::cycle::table {

/// The member at the end of a path of member pointers.
template <auto... Path>
inline constexpr auto member = [](auto& c) -> auto& {
  return (c.*....*Path);
};
template <auto... Path>
using MemberOf = std::remove_reference_t<decltype((std::declval<Case&>().*....*Path))>;

/// The choice at the end of a path of member pointers, by the names of its enumerators.
template <auto... Path>
ChoiceKind choice(std::vector<std::pair<std::string, MemberOf<Path...>>> named) {
  ChoiceKind kind;
  std::vector<MemberOf<Path...>> values;
  for (auto& [name, value] : named) {
    kind.names.push_back(std::move(name));
    values.push_back(value);
  }
  kind.index = [values](const Case& c) {
    return static_cast<int>(std::find(values.begin(), values.end(), (c.*....*Path)) - values.begin());
  };
  kind.choose = [values](Case& c, int index) { (c.*....*Path) = values[static_cast<std::size_t>(index)]; };
  return kind;
}

/// Choice whose names are in the order of the values of an enumeration.
template <auto... Path>
ChoiceKind choice_in_order(const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, MemberOf<Path...>>> named;
  for (const std::string& name : names) named.emplace_back(name, static_cast<MemberOf<Path...>>(named.size()));
  return choice<Path...>(std::move(named));
}

/// When a key is in use, as a rule and in words; the default means always.
struct When {
  bool (*holds)(const Case&) = nullptr;
  const char* words = "";
};

/// Of keys that the oil consumption uses.
inline constexpr When kOilFollowed{[](const Case& c) { return c.follows_oil(); }, "film.supply = \"film-on-liner\""};

/// Of keys of the composition of the gas.
inline constexpr When kComposition{[](const Case& c) {
                                     return (c.gas_path.is_computed() || c.purpose == CasePurpose::kGasPath) &&
                                            c.gas.composition.is_stated();
                                   },
                                   "gas.composition.fuel is stated"};

inline Range above(double low, double high) { return {low, high, true, false}; }
inline Range between(double low, double high) { return {low, high, false, false}; }
inline Range strictly_between(double low, double high) { return {low, high, true, true}; }

/// A key as the table has it; what is not stated is that of most keys.
struct Row {
  std::string key;
  Kind kind;
  DisplayUnit unit = si_unit("");
  std::optional<Range> range = std::nullopt;
  Need need = Need::kDefault;
  When when = {};
  std::string help;
  std::string example;
  Uses uses = {};
  bool is_for_record = false;
};

inline Field field(Row row) {
  return {std::move(row.key), std::move(row.kind), row.unit.si,    row.unit.name,       row.range,
          row.need,           row.when.holds,      row.when.words, std::move(row.help), std::move(row.example),
          row.uses,           row.is_for_record};
}

/// What differs between the keys of the ring's face and of the pad's.
struct FaceText {
  std::string section;       ///< "ring.face"
  const char* crowned;       ///< forms with a crown
  const char* crown_height;  ///< what it is
  double highest;            ///< crown height [m]
  const char* extent;        ///< what x runs over
  Uses uses;                 ///< what uses the face
};

/// The keys of a formula of the face at the end of a path of member pointers.
template <auto... Path>
std::vector<Field> face_fields(const FaceText& text) {
  const auto key = [&](const char* name) { return text.section + "." + name; };
  const std::string polynomial = key("form = \"polynomial\""), crowned = key("form = ") + text.crowned;
  const When is_polynomial{[](const Case& c) { return (c.*....*Path).form == FaceForm::kPolynomial; },
                           polynomial.c_str()};
  const When is_crowned{[](const Case& c) {
                          const FaceForm form = (c.*....*Path).form;
                          return form == FaceForm::kParabola || form == FaceForm::kCosine;
                        },
                        crowned.c_str()};
  return {
      field({.key = key("coefficients"),
             .kind = NumberListKind{member<Path..., &FaceShape::coefficients>},
             .unit = kPlainNumber,
             .need = Need::kRequired,
             .when = is_polynomial,
             .help = "coefficients of the height, highest power first",
             .example = "[4.0, -4.8, 1.44]",
             .uses = text.uses}),
      field({.key = key("length_unit"),
             .kind = UnitNameKind{member<Path..., &FaceShape::length_unit>},
             .unit = kMillimetre,
             .range = above(0, 1),
             .need = Need::kRequired,
             .when = is_polynomial,
             .help = "unit of x in the polynomial",
             .example = "\"mm\"",
             .uses = text.uses}),
      field({.key = key("height_unit"),
             .kind = UnitNameKind{member<Path..., &FaceShape::height_unit>},
             .unit = kMicrometre,
             .range = above(0, 1),
             .need = Need::kRequired,
             .when = is_polynomial,
             .help = "unit of the height in the polynomial",
             .example = "\"um\"",
             .uses = text.uses}),
      field({.key = key("crown_height"),
             .kind = NumberKind{member<Path..., &FaceShape::crown_height>},
             .unit = kMicrometre,
             .range = between(0, text.highest),
             .need = Need::kRequired,
             .when = is_crowned,
             .help = text.crown_height,
             .example = "\"15 um\"",
             .uses = text.uses}),
      field({.key = key("apex"),
             .kind = NumberKind{member<Path..., &FaceShape::apex>},
             .unit = kPlainNumber,
             .range = between(0, 1),
             .when = is_crowned,
             .help = std::string("place of the lowest point, as a fraction of the ") + text.extent + " from x = 0",
             .example = "0.5",
             .uses = text.uses}),
  };
}

void append_thermal_fields(std::vector<Field>& fields);
void append_gas_fields(std::vector<Field>& fields);
void append_gas_composition_fields(std::vector<Field>& fields);
void append_gas_path_fields(std::vector<Field>& fields);  ///< after those of the ring
void append_ring_fields(std::vector<Field>& fields);
void append_section_fields(std::vector<Field>& fields);
void append_contact_fields(std::vector<Field>& fields);
void append_measured_fields(std::vector<Field>& fields);
void append_lubricant_fields(std::vector<Field>& fields);
void append_oil_consumption_fields(std::vector<Field>& fields);  ///< evaporation and oil transport
void append_run_fields(std::vector<Field>& fields);
void append_pad_fields(std::vector<Field>& fields);

}  // namespace ringfilm::cycle::table
