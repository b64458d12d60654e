#include "ringfilm/pad/pad_notes.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace ringfilm::pad {
namespace {

/// A film that loses more than this share of its flow does so by its model, not by rounding.
constexpr double kMassLost = 1e-4;

template <typename... Values>
std::string text(const char* format, Values... values) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

}  // namespace

void append_notes(const PadSetup& setup, PadResult& result) {
  const cycle::Pad& pad = setup.input.pad;
  const double um = 1e6;
  const Sample& last = result.samples.back();
  const auto note = [&result](const char* topic, std::string message, long count = 1) {
    result.notes.push_back({topic, std::move(message), count});
  };
  if (!pad.load && setup.lowest_gap > 0 && last.separation > 0) {
    note("separation-adds-to-gap",
         text("the separation of %.6g um adds to the gap, whose lowest place is %.6g um: the smallest film is %.6g um",
              last.separation * um, setup.lowest_gap * um, last.min_film_thickness * um));
  }
  if (pad.load && last.separation < 0) {
    note("pressed-closer-than-gap",
         text("the load presses the pad %.6g um closer than the gap is given, to a smallest film of %.6g um",
              -last.separation * um, last.min_film_thickness * um));
  }
  if (setup.p_cavitation < setup.input.film.cavitation_pressure) {
    note("cavitation-pressure-lowered",
         text("the film ruptures at %.6g Pa, the lower edge pressure, and not at film.cavitation_pressure = %.6g Pa",
              setup.p_cavitation, setup.input.film.cavitation_pressure));
  }
  const long losing = std::count_if(result.samples.begin(), result.samples.end(),
                                    [](const Sample& s) { return s.mass_residual > kMassLost; });
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
}

}  // namespace ringfilm::pad
