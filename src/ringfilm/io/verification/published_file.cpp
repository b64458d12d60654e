#include "ringfilm/io/verification/published_file.hpp"

#include <utility>

#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_table.hpp"

namespace ringfilm::io {
namespace {

/// A text that may be empty.
std::string text_of(TomlTable& table, const std::string& key) {
  const TomlValue* value = table.need(key);
  const bool is_empty = value != nullptr && value->kind == TomlValue::Kind::kText && value->text.empty();
  return is_empty ? "" : table.text(key).value_or("");
}

/// The value in SI; a relative deviation must be possible, so it is not zero.
double number_of(TomlTable& table, const std::string& si_unit, const Units& units) {
  const bool is_plain = si_unit == "1";
  table.need("value");
  const auto number = table.quantity("value", si_unit, is_plain ? "0.12" : "\"118 W\"", units);
  if (number == 0.0) {
    table.refuse_value("value", "is not a number to compare with",
                       is_plain ? "a number other than 0 is required" : "a number with unit is required, not 0");
  }
  return number.value_or(0);
}

std::string unit_of(TomlTable& table, const std::string& quantity) {
  std::vector<std::string> names;
  for (const auto& candidate : cycle::cycle_quantities()) {
    if (candidate.name == quantity) return candidate.unit;
    names.push_back(candidate.name);
  }
  if (!quantity.empty()) {
    table.refuse_value("quantity", "is not a cycle value" + did_you_mean(quantity, names),
                       "the names are those of ringfilm run --json");
  }
  return "1";
}

}  // namespace

std::vector<study::PublishedValue> read_published(const std::string& path, const std::string& case_name,
                                                  const Units& units) {
  const TomlValue root = parse_toml(read_source_text(path, path, kMaxToml));
  std::vector<Fault> faults;
  std::vector<study::PublishedValue> values;
  const TomlValue* tables = root.find("published");
  if (tables == nullptr || tables->kind != TomlValue::Kind::kList) {
    throw InputError(path + ": there is no table [[published]]");
  }
  for (const TomlValue& item : tables->items) {
    TomlTable table(item, "[[published]]", {"case", "source", "quantity", "statement", "value", "decided_by"}, faults);
    study::PublishedValue published;
    const std::string of_case = text_of(table, "case");
    published.source = text_of(table, "source");
    published.quantity = text_of(table, "quantity");
    published.statement = text_of(table, "statement");
    published.decided_by = text_of(table, "decided_by");
    published.value = number_of(table, unit_of(table, published.quantity), units);
    if (of_case == case_name) values.push_back(std::move(published));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return values;
}

}  // namespace ringfilm::io
