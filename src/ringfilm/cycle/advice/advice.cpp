#include "ringfilm/cycle/advice/advice.hpp"

#include <algorithm>

#include "ringfilm/base/display.hpp"
#include "ringfilm/case/accuracy.hpp"
#include "ringfilm/cycle/advice/contact_plausibility.hpp"
#include "ringfilm/cycle/advice/gas_plausibility.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/advice/oil_plausibility.hpp"
#include "ringfilm/cycle/integration/cycle_film.hpp"
#include "ringfilm/cycle/setup/free_ring.hpp"

namespace ringfilm::cycle {
namespace {

void append_end_cell_note(const Case& c, std::vector<Note>& notes) {
  if (!c.is_unrolled() || !c.ring.end_gap) return;
  const double reached = strips_of(c).spacing.front();
  if (reached <= kEndCellMissed * c.end_cell()) return;
  notes.push_back(
      {"end-cells-long",
       formatted(
           "the cells at the ends of the gap are %.3g um long, not %.3g um: %d around the ring are too few to grow "
           "from there by %.1f times each; take more solver.cells_y",
           number_in(reached, kMicrometre), number_in(c.end_cell(), kMicrometre), c.solver.cells_y,
           film::kSteepestGrowth),
       1});
}

/// Bending breaks a ring that is more tense than 1 MPa; on the narrow lands of oil rings, with a spring behind them, it
/// is up to 2 MPa (docs/manual/robustness.md) [Pa].
constexpr double kMaxTension = 3e6;

void append_tension_note(double elastic_pressure, std::vector<Note>& notes) {
  if (elastic_pressure <= kMaxTension) return;
  notes.push_back({"ring-tension-high",
                   "the tension of the ring makes an elastic pressure of " + text_in(elastic_pressure, kMegapascal) +
                       ": " + usual_tension(),
                   1});
}

/// Four-stroke engines have bores from 20 mm (models) to 0.6 m (ships), and strokes of 0.6 to 1.5 bores (assumed: what
/// lies far outside is a wrong unit).
constexpr double kMinBore = 0.02, kMaxBore = 0.7, kMinStroke = 0.4, kMaxStroke = 2.5;

void append_size_note(const Engine& engine, std::vector<Note>& notes) {
  const double ratio = engine.stroke / engine.bore;
  const bool is_usual =
      engine.bore >= kMinBore && engine.bore <= kMaxBore && ratio >= kMinStroke && ratio <= kMaxStroke;
  if (is_usual) return;
  notes.push_back({"engine-size-unusual",
                   "engine.bore = " + text_in(engine.bore, kMillimetre) +
                       " and engine.stroke = " + text_in(engine.stroke, kMillimetre) +
                       ": four-stroke engines have bores of 20 to 700 mm and strokes of 0.4 to 2.5 bores; are the "
                       "units right?",
                   1});
}

/// Films thinner than that are layers of molecules, of about 2 nm each, and not oil that flows.
constexpr double kThinnestSupply = 10e-9;

void append_supply_note(const Case& c, std::vector<Note>& notes) {
  if (c.film.supply_at_inlet() == OilSupply::kFlooded || c.supply.film.empty()) return;
  double most = 0;
  for (const StrokeValue& film : c.supply.film) most = std::max(most, film.value);
  if (most == 0 || most >= kThinnestSupply) return;
  notes.push_back({"supply-film-thin",
                   "supply.film is " + text_in(most, kNanometre) +
                       ", a few molecules: a ring leaves 0.5 to 5 um on the liner; is its unit right?",
                   1});
}

/// Keys of the static closure in a cycle.
void append_bore_note(const Case& c, std::vector<Note>& notes) {
  if (c.bends()) {
    if (c.conform.gas_pressure > 0) {
      notes.push_back(
          {"conform-not-used",
           "[conform] is used by ringfilm conform alone: in a cycle the gas of the case acts behind the ring", 1});
    }
    return;
  }
  if (c.liner.is_round() && c.ring.pressure_orders.empty() && !c.ring.pressure_points && !c.ring.free_shape &&
      !(c.conform.gas_pressure > 0))
    return;
  notes.push_back(
      {"bore-taken-as-round",
       "liner.distortion, the orders of the ring's pressure and [conform] are not used: film and friction are those of "
       "a ring that fits a round bore with uniform pressure; film.dimension = \"unrolled\" with "
       "ring.conformity = \"beam\" computes the ring in this bore",
       1});
}

void append_free_shape_note(const Case& c, std::vector<Note>& notes) {
  if (!c.ring.free_shape) return;
  const models::FreeShapeFit fit = free_ring(c);
  notes.push_back(
      {"free-shape-smoothed",
       formatted("ring.free_shape is smoothed over %.3g mm: its points lie %.3g um (rms) from the shape that is left, "
                 "and by that scatter the tangential force of %.4g N is known to %.2g %%, the pressure around the ring "
                 "to %.2g %% of its mean (one standard deviation)",
                 number_in(c.ring.free_shape_smoothing, kMillimetre), number_in(fit.residual, kMicrometre),
                 fit.tangential_force, 100 * fit.force_deviation, 100 * fit.pressure_deviation),
       1});
}

}  // namespace

std::vector<Note> advice(const Setup& setup) {
  const Case& c = setup.input;
  std::vector<Note> notes = setup.notes;
  if (c.solver.accuracy) notes.push_back({"accuracy-asked-for", accuracy_text(c), 1});
  append_end_cell_note(c, notes);
  if (!c.ring.pressure_above.is_stated()) append_gas_notes(c, setup.ring.lands.above, notes);
  append_viscosity_notes(setup.ring.oil, notes);
  append_contact_notes(c, notes);
  append_tension_note(setup.ring.elastic_pressure, notes);
  append_size_note(c.engine, notes);
  append_supply_note(c, notes);
  append_bore_note(c, notes);
  append_free_shape_note(c, notes);
  sort_notes(notes);
  return notes;
}

}  // namespace ringfilm::cycle
