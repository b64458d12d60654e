#pragma once
#include <memory>

#include "ringfilm/models/oil/viscosity_laws.hpp"

namespace ringfilm::models {

/// ln eta + 9.67, by which Roelands' and Houpert's laws divide; eta [Pa s]. Throws InputError below the 0.0632 mPa s at
/// which they start.
double roelands_logarithm(double eta);

/// Roelands' pressure-viscosity index Z [-], eq-roelands-index.
/// @param alpha_0 pressure-viscosity coefficient [1/Pa]; @param eta_0 viscosity to which it belongs [Pa s]
double roelands_index(double alpha_0, double eta_0);

/// Houpert's form of Roelands' law, eq-roelands; pressure absolute.
/// eta = exp{ (ln eta_T + 9.67) [(1 + p/1.98e8)^Z - 1] } eta_T with eta_T the viscosity at T and p = 0 [Pa s].
std::unique_ptr<const ViscosityCurve> roelands_curve(double eta_T, double Z);

}  // namespace ringfilm::models
