#pragma once
#include "ringfilm/case/case_choices.hpp"

/// The input of the composition of the gas: a part of a Case.
namespace ringfilm::cycle {

/// The keys under `gas.composition`: charge and combustion of the cylinder, air of the crankcase. The defaults are
/// typical and assumed.
struct GasComposition {
  Fuel fuel = Fuel::kNone;         ///< fuel of the charge; kNone: the gas has no composition
  double excess_air_ratio = 1;     ///< lambda [-]
  double premixed_share = 1;       ///< share of the fuel that is in the charge before it burns [-]
  double humidity = 0.01;          ///< water in the air, over its dry mass [-]
  double residual_share = 0.05;    ///< burnt gas in the charge before it burns, by mass [-]
  BurnLaw burn = BurnLaw::kWiebe;  ///< how the burnt share rises where gas enters the ring pack
  double burn_begin_deg = -10;     ///< begin of the combustion, 0 = firing TDC [degree]
  double crankcase_air = 0;        ///< air into the crankcase of a cylinder [kg/s]

  bool is_stated() const { return fuel != Fuel::kNone; }  ///< does the gas have a composition?
};

}  // namespace ringfilm::cycle
