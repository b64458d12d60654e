#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_tree.hpp"

namespace ringfilm::io {
namespace {

constexpr const char* kAbove = "ring.pressure_above";
constexpr const char* kBelow = "ring.pressure_below";
constexpr const char* kLand = "ring.land_below";
/// More rings than any engine has; a larger number is a slip.
constexpr std::size_t kMaxRings = 20;

using Entries = std::map<std::string, TomlEntry>;

/// The entries of one ring, by the keys of a case of one ring.
struct RingEntries {
  Entries entries;
  std::set<std::string> faulty;
};

std::string number(std::size_t ring) { return std::to_string(ring); }

/// A piston land lies between two rings.
void refuse_last_land(const std::string& key, const TomlEntry* stated, std::vector<Fault>& faults) {
  if (stated == nullptr) return;
  faults.push_back({stated->value.key_mark,
                    key + " is the height of a piston land between two rings, and no ring follows", "leave it out"});
}

/// Does the case state the pressures of the piston lands? One whose model is not known may compute them.
bool has_given_gas(const std::vector<TomlEntry>& common) {
  const auto model = std::ranges::find(common, "gas_path.model", &TomlEntry::key);
  return model == common.end() || model->value.text == "given";
}

/// Gives each ring the pressure of the piston land above it.
void join_lands(std::map<std::size_t, RingEntries>& rings, const std::string& path, PackTrees& pack) {
  for (std::size_t i = 2; i <= rings.size(); ++i) {
    Entries &upper = rings.at(i - 1).entries, &ring = rings.at(i).entries;
    if (const auto stated = ring.find(kAbove); stated != ring.end()) {
      pack.faults.push_back({stated->second.value.key_mark,
                             cycle::pack_key(i, kAbove) + " is the pressure below ring " + number(i - 1),
                             "state " + cycle::pack_key(i - 1, kBelow) + " alone"});
    } else if (const auto land = upper.find(kBelow); land != upper.end()) {
      TomlEntry above = land->second;
      above.key = kAbove;
      ring.emplace(kAbove, std::move(above));
    } else if (!rings.at(i - 1).faulty.contains(kBelow)) {
      pack.missing_pressures.push_back(
          {{path, 0, 0, ""},
           "the key " + cycle::pack_key(i - 1, kBelow) + " is missing: the gas pressure between the rings " +
               number(i - 1) + " and " + number(i),
           "write, for example, pressure_below = \"1.4 bar\", or a CSV file like that of the cylinder, in that "
           "[[ring]]"});
    }
  }
}

}  // namespace

PackTrees pack_trees(CaseTree tree) {
  std::map<std::size_t, RingEntries> rings;
  std::vector<TomlEntry> common;
  const TomlEntry* single = nullptr;
  for (const TomlEntry& entry : tree.entries) {
    const auto of_ring = cycle::ring_key(entry.key);
    if (!of_ring) {
      if (entry.key.rfind("ring.", 0) == 0) single = &entry;
      common.push_back(entry);
      continue;
    }
    TomlEntry plain = entry;
    plain.key = of_ring->key;
    rings[of_ring->ring].entries.emplace(of_ring->key, std::move(plain));
  }
  PackTrees pack;
  if (rings.empty()) {
    const auto land = std::ranges::find(tree.entries, kLand, &TomlEntry::key);
    refuse_last_land(kLand, land == tree.entries.end() ? nullptr : &*land, pack.faults);
    pack.trees.push_back(std::move(tree));
    return pack;
  }
  pack.is_pack = true;
  const std::size_t n = rings.rbegin()->first;
  if (n > kMaxRings) {
    pack.faults.push_back({rings.rbegin()->second.entries.begin()->second.value.key_mark,
                           "ring " + number(n) + " is stated, and a pack has " + number(kMaxRings) + " rings at most",
                           "take rings out"});
    return pack;
  }
  if (n != rings.size()) {
    pack.faults.push_back({rings.rbegin()->second.entries.begin()->second.value.key_mark,
                           "ring " + number(n) + " is stated, but there are " + number(rings.size()) + " rings",
                           "rings count from 1, the one next to the chamber"});
    return pack;
  }
  if (single != nullptr) {
    pack.faults.push_back({single->value.key_mark, single->key + " belongs to no ring of the pack",
                           single->value.key_mark.line == 0
                               ? "a key of one ring is " + cycle::pack_key(1, single->key)
                               : "write it into a [[ring]] section, or [ring] for a case of one ring"});
    std::erase_if(common, [](const TomlEntry& entry) { return entry.key.rfind("ring.", 0) == 0; });
  }
  std::set<std::string> faulty;
  for (const std::string& key : tree.faulty) {
    const auto of_ring = cycle::ring_key(key);
    if (of_ring && rings.contains(of_ring->ring)) {
      rings.at(of_ring->ring).faulty.insert(of_ring->key);
    } else {
      faulty.insert(key);
    }
  }
  if (has_given_gas(common)) join_lands(rings, tree.path, pack);
  const Entries& last = rings.at(n).entries;
  const auto land = last.find(kLand);
  refuse_last_land(cycle::pack_key(n, kLand), land == last.end() ? nullptr : &land->second, pack.faults);
  for (auto& [i, ring] : rings) {
    CaseTree one = tree;
    if (i > 1) one.faults.clear();
    one.faulty = faulty;
    one.faulty.merge(ring.faulty);
    one.entries.clear();
    for (const TomlEntry& entry : common) {
      if (!ring.entries.contains(entry.key)) one.entries.push_back(entry);
    }
    for (auto& [key, entry] : ring.entries) one.entries.push_back(std::move(entry));
    pack.trees.push_back(std::move(one));
  }
  return pack;
}

}  // namespace ringfilm::io
