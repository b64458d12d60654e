#pragma once
#include "ringfilm/case/case.hpp"
#include "ringfilm/gas_path/pack.hpp"
#include "ringfilm/models/gas/charge_mixture.hpp"

namespace ringfilm::cycle {

/// Charge and combustion that a case states. Not for one without gas.composition.fuel.
models::ChargeMixture charge_mixture(const GasComposition& composition);

/// Gas constant, heat capacity ratio and viscosity of a case, as stated or of its mixture.
models::MixtureProperties gas_properties(const Case& c);

/// Writes gas_properties() into the keys of the case and of its rings, from where all else takes them.
void put_gas_properties(Case& c);

/// What the gas of a case consists of, with the walls that it meets. Not for one without gas.composition.fuel. Walls
/// are those of thermal.liner, else operating.oil_temperature, else the temperature of the crankcase.
gas_path::Composition gas_composition(const Case& c);

}  // namespace ringfilm::cycle
