#include "ringfilm/io/case/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "ringfilm/base/joined.hpp"
#include "ringfilm/case/accuracy.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_edit.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/case/case_value_text.hpp"
#include "ringfilm/io/case/case_values.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/trade_terms.hpp"

namespace ringfilm::io {
namespace {

using cycle::Case;
using cycle::Field;
using cycle::Need;

std::string section_of(const Field& field) {
  const std::size_t dot = field.key.rfind('.');
  return dot == std::string::npos ? "" : field.key.substr(0, dot);
}

std::string name_of(const Field& field) { return field.key.substr(field.key.rfind('.') + 1); }

/// What the wiebe model and the ends of an unrolled ring take where the case is silent; optional keys of other models
/// have no default.
Case with_optional_defaults(Case c) {
  if (c.gas.model == cycle::GasModel::kWiebe) {
    c.gas.intake_pressure = c.gas.intake_pressure.value_or(cycle::Gas::kWiebeIntakePressure);
    c.gas.exhaust_pressure = c.gas.exhaust_pressure.value_or(cycle::Gas::kWiebeExhaustPressure);
  }
  if (c.is_unrolled() && c.ring.end_gap) c.solver.end_cell = c.end_cell();
  return c;
}

const char* const kGrade = "lubricant.grade";

/// The case that states these values, with the oil of a grade where the shipped folder is found; values that are empty
/// are not stated.
Case case_stating(const std::vector<StartValue>& values, const Units& units) {
  Case c;
  const auto grade = std::find_if(values.begin(), values.end(), [](const auto& one) { return one.key == kGrade; });
  // Before the rest: files that the rest names are not read.
  if (grade != values.end() && find_shipped_folder()) update(c, {{kGrade, parse_toml_value(grade->value)}}, units);
  std::vector<Fault> faults;
  const auto conditions =
      std::find_if(values.begin(), values.end(), [](const auto& one) { return one.key == "conditions"; });
  if (conditions != values.end()) {
    set_value(c, *cycle::find_field("conditions"), {"conditions", parse_toml_value(conditions->value), ""}, units,
              faults);
    cycle::set_conditions(c.conditions, c);
  }
  for (const auto& [key, value, remark] : values) {
    if (!value.empty()) set_value(c, *cycle::find_field(key), {key, parse_toml_value(value), ""}, units, faults);
  }
  if (!faults.empty()) throw std::logic_error("a value of a case to start from is refused: " + describe(faults));
  return c;
}

/// A case with a Wiebe cycle, for the defaults of that model.
Case wiebe_case() {
  Case c;
  c.gas.model = cycle::GasModel::kWiebe;
  return with_optional_defaults(c);
}

/// Default of a key in the unit people use, "required", or nothing for a key that may be absent.
std::string default_words(const Field& field, const Units& units) {
  if (cycle::is_required(field, Case{})) return "required";
  if (field.need == Need::kOptional)
    return field.active_when.find("wiebe") == std::string::npos ? "-"
                                                                : shown_value(field, wiebe_case(), units) + " (wiebe)";
  const auto default_in = [&](cycle::Problem problem) { return shown_value(field, cycle::blank_case(problem), units); };
  const std::string value = default_in(field.uses.cycle ? cycle::Problem::kCycle : cycle::Problem::kPad);
  const std::string of_pad = field.uses.cycle && field.uses.pad ? default_in(cycle::Problem::kPad) : value;
  return (value.empty() ? "-" : value) + (of_pad == value ? "" : " (pad: " + of_pad + ")");
}

std::string unit_words(const Field& field) {
  if (field.display_unit.empty() || field.display_unit == "1") return "-";
  return field.display_unit;
}

/// Range of a number, or the names of a choice.
std::string allowed_words(const Field& field, const Units& units) {
  if (const auto* choice = std::get_if<cycle::ChoiceKind>(&field.kind)) {
    return joined(choice->names, " | ");
  }
  if (std::holds_alternative<cycle::FieldAnglesKind>(field.kind)) return "none | all | [angles]";
  const std::string range = range_words(field, units);
  return range.empty() ? "-" : range;
}

std::string meaning_words(const Field& field) {
  return field.help + (field.active_when.empty() ? "" : " (where " + field.active_when + ")");
}

/// Rows of the table of keys, the first its head. @param keys keys that have a row
std::vector<std::vector<std::string>> rows(const std::string& section, const std::set<std::string>& keys,
                                           const Units& units) {
  std::vector<std::vector<std::string>> rows{{"key", "unit", "default", "allowed", "meaning"}};
  for (const Field& field : cycle::case_fields()) {
    if (section_of(field) != section || !keys.contains(field.key)) continue;
    rows.push_back({name_of(field), unit_words(field), default_words(field, units), allowed_words(field, units),
                    meaning_words(field)});
  }
  return rows;
}

/// A bar inside a cell would end it.
std::string in_markdown(const std::string& cell) {
  std::string escaped;
  for (const char c : cell) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::vector<std::string> sections() {
  std::vector<std::string> sections;
  for (const Field& field : cycle::case_fields()) {
    if (sections.empty() || sections.back() != section_of(field)) sections.push_back(section_of(field));
  }
  return sections;
}

std::set<std::string> all_keys() {
  std::set<std::string> keys;
  for (const Field& field : cycle::case_fields()) keys.insert(field.key);
  return keys;
}

/// The keys that a word selects: the key itself or those of the section of that name, else all that contain it.
std::set<std::string> keys_of_word(std::string word, const std::set<std::string>& all) {
  std::erase_if(word, [](char c) { return c == '[' || c == ']'; });
  if (word.ends_with('.')) word.pop_back();
  std::set<std::string> selected;
  const auto select = [&](const auto& is_meant) {
    std::ranges::copy_if(all, std::inserter(selected, selected.end()), is_meant);
    return !selected.empty();
  };
  if (select([&](const std::string& key) { return key == word || key.starts_with(word + "."); })) return selected;
  const TradeTerm* term = trade_term(word);
  const auto by_term = [&] { return term != nullptr && select([&](const auto& key) { return key == term->key; }); };
  constexpr std::size_t kShort = 3;  // "vi" is a part of many keys
  if (word.size() <= kShort && by_term()) return selected;
  if (select([&](const std::string& key) { return key.find(word) != std::string::npos; })) return selected;
  if (by_term()) return selected;
  const KeyProposal proposal = key_proposal(word, {all.begin(), all.end()});
  throw InputError("ringfilm fields " + word + ": there is no such section or key" + proposal.message,
                   proposal.remedy.empty() ? "ringfilm fields lists all keys" : proposal.remedy);
}

std::set<std::string> selected_keys(const std::vector<std::string>& words) {
  const std::set<std::string> all = all_keys();
  std::set<std::string> keys;
  for (const std::string& word : words) keys.merge(keys_of_word(word, all));
  return words.empty() ? all : keys;
}

/// Writes "[section]" whenever it changes.
class SectionHeads {
 public:
  std::string before(const Field& field) {
    const std::string section = section_of(field);
    if (section == last_) return "";
    last_ = section;
    return fmt::format("\n[{}]\n", section);
  }

 private:
  std::string last_;
};

}  // namespace

std::vector<CaseEntry> pack_entries(const std::vector<std::vector<CaseEntry>>& rings) {
  std::vector<CaseEntry> entries;
  for (const CaseEntry& entry : rings.front()) {
    if (!cycle::is_of_ring(entry.key)) entries.push_back(entry);
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (CaseEntry entry : rings[i]) {
      if (!cycle::is_of_ring(entry.key) || cycle::is_implied_in_pack(i + 1, entry.key)) continue;
      entry.key = cycle::pack_key(i + 1, entry.key);
      entries.push_back(std::move(entry));
    }
  }
  return entries;
}

std::vector<CaseEntry> case_entries(const Case& given) {
  if (given.is_pack()) {
    std::vector<std::vector<CaseEntry>> rings;
    for (const Case& ring : given.rings) rings.push_back(case_entries(ring));
    return pack_entries(rings);
  }
  const Units units;
  const Case c = with_optional_defaults(given);
  std::vector<CaseEntry> entries;
  for (const Field& field : cycle::case_fields()) {
    const bool is_stated = c.stated.contains(field.key);
    if (!cycle::is_active(field, c)) continue;
    if (c.solver.accuracy && !is_stated && cycle::is_chosen_by_accuracy(field.key)) continue;
    const std::string value = exact_value(field, c);
    if (value.empty()) continue;
    entries.push_back(
        {field.key, value, shown_value(field, c, units), !is_stated, field.help, si_number(field, c), field.unit});
  }
  return entries;
}

std::string resolved_case(const Case& given) { return case_text(case_entries(given)); }

std::string case_text(const std::vector<CaseEntry>& entries) {
  std::string text = "# Every value in use, in SI and exact. File names are as seen from the folder of the run.\n";
  std::string last_section;
  std::size_t last_ring = 0;
  for (const CaseEntry& entry : entries) {
    // The keys of the oil file are written out, so the oil itself must not be named again.
    if (entry.key == "lubricant.file" || entry.key == kGrade) continue;
    const auto of_ring = cycle::ring_key(entry.key);
    const std::size_t ring = of_ring ? of_ring->ring : 0;
    // `ring.2.contact.roughness` is `roughness` in [ring.contact] of the second [[ring]].
    const std::string key = of_ring ? "ring" + entry.key.substr(entry.key.find('.', 5)) : entry.key;
    const std::size_t dot = key.rfind('.');
    const std::string section = dot == std::string::npos ? "" : key.substr(0, dot);
    if (ring != last_ring) {
      text += "\n[[ring]]\n";
      last_section = "ring";
    }
    if (section != last_section) text += fmt::format("\n[{}]\n", section);
    last_section = section;
    last_ring = ring;
    text += fmt::format("{} = {}\n", key.substr(dot == std::string::npos ? 0 : dot + 1), entry.value);
  }
  return text;
}

std::string commented_case(const std::string& head, const std::vector<StartValue>& values) {
  const Units units;
  const Case c = with_optional_defaults(case_stating(values, units));
  std::string text = head;
  SectionHeads heads;
  for (const Field& field : cycle::case_fields()) {
    if (!cycle::belongs(field, c)) continue;
    const auto stated =
        std::find_if(values.begin(), values.end(), [&](const StartValue& value) { return value.key == field.key; });
    const bool is_stated = stated != values.end();
    const std::string usual = cycle::is_active(field, c) ? written_value(field, c, units) : "";
    const bool explains_use = !is_stated && usual.empty();
    text += heads.before(field) + "\n# " + (explains_use ? meaning_words(field) : field.help) + ".\n";
    const std::string allowed = allowed_words(field, units);
    if (allowed != "-") text += "# Allowed: " + allowed + ".\n";
    if (is_stated && !stated->value.empty()) {
      text += fmt::format("{} = {}  # {}\n", name_of(field), stated->value, stated->remark);
    } else if (is_stated) {
      text += fmt::format("# {} = {}  # MISSING: {}\n", name_of(field), field.example, stated->remark);
    } else {
      text += fmt::format("# {} = {}  # {}\n", name_of(field), usual.empty() ? field.example : usual,
                          usual.empty()                  ? "example"
                          : c.stated.contains(field.key) ? "of the oil"
                                                         : "default");
    }
  }
  return text;
}

std::string fields_table(const std::vector<std::string>& words) {
  const Units units;
  const std::set<std::string> keys = selected_keys(words);
  std::string text;
  if (words.empty())
    text = "include = [\"fragment.toml\"] before the first section reads more keys from other files.\n";
  for (const std::string& section : sections()) {
    const auto table = rows(section, keys, units);
    if (table.size() == 1) continue;
    std::vector<std::size_t> width(table.front().size(), 0);
    for (const auto& row : table) {
      for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
    }
    text += section.empty() ? "\nbefore the first section\n" : fmt::format("\n[{}]\n", section);
    for (const auto& row : table) {
      text += " ";
      for (std::size_t i = 0; i + 1 < row.size(); ++i) text += fmt::format(" {:<{}} ", row[i], width[i]);
      text += fmt::format(" {}\n", row.back());
    }
  }
  return text;
}

std::string fields_markdown() {
  const Units units;
  const std::set<std::string> keys = all_keys();
  std::string text;
  for (const std::string& section : sections()) {
    text += section.empty() ? "\n### Before the first section\n\n" : fmt::format("\n### `[{}]`\n\n", section);
    std::string after_head = "|---|---|---|---|---|\n";
    for (const auto& row : rows(section, keys, units)) {
      text += "|";
      for (const std::string& cell : row) text += fmt::format(" {} |", in_markdown(cell));
      text += "\n";
      text += std::exchange(after_head, "");
    }
  }
  return text;
}

}  // namespace ringfilm::io
