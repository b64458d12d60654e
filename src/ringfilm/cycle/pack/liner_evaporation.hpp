#pragma once
#include <functional>
#include <vector>

#include "ringfilm/models/crank_slider.hpp"
#include "ringfilm/models/oil/evaporation.hpp"

namespace ringfilm::cycle {

/// The liner above the first ring, its oil, and what carries the vapour away. Places count from the TDC position of
/// the chamber edge of that ring.
struct EvaporatingLiner {
  models::CrankSlider crank{};
  double speed = 0;                            ///< speed of the crankshaft [rad/s]
  double bore = 0;                             ///< [m]
  std::vector<models::OilFraction> fractions;  ///< fractions of the fresh oil
  std::function<double(double)> temperature;   ///< temperature of the liner at a place [K]
  std::function<double(double)>
      mass_transfer;  ///< beta at a crank angle [degree], over T_w^wall_temperature_power [m/s/K^power]
  /// Power of the wall temperature with which beta goes: 1 of the analogy with heat, 0 where it is stated [-].
  double wall_temperature_power = 0;
  std::vector<double> film;  ///< oil that the first ring leaves, mean of its downstrokes, in cells of a stroke [kg/m2]
  double carried = 0;        ///< oil under the rings, which they carry along, per length of circumference [kg/m]
  double reach = 0;          ///< place from which on each downstroke lays fresh oil [m]
};

/// What evaporates from it over the cycle that repeats itself.
struct EvaporatedOil {
  double of_fresh_oil = 0;  ///< as if the film had the composition of the fresh oil at all times, eq-fresh-rate [kg/s]
  double rate = 0;          ///< with the composition that each place has, eq-renewal [kg/s]
  double within_reach = 0;  ///< part of it from the liner that gets fresh oil in each cycle [kg/s]
  int cycles = 0;           ///< until it repeats itself
  // balance of the last cycle [kg]
  double replenished = 0;  ///< fresh oil laid, less what lay there
  double evaporated = 0;
  double stored = 0;  ///< change of the oil on the liner and under the rings
};

/// Follows the fractions of the oil along the liner until a cycle evaporates as much as the one before.
EvaporatedOil evaporated_oil(const EvaporatingLiner& liner);

}  // namespace ringfilm::cycle
