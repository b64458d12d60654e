#include "variations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "commands/commands.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/case/keys/case_fields.hpp"

namespace ringfilm::app {
namespace {

/// More would be a study of hours.
constexpr std::size_t kMaxCombinations = 10000;

struct Number {
  double value;
  std::string unit;  ///< empty: none is stated
};

/// Nothing where the text does not begin with a number.
std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const std::size_t sign = text.starts_with("+") ? 1 : 0;
  const auto [end, error] = std::from_chars(text.data() + sign, text.data() + text.size(), number.value);
  if (error != std::errc()) return std::nullopt;
  number.unit = trimmed(std::string_view(end, text.data() + text.size()));
  return number;
}

/// The unit in which people write the key; empty where it has none.
std::string usual_unit(const std::string& key) {
  const auto of_ring = cycle::ring_key(key);
  const cycle::Field* field = cycle::find_field(of_ring ? of_ring->key : key);
  return field == nullptr || field->unit.empty() || field->unit == "1" ? "" : field->display_unit;
}

std::string with_unit(double value, const std::string& unit) {
  return number_text(value, 12) + (unit.empty() ? "" : " " + unit);
}

InputError not_of_that_form(const std::string& text, const VariationForm& form) {
  return InputError(form.label + text + " is not a key with its values", "write, for example, " + form.example);
}

/// Is a number in front of two dots? A path begins with them, and a text has them anywhere.
bool is_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  return dots != std::string::npos && number_of(trimmed(text.substr(0, dots)));
}

/// The values between the commas, but for those in brackets or quotes.
std::vector<std::string> listed_values(const std::string& text) {
  std::vector<std::string> values(1);
  int depth = 0;
  bool is_quoted = false;
  for (const char c : text) {
    if (c == '"') is_quoted = !is_quoted;
    if (!is_quoted) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == ',' && depth <= 0 && !is_quoted) {
      values.emplace_back();
    } else {
      values.back() += c;
    }
  }
  return values;
}

/// The values of "1000..6000 rpm".
std::vector<std::string> range(const std::string& text, const Variation& of, const VariationForm& form) {
  const std::size_t dots = text.find("..");
  const auto from = number_of(trimmed(text.substr(0, dots))), to = number_of(trimmed(text.substr(dots + 2)));
  const bool has_third_dot = dots + 2 < text.size() && text[dots + 2] == '.';
  if (!from || !to || has_third_dot || form.n_points < 2) throw not_of_that_form(of.key + "=" + text, form);
  if (!from->unit.empty() && from->unit != to->unit) {
    throw InputError(form.label + of.key + "=" + text + " has two units", "state one, behind the second number");
  }
  const std::string unit = to->unit.empty() ? usual_unit(of.key) : to->unit;
  std::vector<std::string> values;
  for (std::size_t i = 0; i < form.n_points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(form.n_points - 1);
    values.push_back(with_unit(from->value + share * (to->value - from->value), unit));
  }
  return values;
}

std::string single(const std::string& text, const std::string& key, const VariationForm& form) {
  const auto number = number_of(text);
  const bool may_be_thousands = text.size() == 3 && text.starts_with("0") && number && number->unit.empty();
  if (may_be_thousands) {
    throw InputError(form.label + key + ": " + "\"" + text + "\" may be the end of a number: a comma separates values",
                     "write thousands without commas, and decimals with points");
  }
  return number && number->unit.empty() ? with_unit(number->value, usual_unit(key)) : text;
}

}  // namespace

std::vector<Variation> variations(const std::vector<std::string>& texts, const VariationForm& form) {
  std::vector<Variation> all;
  std::set<std::string> keys;
  for (const std::string& text : texts) {
    const std::size_t equals = std::min(text.find('='), text.size());
    Variation one{trimmed(text.substr(0, equals)), {}};
    std::vector<std::string> written;
    if (equals < text.size()) written = listed_values(text.substr(equals + 1));
    for (const std::string& value : written) {
      const std::string bare(trimmed(value));
      if (bare.empty()) throw not_of_that_form(text, form);
      if (!is_range(bare)) {
        one.values.push_back(single(bare, one.key, form));
      } else {
        std::ranges::copy(range(bare, one, form), std::back_inserter(one.values));
      }
    }
    if (one.key.empty() || one.values.empty()) throw not_of_that_form(text, form);
    if (!keys.insert(one.key).second) throw InputError(form.label + one.key + " is given twice", "keep one of them");
    all.push_back(std::move(one));
  }
  return all;
}

std::string quoted_cell(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

std::size_t n_combinations(const std::vector<Variation>& varied, const VariationForm& form) {
  std::size_t n = 1;
  for (const Variation& one : varied) n *= one.values.size();
  if (n <= kMaxCombinations) return n;
  throw InputError(fmt::format("{}makes {} combinations, {} at the most are computed", form.label, n, kMaxCombinations),
                   "vary fewer values, or compute a study");
}

std::vector<io::Override> combination(const std::vector<Variation>& varied, std::size_t number,
                                      const VariationForm& form) {
  std::vector<io::Override> settings(varied.size());
  for (std::size_t i = varied.size(); i-- > 0;) {
    const std::size_t n = varied[i].values.size();
    settings[i] = {varied[i].key, varied[i].values[number % n], std::string(trimmed(form.label))};
    number /= n;
  }
  return settings;
}

std::vector<cycle::Case> cases_of(const std::string& path, const std::vector<io::Override>& overrides,
                                  const std::vector<Variation>& varied, const VariationForm& form,
                                  cycle::CasePurpose purpose) {
  const io::Units units;
  std::vector<cycle::Case> cases;
  for (const Variation& one : varied) {
    if (std::ranges::find(overrides, one.key, &io::Override::key) != overrides.end()) {
      throw InputError(
          one.key + " is stated by --set and " + (form.label.empty() ? "varied" : "by " + trimmed(form.label)),
          "keep one of them");
    }
  }
  std::vector<io::DroppedKey> all_dropped;
  const std::size_t n = n_combinations(varied, form);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<io::Override> settings = overrides;
    std::ranges::copy(combination(varied, i, form), std::back_inserter(settings));
    std::vector<io::DroppedKey> dropped;
    cases.push_back(io::read_case_dropping(path, settings, units, dropped, purpose));
    for (io::DroppedKey& one : dropped) {
      if (std::ranges::find(all_dropped, one.key, &io::DroppedKey::key) == all_dropped.end()) {
        all_dropped.push_back(std::move(one));
      }
    }
  }
  print_dropped(all_dropped);
  return cases;
}

}  // namespace ringfilm::app
