#include "ringfilm/study/ensemble/alternatives.hpp"

#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <variant>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::study {
namespace {

using cycle::Case;

/// Those with which the case breaks no rule.
std::vector<Alternative> kept_if_allowed(const Case& c, std::vector<Alternative> alternatives) {
  std::erase_if(alternatives, [&](const Alternative& alternative) {
    Case changed = c;
    alternative.apply(changed);
    return !cycle::broken_rules(changed).empty();
  });
  return alternatives;
}

const cycle::ChoiceKind& choice(const std::string& key) {
  return std::get<cycle::ChoiceKind>(cycle::find_field(key)->kind);
}

void set_number(const std::string& key, Case& c, double value) {
  const cycle::Kind& kind = cycle::find_field(key)->kind;
  if (const auto* optional = std::get_if<cycle::OptionalNumberKind>(&kind)) {
    optional->ref(c) = value;
  } else if (const auto* or_file = std::get_if<cycle::NumberOrFileKind>(&kind)) {
    or_file->number(c) = value;
  } else if (const auto* along_stroke = std::get_if<cycle::StrokeValuesKind>(&kind)) {
    along_stroke->ref(c) = {{0, value}};
  } else {
    std::get<cycle::NumberKind>(kind).ref(c) = value;
  }
}

bool in_range(const std::string& key, double value) {
  const auto& range = cycle::find_field(key)->range;
  return !range || range->contains(value);
}

/// Nobody learns anything from a value this close to the one in use.
bool same(double value, double in_use) { return std::abs(value - in_use) <= 1e-3 * std::abs(in_use); }

}  // namespace

std::string chosen(const std::string& key, const Case& c) { return choice(key).names.at(choice(key).index(c)); }

std::vector<Alternative> other_choices(const std::string& key, const Case& c) {
  const cycle::ChoiceKind& kind = choice(key);
  std::vector<Alternative> others;
  for (int i = 0; i < static_cast<int>(kind.names.size()); ++i) {
    if (i == kind.index(c)) continue;
    others.push_back({key + " = \"" + kind.names[i] + "\"", [choose = kind.choose, i](Case& x) { choose(x, i); }});
  }
  return kept_if_allowed(c, std::move(others));
}

std::vector<Alternative> other_numbers(const std::string& key, const Case& c, double in_use, const DisplayUnit& unit,
                                       std::initializer_list<double> values) {
  std::vector<Alternative> others;
  for (const double requested : values) {
    const std::string number = number_text(number_in(requested, unit), 4);
    const double value = unit.scale.to_si(std::strtod(number.c_str(), nullptr));
    if (same(value, in_use) || !in_range(key, value)) continue;
    const bool is_bare = std::string_view(unit.name) == kPlainNumber.name;
    const std::string written = is_bare ? number : "\"" + number + " " + unit.name + "\"";
    others.push_back({key + " = " + written, [key, value](Case& x) { set_number(key, x, value); }});
  }
  return kept_if_allowed(c, std::move(others));
}

double other_than(double in_use, double value, double instead) { return same(value, in_use) ? instead : value; }

}  // namespace ringfilm::study
