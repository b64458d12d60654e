#pragma once
#include <string>
#include <vector>

#include "ringfilm/cycle/closure/static_closure.hpp"
#include "ringfilm/io/measurement/measurement.hpp"

namespace ringfilm::instrument {

/// What `ringfilm conform` reports: values, contact arcs, point forces and curves around the bore.
io::Measurement conformity_of_case(const cycle::Case& c, const cycle::StaticClosure& closure);

/// A column over the places of the ring: every whole degree from the middle of the gap, and both ends of the ring.
struct ClosureColumn {
  std::string name, unit;
  std::vector<double> values;  ///< SI, angles in degrees
};

/// Angle, deviation of the bore, clearance, line force without point forces, force of the wall up to there, bending
/// moment; target force, and the running surface of the free ring in polar coordinates about the centre of the closed
/// one.
std::vector<ClosureColumn> closure_columns(const cycle::StaticClosure& closure);

/// These columns as text, one row a place.
std::string conformity_csv(const cycle::StaticClosure& closure);

/// The names of the tables of conformity_of_case.
inline constexpr const char* kContactArcs = "contact_arcs";
inline constexpr const char* kContactPoints = "contact_points";
inline constexpr const char* kPointForces = "point_forces";
inline constexpr const char* kPressureOrders = "pressure_orders";

}  // namespace ringfilm::instrument
