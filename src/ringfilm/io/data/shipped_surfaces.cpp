#include "ringfilm/io/data/shipped_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_table.hpp"

namespace ringfilm::io {
namespace {

using models::PlateauCurve;
using Keys = std::vector<std::string>;

const Keys kSurfaceStates = {"new", "run-in", "worn"};
const Keys kLines = {"Rpq", "Rvq", "Rmq"}, kCore = {"Rk", "Rpk", "Rvk", "Mr2"};

/// A quantity that is above 0; nothing where it is absent or refused.
std::optional<double> positive(TomlTable& table, const std::string& key, const std::string& si_unit,
                               const std::string& example, const Units& units) {
  const std::optional<double> value = table.quantity(key, si_unit, example, units);
  if (!value || *value > 0) return value;
  table.refuse_value(key, "is not above 0", "for example " + example);
  return std::nullopt;
}

std::optional<double> needed_height(TomlTable& table, const std::string& key, const std::string& example,
                                    const Units& units) {
  table.need(key, example);
  return positive(table, key, "m", example, units);
}

std::optional<double> needed_ratio(TomlTable& table, const std::string& key, double limit) {
  table.need(key, "0.8");
  const std::optional<double> value = table.number(key);
  if (!value || (*value > 0 && *value < limit)) return value;
  table.refuse_value(key, fmt::format("is not above 0 and below {:.3g}", limit), "80 % is 0.8");
  return std::nullopt;
}

std::optional<PlateauCurve> stated_lines(TomlTable& table, const Units& units) {
  const auto plateau = needed_height(table, "Rpq", "\"0.07 um\"", units);
  const auto valleys = needed_height(table, "Rvq", "\"0.8 um\"", units);
  const auto ratio = needed_ratio(table, "Rmq", 1);
  if (!plateau || !valleys || !ratio) return std::nullopt;
  return PlateauCurve{*plateau, *valleys, *ratio};
}

std::optional<PlateauCurve> lines_of_core(TomlTable& table, const Units& units) {
  const auto core = needed_height(table, "Rk", "\"0.3 um\"", units);
  const auto peaks = needed_height(table, "Rpk", "\"0.1 um\"", units);
  const auto valleys = needed_height(table, "Rvk", "\"1.2 um\"", units);
  const auto ratio = needed_ratio(table, "Mr2", models::kMr2OfGaussian);
  if (!core || !peaks || !valleys || !ratio) return std::nullopt;
  return models::plateau_curve({*core, *peaks, *valleys, *ratio});
}

void read_values(TomlTable& table, const Units& units, LinerSurface& liner) {
  const bool is_core = std::ranges::any_of(kCore, [&](const std::string& key) { return table.find(key) != nullptr; });
  for (const std::string& key : kLines) {
    if (is_core) table.refuse_key(key, "is not used with Rk, Rpk, Rvk and Mr2", "state one of both sets");
  }
  if (const auto curve = is_core ? lines_of_core(table, units) : stated_lines(table, units)) {
    liner.plateau = *curve;
    if (!(curve->Rpq < curve->Rvq)) {
      table.refuse_value(is_core ? "Rvk" : "Rpq",
                         is_core ? "is not that of valleys deeper than the plateau" : "is not below Rvq",
                         "the valleys of a plateau are rougher than the plateau: are the values exchanged?");
    }
  }
  liner.hardness = positive(table, "hardness", "Pa", "\"2.5 GPa\"", units);
  liner.youngs_modulus = positive(table, "youngs_modulus", "Pa", "\"100 GPa\"", units);
}

void read_values(TomlTable& table, const Units& units, RingSurface& ring) {
  ring.roughness = needed_height(table, "roughness", "\"0.07 um\"", units).value_or(0);
}

/// The classes of a list of tables. @param key name of the list @param known keys next to name, state and source
template <class Surface>
std::vector<Surface> read_list(TomlTable& whole, const std::string& key, const Keys& known, const Units& units,
                               std::vector<Fault>& faults) {
  Keys keys = {"name", "state", "source"};
  keys.insert(keys.end(), known.begin(), known.end());
  std::vector<Surface> all;
  std::set<std::pair<std::string, std::string>> found;
  for (const TomlValue& item : whole.items(key)) {
    TomlTable table(item, "[[" + key + "]]", keys, faults);
    Surface surface;
    surface.name = table.needed_text("name", key == "ring" ? "\"nitrided\"" : "\"plateau-honed-grey-iron\"");
    surface.state = table.needed_text("state", "\"run-in\"");
    surface.source = table.needed_text("source", "\"typical, assumed\"");
    if (!surface.state.empty() && std::ranges::find(kSurfaceStates, surface.state) == kSurfaceStates.end()) {
      table.refuse_word("state", surface.state, kSurfaceStates);
    }
    read_values(table, units, surface);
    if (!surface.name.empty() && !found.insert({surface.name, surface.state}).second) {
      table.refuse(table.mark(),
                   fmt::format("the {} {} comes twice as {}", key, io::quoted(surface.name), surface.state),
                   "keep one of them");
    }
    all.push_back(std::move(surface));
  }
  return all;
}

template <class Surface>
Surface surface_of_name(const std::vector<Surface>& all, const std::string& kind, const std::string& name,
                        const std::string& state) {
  Keys names, states;
  for (const Surface& one : all) {
    if (one.name == name && one.state == state) return one;
    if (one.name == name) states.push_back(one.state);
    if (std::ranges::find(names, one.name) == names.end()) names.push_back(one.name);
  }
  const SourceMark file{kSurfacesFile, 0, 0, ""};
  if (states.empty()) {
    throw InputError({{file, fmt::format("no {} is called {}{}", kind, io::quoted(name), did_you_mean(name, names)),
                       fmt::format("choose one of {}", fmt::join(names, ", "))}});
  }
  throw InputError({{file,
                     fmt::format("the {} {} has no state {}{}", kind, io::quoted(name), io::quoted(state),
                                 did_you_mean(state, states)),
                     fmt::format("choose one of {}", fmt::join(states, ", "))}});
}

std::string shown(const std::optional<double>& pressure) { return pressure ? text_in(*pressure, kGigapascal, 3) : "-"; }

std::string micrometres(double height) { return text_in(height, kMicrometre, 3); }

}  // namespace

SurfaceClasses read_surfaces(const NamedFile& file, const Units& units) {
  const SourceText source = read_source_text(file.path, file.shown, kMaxToml);
  const TomlValue root = parse_toml(source);
  std::vector<Fault> faults;
  Keys of_liner = {"hardness", "youngs_modulus"};
  of_liner.insert(of_liner.end(), kLines.begin(), kLines.end());
  of_liner.insert(of_liner.end(), kCore.begin(), kCore.end());
  TomlTable whole(root, "the library", {"liner", "ring"}, faults);
  SurfaceClasses all{read_list<LinerSurface>(whole, "liner", of_liner, units, faults),
                     read_list<RingSurface>(whole, "ring", {"roughness"}, units, faults), source.sha256};
  if (all.liners.empty() && all.rings.empty() && faults.empty()) {
    faults.push_back({source.mark(0), "there is no [[liner]] and no [[ring]]", "state one"});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return all;
}

SurfaceClasses shipped_surfaces(const Units& units) { return read_surfaces(locate(kSurfacesFile, ""), units); }

LinerSurface liner_of_name(const SurfaceClasses& all, const std::string& name, const std::string& state) {
  return surface_of_name(all.liners, "liner", name, state);
}

RingSurface ring_of_name(const SurfaceClasses& all, const std::string& name, const std::string& state) {
  return surface_of_name(all.rings, "ring", name, state);
}

std::string surfaces_table(const SurfaceClasses& all) {
  std::string text = fmt::format("{:<32}{:<12}{:>9}{:>9}{:>7}{:>10}{:>10}  {}\n", "liner", "state", "Rpq", "Rvq", "Rmq",
                                 "hardness", "modulus", "source");
  for (const LinerSurface& liner : all.liners) {
    text += fmt::format("{:<32}{:<12}{:>9}{:>9}{:>7.2f}{:>10}{:>10}  {}\n", liner.name, liner.state,
                        micrometres(liner.plateau.Rpq), micrometres(liner.plateau.Rvq), liner.plateau.Rmq,
                        shown(liner.hardness), shown(liner.youngs_modulus), liner.source);
  }
  text += fmt::format("\n{:<32}{:<12}{:>9}  {}\n", "ring", "state", "Rq", "source");
  for (const RingSurface& ring : all.rings) {
    text += fmt::format("{:<32}{:<12}{:>9}  {}\n", ring.name, ring.state, micrometres(ring.roughness), ring.source);
  }
  return text + "in a case: [contact.plateau] with Rpq, Rvq and Rmq of the liner, Rq of the ring as ring_roughness\n";
}

}  // namespace ringfilm::io
