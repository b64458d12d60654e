#pragma once
#include <functional>
#include <memory>

#include "ringfilm/models/oil/lubricant.hpp"

namespace ringfilm::models {

/// One property of an oil at one temperature: of absolute pressure [Pa], in SI.
using PropertyOfPressure = std::function<double(double)>;

/// An oil whose laws are two functions of the caller: viscosity [Pa s] and density [kg/m3] against absolute pressure
/// [Pa]. The slopes, which steer the search for the film and do not decide where it ends, are differences over 0.2 MPa:
/// for a law that rises by 1e-8 1/Pa they are right to a relative 2e-7. Who has slopes in closed form derives from
/// OilAtTemperature instead. The functions are asked from several threads at a time, at pressures from 0 up; the same
/// pressure must give the same bits. Throws InputError where a function is empty.
std::shared_ptr<const OilAtTemperature> oil_of_functions(PropertyOfPressure viscosity, PropertyOfPressure density);

/// Throws InputError unless the oil has a positive finite density and viscosity and finite slopes at absolute pressures
/// between `low` and `high` [Pa], and its slopes are those of its values to within a hundredth of their largest.
void check_oil(const OilAtTemperature& oil, double low, double high);

}  // namespace ringfilm::models
