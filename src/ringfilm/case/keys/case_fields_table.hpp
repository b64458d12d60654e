#pragma once
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "ringfilm/case/keys/case_fields.hpp"

/// How the sections of the table of case keys are written down; only the files case_fields*.cpp include this.
namespace ringfilm::cycle::table {

/// The member at the end of a path of member pointers.
template <auto... Path>
inline constexpr auto member = [](auto& c) -> auto& {
  return (c.*....*Path);
};

template <auto... Path>
int choice_index(const Case& c) {
  return static_cast<int>((c.*....*Path));
}

template <auto... Path>
void choose(Case& c, int index) {
  auto& choice = (c.*....*Path);
  choice = static_cast<std::remove_reference_t<decltype(choice)>>(index);
}

template <auto... Path>
ChoiceKind choice(std::vector<std::string> names) {
  return {std::move(names), choice_index<Path...>, choose<Path...>};
}

/// SI unit and the unit in which people write it.
struct Unit {
  const char* si;
  const char* display;
};
inline constexpr Unit kNoUnit{"", ""};
inline constexpr Unit kPlainNumber{"1", "1"};

/// When a key is in use, as a rule and in words; the default means always.
struct When {
  bool (*holds)(const Case&) = nullptr;
  const char* words = "";
};

inline Range above(double low, double high) { return {low, high, true, false}; }
inline Range between(double low, double high) { return {low, high, false, false}; }
inline Range strictly_between(double low, double high) { return {low, high, true, true}; }

struct Text {
  std::string help;
  const char* example;
};

inline Field field(std::string key, Kind kind, Unit unit, std::optional<Range> range, Need need, When when, Text text) {
  return {std::move(key), std::move(kind),      unit.si,      unit.display, range, need, when.holds,
          when.words,     std::move(text.help), text.example, std::nullopt};
}

/// What differs between the keys of the ring's face and of the pad's.
struct FaceText {
  std::string section;       ///< "ring.face"
  const char* crowned;       ///< forms with a crown
  const char* crown_height;  ///< what it is
  double highest;            ///< crown height [m]
  const char* extent;        ///< what x runs over
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
  const Unit mm{"m", "mm"}, um{"m", "um"};
  return {
      field(key("coefficients"), NumberListKind{member<Path..., &FaceShape::coefficients>}, kPlainNumber, {},
            Need::kRequired, is_polynomial, {"coefficients of the height, highest power first", "[4.0, -4.8, 1.44]"}),
      field(key("length_unit"), UnitNameKind{member<Path..., &FaceShape::length_unit>}, mm, above(0, 1),
            Need::kRequired, is_polynomial, {"unit of x in the polynomial", "\"mm\""}),
      field(key("height_unit"), UnitNameKind{member<Path..., &FaceShape::height_unit>}, um, above(0, 1),
            Need::kRequired, is_polynomial, {"unit of the height in the polynomial", "\"um\""}),
      field(key("crown_height"), NumberKind{member<Path..., &FaceShape::crown_height>}, um, above(0, text.highest),
            Need::kRequired, is_crowned, {text.crown_height, "\"15 um\""}),
      field(key("apex"), NumberKind{member<Path..., &FaceShape::apex>}, kPlainNumber, between(0, 1), Need::kDefault,
            is_crowned,
            {std::string("place of the lowest point, as a fraction of the ") + text.extent + " from x = 0", "0.5"}),
  };
}

void append_thermal_fields(std::vector<Field>& fields);
void append_gas_fields(std::vector<Field>& fields);
void append_gas_path_fields(std::vector<Field>& fields);  ///< after those of the ring
void append_ring_fields(std::vector<Field>& fields);
void append_contact_fields(std::vector<Field>& fields);
void append_measured_fields(std::vector<Field>& fields);
void append_lubricant_fields(std::vector<Field>& fields);
void append_run_fields(std::vector<Field>& fields);
void append_pad_fields(std::vector<Field>& fields);

}  // namespace ringfilm::cycle::table
