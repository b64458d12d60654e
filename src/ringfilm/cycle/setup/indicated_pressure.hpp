#pragma once
#include "ringfilm/case/case.hpp"
#include "ringfilm/models/gas/gas.hpp"

/// What a cylinder pressure does to the piston, and its index of compression (docs/theory/gas.md).
namespace ringfilm::cycle {

/// Indicated mean effective pressure, eq-imep [Pa].
struct IndicatedPressure {
  double net;         ///< over the whole cycle
  double gross;       ///< over compression and expansion alone
  double per_degree;  ///< change of `net` where the pressure comes one degree later [Pa/degree]
};
IndicatedPressure indicated_pressure(const Engine& engine, const models::CyclePressure& cylinder);

/// Distance of the piston from TDC at a crank angle [degree], in strokes.
double piston_distance(const Engine& engine, double crank_angle_deg);

/// Volume above the piston at a crank angle [degree], in strokes.
double volume_in_strokes(const Engine& engine, double crank_angle_deg, double compression_ratio);

/// Polytropic index between two crank angles [degree], by least squares of ln p over ln V, eq-compression-index.
double polytropic_index(const Engine& engine, const models::CyclePressure& cylinder, double from_deg, double to_deg,
                        double compression_ratio);

/// The index of the compression of a case between -90 and -45 degree; nothing where no compression ratio is known.
std::optional<double> compression_index(const Case& c, const models::CyclePressure& cylinder);

}  // namespace ringfilm::cycle
