#pragma once
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "ringfilm/cycle/case/case_fields.hpp"

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

void append_thermal_fields(std::vector<Field>& fields);
void append_gas_fields(std::vector<Field>& fields);
void append_ring_fields(std::vector<Field>& fields);
void append_contact_fields(std::vector<Field>& fields);
void append_measured_fields(std::vector<Field>& fields);
void append_lubricant_fields(std::vector<Field>& fields);
void append_run_fields(std::vector<Field>& fields);
void append_pad_fields(std::vector<Field>& fields);

}  // namespace ringfilm::cycle::table
