#include "ringfilm/cycle/checks/case_rules_plateau.hpp"

#include <optional>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;

const std::string kPlateauSection = "contact.plateau.";
const char* const kOneSurface = "of a surface made in one step omit [contact.plateau] and state contact.roughness";

/// The values of one way to state the curve, with the names of their keys.
using Way = std::vector<std::pair<const char*, const std::optional<double>*>>;

std::vector<std::string> stated_keys(const Way& way) {
  std::vector<std::string> keys;
  for (const auto& [name, value] : way) {
    if (*value) keys.push_back(kPlateauSection + name);
  }
  return keys;
}

/// Is the curve stated in one way, with all of its values?
bool check_ways(const Plateau& plateau, Breaches& breaches) {
  const Way lines = {{"Rpq", &plateau.Rpq}, {"Rvq", &plateau.Rvq}, {"Rmq", &plateau.Rmq}};
  const Way core = {{"Rk", &plateau.Rk}, {"Rpk", &plateau.Rpk}, {"Rvk", &plateau.Rvk}, {"Mr2", &plateau.Mr2}};
  const std::vector<std::string> of_lines = stated_keys(lines), of_core = stated_keys(core);
  if (!of_lines.empty() && !of_core.empty()) {
    breaches.push_back({of_core.front(),
                        "[contact.plateau] states both " + of_lines.front() + " and " + of_core.front(),
                        "a material ratio curve is stated by Rpq, Rvq and Rmq, or by Rk, Rpk, Rvk and Mr2",
                        RuleBreach::By::kValues,
                        {of_lines, of_core}});
    return false;
  }
  const Way& way = of_core.empty() ? lines : core;
  if (stated_keys(way).size() == way.size()) return true;
  for (const auto& [name, value] : way) {
    if (*value) continue;
    breaches.push_back({kPlateauSection + name,
                        "the key " + kPlateauSection + name + " is missing: one curve has several values",
                        "state Rpq, Rvq and Rmq, or Rk, Rpk, Rvk and Mr2", RuleBreach::By::kMissingKey});
  }
  return false;
}

std::string length(double value) { return text_in(value, kMicrometre, 4); }

/// Do the lines of the drawing belong to a plateau over deeper valleys?
bool check_lines(const Plateau& plateau, Breaches& breaches) {
  const auto refuse = [&](const char* name, const std::string& message, const std::string& remedy) {
    breaches.push_back({kPlateauSection + name, message, remedy});
    return false;
  };
  if (!(*plateau.Rmq > 0 && *plateau.Rmq < 1)) {
    return refuse("Rmq",
                  "contact.plateau.Rmq = " + number_text(*plateau.Rmq) + " leaves no " +
                      (*plateau.Rmq > 0 ? "valleys" : "plateau"),
                  std::string("it lies between 0 and 1; ") + kOneSurface);
  }
  if (*plateau.Rpq < *plateau.Rvq) return true;
  return refuse(
      "Rpq",
      "contact.plateau.Rpq = " + length(*plateau.Rpq) + " is not below contact.plateau.Rvq = " + length(*plateau.Rvq),
      std::string("the plateau is the smoother part: check whether both are exchanged; ") + kOneSurface);
}

/// Are core, peaks and valleys of the drawing those of a plateau over deeper valleys?
bool check_core(const Plateau& plateau, Breaches& breaches) {
  if (!(*plateau.Mr2 > 0 && *plateau.Mr2 < models::kMr2OfGaussian)) {
    breaches.push_back({kPlateauSection + "Mr2",
                        "contact.plateau.Mr2 = " + number_text(*plateau.Mr2) + " is not between 0 and " +
                            number_text(models::kMr2OfGaussian, 3) + ", that of one Gaussian surface",
                        std::string("valleys begin before it; ") + kOneSurface});
    return false;
  }
  const models::PlateauCurve curve = models::plateau_curve({*plateau.Rk, *plateau.Rpk, *plateau.Rvk, *plateau.Mr2});
  if (curve.Rvq > curve.Rpq && curve.Rmq > 0 && curve.Rmq < 1) return true;
  breaches.push_back({kPlateauSection + "Rvk",
                      "contact.plateau.Rvk = " + length(*plateau.Rvk) + " with Mr2 = " + number_text(*plateau.Mr2) +
                          " gives valleys of Rvq = " + length(curve.Rvq) +
                          ", not deeper than a plateau of Rpq = " + length(curve.Rpq),
                      std::string("check Rk, Rpk and Rvk; ") + kOneSurface});
  return false;
}

}  // namespace

bool append_plateau_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  const Plateau& plateau = c.contact.plateau;
  if (!plateau.is_stated() || c.contact.model == ContactLaw::kTable) return true;
  if (!check_ways(plateau, breaches)) return false;
  if (!(plateau.has_core() ? check_core(plateau, breaches) : check_lines(plateau, breaches))) return false;
  const double Rpq = plateau_curve(c.contact)->Rpq;
  if (plateau.surface_roughness && *plateau.surface_roughness < Rpq) {
    breaches.push_back({kPlateauSection + "surface_roughness",
                        "contact.plateau.surface_roughness = " + length(*plateau.surface_roughness) +
                            " is below the Rpq of its plateau, " + length(Rpq),
                        "Rq of the whole surface contains the valleys; omit it, and it follows from the curve"});
  }
  if (c.contact.measured.roughness_deviation) {
    breaches.push_back(
        {"contact.measured.roughness_deviation",
         "contact.measured.roughness_deviation is of contact.roughness, which [contact.plateau] replaces",
         "omit it with the correlations of the roughness, or vary contact.plateau.Rpq in a study"});
  }
  return true;
}

}  // namespace ringfilm::cycle
