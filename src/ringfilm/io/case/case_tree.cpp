#include "ringfilm/io/case/case_tree.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "ringfilm/case/conditions.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/shipped_oils.hpp"
#include "ringfilm/io/text/document_kind.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/trade_terms.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepestInclude = 8;
const std::string kOilSection = "lubricant.";
const char* const kOilFile = "lubricant.file";
const char* const kOilGrade = "lubricant.grade";

/// Several ways to state one thing, each with its keys.
using Ways = std::vector<std::vector<std::string>>;
/// Quantities with several ways to state each; a case uses one of them. The first key of a way decides.
const std::vector<Ways> kWays = {
    {{"ring.elastic_pressure"},
     {"ring.tangential_force"},
     {"ring.expander_force"},
     {"ring.free_gap"},
     {"ring.free_shape", "ring.free_shape_smoothing"}},
    {{"pad.separation", "pad.oscillation.amplitude", "pad.oscillation.period", "pad.oscillation.phase"},
     {"pad.load"},
     {"pad.separation_history"}},
    {{kOilFile}, {kOilGrade}},
    {{"lubricant.distillation"}, {"lubricant.noack"}},
};

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }

/// A case has some ten sections; a file of its own for each, and as many again.
constexpr std::size_t kMaxIncludes = 32;
/// A file with more faults than this is of another kind; to seek the nearest key takes longer than all else.
constexpr std::size_t kMaxSuggestions = 100;

/// The keys and sections of a case file.
struct CaseNames {
  std::vector<std::string> keys{"include"}, keys_of_cycle, sections;
  std::set<std::string> all_sections;  ///< those that hold only sections among them

  CaseNames() {
    for (const cycle::Field& field : cycle::case_fields()) {
      keys.push_back(field.key);
      if (field.key.rfind("pad.", 0) != 0) keys_of_cycle.push_back(field.key);
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

/// A key of a ring 0, as one that counts from 0 writes it.
bool is_ring_zero(const std::string& key) {
  const std::size_t digits = std::string("ring.").size(), end = key.find_first_not_of('0', digits);
  return key.rfind("ring.0", 0) == 0 && end != std::string::npos && key[end] == '.';
}

const cycle::Field* field_of(const std::string& key) { return cycle::find_field(plain_key(key)); }

/// The section of the table behind a section of a case: `ring.2`, `ring.2.contact` and `ring.2.film` belong to a ring
/// of a pack.
std::string plain_section(const std::string& section) {
  const std::string one = ".land_lift";  // the last part of a key that each of these may have
  const std::string key = plain_key(section + one);
  return key.substr(0, key.size() - one.size());
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

/// Does the line of a key or section end with a comment that calls it assumed?
bool has_assumed_comment(const SourceMark& mark) {
  const std::size_t comment = mark.line_text.find('#');
  return comment != std::string::npos && mark.line_text.find("assumed", comment) != std::string::npos;
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
  Gatherer(const std::string& path, std::vector<DroppedKey>* dropped) : dropped_(dropped) { tree_.path = path; }

  CaseTree gather(const std::vector<Override>& overrides) {
    const SourceText source = read_source_text(tree_.path, tree_.path, kMaxToml);
    const TomlValue root = parse_toml(source);
    check_document_kind(root, DocumentKind::kCase, tree_.path);
    record(source, "case");
    open_.push_back(identity(tree_.path));
    add_file(root, tree_.path);
    const std::vector<TomlEntry> stated = read_overrides(overrides);
    drop_other_ways(stated);
    drop_other_conditions(stated);
    add_oil(stated);
    for (const TomlEntry& entry : stated) {
      tree_.assumed.erase(entry.key);
      replace(entry);
    }
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

  /// Reports a list of rings that is empty, and takes it out.
  void refuse_no_rings(TomlValue& root) {
    std::erase_if(root.members, [this](const auto& member) {
      const auto& [name, value] = member;
      if (name != "ring" || value.kind != TomlValue::Kind::kList || !value.items.empty()) return false;
      fault(value.key_mark, "ring = [] has no ring",
            "state each ring in a [[ring]] section, the one next to the chamber first, or one ring in [ring]");
      tree_.faulty.insert("ring.");
      return true;
    });
  }

  void add_file(TomlValue root, const std::string& path) {
    refuse_no_rings(root);
    number_rings(root);
    FlatToml flat = flatten(root, folder_of(path));
    drop_unknown_sections(flat);
    note_assumed(flat);
    for (const TomlEntry& entry : flat.entries) {
      if (entry.key == "include") {
        add_includes(entry);
      } else {
        add(entry);
      }
    }
  }

  void note_assumed(const FlatToml& flat) {
    std::set<std::string> sections;
    for (const TomlEntry& section : flat.sections) {
      if (has_assumed_comment(section.value.key_mark)) sections.insert(section.key);
    }
    for (const TomlEntry& entry : flat.entries) {
      if (has_assumed_comment(entry.value.key_mark) || lies_in(entry.key, sections)) tree_.assumed.insert(entry.key);
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
    if (const TradeTerm* const term = trade_term(section.key); term != nullptr && field == nullptr) {
      const KeyProposal proposal = key_proposal(section.key, names_.keys);
      return fault(section.value.key_mark, "unknown section [" + section.key + "]" + proposal.message, proposal.remedy);
    }
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
    return tree_.faults.size() < kMaxSuggestions ? nearest_word(word, known) : "";
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
    KeyProposal proposal{"", "", "`ringfilm fields` lists all keys"};
    if (is_ring_zero(entry.key)) {
      proposal.message = ": rings count from 1, the one next to the chamber";
    } else if (tree_.faults.size() < kMaxSuggestions) {
      proposal = key_proposal(plain_key(entry.key), names_of(plain_key(entry.key)));
    }
    if (const auto of_ring = cycle::ring_key(entry.key); of_ring && !proposal.near.empty()) {
      proposal.near = cycle::pack_key(of_ring->ring, proposal.near);
      proposal.message = did_you_mean(proposal.near);
    }
    if (!proposal.near.empty()) tree_.faulty.insert(proposal.near);
    fault(entry.value.key_mark, "unknown key " + entry.key + proposal.message, proposal.remedy);
    return false;
  }

  /// Keys that may be meant: those of a pad only by a key of a pad.
  const std::vector<std::string>& names_of(const std::string& written) const {
    return written.rfind("ring.", 0) == 0 ? names_.keys_of_cycle : names_.keys;
  }

  void add(const TomlEntry& entry) {
    if (!check_known(entry)) return;
    const auto [found, inserted] = entries_.emplace(entry.key, entry);
    if (inserted) return;
    tree_.faulty.insert(entry.key);
    fault(entry.value.key_mark, entry.key + " is given twice",
          deletion_words(found->second.value.key_mark, entry.value.key_mark));
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
    if (open_.size() > kDeepestInclude || included_.size() > kMaxIncludes) {
      tree_.complete = false;
      fault(name.mark,
            open_.size() > kDeepestInclude ? "files are included more than " + std::to_string(kDeepestInclude) + " deep"
                                           : "more than " + std::to_string(kMaxIncludes) + " files are included",
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
      const SourceText source = read_source_text(file.path, file.shown, kMaxToml);
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

  /// What is in force of a key: the value of the command line, else that of the files; nullptr for none.
  const TomlEntry* in_force(const std::string& key, const std::vector<TomlEntry>& stated) const {
    const auto of_line =
        std::find_if(stated.rbegin(), stated.rend(), [&](const auto& entry) { return entry.key == key; });
    if (of_line != stated.rend()) return &*of_line;
    const auto found = entries_.find(key);
    return found == entries_.end() ? nullptr : &found->second;
  }

  static bool is_name(const TomlEntry* entry) {
    return entry != nullptr && entry->value.kind == TomlValue::Kind::kText && !entry->value.text.empty();
  }

  /// Reads the oil that lubricant.file or lubricant.grade names.
  void add_oil(const std::vector<TomlEntry>& stated) {
    const TomlEntry* const file = in_force(kOilFile, stated);
    const TomlEntry* const grade = in_force(kOilGrade, stated);
    if (file != nullptr && grade != nullptr) {
      const SourceMark &one = file->value.key_mark, &other = grade->value.key_mark;
      fault(other, std::string(kOilGrade) + " and " + kOilFile + " are both given",
            one.line > 0 && other.line > 0 ? deletion_words(one, other) : "keep one of them");
      tree_.faulty.insert(kOilSection);
    } else if (is_name(file)) {
      const std::string shipped = shipped_name(file->value.text, file->folder);
      read_oil(
          *file, locate(file->value.text, file->folder),
          shipped.empty() ? "" : "this path was tried; the shipped oil is found from anywhere as \"" + shipped + "\"",
          stated);
    } else if (is_name(grade)) {
      try {
        read_oil(*grade, shipped_oil_of_grade(grade->value.text), "", stated);
      } catch (const InputError& unknown) {
        const Fault& first = unknown.faults().front();
        fault(grade->value.mark, std::string(kOilGrade) + ": " + first.message, first.remedy);
        tree_.faulty.insert(kOilSection);
      }
    }
  }

  /// Another way in which the case states what that key of an oil file states; empty for none.
  std::string other_way(const std::string& key, const std::vector<TomlEntry>& stated) const {
    for (const Ways& ways : kWays) {
      const auto is_this = [&key](const std::vector<std::string>& way) { return way.front() == key; };
      if (std::none_of(ways.begin(), ways.end(), is_this)) continue;
      for (const std::vector<std::string>& way : ways) {
        if (!is_this(way) && in_force(way.front(), stated) != nullptr) return way.front();
      }
    }
    return "";
  }

  void read_oil(const TomlEntry& naming, const NamedFile& file, const std::string& remedy,
                const std::vector<TomlEntry>& stated) {
    const bool replaces = naming.value.mark.line == 0 && dropped_ != nullptr;
    const auto use = [&](const TomlValue& root) {
      for (const TomlEntry& entry : oil_entries(root, folder_of(file.shown), tree_.faults)) {
        if (const std::string other = other_way(entry.key, stated); !other.empty()) {
          tree_.notes.push_back(other + " of the case replaces " + entry.key + " of the oil file");
          continue;
        }
        if (replaces) drop(entry.key);
        tree_.from_oil_file.insert(entry.key);
        add_of_oil(entry, naming.key);
      }
    };
    read_named(naming.value.mark, naming.key, file, kOilFile, use, remedy);
  }

  /// A key of the oil file; the case cannot state it, too.
  void add_of_oil(const TomlEntry& entry, const std::string& naming_key) {
    const auto found = entries_.find(entry.key);
    if (found == entries_.end()) return add(entry);
    const SourceMark mark = found->second.value.key_mark;
    tree_.faulty.insert(entry.key);
    fault(mark, entry.key + " is given twice",
          "delete line " + std::to_string(mark.line) + " of " + mark.file + ", or " + naming_key +
              ": the oil file has it at " + place(entry.value.key_mark));
  }

  /// Takes out what the files state in another of several ways of which a case takes one, where the command line states
  /// one of them.
  void drop_other_ways(const std::vector<TomlEntry>& stated) {
    if (dropped_ == nullptr) return;
    for (const TomlEntry& entry : stated) {
      const auto of_ring = cycle::ring_key(entry.key);
      const std::string key = plain_key(entry.key);
      for (const Ways& ways : kWays) {
        const auto is_this = [&key](const std::vector<std::string>& way) { return way.front() == key; };
        if (std::none_of(ways.begin(), ways.end(), is_this)) continue;
        for (const std::vector<std::string>& way : ways) {
          for (const std::string& other : way) {
            if (!is_this(way)) drop(of_ring ? cycle::pack_key(of_ring->ring, other) : other);
          }
        }
      }
    }
  }

  /// The conditions of a name; of one that the key does not have, which is refused elsewhere, those of the case.
  static cycle::Conditions conditions_of(const std::string& name) {
    const auto& choice = std::get<cycle::ChoiceKind>(cycle::find_field("conditions")->kind);
    const auto found = std::find(choice.names.begin(), choice.names.end(), name);
    cycle::Case c;
    if (found != choice.names.end()) choice.choose(c, static_cast<int>(found - choice.names.begin()));
    return c.conditions;
  }

  /// Conditions of the command line replace those that files state.
  void drop_other_conditions(const std::vector<TomlEntry>& stated) {
    const auto are_conditions = [](const TomlEntry& entry) { return entry.key == "conditions"; };
    const auto asked = std::find_if(stated.begin(), stated.end(), are_conditions);
    if (dropped_ == nullptr || asked == stated.end()) return;
    const auto own = entries_.find("conditions");
    if (own != entries_.end() && own->second.value.text == asked->value.text) return;
    const cycle::Conditions conditions = conditions_of(asked->value.text);
    std::vector<std::string> keys;
    for (const auto& [key, entry] : entries_) {
      if (cycle::is_replaced_by(conditions, key)) keys.push_back(key);
    }
    for (const std::string& key : keys) drop(key);
  }

  void drop(const std::string& key) {
    const auto found = entries_.find(key);
    if (found == entries_.end()) return;
    dropped_->push_back({key, found->second.value.key_mark});
    entries_.erase(found);
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
    for (const auto& [key, text, option] : overrides) {
      TomlEntry entry{key, {}, ""};
      entry.value.key_mark = entry.value.mark = {option, 0, 0, ""};
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
      set_mark(entry.value, {option, 0, 0, ""});
      stated.push_back(entry);
    }
    return stated;
  }

  static void set_mark(TomlValue& value, const SourceMark& mark) {
    value.key_mark = value.mark = mark;
    for (TomlValue& item : value.items) set_mark(item, mark);
    for (auto& [name, member] : value.members) set_mark(member, mark);
  }

  void replace(const TomlEntry& entry) {
    if (dropped_ != nullptr && tree_.from_oil_file.contains(entry.key)) {
      dropped_->push_back({entry.key, entries_.at(entry.key).value.key_mark});
    }
    entries_.insert_or_assign(entry.key, entry);
    tree_.faulty.erase(entry.key);
    tree_.from_oil_file.erase(entry.key);
  }

  std::vector<DroppedKey>* dropped_;  ///< nullptr: the command line drops nothing
  CaseTree tree_;
  std::map<std::string, TomlEntry> entries_;
  std::vector<std::string> open_;                ///< files being read, for include loops
  std::map<std::string, std::string> included_;  ///< identity of each, and where it was included first
  CaseNames names_;
};

}  // namespace

std::vector<TomlEntry> oil_entries(const TomlValue& root, const std::string& folder, std::vector<Fault>& faults) {
  std::vector<TomlEntry> entries;
  for (const auto& [name, value] : root.members) {
    if (name == "file" || name == "grade" || value.kind == TomlValue::Kind::kTable) {
      faults.push_back({value.key_mark, name + " has no place in an oil file",
                        "it holds the keys of [lubricant], without sections"});
    } else {
      entries.push_back({kOilSection + name, value, folder});
    }
  }
  return entries;
}

CaseTree read_case_tree(const std::string& path, const std::vector<Override>& overrides,
                        std::vector<DroppedKey>* dropped) {
  return Gatherer(path, dropped).gather(overrides);
}

}  // namespace ringfilm::io
