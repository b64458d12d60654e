#pragma once
#include <cstdint>
#include <optional>

#include "ringfilm/case/case.hpp"

/// Engines as nobody would build them: the sample that the integration must survive.
namespace ringfilm::cycle::testing {

enum class FaceKind { kNewPolynomial, kRunInPolynomial, kEmbeddedPolynomial, kParabola, kNoisyPoints, kWornFlat };
enum class TraceKind { kSmooth, kNoisy, kKnock, kStep, kKnockAndStep };

const char* name(FaceKind kind);
const char* name(TraceKind kind);

/// One engine and how to integrate it.
struct EngineScenario {
  Case input;
  FaceKind face{};
  TraceKind trace{};
  double rise = 0;             ///< of the face above its lowest point, at the higher edge [m]
  double peak_pressure = 0;    ///< largest sample of the trace [Pa]
  double start_angle_deg = 0;  ///< the integration starts here from a steady film; at a dead centre: from standstill
  std::optional<double>
      side_spacing_deg;  ///< solve the film off the integration too, at angles this far apart [degree]
};

/// Member `index` of the sample `seed`: a shifted Kronecker sequence with the square roots of primes (Richtmyer), which
/// fills the box evenly whatever its length; noise comes from a generator of its own. The same on every machine.
///
/// The box: 500-9000 rpm (one in sixteen cranked at 50-500), oil at -30 to 180 degC, peaks of 1-300 bar, sigma
/// 0.03-2 um, faces rising by 1-200 um with the lowest point anywhere, the three polynomials of the paper, worn flats
/// and points with measured noise, tension 1-100 N, p_c 0-1 bar, both cavitation models, Roelands, Barus and constant
/// viscosity with alpha of 0.5-3e-8 1/Pa, 30-1600 cells, crank steps of
/// 0.5-5 degree fixed and adaptive, traces with noise, knocks and steps, one start in four from standstill.
EngineScenario engine_scenario(std::uint64_t seed, int index);

/// Gas where the film leaves, mass-conserving cavitation.
void put_gas_at_edges(Case& c);

/// 0.3 to 20 um that the oil ring leaves, which reaches 5 to 25 % of the stroke. For a case between edges of gas.
void lay_oil_on_liner(int index, Case& c);

}  // namespace ringfilm::cycle::testing
