#include "ringfilm/io/case/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>

#include "ringfilm/base/append_new.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/io/case/case_checks.hpp"
#include "ringfilm/io/case/case_data.hpp"
#include "ringfilm/io/case/case_tree.hpp"
#include "ringfilm/io/case/case_values.hpp"

namespace ringfilm::io {
namespace {

using cycle::Case;

class CaseReader {
 public:
  CaseReader(CaseTree tree, const Units& units, CasePurpose purpose = CasePurpose::kFilm)
      : tree_(std::move(tree)), units_(units), purpose_(purpose) {}

  /// @param faults receives all that is wrong, each with its key where one is known
  Case read(std::vector<KeyFault>& faults) {
    read_values();
    read_data_files();
    if (tree_.complete) check();
    add_tree_faults("");
    sort_faults();
    faults = std::move(faults_);
    return std::move(case_);
  }

  /// The case of a tree that may have faults.
  Case read_as_far_as_possible(bool with_data_files) {
    read_values();
    if (with_data_files) read_data_files();
    return std::move(case_);
  }
  bool has_faults() const { return !faults_.empty(); }

 private:
  void read_values() {
    case_ = cycle::blank_case(purpose_ == CasePurpose::kClosure ? cycle::Problem::kClosure : problem());
    case_.purpose = purpose_;
    case_.files = tree_.files;
    case_.notes = tree_.notes;
    // First, since all other keys replace what the conditions set.
    const auto conditions = std::find_if(tree_.entries.begin(), tree_.entries.end(),
                                         [](const TomlEntry& entry) { return entry.key == "conditions"; });
    if (conditions != tree_.entries.end()) {
      read_value(*conditions);
      if (case_.problem == cycle::Problem::kCycle) cycle::set_conditions(case_.conditions, case_);
    }
    for (const TomlEntry& entry : tree_.entries) {
      if (entry.key != "conditions") read_value(entry);
    }
    cycle::keep_own_temperature(case_);
  }

  /// A pad where any of its keys is stated, be it with a slip; a static closure where keys of it and none of a cycle
  /// are.
  cycle::Problem problem() const {
    const auto of_section = [](const std::string& key, const char* section) { return key.rfind(section, 0) == 0; };
    const auto any_stated = [&](const auto& is_one) {
      return std::any_of(tree_.entries.begin(), tree_.entries.end(),
                         [&](const TomlEntry& entry) { return is_one(entry.key); }) ||
             std::any_of(tree_.faulty.begin(), tree_.faulty.end(), is_one);
    };
    if (any_stated([&](const std::string& key) { return of_section(key, "pad."); })) return cycle::Problem::kPad;
    const Case closure = cycle::blank_case(cycle::Problem::kClosure);
    const bool of_cycle = any_stated([&](const std::string& key) {
      const cycle::Field* field = cycle::find_field(key);
      return field == nullptr || !cycle::belongs(*field, closure);
    });
    const bool of_closure = any_stated([&](const std::string& key) { return of_section(key, "conform."); });
    return of_closure && !of_cycle ? cycle::Problem::kClosure : cycle::Problem::kCycle;
  }

  void read_value(const TomlEntry& entry) {
    given_[entry.key] = &entry;
    case_.stated.insert(entry.key);
    add_tree_faults("");
    if (!set_value(case_, *cycle::find_field(entry.key), entry, units_, tree_.faults)) tree_.faulty.insert(entry.key);
    add_tree_faults(entry.key);
  }

  bool is_good(const std::string& key) const { return given_.contains(key) && !is_faulty(key); }

  bool is_faulty(const std::string& key) const {
    return std::any_of(tree_.faulty.begin(), tree_.faulty.end(), [&key](const std::string& faulty) {
      return key == faulty || (faulty.back() == '.' && key.rfind(faulty, 0) == 0);
    });
  }

  void read_data_files() {
    for (const DataFile& data : data_files(case_, units_)) {
      if (is_good(data.key)) read_data(data);
    }
  }

  void read_data(const DataFile& data) {
    try {
      read_data_file(data, case_);
    } catch (const InputError& error) {
      tree_.faulty.insert(data.key);
      for (const Fault& f : error.faults()) {
        const bool in_file = f.mark.line > 0;
        const SourceMark& named = given_.at(data.key)->value.mark;
        const std::string file = f.mark.file.empty() ? "" : f.mark.file + ": ";
        tree_.faults.push_back(in_file ? f : Fault{named, data.key + ": " + file + f.message, f.remedy});
      }
    }
  }

  void check() {
    StatedKeys stated{tree_.path, {}, tree_.faulty, tree_.from_oil_file};
    for (const auto& [key, entry] : given_) stated.given[key] = {entry->value.key_mark, entry->value.mark};
    add_tree_faults("");
    std::ranges::move(case_faults(case_, stated), std::back_inserter(faults_));
  }

  /// Takes the faults that the tree has so far. @param key whose faults they are
  void add_tree_faults(const std::string& key) {
    for (Fault& fault : tree_.faults) faults_.push_back({key, std::move(fault)});
    tree_.faults.clear();
  }

  /// In the order in which a person meets them: file by file, from top to bottom, then what is missing.
  void sort_faults() {
    std::vector<std::string> order;
    for (const cycle::InputFile& file : case_.files) order.push_back(file.path);
    const auto rank = [&](const KeyFault& f) {
      const SourceMark& mark = f.fault.mark;
      const auto found = std::find(order.begin(), order.end(), mark.file);
      return std::tuple(mark.line == 0, found - order.begin(), mark.line, mark.column);
    };
    std::stable_sort(faults_.begin(), faults_.end(),
                     [&](const KeyFault& a, const KeyFault& b) { return rank(a) < rank(b); });
  }

  CaseTree tree_;
  const Units& units_;
  CasePurpose purpose_;
  Case case_;
  std::vector<KeyFault> faults_;
  std::map<std::string, const TomlEntry*> given_;
};

bool same(const Fault& a, const Fault& b) {
  return a.mark.file == b.mark.file && a.mark.line == b.mark.line && a.mark.column == b.mark.column &&
         a.message == b.message;
}

/// The faults of a pack, each once: those at no line of a file name their ring, but not where they are of a key that
/// all rings share.
void append_ring_faults(const std::vector<std::vector<KeyFault>>& of_rings, std::vector<Fault>& faults) {
  const auto has = [](const std::vector<KeyFault>& ring, const Fault& fault) {
    return std::ranges::any_of(ring, [&](const KeyFault& one) { return same(one.fault, fault); });
  };
  for (std::size_t i = 0; i < of_rings.size(); ++i) {
    std::vector<Fault> named;
    for (const KeyFault& of_key : of_rings[i]) {
      const std::string& key = of_key.key;
      Fault fault = of_key.fault;
      const bool of_ring = key.rfind("ring.", 0) == 0;
      const bool of_all = std::ranges::all_of(of_rings, [&](const auto& ring) { return has(ring, fault); });
      const bool may_be_common = cycle::may_be_of_ring(key) && of_all;
      if (fault.mark.line == 0 && cycle::is_of_ring(key) && (of_ring || !may_be_common)) {
        fault.message = "ring " + std::to_string(i + 1) + ": " + fault.message;
      }
      named.push_back(std::move(fault));
    }
    append_new(faults, std::move(named), same);
  }
}

/// Removes the keys of files that are in use in the case without the overrides, and not with them.
/// @param without_overrides the case of each tree @returns whether there was such a key
bool drop_unused(PackTrees& pack, const std::vector<Case>& without_overrides, bool with_data_files, const Units& units,
                 std::vector<DroppedKey>& dropped) {
  if (pack.trees.size() != without_overrides.size()) return false;
  std::size_t n_removed = 0;
  for (std::size_t i = 0; i < pack.trees.size(); ++i) {
    CaseTree& tree = pack.trees[i];
    const Case& once = without_overrides[i];
    CaseReader reader(tree, units);
    const Case now = reader.read_as_far_as_possible(with_data_files);
    // With a value that cannot be read it is not known what is in use.
    if (now.problem != once.problem || reader.has_faults()) continue;
    n_removed += std::erase_if(tree.entries, [&](const TomlEntry& entry) {
      const cycle::Field& field = *cycle::find_field(entry.key);
      const bool of_file = entry.value.key_mark.line > 0 && !tree.from_oil_file.contains(entry.key);
      if (!of_file || cycle::is_active(field, now) || !cycle::is_active(field, once)) return false;
      const std::string key = pack.is_pack ? cycle::pack_key(i + 1, entry.key) : entry.key;
      const auto is_same = [&key](const DroppedKey& one) { return one.key == key; };
      if (std::none_of(dropped.begin(), dropped.end(), is_same)) dropped.push_back({key, entry.value.key_mark});
      return true;
    });
  }
  return n_removed > 0;
}

/// What is wrong with the rings of a pack together, each at its place in the file.
std::vector<Fault> pack_faults(const Case& pack, const std::vector<std::map<std::string, SourceMark>>& places) {
  std::vector<Fault> faults;
  for (const cycle::RuleBreach& breach : cycle::broken_pack_rules(pack)) {
    const auto of_ring = cycle::ring_key(breach.key);
    const auto& of = places.at(of_ring ? of_ring->ring - 1 : 0);
    const auto found = of.find(of_ring ? of_ring->key : breach.key);
    faults.push_back({found == of.end() ? SourceMark{} : found->second, breach.message, breach.remedy});
  }
  return faults;
}

/// One fault in place of those of a pack that describes the gas between its rings without asking for it: each of these
/// keys is unused, and each pressure that they would give is missing.
void join_gas_faults(PackTrees& pack, std::vector<std::vector<KeyFault>>& of_rings) {
  const auto waits_for_gas = [](const KeyFault& one) {
    return one.used_where.find("gas_path.model = \"orifice-volume\"") != std::string::npos;
  };
  std::vector<KeyFault> waiting;
  for (std::size_t i = 0; i < of_rings.size(); ++i) {
    for (KeyFault one : of_rings[i]) {
      one.key = cycle::pack_key(i + 1, one.key);
      const bool is_known = std::ranges::any_of(waiting, [&](const KeyFault& k) { return k.key == one.key; });
      if (waits_for_gas(one) && !is_known) waiting.push_back(std::move(one));
    }
  }
  if (waiting.size() < 2) return;
  for (std::vector<KeyFault>& ring : of_rings) std::erase_if(ring, waits_for_gas);
  pack.missing_pressures.clear();
  const KeyFault& first = waiting.front();
  pack.faults.push_back({first.fault.mark,
                         fmt::format("{} and {} more keys are those of the gas between the rings, which is not "
                                     "computed: the case does not state gas_path.model = \"orifice-volume\"",
                                     first.key, waiting.size() - 1),
                         "write model = \"orifice-volume\" in [gas_path]; or remove these keys and state "
                         "pressure_below, the pressure between two rings, in each [[ring]] but the last"});
}

/// Refuses a pad where rings are required.
void refuse_pad(const CaseTree& tree, const char* what, const char* remedy) {
  for (const TomlEntry& entry : tree.entries) {
    if (entry.key.rfind("pad.", 0) == 0) {
      throw InputError({Fault{entry.value.key_mark, std::string("a case with [pad] has no ") + what, remedy}});
    }
  }
}

/// Refuses a case that describes the gas of its rings alone where films are to be computed: every key of oil and
/// contact would be missing.
void refuse_gas_alone(const PackTrees& pack, const std::string& path) {
  const auto states = [&](const auto& is_meant) {
    return std::ranges::any_of(pack.trees, [&](const CaseTree& tree) {
      return std::ranges::any_of(tree.entries, [&](const TomlEntry& one) { return is_meant(one.key); }) ||
             std::ranges::any_of(tree.faulty, is_meant) || !tree.complete;
    });
  };
  const auto is_of_films = [](const std::string& key) {
    return key.starts_with("contact.") || key.starts_with("lubricant.") || key == "operating.oil_temperature";
  };
  const auto is_of_gas = [](const std::string& key) { return key == "gas_path.model"; };
  if (!states(is_of_gas) || states(is_of_films)) return;
  throw InputError(
      {Fault{{path, 0, 0, ""},
             "the case describes the gas of its rings alone: it states no key of [lubricant] and [contact]",
             "compute it with ringfilm gas " + path +
                 ", in a study with compute = \"gas\"; films require [lubricant] and [contact], too"}});
}

Case case_of(PackTrees pack, const Units& units, CasePurpose purpose = CasePurpose::kFilm) {
  if (purpose == CasePurpose::kGasPath) {
    for (const CaseTree& tree : pack.trees) {
      refuse_pad(tree, "ring pack", "name a case with [engine], [gas] and [ring] or [[ring]]");
    }
  } else if (purpose == CasePurpose::kFilm && !pack.trees.empty()) {
    refuse_gas_alone(pack, pack.trees.front().path);
  }
  std::vector<Case> cases;
  std::vector<std::map<std::string, SourceMark>> places(pack.trees.size());
  std::vector<std::vector<KeyFault>> of_rings(pack.trees.size());
  for (std::size_t i = 0; i < pack.trees.size(); ++i) {
    for (const TomlEntry& entry : pack.trees[i].entries) places[i][entry.key] = entry.value.mark;
    cases.push_back(CaseReader(std::move(pack.trees[i]), units, purpose).read(of_rings[i]));
  }
  if (pack.is_pack) join_gas_faults(pack, of_rings);
  const auto is_model = [](const KeyFault& one) { return one.key == "gas_path.model"; };
  if (std::ranges::any_of(of_rings, [&](const auto& of) { return std::ranges::any_of(of, is_model); })) {
    pack.missing_pressures.clear();  // which the model may compute
  }
  std::vector<Fault> faults = std::move(pack.faults);
  std::ranges::move(pack.missing_pressures, std::back_inserter(faults));
  if (pack.is_pack) {
    append_ring_faults(of_rings, faults);
  } else {
    for (KeyFault& one : of_rings.front()) faults.push_back(std::move(one.fault));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  Case all = pack.is_pack ? ring_pack(std::move(cases)) : std::move(cases.front());
  if (faults = pack_faults(all, places); !faults.empty()) throw InputError(std::move(faults));
  return all;
}

}  // namespace

cycle::Case ring_pack(std::vector<cycle::Case> rings) {
  Case pack = rings.front();
  pack.stated.clear();
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (const std::string& key : rings[i].stated) {
      if (!cycle::is_implied_in_pack(i + 1, key)) pack.stated.insert(cycle::pack_key(i + 1, key));
    }
    append_new(pack.files, rings[i].files, [](const auto& a, const auto& b) { return a.path == b.path; });
    append_new(pack.notes, rings[i].notes, std::equal_to());
  }
  pack.rings = std::move(rings);
  return pack;
}

cycle::Case read_case(const std::string& path, const std::vector<Override>& overrides) {
  return read_case(path, overrides, Units());
}

cycle::Case read_case(const std::string& path, const std::vector<Override>& overrides, const Units& units,
                      CasePurpose purpose) {
  return case_of(pack_trees(read_case_tree(path, overrides)), units, purpose);
}

namespace {

/// Leaves the keys that the static closure uses, of a pack those of its first ring.
void keep_closure(CaseTree& tree) {
  const Case closure = cycle::blank_case(cycle::Problem::kClosure);
  const auto is_other = [&](const std::string& key) {
    const auto of_ring = cycle::ring_key(key);
    const cycle::Field* field = cycle::find_field(of_ring ? of_ring->key : key);
    return (of_ring && of_ring->ring > 1) || (field != nullptr && !cycle::belongs(*field, closure));
  };
  refuse_pad(tree, "ring that could close", "name the case of a ring, with engine.bore, [ring] and [liner]");
  std::erase_if(tree.entries, [&](const TomlEntry& entry) { return is_other(entry.key); });
  std::erase_if(tree.faulty, is_other);
  tree.from_oil_file.clear();
}

PackTrees closure_trees(const std::string& path, const std::vector<Override>& overrides,
                        std::vector<DroppedKey>* dropped) {
  CaseTree tree = read_case_tree(path, overrides, dropped);
  keep_closure(tree);
  return pack_trees(std::move(tree));
}

}  // namespace

cycle::Case read_closure_case(const std::string& path, const std::vector<Override>& overrides, const Units& units,
                              std::vector<DroppedKey>& dropped) {
  return case_of(closure_trees(path, overrides, &dropped), units, CasePurpose::kClosure);
}

cycle::Case read_case_dropping(const std::string& path, const std::vector<Override>& overrides, const Units& units,
                               std::vector<DroppedKey>& dropped, CasePurpose purpose) {
  PackTrees pack = pack_trees(read_case_tree(path, overrides, &dropped));
  if (!overrides.empty()) {
    // Whether a trace covers the cycle decides on keys of the gas, and data files on no others.
    const bool with_data_files = std::any_of(overrides.begin(), overrides.end(), [](const Override& override) {
      return override.key.rfind("gas.", 0) == 0;
    });
    std::vector<Case> without_overrides;
    const PackTrees before = pack_trees(read_case_tree(path, {}));
    for (const CaseTree& tree : before.trees) {
      without_overrides.push_back(CaseReader(tree, units).read_as_far_as_possible(with_data_files));
    }
    while (drop_unused(pack, without_overrides, with_data_files, units, dropped)) {
      // A key that was removed may have been the reason for another.
    }
  }
  return case_of(std::move(pack), units, purpose);
}

std::set<std::string> keys_called_assumed(const std::string& path, const std::vector<Override>& overrides) {
  std::vector<DroppedKey> dropped;
  return read_case_tree(path, overrides, &dropped).assumed;
}

std::string listed(const std::vector<DroppedKey>& dropped) {
  std::string text;
  for (const auto& [key, mark] : dropped) {
    text += (text.empty() ? "" : ", ") + key + " (" + mark.file + ":" + std::to_string(mark.line) + ")";
  }
  return text;
}

}  // namespace ringfilm::io
