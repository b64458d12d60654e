#include "ringfilm/cycle/pack/gas_through_films.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/pack/simulate_pack.hpp"

namespace ringfilm::cycle {
namespace {

/// Relative change of the blow-by from one turn to the next that is let through.
constexpr double kUnchanged = 1e-3;
constexpr int kMaxTurns = 10;

/// The films of the rings as their gas asks for them, at each degree without fields; nothing where one is not found.
std::optional<std::vector<CycleResult>> films(Case c, Observer* observer) {
  for (Case& ring : c.is_pack() ? std::span(c.rings) : std::span(&c, 1)) {
    ring.output = {};
    ring.output.crank_angle_step_deg = 1;
  }
  std::vector<CycleResult> results;
  for (RingOutcome& outcome : simulate_rings(c, observer)) {
    if (outcome.stop || !outcome.result.complete) return std::nullopt;
    results.push_back(std::move(outcome.result));
  }
  return results;
}

/// Gap over the face that gas passes all around, eq-face-flow [m]; of a ring that bends eq-open-gas-path.
double gas_opening(const Case& ring, const CycleResult& film, std::size_t k) {
  if (ring.bends()) return film.unrolled_samples[k].gas_opening;
  return film.samples[k].gas_breakthrough > 0 ? film.samples[k].min_film_thickness : 0;
}

/// Takes what gas passes over a face halfway to what a film lets through: full steps would swing.
void open_face(Case& ring, const CycleResult& film, bool is_first) {
  std::vector<double>& opening = ring.ring.gas_path.face_opening;
  const double share = is_first ? 1 : 0.5;
  opening.resize(film.samples.size(), 0.0);
  for (std::size_t k = 0; k < opening.size(); ++k) {
    opening[k] += share * (gas_opening(ring, film, k) - opening[k]);
  }
}

void add_note(CaseWithGas& found, int turns, bool is_unchanged) {
  double through = 0;
  for (std::size_t k = 0; k < found.gas->paths.size(); ++k) {
    const gas_path::Path& path = found.gas->paths[k];
    if (path.kind == gas_path::PathKind::kFace && path.ring == 0) through += found.gas->transported[k];
  }
  const std::string how = is_unchanged ? "" : "; blow-by still changes by more than 0.1 % from turn to turn";
  std::vector<std::string>& notes = found.input.is_pack() ? found.input.rings.front().notes : found.input.notes;
  notes.push_back("gas passes the films where they do not hold it: " + text_in(through, kMilligram) +
                  " per cycle over the face of the first ring; gas and films were computed in " +
                  std::to_string(turns) + " turns" + how);
}

}  // namespace

CaseWithGas solve_gas_through_films(Case pack, Observer* observer) {
  CaseWithGas now = solve_gas_of_case(pack);
  if (!pack.gas_path.passes_films()) return now;
  for (int turn = 1;; ++turn) {
    const std::optional<std::vector<CycleResult>> found = films(now.input, observer);
    if (!found) return now;
    for (std::size_t i = 0; i < found->size(); ++i) {
      open_face(pack.is_pack() ? pack.rings[i] : pack, (*found)[i], turn == 1);
    }
    const double before = now.gas->blow_by;
    now = solve_gas_of_case(pack);
    const bool is_unchanged = std::abs(now.gas->blow_by - before) <= kUnchanged * std::abs(before);
    if (!is_unchanged && turn < kMaxTurns) continue;
    add_note(now, turn, is_unchanged);
    return now;
  }
}

}  // namespace ringfilm::cycle
