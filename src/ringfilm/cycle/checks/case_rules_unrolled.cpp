#include "ringfilm/cycle/checks/case_rules_unrolled.hpp"

#include <algorithm>
#include <string>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/checks/case_rules_film2d.hpp"
#include "ringfilm/cycle/integration/cycle_film.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;

/// Four fields of four bytes each are kept at every node: 320 MB, and while the result is written two copies more.
constexpr double kMaxFilm2dFieldValues = 2e7;
constexpr double kBytesOfFields = 4 * 4;
/// Sums of a strip that are kept at every angle with output.reduction = "along-face".
constexpr double kMaxStripValues = 1e7;

double strips(const Case& c) { return c.ring.end_gap ? c.solver.cells_y + 1 : c.solver.cells_y; }

void check_method(const Case& c, Breaches& breaches) {
  if (c.solver.method != Method::kPointRelaxation) return;
  breaches.push_back(
      {"solver.method",
       "solver.method = \"point-relaxation\" solves the film across the face alone, not the unrolled one",
       "take \"coupled-newton\", or film.dimension = \"face\""});
}

void check_scheme(const Case& c, Breaches& breaches) {
  if (c.solver.cell_lengths == CellLengths::kByGap) {
    breaches.push_back({"solver.cell_lengths", "solver.cell_lengths = \"by-gap\" is for the film across the face alone",
                        "take \"uniform\", or film.dimension = \"face\""});
  }
  if (c.ring.local_deformation != LocalDeformation::kNone) {
    breaches.push_back({"ring.local_deformation",
                        "ring.local_deformation = \"half-space\" is for the film across the face alone",
                        "take \"none\", or film.dimension = \"face\""});
  }
}

/// @returns whether some of the circumference is left to the ring
bool check_gap(const Case& c, Breaches& breaches) {
  if (c.ring_length() > 0) return true;
  breaches.push_back({"ring.end_gap",
                      "ring.end_gap = " + text_in(*c.ring.end_gap, kMillimetre) +
                          " is not below the circumference of the bore, " +
                          text_in(std::numbers::pi * c.engine.bore, kMillimetre),
                      "state the gap between the ends of the ring in the bore, for example \"0.3 mm\""});
  return false;
}

double length_of_end_cell(const Case& c, int cells_y) {
  return film::refined_around(cells_y, c.ring_length(), c.end_cell()).spacing.front();
}

/// The fewest cells around, above those of the case, whose end cell is no longer than asked for, up to a tenth.
int cells_that_would_do(const Case& c) {
  const auto is_enough = [&c](int cells) { return length_of_end_cell(c, cells) <= kEndCellMissed * c.end_cell(); };
  int few = c.solver.cells_y, enough = 2 * few;
  while (!is_enough(enough)) {
    few = enough;
    enough *= 2;
  }
  while (enough - few > 1) {
    const int middle = few + (enough - few) / 2;
    (is_enough(middle) ? enough : few) = middle;
  }
  return enough;
}

/// Cells at the ends longer than the face is wide see nothing of what the ends do.
void check_end_cell_reached(const Case& c, Breaches& breaches) {
  const double reached = length_of_end_cell(c, c.solver.cells_y);
  if (reached <= std::max(c.ring.face_width, kEndCellMissed * c.end_cell())) return;
  breaches.push_back({"solver.cells_y",
                      "solver.cells_y = " + number_text(c.solver.cells_y) + " makes the cells at the ends of the gap " +
                          text_in(reached, kMillimetre) + " long, more than the face is wide, " +
                          text_in(c.ring.face_width, kMillimetre),
                      "take " + number_text(cells_that_would_do(c)) +
                          " or more: cells grow by at most 1.3 times each from " + text_in(c.end_cell(), kMicrometre) +
                          " at the ends"});
}

void check_end_cell(const Case& c, Breaches& breaches) {
  const double longest = c.ring_length() / c.solver.cells_y;
  if (!c.ring.end_gap) return;
  if (c.end_cell() <= longest) return check_end_cell_reached(c, breaches);
  breaches.push_back({"solver.end_cell",
                      "solver.end_cell = " + text_in(c.end_cell(), kMicrometre) + " is longer than " +
                          number_text(c.solver.cells_y) + " cells that are all alike, " + text_in(longest, kMicrometre),
                      "cells are shortest at the ends of the gap: state a shorter one, or fewer solver.cells_y"});
}

/// @returns whether they are few enough
bool film2d_is_small_enough(const Case& c, Breaches& breaches) {
  const double nodes = (c.solver.cells + 1.0) * strips(c);
  if (nodes <= kMaxFilm2dNodes) return true;
  breaches.push_back({"solver.cells_y",
                      "solver.cells = " + number_text(c.solver.cells) + " and solver.cells_y = " +
                          number_text(c.solver.cells_y) + " make " + number_text(nodes) + " nodes, more than " +
                          number_text(kMaxFilm2dNodes) + ", of which each takes about a kilobyte",
                      "take fewer cells; 200 by 180 are usual"});
  return false;
}

void check_film2d_fields(const Case& c, Breaches& breaches) {
  const Output& output = c.output;
  if (output.fields == FieldOutput::kNone) return;
  const double all = output.crank_angles_deg.empty() ? kCycleDeg / output.crank_angle_step_deg
                                                     : static_cast<double>(output.crank_angles_deg.size());
  const double angles = output.fields == FieldOutput::kAll ? all : static_cast<double>(output.field_angles_deg.size());
  if (output.reduction == FieldReduction::kAlongFace) {
    if (angles * strips(c) <= kMaxStripValues) return;
    breaches.push_back({"output.fields",
                        "output.fields asks for " + number_text(angles) + " angles of " + number_text(strips(c)) +
                            " strips, more than " + number_text(kMaxStripValues) + " values a field",
                        "list the angles that matter, for example [\"0 degree\", \"20 degree\"]"});
    return;
  }
  const double values = angles * (c.solver.cells + 1.0) * strips(c);
  if (values <= kMaxFilm2dFieldValues) return;
  breaches.push_back({"output.fields",
                      "output.fields asks for " + number_text(angles) + " angles of " +
                          number_text(c.solver.cells + 1) + " x " + number_text(strips(c)) + " nodes, which take " +
                          text_in(values * kBytesOfFields, kMegabyte) + " of memory; allowed are " +
                          text_in(kMaxFilm2dFieldValues * kBytesOfFields, kMegabyte),
                      "list the angles that matter, for example [\"0 degree\", \"20 degree\"], or keep what each "
                      "strip sums up to: output.reduction = \"along-face\""});
}

}  // namespace

void append_unrolled_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  if (!c.is_unrolled()) return;
  check_method(c, breaches);
  check_scheme(c, breaches);
  const bool is_on_ring = check_gap(c, breaches);
  if (film2d_is_small_enough(c, breaches) && is_on_ring) check_end_cell(c, breaches);
  check_film2d_fields(c, breaches);
}

}  // namespace ringfilm::cycle
