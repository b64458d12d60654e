#include "ringfilm/io/case/case_tree.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "ringfilm/cycle/case/case_fields.hpp"
#include "ringfilm/io/text/suggestion.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepestInclude = 8;
const char* const kOilSection = "lubricant.";

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }

/// A case has some ten sections; a file of its own for each, and as many again.
constexpr std::size_t kMostIncludes = 32;
/// A file with more faults than this is of another kind; to seek the nearest key takes longer than all else.
constexpr std::size_t kMostSuggestions = 100;

/// The keys and sections of a case file.
struct CaseNames {
  std::vector<std::string> keys{"include"}, sections;
  std::set<std::string> all_sections;  ///< those that hold only sections among them

  CaseNames() {
    for (const cycle::Field& field : cycle::case_fields()) {
      keys.push_back(field.key);
      const std::size_t last = field.key.rfind('.');
      if (last == std::string::npos) continue;
      const std::string section = field.key.substr(0, last);
      if (std::find(sections.begin(), sections.end(), section) == sections.end()) sections.push_back(section);
      for (std::size_t dot = section.find('.'); dot != std::string::npos; dot = section.find('.', dot + 1)) {
        all_sections.insert(section.substr(0, dot));
      }
      all_sections.insert(section);
    }
  }
};

/// Does a key lie in one of these sections, or in a section of one?
bool lies_in(const std::string& key, const std::set<std::string>& sections) {
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1)) {
    if (sections.contains(key.substr(0, dot))) return true;
  }
  return false;
}

/// The key of the table behind a key of a case of one ring or of a ring of a pack.
std::string plain_key(const std::string& key) {
  const auto of_ring = cycle::ring_key(key);
  return of_ring ? of_ring->key : key;
}

const cycle::Field* field_of(const std::string& key) { return cycle::find_field(plain_key(key)); }

/// The same of a section: `ring.2` and `ring.2.contact` are those of a ring of a pack.
std::string plain_section(const std::string& section) {
  const std::string key = plain_key(section + ".x");
  return key.substr(0, key.size() - 2);
}

/// [[ring]] sections as the sections ring.1, ring.2, ...
void number_rings(TomlValue& root) {
  for (auto& [name, value] : root.members) {
    const auto is_table = [](const TomlValue& item) { return item.kind == TomlValue::Kind::kTable; };
    if (name != "ring" || value.kind != TomlValue::Kind::kList || value.items.empty() ||
        !std::all_of(value.items.begin(), value.items.end(), is_table)) {
      continue;
    }
    std::vector<TomlValue> rings = std::move(value.items);
    value.items.clear();
    value.kind = TomlValue::Kind::kTable;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      value.members.push_back({std::to_string(i + 1), std::move(rings[i])});
    }
  }
}

std::string place(const SourceMark& mark) {
  if (mark.line == 0) return mark.file;
  return mark.file + ":" + std::to_string(mark.line) + ":" + std::to_string(mark.column);
}

bool is_text_key(const cycle::Field& field) {
  return std::holds_alternative<cycle::TextKind>(field.kind) ||
         std::holds_alternative<cycle::OptionalTextKind>(field.kind) ||
         std::holds_alternative<cycle::FileKind>(field.kind) ||
         std::holds_alternative<cycle::OptionalFileKind>(field.kind) ||
         std::holds_alternative<cycle::ChoiceKind>(field.kind) ||
         std::holds_alternative<cycle::UnitNameKind>(field.kind);
}

class Gatherer {
 public:
  explicit Gatherer(const std::string& path) { tree_.path = path; }

  CaseTree gather(const std::vector<Override>& overrides) {
    const SourceText source = read_source_text(tree_.path, tree_.path, kLargestToml);
    const TomlValue root = parse_toml(source);
    record(source, "case");
    open_.push_back(identity(tree_.path));
    add_file(root, tree_.path);
    const std::vector<TomlEntry> stated = read_overrides(overrides);
    add_oil_file(stated);
    for (const TomlEntry& entry : stated) replace(entry);
    for (auto& [key, entry] : entries_) tree_.entries.push_back(entry);
    return std::move(tree_);
  }

 private:
  static std::string identity(const std::string& path) {
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(path, error);
    return error ? path : canonical.string();
  }

  void record(const SourceText& source, const std::string& role) {
    tree_.files.push_back({role, source.path, source.sha256});
    if (source.has_byte_order_mark) {
      tree_.notes.push_back(source.path + " starts with a byte-order mark, which was skipped");
    }
  }

  void fault(const SourceMark& mark, const std::string& message, const std::string& remedy) {
    tree_.faults.push_back({mark, message, remedy});
  }

  void add_file(TomlValue root, const std::string& path) {
    number_rings(root);
    FlatToml flat = flatten(root, folder_of(path));
    drop_unknown_sections(flat);
    for (const TomlEntry& entry : flat.entries) {
      if (entry.key == "include") {
        add_includes(entry);
      } else {
        add(entry);
      }
    }
  }

  /// Reports an unknown section once and leaves its keys out.
  void drop_unknown_sections(FlatToml& flat) {
    std::set<std::string> unknown;
    for (const TomlEntry& section : flat.sections) {  // an outer one before those in it
      if (is_section(section.key)) continue;
      if (!lies_in(section.key, unknown)) refuse_section(section);
      unknown.insert(section.key);
    }
    std::erase_if(flat.entries, [&](const TomlEntry& entry) { return lies_in(entry.key, unknown); });
  }

  void refuse_section(const TomlEntry& section) {
    const cycle::Field* const field = cycle::find_field(section.key);
    const std::string near = field != nullptr ? "" : nearest(section.key, names_.sections);
    if (field != nullptr) tree_.faulty.insert(section.key);
    if (!near.empty()) tree_.faulty.insert(near + ".");
    fault(section.value.key_mark,
          field != nullptr ? section.key + " is a section here"
                           : "unknown section [" + section.key + "]" + did_you_mean(near),
          field != nullptr ? "it requires one value, for example " + field->example : "");
  }

  bool is_section(const std::string& name) const { return names_.all_sections.contains(plain_section(name)); }

  std::string nearest(const std::string& word, const std::vector<std::string>& known) const {
    return tree_.faults.size() < kMostSuggestions ? nearest_word(word, known) : "";
  }

  static std::string did_you_mean(const std::string& near) {
    return near.empty() ? "" : "; did you mean " + near + "?";
  }

  /// @returns whether the key is known
  bool check_known(const TomlEntry& entry) {
    if (field_of(entry.key) != nullptr) return true;
    if (is_section(entry.key)) {
      fault(entry.value.key_mark, entry.key + " is a section, not a key",
            "write [" + entry.key + "] and its keys below");
      tree_.faulty.insert(entry.key + ".");
      return false;
    }
    std::string near = nearest(plain_key(entry.key), names_.keys);
    if (const auto of_ring = cycle::ring_key(entry.key); of_ring && !near.empty()) {
      near = cycle::pack_key(of_ring->ring, near);
    }
    if (!near.empty()) tree_.faulty.insert(near);
    fault(entry.value.key_mark, "unknown key " + entry.key + did_you_mean(near),
          near.empty() ? "`ringfilm fields` lists all keys" : "");
    return false;
  }

  void add(const TomlEntry& entry) {
    if (!check_known(entry)) return;
    const auto [found, inserted] = entries_.emplace(entry.key, entry);
    if (inserted) return;
    tree_.faulty.insert(entry.key);
    fault(entry.value.key_mark, entry.key + " is given twice",
          "it is given at " + place(found->second.value.key_mark) + " too; keep one of them");
  }

  void add_includes(const TomlEntry& entry) {
    const TomlValue& value = entry.value;
    const std::vector<TomlValue> names = value.kind == TomlValue::Kind::kList ? value.items : std::vector{value};
    for (const TomlValue& name : names) {
      if (name.kind != TomlValue::Kind::kText || name.text.empty()) {
        tree_.complete = false;
        fault(name.mark, "include = " + name.as_written() + " is not a file name",
              "write include = [\"surfaces.toml\"]");
        continue;
      }
      add_include(name, locate(name.text, entry.folder));
    }
  }

  void add_include(const TomlValue& name, const NamedFile& file) {
    const std::string id = identity(file.path);
    if (std::find(open_.begin(), open_.end(), id) != open_.end()) {
      fault(name.mark, file.shown + " includes itself", "take this include out");
      return;
    }
    const auto [first, is_first] = included_.emplace(id, place(name.mark));
    if (!is_first) {
      fault(name.mark, file.shown + " is included twice",
            "it is included at " + first->second + " too; keep one of them");
      return;
    }
    if (open_.size() > kDeepestInclude || included_.size() > kMostIncludes) {
      tree_.complete = false;
      fault(name.mark,
            open_.size() > kDeepestInclude ? "files are included more than " + std::to_string(kDeepestInclude) + " deep"
                                           : "more than " + std::to_string(kMostIncludes) + " files are included",
            "put their keys into fewer files");
      return;
    }
    read_named(name.mark, "include", file, "include", [&](const TomlValue& root) {
      open_.push_back(id);
      add_file(root, file.shown);
      open_.pop_back();
    });
  }

  /// Reads a TOML file that `mark` names; `use` gets its tree. A file that cannot be read is a fault at `mark`.
  /// @param remedy instead of that of a file that cannot be read, unless empty
  template <typename Use>
  void read_named(const SourceMark& mark, const std::string& key, const NamedFile& file, const std::string& role,
                  const Use& use, const std::string& remedy = "") {
    try {
      const SourceText source = read_source_text(file.path, file.shown, kLargestToml);
      const TomlValue root = parse_toml(source);
      record(source, role);
      use(root);
    } catch (const InputError& error) {
      tree_.complete = false;
      for (const Fault& f : error.faults()) {
        const bool in_file = f.mark.line > 0;
        tree_.faults.push_back(
            in_file ? f
                    : Fault{mark, key + " = \"" + file.shown + "\": " + f.message, remedy.empty() ? f.remedy : remedy});
      }
    }
  }

  void add_oil_file(const std::vector<TomlEntry>& stated) {
    const std::string key = "lubricant.file";
    const TomlEntry* named = entries_.contains(key) ? &entries_.at(key) : nullptr;
    for (const TomlEntry& entry : stated) {
      if (entry.key == key) named = &entry;
    }
    if (named == nullptr || named->value.kind != TomlValue::Kind::kText || named->value.text.empty()) return;
    const NamedFile file = locate(named->value.text, named->folder);
    const SourceMark mark = named->value.mark;
    const auto use = [&](const TomlValue& root) {
      for (const auto& [name, value] : root.members) {
        if (name == "file" || value.kind == TomlValue::Kind::kTable) {
          fault(value.key_mark, name + " has no place in an oil file",
                "it holds the keys of [lubricant], without sections");
        } else {
          tree_.from_oil_file.insert(kOilSection + name);
          add({kOilSection + name, value, folder_of(file.shown)});
        }
      }
    };
    const std::string shipped = shipped_name(named->value.text, named->folder);
    read_named(
        mark, key, file, key, use,
        shipped.empty() ? "" : "this path was tried; the shipped oil is found from anywhere as \"" + shipped + "\"");
  }

  /// What a shipped oil is called from anywhere, of a name that leads to it through other folders; empty for none.
  static std::string shipped_name(const std::string& name, const std::string& folder) {
    const std::size_t begin = name.rfind("/data/");
    if (begin == std::string::npos) return "";
    const std::string bare = name.substr(begin + 1);
    return locate(bare, folder).shown == bare ? bare : "";
  }

  std::vector<TomlEntry> read_overrides(const std::vector<Override>& overrides) {
    std::vector<TomlEntry> stated;
    for (const auto& [key, text] : overrides) {
      TomlEntry entry{key, {}, ""};
      entry.value.key_mark = entry.value.mark = {"--set", 0, 0, ""};
      if (key == "include") {
        fault(entry.value.mark, "include cannot be set on the command line",
              "write it into the case file, or set the keys of that file one by one");
        continue;
      }
      if (!check_known(entry)) continue;
      if (text.empty()) {
        entries_.erase(key);
        continue;
      }
      try {
        entry.value = parse_toml_value(text);
      } catch (const InputError&) {
        entry.value.kind = TomlValue::Kind::kText;
      }
      if (is_text_key(*field_of(key)) && entry.value.kind != TomlValue::Kind::kText) {
        entry.value = {};
        entry.value.kind = TomlValue::Kind::kText;
      }
      if (entry.value.kind == TomlValue::Kind::kText && entry.value.text.empty()) entry.value.text = text;
      from_command_line(entry.value);
      stated.push_back(entry);
    }
    return stated;
  }

  static void from_command_line(TomlValue& value) {
    value.key_mark = value.mark = {"--set", 0, 0, ""};
    for (TomlValue& item : value.items) from_command_line(item);
    for (auto& [name, member] : value.members) from_command_line(member);
  }

  void replace(const TomlEntry& entry) {
    entries_.insert_or_assign(entry.key, entry);
    tree_.faulty.erase(entry.key);
    tree_.from_oil_file.erase(entry.key);
  }

  CaseTree tree_;
  std::map<std::string, TomlEntry> entries_;
  std::vector<std::string> open_;                ///< files being read, for include loops
  std::map<std::string, std::string> included_;  ///< identity of each, and where it was included first
  CaseNames names_;
};

}  // namespace

CaseTree read_case_tree(const std::string& path, const std::vector<Override>& overrides) {
  return Gatherer(path).gather(overrides);
}

}  // namespace ringfilm::io
