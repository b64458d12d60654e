#include "ringfilm/io/inverse/varied_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::io {

std::string toml_text(const TomlValue& value) {
  using Kind = TomlValue::Kind;
  switch (value.kind) {
    case Kind::kText:
      return quoted(value.text);
    case Kind::kInteger:
    case Kind::kNumber:
      return exact_text(value.number);
    case Kind::kList: {
      std::string text;
      for (const TomlValue& item : value.items) text += (text.empty() ? "" : ", ") + toml_text(item);
      return "[" + text + "]";
    }
    case Kind::kTable: {
      std::string text;
      for (const TomlMember& member : value.members) {
        text += (text.empty() ? " " : ", ") + quoted(member.key) + " = " + toml_text(member.value);
      }
      return "{" + text + " }";
    }
    case Kind::kOther:
      break;
  }
  return value.as_written();
}

bool VariedDocumentReader::read_case_of(TomlTable& table) {
  table.choose("compute", {{"films", study::Compute::kFilms}, {"gas", study::Compute::kGas}}, compute_);
  const std::string name = table.needed_text("case", "\"my_engine.toml\"");
  if (name.empty()) return false;
  case_path_ = locate(name, folder_).shown;
  const SourceMark mark = table.find("case")->mark;
  if (!add_base({}, mark)) return false;
  if (first_base().problem == cycle::Problem::kClosure) {
    faults_.push_back({mark, fmt::format("{} is a ring in its bore without an engine cycle", case_path_),
                       "name a case with [engine] and [ring], or a pad"});
    return false;
  }
  return true;
}

std::optional<std::size_t> VariedDocumentReader::add_base(const std::vector<Override>& overrides,
                                                          const SourceMark& mark) {
  try {
    const bool is_gas = compute_ == study::Compute::kGas;
    std::vector<DroppedKey> dropped;
    cycle::Case read =
        read_case_dropping(case_path_, overrides, units_, dropped, is_gas ? CasePurpose::kGasPath : CasePurpose::kFilm);
    record(read);
    bases_.push_back(std::move(read));
    return bases_.size() - 1;
  } catch (const InputError& error) {
    append_case_faults(error, mark, faults_);
    return std::nullopt;
  }
}

Override VariedDocumentReader::override_of(const std::string& key, const TomlValue& value) {
  const cycle::Field* field = study::field_of_key(key);
  const bool is_file = field != nullptr && study::is_file(*field) && value.kind == TomlValue::Kind::kText;
  return {key, is_file ? quoted(locate(value.text, folder_).shown) : toml_text(value)};
}

std::vector<Override> VariedDocumentReader::overrides_of(const TomlValue& values) {
  std::vector<Override> overrides;
  for (const TomlMember& member : values.members) overrides.push_back(override_of(member.key, member.value));
  return overrides;
}

std::optional<study::Variable> VariedDocumentReader::read_variable(TomlTable& table) {
  using study::FactorMode;
  const std::size_t n_before = faults_.size();
  study::Variable variable;
  variable.mark = table.mark();
  variable.key = table.needed_text("key", "\"ring.face.crown_height\"");
  if (variable.key.empty()) return std::nullopt;
  const cycle::Field* field = study::field_of_key(variable.key);
  if (field == nullptr) {
    std::vector<std::string> known;
    for (const cycle::Field& one : cycle::case_fields()) known.push_back(one.key);
    table.refuse_word("key", variable.key, known);
    return std::nullopt;
  }
  table.choose("how", {{"set", FactorMode::kSet}, {"scale", FactorMode::kScale}, {"add", FactorMode::kAdd}},
               variable.how);
  table.choose("spacing", {{"linear", study::Spacing::kLinear}, {"log", study::Spacing::kLogarithmic}},
               variable.spacing);
  if (const auto item = table.count("item")) variable.item = static_cast<std::size_t>(*item);
  variable.unit = variable.how == FactorMode::kScale ? "1" : field->unit;
  variable.display_unit = variable.how == FactorMode::kScale ? "1" : field->display_unit;
  // The size of a unit is a length, and a number of a list is bare.
  if (std::holds_alternative<cycle::UnitNameKind>(field->kind)) variable.unit = variable.display_unit = "m";
  if (variable.unit.empty()) variable.unit = variable.display_unit = "1";
  const bool is_difference = variable.how == FactorMode::kAdd && variable.unit == "K";
  if (is_difference) variable.display_unit = "K";
  const std::string example = variable.unit == "1" ? "0.1" : fmt::format("\"1 {}\"", variable.display_unit);
  table.need("lower", example);
  table.need("upper", example);
  const auto lower = table.quantity("lower", variable.unit, example, units_);
  const auto upper = table.quantity("upper", variable.unit, example, units_);
  if (faults_.size() > n_before) return std::nullopt;
  variable.lower = *lower;
  variable.upper = *upper;
  if (variable.spacing == study::Spacing::kLogarithmic && !(variable.lower > 0)) {
    table.refuse_value("lower", "cannot be the end of a logarithmic range", "both ends must be above 0");
    return std::nullopt;
  }
  if (!(variable.lower < variable.upper)) {
    table.refuse_value("lower", fmt::format("is not below upper = {}", table.find("upper")->as_written()),
                       "lower must be below upper; are they exchanged?");
    return std::nullopt;
  }
  return variable;
}

std::optional<cycle::Quantity> VariedDocumentReader::read_quantity(TomlTable& table,
                                                                   const std::vector<cycle::Quantity>& known) {
  const std::string name = table.needed_text("quantity", "\"fmep\"");
  if (name.empty()) return std::nullopt;
  if (const cycle::Quantity* found = find_by_name(known, name)) return *found;
  std::vector<std::string> names;
  for (const cycle::Quantity& quantity : known) names.push_back(quantity.name);
  table.refuse_word("quantity", name, names);
  return std::nullopt;
}

std::optional<double> VariedDocumentReader::read_deviation(TomlTable& table, const std::string& key,
                                                           const cycle::Quantity& quantity) {
  const std::string unit = quantity.unit == "K" ? "K" : quantity.display_unit;
  const std::string example = quantity.unit == "1" ? "0.01" : fmt::format("\"2 {}\"", unit);
  const auto deviation = table.quantity(key, quantity.unit, example, units_);
  if (deviation && !(*deviation > 0)) {
    table.refuse_value(key, "is not above 0", "a standard deviation is above 0; omit the key where there is none");
    return std::nullopt;
  }
  return deviation;
}

}  // namespace ringfilm::io
