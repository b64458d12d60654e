#include "ringfilm/pad/pad_notes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ringfilm/base/number_text.hpp"
#include "ringfilm/cycle/advice/limits.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"

namespace ringfilm::pad {
namespace {

/// A film that loses more than this share of its flow does so by its model, not by rounding.
constexpr double kMassLost = 1e-4;
/// A lowest place of the gap that the grid misses by more than this share of the film changes what the pad carries.
constexpr double kMissed = 0.01;

/// Do stated pressures of edge and side meet in a corner with a jump?
bool has_jumps_in_corners(const cycle::Pad& pad) {
  if (!pad.width || !pad.has_sides_at_pressures()) return false;
  const auto differs = [&](double side) { return side != pad.left_pressure || side != pad.right_pressure; };
  return differs(pad.front_pressure) || differs(pad.back_pressure);
}

/// Reynolds' equation drops terms of the order of (h/L)^2 against 1: 1 % from here on.
constexpr double kThickestFilm = 0.1;  // share of the length of the pad

/// Films that were solved and that no oil forms, with the limits of the cycle.
void append_limit_notes(const PadFilm& film, PadResult& result) {
  const double length = film.setup().input.pad.length;
  const auto where = [&](const Sample& s) {
    return result.is_history ? formatted(" (at %.4g s)", s.time) : std::string();
  };
  const auto thickness = [](const Sample& s) { return s.min_film_thickness; };
  const auto stress = [&](const Sample& s) {
    return std::max(std::abs(s.friction_moving), std::abs(s.friction_fixed)) / length;
  };
  const cycle::Limit too_thick = {
      cycle::Limit::Allowed::kBelow, "film-too-thick", kThickestFilm * length, 1e-6,
      "the smallest film is up to %.4g um thick%s: Reynolds' equation needs films that are thin against the pad's "
      "length, at most %.4g um"};
  cycle::append_limit_note(cycle::kFilmBelowMolecules, result.samples, thickness, where, result.notes);
  cycle::append_limit_note(too_thick, result.samples, thickness, where, result.notes);
  cycle::append_limit_note(
      cycle::kFilmPressureHigh, result.samples, [](const Sample& s) { return s.peak_film_pressure; }, where,
      result.notes);
  cycle::append_limit_note(cycle::kShearStressHigh, result.samples, stress, where, result.notes);
}

}  // namespace

const char* cell_keys(const PadSetup& setup) {
  return setup.surface ? "solver.cells and solver.cells_y" : "solver.cells";
}

void append_notes(const PadFilm& film, PadResult& result) {
  const PadSetup& setup = film.setup();
  const cycle::Pad& pad = setup.input.pad;
  const double um = 1e6;
  const auto note = [&result](const char* topic, std::string message, long count = 1) {
    result.notes.push_back({topic, std::move(message), count});
  };
  const bool has_film = !result.samples.empty();
  const Sample last = has_film ? result.samples.back() : Sample{};
  if (has_film && !pad.load && setup.lowest_gap > 0 && last.separation > 0) {
    note("separation-adds-to-gap",
         formatted(
             "the separation of %.6g um adds to the gap, whose lowest place is %.6g um: the smallest film is %.6g um",
             last.separation * um, setup.lowest_gap * um, last.min_film_thickness * um));
  }
  if (const double missed = film.lowest_height(); has_film && missed > kMissed * last.min_film_thickness) {
    note("gap-finer-than-cells",
         formatted(
             "the lowest place of the gap lies between the places that the cells see, which are %.3g um higher: take "
             "more %s",
             missed * um, cell_keys(setup)));
  }
  if (has_film && pad.load && last.separation < -kMissed * last.min_film_thickness) {
    note("pressed-closer-than-gap",
         formatted("the load presses the pad %.6g um closer than the gap is given, to a smallest film of %.6g um",
                   -last.separation * um, last.min_film_thickness * um));
  }
  result.notes.insert(result.notes.end(), setup.notes.begin(), setup.notes.end());
  append_limit_notes(film, result);
  if (has_film && has_jumps_in_corners(pad)) {
    note("edge-flow-grows",
         "the flows through edges and sides grow with the logarithm of finer cells: in the corners of the pad their "
         "pressures differ and meet in a jump; load and friction do not grow");
  }
  if (setup.p_cavitation < setup.input.film.cavitation_pressure) {
    note("cavitation-pressure-lowered",
         formatted(
             "the film ruptures at %.6g Pa, the lower edge pressure, and not at film.cavitation_pressure = %.6g Pa",
             setup.p_cavitation, setup.input.film.cavitation_pressure));
  }
  const long broken = std::count_if(result.samples.begin(), result.samples.end(),
                                    [](const Sample& s) { return s.gas_breakthrough > 0; });
  if (broken > 0) {
    note("gas-breaks-through",
         "gas of an edge reaches the lowest place of the gap: the film does not hold it, and how much gas blows "
         "through is not computed",
         broken);
  }
  if (const auto supply = setup.supply(); has_film && supply) {
    const std::vector<double>& h = result.profiles.back().film_thickness;
    const double inlet = setup.runs_left() ? h.back() : h.front();
    if (2 * *supply > inlet) {
      note(
          "supply-beyond-inlet",
          formatted("a film of %.4g um comes in, and the gap of %.4g um at the inlet takes %.4g um of it: the inlet is "
                    "flooded",
                    *supply * um, inlet * um, 0.5 * inlet * um));
    }
  }
  const auto worst =
      std::max_element(result.samples.begin(), result.samples.end(),
                       [](const Sample& a, const Sample& b) { return a.mass_residual < b.mass_residual; });
  const long losing = std::count_if(result.samples.begin(), result.samples.end(),
                                    [](const Sample& s) { return s.mass_residual > kMassLost; });
  if (losing > 0 && setup.input.film.cavitation == cycle::Cavitation::kMassConserving) {
    note("mass-residual",
         formatted(
             "mass is kept to no better than %.2g of the largest flow: gaps, viscosities or pressures differ too much "
             "for these numbers to be trusted",
             worst->mass_residual),
         losing);
  }
  if (losing > 0 && setup.input.film.cavitation == cycle::Cavitation::kReynoldsExit) {
    note("mass-not-kept",
         "film.cavitation = \"reynolds-exit\" does not keep mass where the film ruptures: the flows at the two edges "
         "differ",
         losing);
  }
  if (result.effort.cut_steps > 0) {
    note("shorter-steps", "time steps that were solved only after they were cut", result.effort.cut_steps);
  }
  if (result.effort.eased_starts > 0) {
    note("eased-start", "steady films that were found only from slower motion or another first guess",
         result.effort.eased_starts);
  }
  cycle::sort_notes(result.notes);
}

}  // namespace ringfilm::pad
