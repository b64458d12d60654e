#pragma once
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

/// Adds the oil on the liner to what the samples give.
void add_liner_oil(const Setup& setup, const LinerOil& oil, CycleValues& values, StrokeProfile& profile);

/// Values of `derived_quantities()`.
std::map<std::string, double> derived_values(const Setup& setup, const film::FilmGrid& grid);

}  // namespace ringfilm::cycle
