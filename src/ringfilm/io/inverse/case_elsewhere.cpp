#include "ringfilm/io/inverse/case_elsewhere.hpp"

#include <filesystem>
#include <variant>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

bool may_name_file(const cycle::Field& field) {
  return study::is_file(field) || std::holds_alternative<cycle::NumberOrFileKind>(field.kind) ||
         std::holds_alternative<cycle::OptionalNumberOrFileKind>(field.kind);
}

}  // namespace

std::string resolved_case_in(const std::string& folder, const cycle::Case& c, const std::vector<std::string>& heading) {
  std::vector<CaseEntry> entries = case_entries(c);
  for (CaseEntry& entry : entries) {
    const cycle::Field* field = study::field_of_key(entry.key);
    if (field == nullptr || !may_name_file(*field) || entry.value.size() < 2 || entry.value.front() != '"') continue;
    const std::string name = parse_toml_value(entry.value).text;
    std::error_code error;
    if (!fs::is_regular_file(name, error)) continue;
    const fs::path relative = fs::relative(fs::absolute(name), fs::absolute(folder), error);
    if (!error && !relative.empty()) entry.value = quoted(relative.generic_string());
  }
  std::string text;
  for (const std::string& line : heading) text += "# " + line + "\n";
  return text + case_text(entries);
}

}  // namespace ringfilm::io
