#include "ringfilm/cycle/case_rules_unrolled.hpp"

#include <cstdio>
#include <string>

#include "ringfilm/cycle/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;

/// The solver needs about a kilobyte for each.
constexpr double kMostNodes = 2e6;
/// Four fields of four bytes each are kept at every node: 320 MB, and while the result is written two copies more.
constexpr double kMostFieldValues = 2e7;
constexpr double kBytesOfFields = 4 * 4;
/// Sums of a strip that are kept at every angle with output.reduction = "along-face".
constexpr double kMostStripValues = 1e7;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

double strips(const Case& c) { return c.ring.end_gap ? c.solver.cells_y + 1 : c.solver.cells_y; }

void check_method(const Case& c, Breaches& breaches) {
  if (c.solver.method == Method::kCoupledNewton) return;
  breaches.push_back(
      {"solver.method",
       "solver.method = \"" +
           std::string(c.solver.method == Method::kPointRelaxation ? "point-relaxation" : "nested-secant") +
           "\" solves the film across the face alone, not the unrolled one",
       "take \"coupled-newton\", or film.dimension = \"face\""});
}

/// @returns whether some of the circumference is left to the ring
bool check_gap(const Case& c, Breaches& breaches) {
  if (c.ring_length() > 0) return true;
  breaches.push_back({"ring.end_gap",
                      "ring.end_gap = " + number(*c.ring.end_gap * 1e3) +
                          " mm is not below the circumference of the bore, " +
                          number(std::numbers::pi * c.engine.bore * 1e3) + " mm",
                      "state the gap between the ends of the ring in the bore, for example \"0.3 mm\""});
  return false;
}

void check_end_cell(const Case& c, Breaches& breaches) {
  const double longest = c.ring_length() / c.solver.cells_y;
  if (!c.ring.end_gap || c.end_cell() <= longest) return;
  breaches.push_back({"solver.end_cell",
                      "solver.end_cell = " + number(c.end_cell() * 1e6) + " um is longer than " +
                          number(c.solver.cells_y) + " cells that are all alike, " + number(longest * 1e6) + " um",
                      "cells are shortest at the ends of the gap: state a shorter one, or fewer solver.cells_y"});
}

void check_nodes(const Case& c, Breaches& breaches) {
  const double nodes = (c.solver.cells + 1.0) * strips(c);
  if (nodes <= kMostNodes) return;
  breaches.push_back({"solver.cells_y",
                      "solver.cells = " + number(c.solver.cells) + " and solver.cells_y = " + number(c.solver.cells_y) +
                          " make " + number(nodes) + " nodes, more than " + number(kMostNodes) +
                          ", of which each takes about a kilobyte",
                      "take fewer cells; 200 by 180 are usual"});
}

void check_fields(const Case& c, Breaches& breaches) {
  const Output& output = c.output;
  if (output.fields == FieldsWanted::kNone) return;
  const double all = output.crank_angles_deg.empty() ? kCycleDeg / output.crank_angle_step_deg
                                                     : static_cast<double>(output.crank_angles_deg.size());
  const double angles = output.fields == FieldsWanted::kAll ? all : static_cast<double>(output.field_angles_deg.size());
  if (output.reduction == FieldReduction::kAlongFace) {
    if (angles * strips(c) <= kMostStripValues) return;
    breaches.push_back({"output.fields",
                        "output.fields asks for " + number(angles) + " angles of " + number(strips(c)) +
                            " strips, more than " + number(kMostStripValues) + " values a field",
                        "list the angles that matter, for example [\"0 degree\", \"20 degree\"]"});
    return;
  }
  const double values = angles * (c.solver.cells + 1.0) * strips(c);
  if (values <= kMostFieldValues) return;
  breaches.push_back({"output.fields",
                      "output.fields asks for " + number(angles) + " angles of " + number(c.solver.cells + 1) + " x " +
                          number(strips(c)) + " nodes, which take " + number(values * kBytesOfFields / 1e6) +
                          " MB of memory; allowed are " + number(kMostFieldValues * kBytesOfFields / 1e6) + " MB",
                      "list the angles that matter, for example [\"0 degree\", \"20 degree\"], or keep what each "
                      "strip sums up to: output.reduction = \"along-face\""});
}

}  // namespace

void append_unrolled_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  if (!c.is_unrolled()) return;
  check_method(c, breaches);
  if (check_gap(c, breaches)) check_end_cell(c, breaches);
  check_nodes(c, breaches);
  check_fields(c, breaches);
}

}  // namespace ringfilm::cycle
