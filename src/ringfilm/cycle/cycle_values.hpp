#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ringfilm/cycle/integration/liner_oil.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/film/film_state.hpp"

namespace ringfilm::cycle {

/// Values of the cycle from samples at all base angles, equally spaced; eqs eq-mean, eq-energy-per-cycle, eq-fmep.
CycleValues cycle_values(const Setup& setup, const std::vector<Sample>& base);

/// Their replacement when the integration stopped: every value NaN.
CycleValues no_cycle_values();

/// Contact work along the stroke from the same samples, shared out over the liner that each crank step sweeps.
/// @param archard_wear_load the value of the cycle, which is that of the whole stroke [N m]
StrokeProfile stroke_profile(const Setup& setup, const std::vector<Sample>& base, double archard_wear_load);

/// Oil that a cycle moved, and the oil on the liner along its strokes. Per length of circumference.
struct OilOfCycle {
  LinerOil::Account account;
  /// Mean of the oil ahead of the ring before a stroke, and of that behind it after the stroke, over the stretch of
  /// liner that its edge passes while it goes from one place below TDC to another [kg/m2]
  std::function<double(std::size_t stroke, double begin, double end)> ahead, behind;
};
OilOfCycle oil_of_cycle(const LinerOil& oil);

/// Adds the oil on the liner to what the samples give.
void add_liner_oil(const Setup& setup, const OilOfCycle& oil, CycleValues& values, StrokeProfile& profile);

/// Values of `derived_quantities()`.
std::map<std::string, double> derived_values(const Setup& setup, const film::FilmGrid& grid);

}  // namespace ringfilm::cycle
