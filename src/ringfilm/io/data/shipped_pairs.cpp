#include "ringfilm/io/data/shipped_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/toml_table.hpp"

namespace ringfilm::io {
namespace {

using models::FrictionPair;
using models::FrictionState;

const std::vector<std::pair<std::string, FrictionState>> kStates = {{"lubricated", FrictionState::kLubricated},
                                                                    {"dry", FrictionState::kDry}};

constexpr std::size_t kMaxLibrary = std::size_t{1} << 20;  // [byte]

void read_friction(TomlTable& table, FrictionPair& pair) {
  const auto friction = table.number("friction");
  if (!friction || !(*friction > 0)) {
    table.refuse(table.mark(), "friction is missing or not above 0", "state the coefficient, for example 0.12");
    return;
  }
  pair.friction = *friction;
  const std::vector<TomlValue> band = table.items("band");
  if (band.empty()) return;
  if (band.size() != 2 || !(band[0].number <= pair.friction && pair.friction <= band[1].number)) {
    table.refuse(table.find("band")->mark, "band does not enclose the coefficient", "write band = [low, high]");
    return;
  }
  pair.low = band[0].number;
  pair.high = band[1].number;
}

FrictionPair read_pair(const TomlValue& value, const Units& units, std::vector<Fault>& faults) {
  TomlTable table(value, "[[pair]]", {"name", "coating", "liner", "state", "friction", "band", "hardness", "source"},
                  faults);
  FrictionPair pair;
  pair.name = table.needed_text("name", "\"crn-on-grey-iron\"");
  pair.coating = table.needed_text("coating", "\"CrN (PVD)\"");
  pair.liner = table.needed_text("liner", "\"grey iron\"");
  pair.source = table.needed_text("source", "\"typical, assumed\"");
  table.need("state", "\"lubricated\"");
  table.choose("state", kStates, pair.state);
  read_friction(table, pair);
  pair.hardness = table.quantity("hardness", "Pa", "\"2.5 GPa\"", units);
  return pair;
}

nlohmann::ordered_json maybe(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace

FrictionPairs read_friction_pairs(const NamedFile& file, const Units& units) {
  const SourceText source = read_source_text(file.path, file.shown, kMaxLibrary);
  const TomlValue root = parse_toml(source);
  FrictionPairs all;
  all.sha256 = source.sha256;
  std::vector<Fault> faults;
  std::set<std::string> names;
  TomlTable whole(root, "the library", {"pair"}, faults);
  for (const TomlValue& item : whole.items("pair")) {
    all.pairs.push_back(read_pair(item, units, faults));
    if (names.insert(all.pairs.back().name).second) continue;
    faults.push_back(
        {item.key_mark, "the name " + io::quoted(all.pairs.back().name) + " comes twice", "keep one of them"});
  }
  if (all.pairs.empty() && faults.empty()) faults.push_back({source.mark(0), "there is no [[pair]]", "state one"});
  if (!faults.empty()) throw InputError(std::move(faults));
  return all;
}

FrictionPairs shipped_pairs(const Units& units) { return read_friction_pairs(locate(kPairsFile, ""), units); }

FrictionPair pair_of_name(const FrictionPairs& pairs, const std::string& name) {
  std::string known;
  for (const FrictionPair& pair : pairs.pairs) {
    if (pair.name == name) return pair;
    known += (known.empty() ? "" : ", ") + pair.name;
  }
  throw InputError({{{kPairsFile, 0, 0, ""},
                     "no pair is called " + io::quoted(name),
                     "choose one of " + known + ", or state contact.boundary_shear_strength_coefficient"}});
}

std::string name_of(FrictionState state) {
  return std::find_if(kStates.begin(), kStates.end(), [&](const auto& one) { return one.second == state; })->first;
}

std::string pairs_table(const std::vector<FrictionPair>& pairs) {
  std::string text =
      fmt::format("{:<32}{:<12}{:>9}{:>14}{:>10}  {}\n", "name", "state", "friction", "band", "hardness", "source");
  for (const FrictionPair& pair : pairs) {
    text += fmt::format("{:<32}{:<12}{:>9.4g}{:>14}{:>10}  {}\n", pair.name, name_of(pair.state), pair.friction,
                        pair.low ? fmt::format("{:.2f} to {:.2f}", *pair.low, *pair.high) : "-",
                        pair.hardness ? text_in(*pair.hardness, kGigapascal, 3) : "-", pair.source);
  }
  return text +
         "friction: coefficient of boundary friction; of dry rows that of a probe without oil, not an input of an "
         "engine\nin a case: [contact] friction_pair = \"crn-on-grey-iron\"\n";
}

std::string pairs_json(const std::vector<FrictionPair>& pairs, const SurfaceClasses& surfaces) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array(), liners = list, rings = list;
  for (const FrictionPair& pair : pairs) {
    list.push_back({{"name", pair.name},
                    {"coating", pair.coating},
                    {"liner", pair.liner},
                    {"state", name_of(pair.state)},
                    {"friction", pair.friction},
                    {"friction_low", maybe(pair.low)},
                    {"friction_high", maybe(pair.high)},
                    {"hardness", maybe(pair.hardness)},
                    {"source", pair.source}});
  }
  for (const LinerSurface& liner : surfaces.liners) {
    liners.push_back({{"name", liner.name},
                      {"state", liner.state},
                      {"Rpq", liner.plateau.Rpq},
                      {"Rvq", liner.plateau.Rvq},
                      {"Rmq", liner.plateau.Rmq},
                      {"hardness", maybe(liner.hardness)},
                      {"youngs_modulus", maybe(liner.youngs_modulus)},
                      {"source", liner.source}});
  }
  for (const RingSurface& ring : surfaces.rings) {
    rings.push_back(
        {{"name", ring.name}, {"state", ring.state}, {"roughness", ring.roughness}, {"source", ring.source}});
  }
  const nlohmann::ordered_json all = {{"pairs", list}, {"liners", liners}, {"rings", rings}};
  return all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace ringfilm::io
