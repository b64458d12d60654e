#include "ringfilm/cycle/checks/case_rules_pad.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/case/case_face.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/checks/case_rules_film2d.hpp"
#include "ringfilm/cycle/checks/case_rules_oil.hpp"
#include "ringfilm/cycle/checks/case_rules_plateau.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;

constexpr double kMaxSteps = 1e6;
/// Rows of the CSV file, some 80 bytes each; values of a field.
constexpr double kMaxRows = 1e7;

void check_what_is_given(const Pad& pad, Breaches& breaches) {
  std::vector<std::string> given;
  if (pad.separation) given.push_back("pad.separation");
  if (pad.load) given.push_back("pad.load");
  if (pad.separation_history_file) given.push_back("pad.separation_history");
  if (given.size() == 1) return;
  const std::string remedy =
      "state exactly one of pad.separation, alone or with [pad.oscillation], pad.load and pad.separation_history";
  if (given.empty()) {
    breaches.push_back(
        {"pad.separation", "neither separation nor load of the pad is stated", remedy, RuleBreach::By::kMissingKey});
    return;
  }
  std::vector<std::vector<std::string>> ways;
  for (const std::string& key : given) ways.push_back({key});
  if (pad.separation && pad.oscillation.amplitude) ways.front().push_back("pad.oscillation.amplitude");
  breaches.push_back(
      {given.back(), joined(given, " and ") + " are stated together", remedy, RuleBreach::By::kValues, ways});
}

/// Do places run from 0 to the end?
bool covers(const std::vector<double>& places, double end) { return places.front() == 0 && places.back() == end; }

/// @returns whether there is a formula, or points that run from 0 to the length, and to the width
bool check_gap(const Pad& pad, Breaches& breaches) {
  if (pad.has_formula()) return pad.length > 0;
  if (pad.gap_x.empty()) return false;
  const bool is_map = !pad.gap_y.empty();
  if (is_map && !pad.width) {
    breaches.push_back({"pad.gap", "the gap is a map over x and y, and the pad has no width",
                        "state pad.width, or give the gap along x alone"});
    return false;
  }
  const bool is_long = covers(pad.gap_x, pad.length), is_wide = !is_map || covers(pad.gap_y, *pad.width);
  if (!is_long) {
    breaches.push_back(
        {"pad.gap",
         "the points of the gap run from x = " + range_in(pad.gap_x.front(), pad.gap_x.back(), kMillimetre) +
             ", the pad from " + range_in(0, pad.length, kMillimetre),
         "points from x = 0 to pad.length are required, both included"});
  }
  if (!is_wide) {
    breaches.push_back(
        {"pad.gap",
         "the rows of the gap run from y = " + range_in(pad.gap_y.front(), pad.gap_y.back(), kMillimetre) +
             ", the pad from " + range_in(0, *pad.width, kMillimetre),
         "rows from y = 0 to pad.width are required, both included"});
  }
  return is_long && is_wide;
}

/// @returns whether the grooves lie on the pad one after the other, none of them at its lowest point
bool check_grooves(const Pad& pad, Breaches& breaches) {
  if (!pad.has_formula() || pad.grooves.positions.empty()) return true;
  const auto refuse = [&](const std::string& fault, const char* remedy) {
    breaches.push_back({"pad.grooves.positions", fault, remedy});
    return false;
  };
  const double lowest = lowest_point(pad).x;
  double end = -1;  // end of the groove before [m]; none before the first
  const std::vector<double>& positions = pad.grooves.positions;
  const auto ends = groove_ends(pad);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const std::string position = number_text(positions[k]);
    if (!(positions[k] >= 0 && positions[k] <= 1)) {
      return refuse("the position " + position + " of a groove is not on the pad",
                    "positions are fractions of pad.length, from 0 to 1");
    }
    if (!(ends[k].first > end)) {
      return refuse("the groove at the position " + position + " is not beyond the one before it",
                    "list the positions from x = 0 on, more than pad.grooves.width apart");
    }
    if (lowest >= ends[k].first && lowest <= ends[k].second) {
      return refuse("the groove at the position " + position +
                        " lies at the lowest point of the gap, x = " + text_in(lowest, kMillimetre),
                    "the separation counts from that point; move the groove, or take a narrower one");
    }
    end = ends[k].second;
  }
  return true;
}

/// A film around a journal has a direction of load, and once around is all of it.
void check_journal(const Case& c, Breaches& breaches) {
  if (!c.pad.journal_radius) return;
  const auto refuse = [&](const std::string& fault, const char* remedy) {
    breaches.push_back({"pad.journal_radius", fault, remedy});
  };
  constexpr double kRounding = 1e-6;
  const double around = 2 * std::numbers::pi * *c.pad.journal_radius;
  if (c.pad.length > around * (1 + kRounding)) {
    refuse("pad.length = " + text_in(c.pad.length, kMillimetre) + " is more than the journal has around it, " +
               text_in(around, kMillimetre),
           "state a length of at most 2 pi times pad.journal_radius");
  }
  if (c.pad.load) {
    refuse("pad.journal_radius excludes pad.load", "the load of a journal has a direction; state pad.separation");
  }
  if (c.has_contact()) {
    refuse("pad.journal_radius excludes contact.composite_modulus",
           "the journal load is that of the film; omit one of the two keys");
  }
}

/// Where the gap is joined with itself it must not jump.
void check_joined_gap(const Pad& pad, Breaches& breaches) {
  if (pad.sides != Sides::kPeriodic || pad.gap_y.empty()) return;
  constexpr double kRounding = 1e-9;
  const std::size_t n_x = pad.gap_x.size(), last = pad.gap_height.size() - n_x;
  for (std::size_t i = 0; i < n_x; ++i) {
    const double front = pad.gap_height[i], back = pad.gap_height[last + i];
    if (std::abs(front - back) <= kRounding * std::max(std::abs(front), std::abs(back))) continue;
    breaches.push_back({"pad.sides",
                        "pad.sides = \"periodic\" joins the sides of the pad, and at x = " +
                            text_in(pad.gap_x[i], kMillimetre) + " the gap is " + text_in(front, kMicrometre) +
                            " at y = 0 and " + text_in(back, kMicrometre) + " at y = width",
                        "give the map the same first and last row, or take open or closed sides"});
    return;
  }
}

/// An edge below the pressure of cavities would be filled with gas. In an infinitely wide pad, such an edge lowers the
/// pressure of the cavities, with a note.
void check_edge_pressures(const Case& c, Breaches& breaches) {
  const Pad& pad = c.pad;
  if (!pad.width) return;
  const auto check = [&](const char* key, double pressure) {
    if (pressure >= c.film.cavitation_pressure) return;
    breaches.push_back({key,
                        std::string(key) + " = " + text_in(pressure, kBar) + " is below film.cavitation_pressure = " +
                            text_in(c.film.cavitation_pressure, kBar) + ": the film cannot be full there",
                        "raise it, or lower film.cavitation_pressure"});
  };
  check("pad.left_pressure", pad.left_pressure);
  check("pad.right_pressure", pad.right_pressure);
  if (!pad.has_sides_at_pressures()) return;
  check("pad.front_pressure", pad.front_pressure);
  check("pad.back_pressure", pad.back_pressure);
}

void check_film(const Pad& pad, Breaches& breaches) {
  const models::RingFace::Minimum lowest = lowest_point(pad);
  std::string across;
  if (!pad.has_formula() && !pad.gap_y.empty()) {
    const auto at = std::find(pad.gap_height.begin(), pad.gap_height.end(), lowest.height);
    across = ", y = " + text_in(pad.gap_y[(at - pad.gap_height.begin()) / pad.gap_x.size()], kMillimetre);
  }
  const std::string place =
      "at x = " + text_in(lowest.x, kMillimetre) + across + " the gap is " + text_in(lowest.height, kMicrometre);
  const std::string remedy = "the separation adds to the gap, and their sum must be above zero everywhere";
  const double amplitude = pad.oscillation.amplitude.value_or(0);
  if (pad.separation && !(lowest.height + *pad.separation - amplitude > 0)) {
    const std::string less =
        amplitude > 0 ? " less pad.oscillation.amplitude = " + text_in(amplitude, kMicrometre) : "";
    breaches.push_back(
        {"pad.separation",
         place + ", with pad.separation = " + text_in(*pad.separation, kMicrometre) + less + " no film is left",
         remedy});
  }
  const auto closest = std::min_element(pad.history_separation.begin(), pad.history_separation.end());
  if (closest != pad.history_separation.end() && !(lowest.height + *closest > 0)) {
    breaches.push_back({"pad.separation_history",
                        place + ", with the separation of " + text_in(*closest, kMicrometre) + " at " +
                            number_text(pad.history_time[closest - pad.history_separation.begin()]) +
                            " s no film is left",
                        remedy});
  }
}

/// Nodes in one direction at the most: each piece between steps of the gap gets two cells or more.
double most_nodes(int cells, const std::vector<double>& places) {
  double pieces = 1;
  for (std::size_t i = 1; i < places.size(); ++i) pieces += places[i] == places[i - 1];
  return cells + 3 * pieces + 1;
}

double most_nodes(const Case& c) {
  const double of_grooves = 6 * static_cast<double>(c.pad.grooves.positions.size());  // two more pieces for each
  const double along = most_nodes(c.solver.cells, c.pad.gap_x) + of_grooves;
  return c.pad.width ? along * most_nodes(c.solver.cells_y, c.pad.gap_y) : along;
}

void check_nodes(const Case& c, Breaches& breaches) {
  if (!c.pad.width || most_nodes(c) <= kMaxFilm2dNodes) return;
  breaches.push_back({"solver.cells_y",
                      "solver.cells and solver.cells_y, with the steps of the gap, make a grid of " +
                          number_text(most_nodes(c)) + " nodes, more than " + number_text(kMaxFilm2dNodes),
                      "take fewer cells in one direction or both"});
}

/// @returns whether the integration ends after it begins, and with the history at the latest
bool check_end(const Pad& pad, Breaches& breaches) {
  const double begin = pad.first_time(), end = pad.last_time();
  if (pad.oscillation.amplitude) {
    if (end > begin) return true;
    breaches.push_back({"pad.end_time",
                        pad.end_time
                            ? "pad.end_time = " + number_text(end) + " s is not above 0 s, where an oscillation begins"
                            : "pad.end_time is not stated, and an oscillation has no end",
                        "state where the integration ends, for example end_time = \"1 s\""});
    return false;
  }
  if (!(end > begin) || end > pad.history_time.back()) {
    breaches.push_back({"pad.end_time",
                        "pad.end_time = " + number_text(end) + " s does not lie in the history, which runs from " +
                            number_text(begin) + " to " + number_text(pad.history_time.back()) + " s",
                        "choose an end after the first and not after the last time of the history"});
    return false;
  }
  return true;
}

void check_times(const Case& c, Breaches& breaches) {
  const Pad& pad = c.pad;
  if (!check_end(pad, breaches)) return;
  const double begin = pad.first_time(), end = pad.last_time();
  const double steps = std::ceil((end - begin) / pad.time_step);
  if (steps > kMaxSteps) {
    breaches.push_back({"pad.time_step", "pad.time_step asks for " + number_text(steps) + " steps",
                        "at the most " + number_text(kMaxSteps) + " are integrated; take a longer step"});
    return;
  }
  const double every = pad.output_step ? *pad.output_step / pad.time_step : 1;
  if (every < 1 - 1e-6 || std::abs(every - std::round(every)) > 1e-6 * every) {
    breaches.push_back({"pad.output_step",
                        "pad.output_step = " + number_text(*pad.output_step) +
                            " s is not a whole number of time steps of " + number_text(pad.time_step) + " s",
                        "take one, two, three ... times pad.time_step"});
  } else if (steps / every * most_nodes(c) > kMaxRows) {
    breaches.push_back({pad.output_step ? "pad.output_step" : "pad.time_step",
                        "the result would hold " + number_text(std::ceil(steps / every)) + " instants of " +
                            number_text(most_nodes(c)) + " nodes, more than " + number_text(kMaxRows) + " rows",
                        "keep fewer instants with a longer pad.output_step"});
  }
}

void check_oil(const Case& c, Breaches& breaches) {
  if (c.thermal.is_stated()) {
    append_thermal_breaches(c, breaches);
    append_oil_law_breaches(c.lubricant, breaches);
  } else if (!c.lubricant.constant_density && !c.lubricant.density.empty()) {
    breaches.push_back({"lubricant.density",
                        "lubricant.density has values at temperatures; a pad without [thermal] has no temperature",
                        "write one value, for example \"850 kg/m3\", or state the temperatures of the walls"});
  }
  for (const auto& parameter : models::viscosity_law(c.lubricant.viscosity_pressure).parameters) {
    if (parameter.statement == models::Statement::kRequired || c.stated.contains("lubricant." + parameter.key))
      continue;
    breaches.push_back({"lubricant.viscosity_pressure",
                        "lubricant." + parameter.key + " is not stated, and a pad has none to fall back on",
                        "state it in [lubricant], for example " + parameter.key + " = " + parameter.example});
  }
}

void check_critical_rate(const Case& c, Breaches& breaches) {
  const Lubricant& oil = c.lubricant;
  if (oil.critical_shear_rate || oil.hths_viscosity) return;
  const bool is_pad = c.problem == Problem::kPad && !c.thermal.is_stated();
  breaches.push_back({"lubricant.shear_thinning", "the critical shear rate of the oil is missing",
                      is_pad ? "state lubricant.critical_shear_rate, for example \"2.4e6 s-1\""
                             : "state lubricant.hths_viscosity, for example \"2.9 mPa s\", or "
                               "lubricant.critical_shear_rate with its temperature"});
}

void check_thinning(const Case& c, Breaches& breaches) {
  const Lubricant& oil = c.lubricant;
  if (oil.shear_thinning == ShearThinning::kNone) return;
  check_critical_rate(c, breaches);
  if (oil.shear_thinning == ShearThinning::kCarreau && oil.shear_exponent && *oil.shear_exponent >= 1) {
    breaches.push_back({"lubricant.shear_exponent",
                        "lubricant.shear_exponent = " + number_text(*oil.shear_exponent) +
                            " is not below 1, and the viscosity of Carreau's law would not fall",
                        "n lies between 0 and 1, for example 0.5"});
  }
}

void check_contact(const Case& c, Breaches& breaches) {
  if (!c.has_contact() || !c.pad.width) return;
  breaches.push_back({"contact.composite_modulus", "contact.composite_modulus is for a pad without pad.width",
                      "a film in two dimensions has no asperity contact in a pad; omit the width, or [contact]"});
}

/// The key that makes a film other than one of a Newtonian oil between smooth walls.
std::string key_of_factors(const Case& c) {
  if (c.film.flow_factors != Roughness::kNone) return "film.flow_factors";
  if (c.film.shear_flow != Roughness::kNone) return "film.shear_flow";
  if (c.film.stress_factors != Roughness::kNone) return "film.stress_factors";
  if (c.film.average_gap != AverageGap::kNominal) return "film.average_gap";
  return "lubricant.shear_thinning";
}

/// Factors of a measured pair belong to its contact law.
void check_measured_factors(const Case& c, const std::string& key, Breaches& breaches) {
  if (!c.film.is_measured()) return;
  if (c.contact.model != ContactLaw::kTable) {
    breaches.push_back({key, "a flow of \"measured\" requires contact.model = \"table\"",
                        "contact and flow are those of one gap; state contact.law, or \"patir-cheng\""});
  } else if (!c.contact.law_file.empty() && !c.contact.law->rows.h.empty() && c.contact.law->flow == nullptr) {
    breaches.push_back({key, "contact.law has no flow factors, and a flow is \"measured\"",
                        "write it with ringfilm contact --flow-factors, or state \"patir-cheng\""});
  }
  if (c.film.stress_factors == Roughness::kMeasured && !(c.contact.eyring_shear_stress > 0)) {
    breaches.push_back({"film.stress_factors",
                        "film.stress_factors = \"measured\" requires a contact.eyring_shear_stress above 0",
                        "it limits the stress in the thinnest gaps; oils have 2 to 10 MPa"});
  }
}

}  // namespace

std::vector<RuleBreach> broken_pad_rules(const Case& c) {
  Breaches breaches;
  check_what_is_given(c.pad, breaches);
  if (check_gap(c.pad, breaches) && check_grooves(c.pad, breaches)) {
    check_film(c.pad, breaches);
    check_joined_gap(c.pad, breaches);
    check_nodes(c, breaches);
  }
  append_gas_edge_breaches(c, breaches);
  append_flow_factor_breaches(c, breaches);
  if (c.film.left_edge == EdgeFluid::kGas && c.film.right_edge == EdgeFluid::kGas && c.pad.speed == 0 &&
      c.pad.history_time.empty() && !c.pad.oscillation.amplitude && c.pad.left_pressure != c.pad.right_pressure) {
    breaches.push_back({"pad.speed", "with gas at both edges, of different pressures, no film is steady at rest",
                        "the gas blows through: state pad.speed, oil at an edge, or equal pressures"});
  }
  check_edge_pressures(c, breaches);
  check_journal(c, breaches);
  if (!c.pad.history_time.empty() || c.pad.oscillation.amplitude) check_times(c, breaches);
  check_contact(c, breaches);
  append_plateau_breaches(c, breaches);
  check_oil(c, breaches);
  if (breaches.empty() && c.thermal.is_stated()) append_viscosity_breaches(c, breaches);
  return breaches;
}

void append_supply_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  if (c.film.supply_at_inlet() == OilSupply::kFlooded) return;
  const auto require = [&](bool is_stated, const std::string& key, const char* meaning) {
    if (!is_stated)
      breaches.push_back({key, "the key " + key + " is missing: " + meaning, "state it, or film.supply = \"flooded\""});
  };
  require(!c.supply.film.empty(), "supply.film", "the film on the liner ahead of the ring, for example \"2 um\"");
  append_stroke_breaches("supply.film", c.supply.film, breaches);
  if (c.film.supply != OilSupply::kFilmOnLiner) return;
  require(c.supply.reach.has_value(), "supply.reach", "how far up the oil ring lays its film, for example \"10 mm\"");
  if (c.supply.reach && !(*c.supply.reach < c.engine.stroke)) {
    breaches.push_back({"supply.reach",
                        "supply.reach = " + text_in(*c.supply.reach, kMillimetre) + " is not within the stroke of " +
                            text_in(c.engine.stroke, kMillimetre),
                        "the ring would never find oil; the oil ring reaches up to some 10 mm below TDC"});
  }
  if (c.ring.face.orientation == Orientation::kLeadingEdge) {
    breaches.push_back({"film.supply",
                        "film.supply = \"film-on-liner\" excludes ring.face.orientation = \"leading-edge\"",
                        "a face that turns over at the dead centres keeps no account of its oil; state how the ring is "
                        "installed, \"x0-chamber\" or \"x0-crankcase\""});
  }
  const double steps = 180 / c.solver.crank_step_deg;
  if (std::abs(steps - std::round(steps)) > 1e-9 * steps) {
    breaches.push_back({"solver.crank_step",
                        "solver.crank_step = " + number_text(c.solver.crank_step_deg) +
                            " degree does not end at the dead centres, as film.supply = \"film-on-liner\" requires",
                        "state a step that divides 180 degree"});
  }
}

void append_gas_edge_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  append_supply_breaches(c, breaches);
  const Film& film = c.film;
  const char* key = film.chamber_edge == EdgeFluid::kGas     ? "film.chamber_edge"
                    : film.crankcase_edge == EdgeFluid::kGas ? "film.crankcase_edge"
                    : film.left_edge == EdgeFluid::kGas      ? "film.left_edge"
                    : film.right_edge == EdgeFluid::kGas     ? "film.right_edge"
                                                             : nullptr;
  if (key == nullptr) return;
  const std::string gas = std::string(key) + " = \"gas\"";
  if (film.cavitation != Cavitation::kMassConserving) {
    breaches.push_back({key, gas + " requires film.cavitation = \"mass-conserving\"",
                        "a meniscus is found by the balance of mass; state that model, or oil at the edges"});
  }
  if (c.is_unrolled()) {
    breaches.push_back({key, gas + " requires film.dimension = \"face\"",
                        "the film of the whole ring has oil at its edges; compute the face, or state oil"});
  }
  if (c.pad.width) {
    breaches.push_back({key, gas + " is for a pad without pad.width",
                        "a film in two dimensions has oil at its edges; omit the width, or state oil"});
  }
  if (c.solver.method == Method::kPointRelaxation) {
    breaches.push_back({key, gas + " requires solver.method = \"coupled-newton\"",
                        "the other methods are those of the paper, for edges of oil"});
  }
}

void append_flow_factor_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  check_thinning(c, breaches);
  if (!c.has_flow_factors()) return;
  const std::string key = key_of_factors(c);
  check_measured_factors(c, key, breaches);
  if (c.is_unrolled() && c.lubricant.thins()) {
    breaches.push_back({"lubricant.shear_thinning", "lubricant.shear_thinning requires film.dimension = \"face\"",
                        "the film of the whole ring has a Newtonian oil; compute the face, or omit it"});
  }
  if (c.problem == Problem::kPad && c.pad.width) {
    breaches.push_back({key, key + " is for a pad without pad.width",
                        "a pad with a width has smooth walls and a Newtonian oil; omit the width, or this key"});
  }
  if (c.solver.method == Method::kPointRelaxation) {
    breaches.push_back({key, key + " requires solver.method = \"coupled-newton\"",
                        "the other methods are those of the paper, for a Newtonian oil between smooth walls"});
  }
}

}  // namespace ringfilm::cycle
